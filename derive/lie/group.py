"""A matrix Lie group as data: a basis of its algebra and how its elements are stored.

Everything else (hat, vee, bracket, ad, Ad, coad) follows from the basis, here and only here.
Velocities are body velocities (left invariance): g' = g hat(nu).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

import sympy
from sympy import ImmutableMatrix, Matrix

from derive.lie.chart import Charted
from derive.lie.cover import Let, Scaled

Pull = Callable[[str, Matrix], Matrix]
"""(name, x) -> Ad of g^-1 on x (n, 1); its steps are named after `name`."""


@dataclass(frozen=True)
class Group:
    """A group G of m x m matrices with n-dimensional algebra, elements kept as k numbers.

    name:     as written in a vehicle file
    basis:    n matrices (m, m), exact: the coordinates of the algebra
    units:    n units of the velocity's coordinates
    identity: the k stored numbers of e
    embed:    k stored numbers -> element (m, m)
    store:    element (m, m) -> k stored numbers (k, 1)
    inverse:  element -> element
    residual: stored numbers -> expressions that all vanish on the group, and only there
    storage:  the stored numbers in words
    shape:    their shape in numpy
    cover:    writes the steps from stored numbers to the unit quaternion, if it has one
    chart:    writes the steps from stored numbers to the logarithm, if it has a closed form
    factors:  of a direct product, in order; empty for any other group
    first:    the group that this one is in another basis, and the new E_j in its coordinates
    is_rotation: its velocities are angular rates of a body in space
    attitude: unit quaternion (4, 1), scalar first -> stored numbers (k, 1), of a group of attitudes
    short_…:  optional shorter formulas, each held to its definition by a test
    """

    name: str
    basis: tuple[ImmutableMatrix, ...]
    units: tuple[str, ...]
    identity: tuple[int, ...]
    embed: Callable[[Matrix], Matrix]
    store: Callable[[Matrix], Matrix]
    inverse: Callable[[Matrix], Matrix]
    residual: Callable[[Matrix], Matrix]
    storage: str
    shape: tuple[int, ...]
    cover: Callable[[Let, Matrix], Scaled] | None = None
    chart: Charted | None = None
    factors: tuple[Group, ...] = ()
    first: tuple[Group, ImmutableMatrix] | None = None
    is_rotation: bool = False
    attitude: Callable[[Matrix], Matrix] | None = None
    short_Ad: Callable[[Matrix], Matrix] | None = None
    short_error: Callable[[Let, Matrix, Matrix], Matrix] | None = None
    short_pull: Callable[[Let, Matrix], Pull] | None = None

    @property
    def dim(self) -> int:
        """n, the dimension of the algebra."""
        return len(self.basis)

    @property
    def size(self) -> int:
        """k, how many numbers are stored."""
        return len(self.identity)

    @property
    def unit(self) -> str:
        """Units of a velocity, each once."""
        return _listed(self.units)

    @property
    def acceleration_unit(self) -> str:
        """Units of the rate of a velocity."""
        return _listed(_per_second(unit) for unit in self.units)

    @property
    def log_unit(self) -> str:
        """Units of a logarithm."""
        return _listed(times_second(unit) for unit in self.units)

    @property
    def force_unit(self) -> str:
        """Units of a force: power over velocity."""
        names = {"rad/s": "N m", "m/s": "N", "1/s": "J"}
        return _listed(names.get(unit, f"W/({unit})") for unit in self.units)

    @property
    def momentum_unit(self) -> str:
        """Units of a momentum: force times time."""
        return _listed(f"{unit} s" for unit in self.force_unit.split(", "))

    @property
    def inertia_unit(self) -> str:
        """Units of an inertia, of its diagonal first."""
        turns, moves = "rad/s" in self.units, "m/s" in self.units
        if set(self.units) <= {"rad/s", "m/s"}:
            return ", ".join(["kg m^2"] * turns + ["kg m"] * (turns and moves) + ["kg"] * moves)
        return "J s^2" if set(self.units) == {"1/s"} else "force over acceleration"

    def split_element(self, stored: Matrix) -> list[Matrix]:
        """Stored numbers of each factor of a product."""
        return cut(stored, [factor.size for factor in self.factors])

    def split_velocity(self, x: Matrix) -> list[Matrix]:
        """Algebra coordinates of each factor of a product."""
        return cut(x, [factor.dim for factor in self.factors])

    @cached_property
    def _left_inverse(self) -> Matrix:
        stacked = Matrix.hstack(*(Matrix(e.reshape(e.rows * e.cols, 1)) for e in self.basis))
        gram = stacked.T * stacked
        if gram.det() == 0:
            raise ValueError(f"{self.name}: the basis matrices are linearly dependent")
        return gram.inv() * stacked.T

    def hat(self, x: Matrix) -> Matrix:
        """Algebra coordinates (n, 1) to matrix (m, m): hat(x) = sum x_i E_i."""
        m = self.basis[0].rows
        return sum((x[i] * e for i, e in enumerate(self.basis)), sympy.zeros(m, m))

    def vee(self, a: Matrix) -> Matrix:
        """Matrix of the algebra (m, m) to coordinates (n, 1): vee(hat(x)) = x."""
        return self._left_inverse * Matrix(a).reshape(a.rows * a.cols, 1)

    @cached_property
    def structure(self) -> tuple[ImmutableMatrix, ...]:
        """Structure constants: column j of the i-th matrix is vee [E_i, E_j], (n, n) each."""
        brackets = [[self.vee(a * b - b * a) for b in self.basis] for a in self.basis]
        return tuple(ImmutableMatrix(Matrix.hstack(*row)) for row in brackets)

    def bracket(self, x: Matrix, y: Matrix) -> Matrix:
        """[x, y] in coordinates (n, 1): hat([x, y]) = hat(x) hat(y) - hat(y) hat(x)."""
        return self.ad(x) * y

    def ad(self, x: Matrix) -> Matrix:
        """ad_x, (n, n): ad_x y = [x, y]."""
        zero = sympy.zeros(self.dim, self.dim)
        return sum((x[i] * c for i, c in enumerate(self.structure)), zero)

    def coad(self, x: Matrix) -> Matrix:
        """ad*_x, (n, n), in the paper's sign: <ad*_x a; y> = <a; [x, y]>."""
        return self.ad(x).T

    def Ad(self, g: Matrix) -> Matrix:
        """Ad_g, (n, n), of an element g (m, m): hat(Ad_g x) = g hat(x) g^-1."""
        if self.short_Ad:
            return self.short_Ad(g)
        return self.long_Ad(g)

    def long_Ad(self, g: Matrix) -> Matrix:
        """Ad_g by its definition, column by column."""
        back = self.inverse(g)
        return Matrix.hstack(*(self.vee(g * e * back) for e in self.basis))

    def error(self, let: Let, g_r: Matrix, g: Matrix) -> Matrix:
        """Stored numbers (k, 1) of g_r^-1 g, from stored numbers."""
        if self.short_error:
            return self.short_error(let, g_r, g)
        return self.long_error(g_r, g)

    def long_error(self, g_r: Matrix, g: Matrix) -> Matrix:
        """Stored numbers of g_r^-1 g by its definition."""
        return self.store(self.inverse(self.embed(g_r)) * self.embed(g))

    def pull(self, let: Let, g: Matrix) -> Pull:
        """Ad of g^-1, for stored g, as a function of velocities."""
        if self.short_pull:
            return self.short_pull(let, g)
        back = self.Ad(self.inverse(self.embed(g)))
        entries = let("to_body", Matrix(list(back)), "1", "Ad of g_e^-1: reference to body frame")
        return lambda _, x: entries.reshape(*back.shape) * x


