"""Closed loops as plain differential equations of matrices: what the simulator is held to.

g, nu, g_r, the momentum of the wheels and the integral of force^2 are integrated by scipy, with
nothing kept on the group; of the code under test only the emitted numpy controller is called.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from bench import made
from bench.algebra import Array, algebra, exp
from derive import flight
from derive.native.load import load_module
from derive.simulate.craft import Craft, folder_of
from derive.simulate.reference import Reference
from derive.simulate.runs import Runs, Setting

ACCURACY = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}


@cache
def craft(name: str, law: str = "log", options: tuple[str, ...] = ()) -> Craft:
    """The vehicle of the benches on a group, without a cache on disk."""
    return flight.craft(made.vehicle(name, law, options), None)


def runs(one: Craft, loops: int = 1, met: bool = True, seed: int = 5) -> Runs:
    """So many loops off the identity; with everything a loop can meet, or nothing of it."""
    space = algebra(one.group)
    n, count = space.dim, len(one.inertia)
    random = np.random.default_rng(seed)
    off = random.normal(size=(loops, n))
    off *= 1.2 / np.linalg.norm(off, axis=1, keepdims=True)
    heavier = 1 + met * random.uniform(-0.2, 0.2, (1, loops))
    push = [met * random.uniform(-0.5, 0.5, (n, loops)) for _ in range(4)]
    return Runs(
        g=space.store(exp(space.hat(off))).T,
        nu=random.uniform(-0.4, 0.4, (n, loops)),
        momentum=random.normal(size=(n, loops)) * ("momentum" in one.options),
        inertia=heavier * np.array(one.inertia)[:, None] + np.zeros((count, loops)),
        external=push[0] * ("external" in one.options),
        disturbance=push[1],
        sine=push[2],
        cosine=push[3],
        seeds=tuple(range(10, 10 + loops)),
    )


def square(upper: Array) -> Array:
    """Upper triangle, row by row, to the matrix."""
    n = next(n for n in range(1, 30) if n * (n + 1) // 2 == len(upper))
    whole = np.zeros((n, n))
    whole[np.triu_indices(n)] = upper
    return np.asarray(whole + np.triu(whole, 1).T)


@dataclass(frozen=True)
class Plain:
    """One loop of a craft, the i-th of its runs."""

    craft: Craft
    reference: Reference
    setting: Setting
    runs: Runs
    i: int = 0

    def split(self, y: Array) -> list[Array]:
        """g, nu, g_r, momentum, effort."""
        space = algebra(self.craft.group)
        k, n = len(space.kept), space.dim
        return np.split(y, np.cumsum([k, n, k, n]))

    def force(self, t: float, y: Array) -> Array:
        """What the actuators give for the state: the emitted law, cut off."""
        g, nu, g_r, momentum, _ = self.split(y)
        shape = algebra(self.craft.group).shape
        known = {"momentum": momentum, "external": self.runs.external[:, self.i]}
        nu_r, nu_r_dot = (one[:, 0] for one in self.reference.at(t))
        asked = _module(self.craft).tracking(
            g=g.reshape(shape), nu=nu, g_r=g_r.reshape(shape), nu_r=nu_r, nu_r_dot=nu_r_dot,
            **{name: known[name] for name in self.craft.options},
        ).force  # fmt: skip
        most = np.inf if self.setting.force_limit is None else np.array(self.setting.force_limit)
        return np.asarray(np.minimum(np.maximum(asked, -most), most))

    def rates(self, t: float, y: Array, force: Array) -> Array:
        """I nu' = ad*_nu (I nu + h) + force + external + disturbance, h' = -force."""
        space, met, i = algebra(self.craft.group), self.runs, self.i
        g, nu, g_r, momentum, _ = self.split(y)
        inertia = square(met.inertia[:, i])
        turn = 2 * np.pi * self.setting.hertz * t
        wheels = momentum if "momentum" in self.craft.options else 0.0
        total = space.coad(nu, inertia @ nu + wheels) + force + met.external[:, i]
        total = total + met.disturbance[:, i]
        total = total + np.sin(turn) * met.sine[:, i] + np.cos(turn) * met.cosine[:, i]
        nu_r = self.reference.at(t)[0][:, 0]
        moved = np.linalg.solve(inertia, total)
        return np.concatenate([space.flow(g, nu), moved, space.flow(g_r, nu_r), -force,
                               [force @ force]])  # fmt: skip

    def flown(self) -> list[Array]:
        """The parts of the state at the end; with a rate, the force is held over each period."""
        met, i, seconds = self.runs, self.i, self.setting.seconds
        y = np.concatenate([met.g[:, i], met.nu[:, i], self.reference.start[:, 0],
                            met.momentum[:, i], [0.0]])  # fmt: skip
        if self.setting.rate is None:
            return self.split(
                _solved(lambda t, y: self.rates(t, y, self.force(t, y)), 0, seconds, y)
            )
        for place in range(round(seconds * self.setting.rate)):
            t = place / self.setting.rate
            held = self.force(t, y)
            y = _solved(lambda t, y, held=held: self.rates(t, y, held),  # type: ignore[misc]
                        t, t + 1 / self.setting.rate, y)  # fmt: skip
        return self.split(y)


def _solved(rates: Callable[[float, Array], Array], start: float, end: float, y: Array) -> Array:
    found = solve_ivp(rates, (start, end), y, **ACCURACY)
    assert found.success
    return np.asarray(found.y[:, -1])


@cache
def _module(one: Craft) -> Any:
    return load_module(folder_of(one) / "numpy" / f"{one.name}.py")
