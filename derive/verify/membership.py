"""What the guard's own numbers must be, exactly: distance from the group, pivots of an inertia."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

Row = Sequence[Fraction]


def residual(factors: Sequence[str], g: Row) -> tuple[list[Fraction], list[Fraction]] | None:
    """What vanishes on the group of its stored numbers: of those that turn, of the rows below.

    Of a rotation: the first columns a unit each and at right angles, the last their product. Of
    a quaternion: |q|^2 - 1. None for a factor that is not known, a user's group.
    """
    turn, below = list[Fraction](), list[Fraction]()
    start = 0
    for name in factors:
        if vectors := re.fullmatch(r"R([1-9]\d?)", name):
            start += int(vectors[1])
            continue
        if name not in _SIZES:
            return None
        size, whole = _SIZES[name]
        piece = g[start : start + (4 if name == "S3" else whole**2)]
        start += len(piece)
        turn += [_dot(piece, piece) - 1] if name == "S3" else _rotation(piece, size, whole)
        below += [] if name == "S3" else _below(piece, size, whole)
    return turn, below


_SIZES = {"SO2": (2, 2), "SO3": (3, 3), "S3": (4, 4), "SE2": (2, 3), "SE3": (3, 4), "SE23": (3, 5)}
"""Rows of the rotation and of the matrix."""


def _rotation(g: Row, size: int, whole: int) -> list[Fraction]:
    a, *others = [[g[i * whole + j] for i in range(size)] for j in range(size)]
    if size == 2:
        product, square = [-a[1], a[0]], [_dot(a, a) - 1]
    else:
        b = others[0]
        product = [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]
        square = [_dot(a, a) - 1, _dot(a, b), _dot(b, b) - 1]
    return [*square, *(x - y for x, y in zip(others[-1], product, strict=True))]


def _below(g: Row, size: int, whole: int) -> list[Fraction]:
    return [g[i * whole + j] - (i == j) for i in range(size, whole) for j in range(whole)]


def _dot(a: Row, b: Row) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))


def pivots(upper: Row, n: int) -> list[Fraction]:
    """Of an inertia, given as its upper triangle row by row: by elimination, without exchanges."""
    places = iter(upper)
    rows: list[list[Any]] = [[None] * n for _ in range(n)]
    for i in range(n):
        for j in range(i, n):
            rows[i][j] = rows[j][i] = next(places)
    found = []
    for k in range(n):
        found.append(rows[k][k])
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k], strict=True)]
    return found
