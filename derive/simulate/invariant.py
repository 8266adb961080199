"""What no correct run breaks: the decay of W, the group, the energy of a free plant, answers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from derive.simulate.flight import Flight
from derive.simulate.loop import Loop
from derive.simulate.outcome import crosses
from derive.simulate.pilot import REFUSED
from derive.simulate.space import Array

SHOWN = 8.0  # k_s t up to which W is judged: after that it is at the floor of the integration


@dataclass(frozen=True)
class Invariant:
    """One of them in one run; `why` says why it does not apply, and is empty where it does."""

    name: str
    measured: float
    limit: float
    why: str = ""

    @property
    def ok(self) -> bool:
        """Whether it holds, or does not apply."""
        return bool(self.why) or self.measured <= self.limit

    @property
    def verdict(self) -> str:
        """In words."""
        if self.why:
            return f"not applicable: {self.why}"
        return "holds" if self.ok else "BROKEN"


Watched = tuple[Invariant, ...]


def invariants(loop: Loop, flight: Flight) -> Watched:
    """All of them, for the only loop of a run; one that has lost its numbers breaks them."""
    return watched(loop, [flight])[0]


def watched(loop: Loop, flights: Sequence[Flight]) -> list[Watched]:
    """All of them, for each of the loops that flew together."""
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        free = _freedom(loop)
        return [
            (_decay(loop, flight, i), _membership(loop, flight), free[i], _answered(flight))
            for i, flight in enumerate(flights)
        ]


def facts(each: Sequence[Invariant]) -> list[dict[str, Any]]:
    """As plain data."""
    return [
        {"name": one.name, "measured": None if one.why else one.measured, "limit": one.limit,
         "verdict": one.verdict} for one in each
    ]  # fmt: skip


def _decay(loop: Loop, flight: Flight, column: int) -> Invariant:
    """W = s'Is/2 against W(0) exp(-2 k_s t), which holds for the exact law in continuous time."""
    name = "W = W(0) exp(-2 k_s t)"
    why = _why_no_decay(loop, flight, column)
    if why:
        return Invariant(name, 0.0, 1e-8, why)
    k_s = dict(loop.craft.gains)["k_s"]
    W = np.einsum("ti,ij,tj->t", flight.s, symmetric(loop.craft.inertia), flight.s) / 2
    judged = k_s * flight.t <= SHOWN
    decay = W[judged] / W[0] / np.exp(-2 * k_s * flight.t[judged])
    return Invariant(name, float(np.abs(decay - 1).max()), 1e-8)


def _why_no_decay(loop: Loop, flight: Flight, column: int) -> str:
    setting, runs = loop.setting, loop.runs
    met = [_of(one, column) for one in (runs.disturbance, runs.sine, runs.cosine)]
    pushed = any(np.any(one) for one in met)
    inertia = _of(runs.inertia, column)
    reasons = (
        ("k_s" not in dict(loop.craft.gains), f"{loop.craft.controller} has no such law"),
        (setting.rate is not None, "the controller is sampled"),
        (loop.pilot.backend == "f32", "single precision moves s by more than the limit"),
        (pushed, "a disturbance acts"),
        (setting.is_noisy, "measurements are noisy"),
        (np.any(flight.force != flight.asked), "the actuators saturate"),
        (np.any(flight.status >= REFUSED), "the controller refused a state"),
        (np.any(inertia != np.array(loop.craft.inertia)), "the inertia is in error"),
        (
            crossings(flight, loop.space.turns, setting.period) > 0,
            "the error crosses the cut locus",
        ),
        (not np.any(flight.s[0]), "s starts at zero"),
    )
    return next((why for applies, why in reasons if applies), "")


def crossings(flight: Flight, turns: Sequence[int], period: float) -> int:
    """How often the error crosses the cut locus, as a sweep counts it."""
    nu_u, rate = flight.nu_u.T[list(turns)], flight.rate_error()
    if not len(nu_u):
        return 0
    faster = np.maximum(rate[:-1], rate[1:])
    return int(crosses(nu_u[:, :-1], nu_u[:, 1:], faster, period).sum())


def _membership(loop: Loop, flight: Flight) -> Invariant:
    """Residual of g and g_r, relative to the square of their largest entry."""
    off = []
    for g in (flight.g, flight.g_r):
        size = np.maximum(1.0, np.abs(g).max(1)) ** 2
        off.append(loop.space.drift(g.T) / size)
    worst = float(np.max(off))  # of which a NaN is the largest
    return Invariant("g and g_r stay on the group", worst, 1e-10)


def _freedom(loop: Loop) -> list[Invariant]:
    """Kinetic energy nu'I nu/2 of each plant without any force, over the same time and steps."""
    name, limit = "energy of the plant left alone", 1e-8
    speeds = np.stack([body.nu for body in loop.coasted()])  # (T, n, N)
    found = []
    for i in range(speeds.shape[2]):
        inertia = symmetric(_of(loop.runs.inertia, i).tolist())
        energy = np.einsum("ti,ij,tj->t", speeds[:, :, i], inertia, speeds[:, :, i]) / 2
        change = float(np.abs(energy / energy[0] - 1).max()) if energy[0] else 0.0
        found.append(Invariant(name, change, limit, "" if energy[0] else "it starts at rest"))
    return found


def _answered(flight: Flight) -> Invariant:
    """Instants at which the controller refused its input, or found what it leads to not finite."""
    bad = (flight.status >= REFUSED) | ~np.isfinite(flight.energy)
    return Invariant("no state is refused", float(bad.sum()), 0.0)


def _of(values: Array, column: int) -> Array:
    """What a loop has, of columns (size, N) or (size, 1) that all share."""
    return values[:, column if values.shape[1] > 1 else 0]


def symmetric(upper: Sequence[float]) -> Array:
    """Upper triangle by rows, n(n+1)/2 numbers, to the matrix (n, n)."""
    n = int((np.sqrt(8 * len(upper) + 1) - 1) / 2 + 0.5)
    matrix = np.zeros((n, n))
    rows, columns = np.triu_indices(n)
    matrix[rows, columns] = matrix[columns, rows] = upper
    return matrix
