"""Elements of any group in double, in its storage, by textbook formulas and scipy's exponential."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm

from derive.control.kinematic import laws_of
from derive.lie.group import Group
from tests.control.drawn import HALF_TURNS
from tests.groups import BASES, TURNED
from tests.points import hat, rows

Array = NDArray[np.float64]
PI = np.pi
AXES = tuple(np.array(axis, float) for axis in ([1, 0, 0], [0, 1, 0], [0, 0, 1], [1, -2, 3]))
NOWHERE = ("skew", "vec")


def rotation(axis: Array, angle: float) -> Array:
    """Rotation matrix by Rodrigues' formula."""
    x, y, z = axis / np.linalg.norm(axis)
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K)


def plane(_: Array, angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s], [s, c]])


def quaternion(axis: Array, angle: float) -> Array:
    """Unit quaternion, scalar first."""
    unit = axis / np.linalg.norm(axis)
    return np.concatenate(([np.cos(angle / 2)], np.sin(angle / 2) * unit))


def parts(group: Group) -> tuple[Group, ...]:
    return group.factors or (group,)


def turner(group: Group) -> int | None:
    """The first factor in which something turns."""
    turns = (i for i, one in enumerate(parts(group)) if one.name in HALF_TURNS)
    return next(turns, None)


def element(group: Group, axis: Array, angle: float, seed: int = 0) -> Array:
    """Stored numbers (k,): the first factor that can turns by the angle, the rest is drawn."""
    random, first = np.random.default_rng(seed), turner(group)
    pieces = [
        _one(one, axis, angle if first in (i, None) else angle / 8, random)
        for i, one in enumerate(parts(group))
    ]
    return np.concatenate(pieces)


def _one(group: Group, axis: Array, angle: float, random: np.random.Generator) -> Array:
    if group.name == "S3":
        return quaternion(axis, angle)
    if group.name in TURNED and group.name not in BASES:
        size = TURNED[group.name]
        return _moved(group, (rotation if size == 3 else plane)(axis, angle), random)
    if group.name in HALF_TURNS:
        X = np.array(hat(group, HALF_TURNS[group.name]), float)
        turn = np.eye(len(X)) + np.sin(angle) * X + (1 - np.cos(angle)) * X @ X
        return np.asarray(turn.ravel())
    drawn = random.normal(size=group.dim)
    if len(group.shape) == 1:
        return angle * drawn
    return np.asarray(expm(angle * np.array(hat(group, drawn.tolist()), float) / 3).ravel())


def _moved(group: Group, turn: Array, random: np.random.Generator) -> Array:
    """A rotation in the corner, translations beside it, the last rows those of 1."""
    g, size = np.eye(group.basis[0].rows), len(turn)
    g[:size, :size], g[:size, size:] = turn, random.normal(size=g[:size, size:].shape)
    return np.asarray(g.ravel())


def velocity(group: Group, g: Array, nu: Array) -> Array:
    """The rate of the stored numbers, g hat(nu) in the group's storage; one row each."""
    numbers, speeds = (
        _cut(g, [one.size for one in parts(group)]),
        _cut(nu, [one.dim for one in parts(group)]),
    )
    pieces = zip(parts(group), numbers, speeds, strict=True)
    return np.concatenate([_velocity(one, a, x) for one, a, x in pieces])


def _velocity(one: Group, g: Array, nu: Array) -> Array:
    if one.name == "S3":
        w, v = g[0], g[1:]
        return np.concatenate([[-v @ nu], w * nu + np.cross(v, nu)]) / 2
    if len(one.shape) == 1:
        return nu
    m = one.basis[0].rows
    flow = sum(x * np.array(e, float) for x, e in zip(nu, rows(one), strict=True))
    return np.asarray((g.reshape(m, m) @ flow).ravel())


def _cut(values: Array, sizes: Sequence[int]) -> list[Array]:
    return np.split(values, np.cumsum(sizes)[:-1])


def cut(group: Group, law: str) -> tuple[float, bool] | None:
    """The angle of `element` at which a law jumps, and whether it has no bound there."""
    first = turner(group)
    if first is None or law in NOWHERE:
        return None
    is_far = parts(group)[first].name == "S3" and law != "sign_vec"
    return (2 * PI if is_far else PI), laws_of(group)[law].is_pole


def away(group: Group, law: str, clearance: float) -> float:
    """How far, as an angle, an element of that small clearance is from the cut.

    The clearance is the cosine or sine of half the angle; |det(g + 1)|/2^m is its square.
    """
    first = parts(group)[turner(group) or 0]
    is_square = law == "cayley" and first.name in BASES
    return float(2 * np.sqrt(clearance) if is_square else 2 * clearance)


def at_cut(group: Group, law: str) -> list[Array]:
    """Elements exactly at the cut, free of rounding; other factors at the identity."""
    first, found = turner(group), cut(group, law)
    if first is None or found is None:
        return []
    pieces: list[Any] = [np.array(one.identity, float) for one in parts(group)]
    return [
        np.concatenate([*pieces[:first], row, *pieces[first + 1 :]])
        for row in _ends(parts(group)[first], found[0])
    ]


def _ends(one: Group, angle: float) -> list[Array]:
    if one.name == "S3":
        far, near = [[-1.0, 0, 0, 0]], [[0, 1.0, 0, 0], [0, 0, 0, -1.0]]
        return [np.array(row) for row in (far if angle > 4 else near)]
    if one.name in HALF_TURNS and one.name in BASES:
        X = np.array(hat(one, HALF_TURNS[one.name]), float)
        return [np.asarray((np.eye(len(X)) + 2 * X @ X).ravel())]
    swap = np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]])
    turns = [np.diag([1.0, -1, -1]), np.diag([-1.0, -1, 1]), swap]
    turns = turns if TURNED[one.name] == 3 else [-np.eye(2)]
    return [_moved(one, turn, np.random.default_rng(1)) for turn in turns]


def is_compact(group: Group) -> bool:
    """Whether every element is a rotation or a unit quaternion, which no factor can stretch."""
    return all(one.name in ("S3", "SO2", "SO3") for one in parts(group))


def grows(group: Group) -> list[int]:
    """Places of translations and of coordinates of R^n, which an element may have of any size."""
    found, start = list[int](), 0
    for one in parts(group):
        size = TURNED.get(one.name) if one.name not in BASES else None
        if len(one.shape) == 1 and one.name != "S3":
            found += range(start, start + one.size)
        elif size:
            m = one.basis[0].rows
            found += [start + i * m + j for i in range(size) for j in range(size, m)]
        start += one.size
    return found


def mirrors(group: Group, g: Array) -> list[Array]:
    """Each factor that is a rotation reflected in its first axis."""
    found, start = [], 0
    for one in parts(group):
        if size := TURNED.get(one.name):
            m = one.basis[0].rows
            part = g[start : start + one.size].reshape(m, m).copy()
            part[:size, 0] *= -1
            found.append(np.concatenate([g[:start], part.ravel(), g[start + one.size :]]))
        start += one.size
    return found
