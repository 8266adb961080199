"""Truth over a batch: each number as a pair of doubles, so that an error of 0.01 eps shows.

Within 8 eps of the cut locus of a rotation either branch is right: there a row has two truths.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.branch import Turn, at_cut, clearance, rotations, turns
from derive.verify.limits import EPS
from derive.verify.natural import Natural, blocks_of
from derive.verify.oracle import baseline_truth, matrix_truth, truth
from derive.verify.plant import Plant
from derive.verify.sample import States
from derive.verify.shape import Block

__all__ = ["Pair", "Plant", "Truth", "plant", "reaching", "tracking"]

Array = NDArray[np.float64]
Pair = tuple[Array, Array]

POLES = ("log", "half_log", "mrp", "cayley")
"""Laws without a bound near -i."""

STATE = ("momentum", "external")
OUTPUTS = ("force", "s", "nu_u", "nu_u_dot")


@dataclass(frozen=True)
class Truth:
    """Outputs by name, (N, n) as high and low part, for each branch; the distance from the cut.

    scales: natural scale of an output where it is larger than its length, (N,) or (N, blocks)
    error:  the error of each row, to 130 digits: for each factor its element and its quaternion
    conditioning: what a relative error on the move counts: s towards a pole at -i, where the
            product q_r^-1 q itself rounds at eps/s; with the identity as reference it is exact
    blocks: of coordinates, each judged on its own scale; what has one number is judged whole
    """

    branches: tuple[dict[str, Pair], ...]
    scales: dict[str, Array]
    error: tuple[tuple[Turn, ...], ...] = ()
    conditioning: Array | float = 1.0
    blocks: tuple[Block, ...] = ()

    def errors(self, found: dict[str, NDArray[Any]]) -> dict[str, Array]:
        """|found - truth| / scale per row and output, on the branch whose law is nearer, (N,)."""
        each = [
            {name: self._one(name, np.asarray(value), branch) for name, value in found.items()
             if name in branch}
            for branch in self.branches
        ]  # fmt: skip
        first, second = each[0], each[-1]
        key = "nu_u" if "nu_u" in first else next(iter(first))
        nearer = second[key] < first[key]
        return {name: np.where(nearer, second[name], first[name]) for name in first}

    def first(self) -> Truth:
        """The same, with the deterministic branch alone counting as true."""
        return replace(self, branches=self.branches[:1])

    def _one(self, name: str, value: NDArray[Any], branch: dict[str, Pair]) -> Array:
        """The largest relative error of a block, (N,)."""
        high, low = branch[name]
        blocks = () if name == "clearance" else self.blocks
        with np.errstate(invalid="ignore", over="ignore"):
            off = block_lengths(blocks, (value.astype(np.float64) - high) - low)
        scale = block_scale(blocks, high, self.scales.get(name, 0.0))
        relative = off / np.where(scale > 0, scale, 1.0)
        return np.asarray(np.where(np.isnan(relative), np.inf, relative).max(-1))


def block_lengths(blocks: tuple[Block, ...], x: Array) -> Array:
    """Length of each block of (N, n), (N, blocks); of the whole where there are none, (N, 1)."""
    rows = [block.rows for block in blocks] or [slice(None)]
    return np.stack([np.linalg.norm(x[:, each], axis=-1) for each in rows], -1)


def block_scale(blocks: tuple[Block, ...], x: Array, given: Array | float) -> Array:
    """The same, or a scale where that is larger."""
    least = np.asarray(given)
    wide = least[:, None] if least.ndim == 1 else least
    return np.asarray(np.maximum(block_lengths(blocks, x), wide))


def tracking(vehicle: Plant, states: States, scalar: str) -> Truth:
    """Truth of the tracking law, eqs. (TckCtrl), (Ctrls2), (Ctrls3), on the stored numbers."""

    def one(row: int, flips: tuple[int, ...]) -> dict[str, Any]:
        at = _row(states, row, "g_r", "g", "nu", "nu_r", "nu_r_dot", *STATE)
        inertia, gains = vehicle.stored(scalar)
        if vehicle.is_baseline:
            name, given = vehicle.controller, vehicle.named_gains(scalar)
            return baseline_truth.tracking(name, inertia, given, *at, flip=bool(flips))
        numbers: Any = (vehicle.law, inertia, *gains, *at)
        if vehicle.is_attitude:
            return truth.tracking(vehicle.group, *numbers, flip=bool(flips))
        return matrix_truth.tracking(vehicle.space, *numbers, flips=flips)

    return _table(one, vehicle, states, scalar)


def reaching(vehicle: Plant, states: States, scalar: str) -> Truth:
    """Truth of the reaching law, eq. (Ctrl2)."""

    def one(row: int, flips: tuple[int, ...]) -> dict[str, Any]:
        at = _row(states, row, "g", "nu", *STATE)
        inertia, gains = vehicle.stored(scalar)
        numbers: Any = (vehicle.law, inertia, *gains, *at)
        if vehicle.is_attitude:
            return truth.reaching(vehicle.group, *numbers, flip=bool(flips))
        return matrix_truth.reaching(vehicle.space, *numbers, flips=flips)

    return _table(one, vehicle, states, scalar)


def at_rest(vehicle: Plant, states: States, scalar: str) -> Truth:
    """Truth of every law of the vehicle, with the identity at rest as reference."""
    run = tracking if vehicle.is_baseline else reaching
    return run(vehicle, states, scalar)


def turned(vehicle: Plant, states: States, scalar: str) -> Truth:
    """Truth of the law and its rate on the rotations alone, whatever they carry."""
    blocks = blocks_of(vehicle)
    turning = [block.kind == "turn" for block in blocks]

    def one(row: int, flips: tuple[int, ...] = ()) -> dict[str, Any]:
        g, nu = _row(states, row, "g", "nu")
        return rotations(vehicle, g, nu, flips)

    plain = [one(row) for row in range(len(states.angle))]
    cuts = [at_cut(found["turns"], EPS[scalar]) for found in plain]
    sides = [plain, [one(row, cut) if cut else plain[row] for row, cut in enumerate(cuts)]]
    branches = [
        {n: _pair([row[n] for row in side]) for n in ("nu_u", "nu_u_dot")} for side in sides
    ]
    sine = np.array([[turn.sine for turn in row["turns"]] for row in plain])
    natural = Natural(vehicle, states, sine, {})
    scales = {"nu_u": natural.value[:, turning], "nu_u_dot": natural.rate[:, turning]}
    judged = tuple(block for block in blocks if block.kind == "turn")
    error = tuple(row["turns"] for row in plain)
    return Truth(tuple(branches), scales, error, blocks=judged)


def plant(vehicle: Plant, states: States, force: NDArray[Any], scalar: str) -> Truth:
    """Truth of the acceleration under a force (N, n), eq. (EulerP)."""
    inertia = vehicle.stored(scalar)[0]

    def one(row: int) -> Any:
        nu, *extras = _row(states, row, "nu", *STATE)
        applied = [float(x) for x in force[row]]
        if vehicle.is_attitude:
            return truth.plant(inertia, nu, applied, *extras)
        return matrix_truth.plant(vehicle.space, inertia, nu, applied, *extras)

    rows = [one(row) for row in range(len(states.angle))]
    scale = Natural(vehicle, states, np.zeros((0, 0)), {}).acceleration(force)
    return Truth(({"nu_dot": _pair(rows)},), {"nu_dot": scale}, blocks=blocks_of(vehicle))


def _table(
    one: Callable[[int, tuple[int, ...]], dict[str, Any]],
    vehicle: Plant,
    states: States,
    scalar: str,
) -> Truth:
    plain = [one(row, ()) for row in range(len(states.angle))]
    at = [turns(vehicle, found) for found in plain]
    other = list(plain)
    for row, error in enumerate(at):
        if flips := at_cut(error, EPS[scalar]):
            other[row] = one(row, flips)
    branches = [_pairs(vehicle, rows) for rows in (plain, other)]
    outputs: dict[str, Array] = {
        name: np.array([[float(x) for x in row[name]] for row in plain])
        for name in ("nu_u", "nu_u_dot", "nu_e", "eta_dot")
        if name in plain[0]
    }
    sine = np.array([[turn.sine for turn in error] for error in at])
    scales = Natural(vehicle, states, sine, outputs).scales()
    has_pole = "S3" in vehicle.factors and vehicle.law in POLES
    conditioning = branches[0]["clearance"][0][:, 0] if has_pole else 1.0
    scales["clearance"] = np.ones(len(plain))
    return Truth(tuple(branches), scales, tuple(at), conditioning, blocks_of(vehicle))


def _pairs(vehicle: Plant, rows: list[dict[str, Any]]) -> dict[str, Pair]:
    found = {name: _pair([row[name] for row in rows]) for name in OUTPUTS if name in rows[0]}
    off = [(clearance(vehicle, turns(vehicle, row)),) for row in rows]
    return found | {"clearance": _pair(off)}


def _row(states: States, row: int, *names: str) -> list[list[float]]:
    return [[float(x) for x in getattr(states, name)[row]] for name in names]


def _pair(rows: list[Any]) -> Pair:
    high = np.array([[float(x) for x in row] for row in rows])
    low = np.array([[float(x - float(x)) for x in row] for row in rows])
    return high, low
