"""Exact points of every group and the laws of quaternions, written for the tests alone."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np

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

PRODUCTS: dict[str, Callable[[Any, Any], list[Any]]] = {
    "SO3": lambda a, b: list((np.reshape(a, (3, 3)) @ np.reshape(b, (3, 3))).ravel()),
    "S3": lambda a, b: list(hamilton(a, b)),
}
"""Group name -> product of stored elements."""