def marked(let: Let, mark: str) -> Let:
    """The same let, its names marked as those of one factor of a product."""
    return lambda name, *rest, **more: let(f"{name}_{mark}", *rest, **more)


def cut(rows: Matrix, sizes: Sequence[int]) -> list[Matrix]:
    """Consecutive rows of these sizes."""
    starts = [sum(sizes[:i]) for i in range(len(sizes))]
    return [rows[a : a + n, :] for a, n in zip(starts, sizes, strict=True)]


def _listed(units: Iterable[str]) -> str:
    return ", ".join(dict.fromkeys(units))


def _per_second(unit: str) -> str:
    """m/s to m/s^2, m/s^2 to m/s^3, m to m/s."""
    stem, power = _seconds(unit)
    return f"{stem}/s" if not power else f"{stem}/s^{power + 1}"


def times_second(unit: str) -> str:
    """m/s to m, m/s^2 to m/s; what is no rate gets a factor."""
    stem, power = _seconds(unit)
    if power > 2:
        return f"{stem}/s^{power - 1}"
    return (f"({stem}) s", stem, f"{stem}/s")[power]


def _seconds(unit: str) -> tuple[str, int]:
    """What stands before /s^power, and the power; 0 where the unit is no rate."""
    found = re.fullmatch(r"(.+)/s(?:\^(\d+))?", unit)
    return (found[1], int(found[2] or 1)) if found else (unit, 0)
