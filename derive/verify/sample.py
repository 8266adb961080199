"""The states on which emitted code is judged: an angle ladder, axes, and O(1) velocities.

Configurations are made with formulas of this file alone and then rounded to the scalar; the
truth is told of the rounded numbers.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

LADDER = (
    0.0, 1e-300, 1e-160, 1e-12, 1e-8, 1e-4, 1e-2, 0.1, 1.0, 2.0, 3.0,
    np.pi - 1e-2, np.pi - 1e-6, np.pi - 1e-9, np.pi - 1e-12, np.pi,
)  # fmt: skip
"""Rotation angles, rad, at which everything is measured."""

BEYOND = (3.5, 4.0, 5.0, 6.0, 2 * np.pi - 1e-2, 2 * np.pi - 1e-4, 2 * np.pi - 1e-6)
"""Further angles on S3, where a quaternion and its negative differ."""

REACH = {("SO3", "gibbs"): 2.0, ("S3", "mrp"): 5.0}
"""Largest angle, rad, for laws with a pole: up to there they amplify an input error by < 5."""

SMOOTH = {
    "SO3": ((0.3, 2.9),),
    "S3": ((0.3, 2.9), (3.4, 3.9)),
    ("SO3", "gibbs"): ((0.3, 1.1),),
    ("S3", "sign_vec"): ((0.3, 2.9),),
}
"""Angles, rad, at which derivatives are taken, by group or by law.

Away from zero, which hides errors in h; away from pi, where the kernel's polynomial ends and
its own slope, which a complex step sees, is at its worst; away from poles.
"""

DTYPES = {"f32": np.float32, "f64": np.float64}


@dataclass(frozen=True)
class States:
    """A batch of N states: g and g_r (N, k), nu, nu_r, nu_r_dot and force (N, 3); SI units.

    angle (N,) and axis (N, 3) say how the error was made.
    """

    angle: Array
    axis: Array
    g: Array
    nu: Array
    g_r: Array
    nu_r: Array
    nu_r_dot: Array

    def described(self, row: int) -> str:
        """The state in words, for a report."""
        axis = " ".join(f"{x:.2g}" for x in self.axis[row])
        nu = " ".join(f"{x:.2g}" for x in self.nu[row])
        return f"phi={self.angle[row]:.16g} n=({axis}) nu=({nu})"


def angles(group: str, law: str) -> tuple[float, ...]:
    """The ladder of a law, rad."""
    whole = LADDER + (BEYOND if group == "S3" else ())
    return tuple(angle for angle in whole if angle <= REACH.get((group, law), 7.0))


def smooth_angles(group: str, law: str, count: int, rng: np.random.Generator) -> Array:
    """Random angles for differences along the flow, rad, (count,)."""
    spans = np.array(SMOOTH.get((group, law), SMOOTH[group]))
    low, high = spans[rng.integers(len(spans), size=count)].T
    return np.asarray(rng.uniform(low, high))


def states(
    group: str, angle: Array, scalar: str, rng: np.random.Generator, *, is_moving: bool
) -> States:
    """One state per angle: axes and velocities random, with e1, e2, e3 among them.

    A moving reference is random, the other is the identity at rest.
    """
    count = len(angle)
    axis = _directions(rng, count)
    dtype = DTYPES[scalar]
    error = _element(group, angle, axis)
    if is_moving:
        turn = rng.uniform(0, np.pi, count)
        g_r = _element(group, turn, _directions(rng, count))
        g = _product(group, g_r, error)
    else:
        g_r, g = _element(group, np.zeros(count), axis), error
    scale = 1.0 if is_moving else 0.0
    nu = _directions(rng, count) * rng.uniform(0.5, 2.0, (count, 1))
    nu_r, nu_r_dot = rng.normal(size=(2, count, 3)) * scale
    stored = [np.asarray(x, dtype) for x in (g, nu, g_r, nu_r, nu_r_dot)]
    return States(angle, axis, *stored)


def ties(scalar: str, rng: np.random.Generator) -> States:
    """Exact rotations by pi at rest: 2 a a^T - 1 for axes a along edges and face diagonals."""
    edges = np.vstack([np.eye(3), -np.eye(3)])
    pairs = [(1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1)]
    whole = np.vstack([edges, pairs, -np.array(pairs)])
    square = (whole**2).sum(1)[:, None, None]
    g = 2 * whole[:, :, None] * whole[:, None, :] / square - np.eye(3)
    angle, dtype = np.full(len(whole), np.pi), DTYPES[scalar]
    at_rest = states("SO3", angle, scalar, rng, is_moving=False)
    return replace(at_rest, axis=whole / np.sqrt(square[:, 0]), g=g.reshape(-1, 9).astype(dtype))


def spread(ladder: tuple[float, ...], each: int) -> Array:
    """Every rung `each` times, rung by rung within a round, (len(ladder) * each,)."""
    return np.repeat(np.asarray(ladder), each)


def _directions(rng: np.random.Generator, count: int) -> Array:
    """Unit vectors, (count, 3): a quarter of them along plus or minus a coordinate axis."""
    unit = rng.normal(size=(count, 3))
    unit /= np.linalg.norm(unit, axis=1, keepdims=True)
    aligned = np.vstack([np.eye(3), -np.eye(3)])
    place = rng.integers(24, size=count)
    unit[place < 6] = aligned[place[place < 6]]
    return unit


def _element(group: str, angle: Array, axis: Array) -> Array:
    """Rotation by angle about axis as stored numbers, (N, k)."""
    half = np.asarray(angle)[:, None] / 2
    if group == "S3":
        return np.hstack([np.cos(half), np.sin(half) * axis])
    hat = cross_matrix(axis)
    turn = np.sin(2 * half)[..., None] * hat + 2 * np.sin(half)[..., None] ** 2 * (hat @ hat)
    return np.asarray(np.eye(3) + turn).reshape(-1, 9)


def _product(group: str, a: Array, b: Array) -> Array:
    """Products of stored elements, (N, k)."""
    if group == "S3":
        return hamilton(a, b)
    return (a.reshape(-1, 3, 3) @ b.reshape(-1, 3, 3)).reshape(-1, 9)


def cross_matrix(x: Array) -> Array:
    """x^, (N, 3, 3), of vectors (N, 3): x^ y = x times y."""
    zero = np.zeros_like(x[:, 0])
    rows = ((zero, -x[:, 2], x[:, 1]), (x[:, 2], zero, -x[:, 0]), (-x[:, 1], x[:, 0], zero))
    return np.stack([np.stack(row, -1) for row in rows], -2)


def hamilton(p: Array, q: Array) -> Array:
    """Quaternion products, scalar first, (N, 4)."""
    w = p[:, :1] * q[:, :1] - (p[:, 1:] * q[:, 1:]).sum(1, keepdims=True)
    return np.hstack([w, p[:, :1] * q[:, 1:] + q[:, :1] * p[:, 1:] + np.cross(p[:, 1:], q[:, 1:])])
