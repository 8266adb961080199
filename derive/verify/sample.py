"""The states on which emitted code is judged: ladders of angles and lengths, O(1) velocities.

Configurations are made with formulas of this folder alone and then rounded to the scalar; the
truth is told of the rounded numbers.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.plant import DTYPES, Plant
from derive.verify.shape import Shape, cross_matrix, expm, space

Array = NDArray[Any]

LADDER = (
    0.0, 1e-300, 1e-160, 1e-12, 1e-8, 1e-4, 1e-2, 0.1, 1.0, 2.0, 3.0,
    np.pi - 1e-2, np.pi - 1e-6, np.pi - 1e-9, np.pi - 1e-12, np.pi,
)  # fmt: skip
"""Rotation angles, rad, at which everything is measured."""

BEYOND = (3.5, 4.0, 5.0, 6.0, 2 * np.pi - 1e-2, 2 * np.pi - 1e-4, 2 * np.pi - 1e-6)
"""Further angles on S3, where a quaternion and its negative differ."""

LENGTHS = (1e-6, 1.0, 1e6)
"""Lengths of a translation, m, at which everything is measured; a control takes no larger."""

MODERATE = (0.0, 1e-12, 1e-8, 1e-4, 1e-2, 0.1, 0.5, 1.0)
"""Norms of hat(x), of which exp is taken on a user's group."""

POLES = {"gibbs": 2.0, "cayley": 2.0}
REACH = {("S3", "mrp"): 5.0, ("S3", "cayley"): 5.0}
"""Largest angle, rad, for laws with a pole: up to there they amplify an input error by < 5."""

SMOOTH = {"S3": ((0.3, 2.9), (3.4, 3.9)), ("S3", "sign_vec"): ((0.3, 2.9),)}
"""Angles, rad, at which derivatives are taken, by factor or by its law.

Away from zero, which hides errors in h; away from pi, where the kernel's polynomial ends and
its own slope, which a complex step sees, is at its worst; away from poles.
"""

LOADS = (1e-3, 1e5)
"""Smallest and largest momentum or external force: as large as the inertia, within these."""


@dataclass(frozen=True)
class States:
    """A batch of N states: g and g_r (N, k), all others (N, n); SI units.

    angle (N,) and axis (N, …) say how the error of one factor was made, which takes its turn.
    """

    angle: Array
    axis: Array
    g: Array
    nu: Array
    g_r: Array
    nu_r: Array
    nu_r_dot: Array
    momentum: Array
    external: Array

    def described(self, row: int) -> str:
        """The state in words, for a report."""
        axis = " ".join(f"{x:.2g}" for x in self.axis[row])
        nu = " ".join(f"{x:.2g}" for x in self.nu[row])
        return f"phi={self.angle[row]:.16g} n=({axis}) nu=({nu})"


def reach(factor: str, law: str) -> float:
    """Largest angle of a factor, rad."""
    if factor == "S3":
        return REACH.get((factor, law), 7.0)
    return POLES.get(law, 3.2)


def angles(vehicle: Plant) -> tuple[float, ...]:
    """The ladder of a vehicle: of its factors the one that goes on longest."""
    if vehicle.own is not None:
        return MODERATE
    turning = [name for name in vehicle.factors if not name.startswith("R")]
    longest = max((reach(name, vehicle.law) for name in turning), default=0.0)
    return tuple(angle for angle in LADDER + BEYOND if angle <= longest)


def smooth_angles(vehicle: Plant, count: int, rng: np.random.Generator) -> Array:
    """Random angles for differences along the flow, rad, (count,)."""
    first = vehicle.factors[0]
    plain = ((0.3, 1.1),) if vehicle.law in POLES or vehicle.own else ((0.3, 2.9),)
    known = SMOOTH.get(first, plain) if len(vehicle.factors) == 1 else plain
    spans = np.array(SMOOTH.get((first, vehicle.law), known))
    low, high = spans[rng.integers(len(spans), size=count)].T
    return np.asarray(rng.uniform(low, high))


def states(
    vehicle: Plant,
    angle: Array,
    scalar: str,
    rng: np.random.Generator,
    *,
    is_moving: bool,
    lengths: tuple[float, ...] = LENGTHS,
) -> States:
    """One state per angle: axes and velocities random, with unit vectors among them.

    A moving reference is random, the other is the identity at rest. The factors take the angle
    in turn, the others then have one of at most 1.1 rad; lengths are taken in turn too.
    """
    count, group, dtype = len(angle), space(vehicle.space), DTYPES[scalar]
    share = 0.6 if is_moving else 1.0  # so that g, a product, is not longer than the longest
    error, axis, angle = _errors(vehicle, angle, rng, tuple(share * x for x in lengths))
    still = [np.broadcast_to(np.eye(a.shape[-1]), a.shape) for a in error]
    g_r, g = still, error
    if is_moving:
        turns = rng.uniform(0, np.pi, count)
        shorter = tuple(0.3 * x for x in lengths)
        places = enumerate(group.shapes, start=1)
        g_r = [_random(one, turns, shorter, place, rng) for place, one in places]
        g = [a @ b for a, b in zip(g_r, error, strict=True)]
    nu = directions(rng, count, group.dim) * rng.uniform(0.5, 2.0, (count, 1))
    nu_r, nu_r_dot = rng.normal(size=(2, count, group.dim)) * (1.0 if is_moving else 0.0)
    load = float(np.clip(np.linalg.norm(vehicle.stored("f64")[0], 2), *LOADS))
    extras = [
        rng.normal(size=(count, group.dim)) * load * (name in vehicle.options)
        for name in ("momentum", "external")
    ]
    kept = (group.kept(g), nu, group.kept(g_r), nu_r, nu_r_dot, *extras)
    return States(angle, axis, *(np.asarray(x, dtype) for x in kept))


