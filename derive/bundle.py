"""The tangent bundle in numbers: the paper's group operation on states (g, nu), batched numpy.

    from derive import bundle
    b = bundle.make("SO3", "log", rate_gain=0.5)    # or bundle.of("vehicles/paper_so3.toml")
    h = b.star(h1, h2)                              # h = (g, nu), over any leading axes

Every number comes from the derivations of derive.control.tangent and derive.control.morse,
printed as emitted numpy is. g has the group's storage shape, nu the shape (..., n).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from derive.control import morse, tangent
from derive.control.kinematic import KinematicLaw, laws_of
from derive.emit.function import Function, compiled
from derive.lie.catalogue import named
from derive.lie.group import Group
from derive.vehicle import CONTROLLERS, InputError, Vehicle, load, resolve
from derive.vehicle.group import group_of
from derive.vehicle.text import described

Array = Any  # a numpy array, or what np.asarray makes one of


class State(NamedTuple):
    """h = (g, nu): a configuration (..., *shape) and a body velocity (..., n)."""

    g: Array
    nu: Array


@dataclass(frozen=True)
class Bundle:
    """(TG, star) of a group, a law and the gain lambda in 1/s; eq. (BnyOp), Lemmas 1 and 2.

    Every method raises ValueError for an array whose last axes are not the group's.
    """

    group: Group
    kinematic: KinematicLaw
    rate_gain: float

    def star(self, h1: tuple[Array, Array], h2: tuple[Array, Array]) -> State:
        """(g1 g2, nu1 + nu2 + lambda (nu_u(g1) + nu_u(g2) - nu_u(g1 g2)))."""
        (g1, nu1), (g2, nu2) = h1, h2
        rows = {"g1": self._rows(g1, "g1"), "g2": self._rows(g2, "g2")}
        return self._state(self._star(rate_gain=self.rate_gain, nu1=nu1, nu2=nu2, **rows))

    @cached_property
    def identity(self) -> State:
        """f = (e, 0)."""
        return self._state(compiled(tangent.identity(self.group))())

    def inverse(self, h: tuple[Array, Array]) -> State:
        """(g^-1, -nu)."""
        g, nu = h
        return self._state(self._inverse(g=self._rows(g), nu=nu))

    def law(self, g: Array) -> Array:
        """nu_u(g), (..., n)."""
        return self._kinematics(g=self._rows(g))["nu_u"]

    def clearance(self, g: Array) -> Array:
        """Distance from where the law jumps or is not defined, (...): zero there, at most 1."""
        return self._kinematics(g=self._rows(g))["clearance"]

    def s(self, h: tuple[Array, Array]) -> Array:
        """Sliding variable nu + lambda nu_u(g), (..., n), in the units of nu."""
        g, nu = h
        return self._sliding(rate_gain=self.rate_gain, g=self._rows(g), nu=nu)["s"]

    def is_sliding(self, h: tuple[Array, Array], tolerance: float) -> Array:
        """Whether h is in H but for the tolerance: |s(h)| <= tolerance, (...) of bool."""
        return np.linalg.norm(self.s(h), axis=-1) <= tolerance

    def above(self, g: Array) -> State:
        """The state of H above g: (g, -lambda nu_u(g))."""
        return self._state(self._above(rate_gain=self.rate_gain, g=self._rows(g)))

    @cached_property
    def heights(self) -> dict[str, Height]:
        """The Morse functions of the group by name; the first is what its laws are judged by."""
        rows = morse.heights_of(self.group).values()
        return {one.name: Height(self.group, one) for one in rows}

    @cached_property
    def _star(self) -> Function:
        return compiled(tangent.star(self.group, self.kinematic))

    @cached_property
    def _inverse(self) -> Function:
        return compiled(tangent.inverse(self.group))

    @cached_property
    def _kinematics(self) -> Function:
        return compiled(tangent.kinematics(self.group, self.kinematic))

    @cached_property
    def _sliding(self) -> Function:
        return compiled(tangent.sliding(self.group, self.kinematic))

    @cached_property
    def _above(self) -> Function:
        return compiled(tangent.above(self.group, self.kinematic))

    def _rows(self, g: Array, name: str = "g") -> Array:
        return flat(self.group, g, name)

    def _state(self, found: dict[str, Array]) -> State:
        g = found["g"]
        return State(g.reshape(*g.shape[:-1], *self.group.shape), found["nu"])


@dataclass(frozen=True)
class Height:
    """A Morse function V in numbers; see derive.control.morse."""

    group: Group
    morse: morse.Morse

    def value(self, g: Array) -> Array:
        """V(g), (...)."""
        return self._run(g, np.zeros(self.group.dim))["V"]

    def rate(self, g: Array, nu: Array) -> Array:
        """V' along g' = g hat(nu), (...), per second."""
        return self._run(g, nu)["V_dot"]

    def gradient(self, g: Array) -> Array:
        """Gradient in body coordinates, (..., n): V' = gradient . nu."""
        return self._run(g, np.zeros(self.group.dim))["gradient"]

    @cached_property
    def _function(self) -> Callable[..., dict[str, Array]]:
        return compiled(morse.height(self.group, self.morse))

    def _run(self, g: Array, nu: Array) -> dict[str, Array]:
        return self._function(g=flat(self.group, g), nu=nu)


def make(group: Group | str, law: str = "log", rate_gain: float = 1.0) -> Bundle:
    """The bundle of a group, by name or as a record, with the law of that name; lambda in 1/s.

    Raises ValueError for a group or law that does not exist, and for a gain that is not positive.
    """
    made = _named(group) if isinstance(group, str) else group
    laws = laws_of(made)
    if law not in laws:
        known = ", ".join(laws)
        raise ValueError(f"law: expected one of {known} on {made.name}, found {law!r}")
    if not 0 < float(rate_gain) < np.inf:
        raise ValueError(f"rate_gain: expected a positive number in 1/s, found {rate_gain!r}")
    return Bundle(made, laws[law], float(rate_gain))


def of(vehicle: Vehicle | Path | str) -> Bundle:
    """The bundle of a vehicle, or of its file: its group, law and lambda. Raises InputError."""
    one = vehicle if isinstance(vehicle, Vehicle) else load(Path(vehicle))
    resolve(one)
    gains = dict(one.gains)
    if "lambda" not in gains:
        having = [name for name, of in CONTROLLERS.items() if "lambda" in of.names]
        expected = (
            f"one of {', '.join(having)}: the operation on the tangent bundle has their lambda"
        )
        remedy = f'write controller = "{having[0]}", or make the bundle with bundle.make'
        raise InputError(one.source, "controller", expected, described(one.controller), remedy)
    return make(group_of(one), one.law, float(gains["lambda"]))


def flat(group: Group, g: Array, name: str = "g") -> Array:
    """(..., *shape) as (..., k); ValueError where the last axes are others."""
    array, shape = np.asarray(g), group.shape
    split = array.ndim - len(shape)
    if split < 0 or array.shape[split:] != shape:
        wanted = ", ".join(map(str, shape))
        raise ValueError(
            f"{name}: expected an array (..., {wanted}) of {group.name}, found {array.shape}"
        )
    return array.reshape(*array.shape[:split], group.size)


def _named(name: str) -> Group:
    try:
        return named(name)
    except KeyError as unknown:
        expected = 'SO2, SO3, S3, SE2, SE3, SE23, R1 to R24, or a product such as "SO3 x R3"'
        raise ValueError(f"group: expected {expected}, found {unknown.args[0]!r}") from None
