"""Exact points of every group and the laws of quaternions, written for the tests alone."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from random import Random
from typing import Any

import numpy as np

from derive.lie.group import Group

Row = tuple[Fraction, ...]


def vector(rng: Random, size: int = 3) -> Row:
    """Rational numbers between -2 and 2."""
    return tuple(Fraction(rng.randint(-14, 14), 7) for _ in range(size))


def unit(x: Sequence[Any]) -> Row:
    """Rational point of S3, by stereographic projection from -i; w < 0 where |x| > 1."""
    row = [Fraction(a) for a in x]
    square = sum((a * a for a in row), Fraction(0))
    return tuple(a / (1 + square) for a in (1 - square, *(2 * a for a in row)))


def hamilton(p: Any, q: Any) -> Any:
    """Quaternion product, scalar first, i j = k; (4,) each, of any kind of number."""
    p, q = np.ravel(p), np.ravel(q)
    w = p[0] * q[0] - p[1:].dot(q[1:])
    return np.array([w, *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])


def conjugate(q: Any) -> Any:
    """The inverse of a unit quaternion."""
    return np.array([q[0], *(-x for x in q[1:])])


def rotation(q: Sequence[Any]) -> Any:
    """Rotation matrix (3, 3) of a unit quaternion: its columns are q e_i q^-1."""
    images = [hamilton(hamilton(q, (0, *row)), conjugate(q))[1:] for row in np.eye(3, dtype=int)]
    return np.array(images).T


STORED: dict[str, Callable[[Sequence[Any]], list[Any]]] = {
    "SO3": lambda q: list(rotation(q).ravel()),
    "S3": list,
}
"""Group name -> stored numbers of the element above a unit quaternion."""


# Any group: exact elements, as matrices of fractions in rows of numpy objects.


def exact(value: Any) -> Fraction:
    """A rational of sympy, an integer or a fraction, as a fraction."""
    return Fraction(int(value.numerator), int(value.denominator))


@cache
def rows(group: Group) -> list[Any]:
    """The basis of a group, (m, m) each, in fractions."""
    m = group.basis[0].rows
    return [np.array([exact(x) for x in e], object).reshape(m, m) for e in group.basis]


def eye(size: int) -> Any:
    return np.array([[Fraction(i == j) for j in range(size)] for i in range(size)], object)


def solve(a: Any, b: Any) -> Any:
    """a^-1 b by elimination, exactly; ZeroDivisionError where a is singular."""
    whole, size = np.concatenate([a, b], axis=1) * Fraction(1), len(a)
    for k in range(size):
        pivot = next((i for i in range(k, size) if whole[i, k]), k)
        whole[[k, pivot]] = whole[[pivot, k]]
        whole[k] = whole[k] / whole[k, k]
        for i in range(size):
            if i != k:
                whole[i] = whole[i] - whole[i, k] * whole[k]
    return whole[:, size:]


def inverse(a: Any) -> Any:
    return solve(a, eye(len(a)))


def hat(group: Group, x: Sequence[Any]) -> Any:
    """sum x_i E_i of fractions."""
    return sum((Fraction(a) * e for a, e in zip(x, rows(group), strict=True)), 0 * rows(group)[0])


def vee(group: Group, a: Any) -> Any:
    """Coordinates of a matrix of the algebra, by the normal equations; AssertionError elsewhere."""
    found, is_exact = _fitted(group, a)
    assert is_exact
    return found


def is_in_algebra(group: Group, a: Any) -> bool:
    """Whether a is a sum of multiples of the E_i."""
    return _fitted(group, a)[1]


def _fitted(group: Group, a: Any) -> tuple[Any, bool]:
    stacked = np.stack([e.ravel() for e in rows(group)], axis=1)
    found = solve(stacked.T @ stacked, (stacked.T @ a.ravel())[:, None])[:, 0]
    return found, not (stacked @ found - a.ravel()).any()


def element(group: Group, rng: Random, far: bool = True) -> Any:
    """A product of Cayley's images of multiples of each E_i: exact, and on the group.

    Each image turns by at most a radian; a far element is the product of several.
    """
    g = one = eye(group.basis[0].rows)
    for _ in range(rng.choice((1, 3)) if far else 1):
        for x, e in zip(vector(rng, group.dim), rows(group), strict=True):
            half = x / 4 * e
            g = g @ solve(one - half, one + half)
    return g


def stored(group: Group, g: Any) -> list[Any]:
    """What is kept of an element, by the conventions: see design and docs/conventions.md."""
    if group.factors:
        pairs = zip(group.factors, _blocks(group, g), strict=True)
        return [x for one, block in pairs for x in stored(one, block)]
    if group.name == "S3":
        return list(g[:, 0])
    if group.name[0] == "R" and group.name[1:].isdigit():
        return list(g[:-1, -1])
    return list(g.ravel())


def _blocks(group: Group, g: Any) -> list[Any]:
    """The diagonal blocks of the factors."""
    sizes = [one.basis[0].rows for one in group.factors]
    starts = [sum(sizes[:i]) for i in range(len(sizes))]
    return [g[a : a + m, a : a + m] for a, m in zip(starts, sizes, strict=True)]


def embedded(group: Group, numbers: Sequence[Any]) -> Any:
    """Stored numbers, of any kind, as the matrix they stand for."""
    if group.factors:
        return _diagonal(group, numbers)
    if group.name == "S3":
        return np.stack([hamilton(numbers, e) for e in np.eye(4, dtype=int)], axis=1)
    m = group.basis[0].rows
    if group.name[0] == "R" and group.name[1:].isdigit():
        g = eye(m)
        g[:-1, -1] = list(numbers)
        return g
    return np.array(list(numbers), object).reshape(m, m)


def _diagonal(group: Group, numbers: Sequence[Any]) -> Any:
    size = group.basis[0].rows
    g, before, start = np.zeros((size, size), int).astype(object), 0, 0
    for one in group.factors:
        m, piece = one.basis[0].rows, numbers[start : start + one.size]
        g[before : before + m, before : before + m] = embedded(one, piece)
        before, start = before + m, start + one.size
    return g


def point(group: Group, rng: Random) -> list[Any]:
    """Stored numbers of an exact element, far from the identity as often as near."""
    return stored(group, element(group, rng))