def _errors(
    vehicle: Plant, angle: Array, rng: np.random.Generator, lengths: tuple[float, ...]
) -> tuple[list[Array], Array, Array]:
    """The error, one matrix per factor; axis and angle of the factor whose turn it is, (N, …)."""
    group, count = space(vehicle.space), len(angle)
    places = [i for i, one in enumerate(group.shapes) if not one.is_vector]
    turning = {place: turn for turn, place in enumerate(places)}
    found, axis, angles = [], np.zeros((count, 3)), np.array(angle, float)
    for place, (name, one) in enumerate(zip(vehicle.factors, group.shapes, strict=True)):
        mine = np.arange(count) % max(1, len(turning)) == turning.get(place, -1)
        limit = np.inf if one.is_own else reach(name, vehicle.law)
        turn = np.where(mine & (angle <= limit), angle, rng.uniform(0.3, 1.1, count))
        angles = np.where(mine, turn, angles)
        about = _planar(one, directions(rng, count, len(one.basis) if one.is_own else 3))
        found.append(_matrix(one, turn, about, _shifts(one, lengths, place, rng, count)))
        axis = about if one.is_own else np.where(mine[:, None], about, axis)
    return found, axis, angles


def _random(
    one: Shape, turn: Array, lengths: tuple[float, ...], place: int, rng: np.random.Generator
) -> Array:
    """Elements of a reference."""
    about = _planar(one, directions(rng, len(turn), len(one.basis) if one.is_own else 3))
    turn = rng.uniform(0, 1, len(turn)) if one.is_own else turn
    return _matrix(one, turn, about, _shifts(one, lengths, place, rng, len(turn)))


def _planar(one: Shape, axis: Array) -> Array:
    """In the plane there are two axes."""
    if one.turns != 1:
        return axis
    return np.asarray(np.where(axis[:, 2:] < 0, -1.0, 1.0) * np.array([0.0, 0.0, 1.0]))


def _shifts(
    one: Shape, lengths: tuple[float, ...], place: int, rng: np.random.Generator, count: int
) -> Array:
    """Translations (N, size, columns), whose lengths take turns, slower than the factors."""
    columns = [
        directions(rng, count, one.size) if one.columns else np.zeros((count, one.size))
        for _ in range(one.columns)
    ]
    if not columns:
        return np.zeros((count, one.size, 0))
    which = (np.arange(count)[:, None] // 2 + place + np.arange(one.columns)) % len(lengths)
    return np.asarray(np.stack(columns, -1) * np.array(lengths)[which][:, None, :])


def _matrix(one: Shape, angle: Array, axis: Array, shifts: Array) -> Array:
    """Rotation by angle about axis, and translations, as matrices (N, m, m)."""
    if one.is_own:
        hat = one.hat(axis)
        length = np.linalg.norm(hat, 2, axis=(1, 2))
        return expm(hat * (angle / length)[:, None, None])
    m = one.basis.shape[-1]
    g = np.tile(np.eye(m), (len(angle), 1, 1))
    half = np.asarray(angle)[:, None] / 2
    if one.is_half:
        return one.matrix(np.hstack([np.cos(half), np.sin(half) * axis]))
    if one.turns:
        hat = cross_matrix(axis)
        turn = np.sin(2 * half)[..., None] * hat + 2 * np.sin(half)[..., None] ** 2 * (hat @ hat)
        g[:, : one.size, : one.size] = (np.eye(3) + turn)[:, : one.size, : one.size]
    g[:, : one.size, one.size :] = shifts
    return g


def ties(vehicle: Plant, scalar: str, rng: np.random.Generator) -> States:
    """Exact rotations by pi at rest: 2 a a^T - 1 for axes a along edges and face diagonals."""
    edges = np.vstack([np.eye(3), -np.eye(3)])
    pairs = [(1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1)]
    whole = np.vstack([edges, pairs, -np.array(pairs)])
    square = (whole**2).sum(1)[:, None, None]
    R = 2 * whole[:, :, None] * whole[:, None, :] / square - np.eye(3)
    angle, group = np.full(len(whole), np.pi), space(vehicle.space)
    at_rest = states(vehicle, angle, scalar, rng, is_moving=False)
    g = group.matrices(at_rest.g.astype(np.float64))
    for one, a in zip(group.shapes, g, strict=True):
        if one.turns and not one.is_half:
            a[:, : one.size, : one.size] = R if one.size == 3 else -np.eye(2)
    axis, kept = whole / np.sqrt(square[:, 0]), group.kept(g).astype(DTYPES[scalar])
    return replace(at_rest, axis=axis, g=kept)


def spread(ladder: tuple[float, ...], each: int) -> Array:
    """Every rung `each` times, rung by rung within a round, (len(ladder) * each,)."""
    return np.repeat(np.asarray(ladder), each)


def directions(rng: np.random.Generator, count: int, n: int) -> Array:
    """Unit vectors, (count, n): a quarter of them along plus or minus a coordinate axis."""
    unit = rng.normal(size=(count, n))
    unit /= np.linalg.norm(unit, axis=1, keepdims=True)
    aligned = np.vstack([np.eye(n), -np.eye(n)])
    place = rng.integers(8 * n, size=count)
    unit[place < 2 * n] = aligned[place[place < 2 * n]]
    return unit
