"""What the guard's own numbers must be, exactly: distance from the group, pivots of an inertia."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

Row = Sequence[Fraction]


def residual(factors: Sequence[str], g: Row) -> list[Fraction] | None:
    """Of each factor what its columns are off a rotation by, and the rows below; |q|^2 - 1.

    In space: a.a - 1, a.b, b.b - 1 and c - a x b of its columns a, b, c. In the plane: a.a - 1 and
    b - J a, J a quarter turn. None for a factor that is not known, a user's group.
    """
    found: list[Fraction] = []
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
        found += _quaternion(piece) if name == "S3" else _rigid(piece, size, whole)
    return found


_SIZES = {"SO2": (2, 2), "SO3": (3, 3), "S3": (4, 4), "SE2": (2, 3), "SE3": (3, 4), "SE23": (3, 5)}
"""Rows of the rotation and of the matrix."""


def _quaternion(q: Row) -> list[Fraction]:
    return [sum((x * x for x in q), Fraction(-1))]


def _rigid(g: Row, size: int, whole: int) -> list[Fraction]:
    rows = [list(g[i * whole : (i + 1) * whole]) for i in range(whole)]
    columns = [[rows[i][j] for i in range(size)] for j in range(size)]
    first, *others = columns
    found = [_dot(first, first) - 1]
    if size == 2:
        found += [x - y for x, y in zip(others[0], (-first[1], first[0]), strict=True)]
    else:
        second, last = others
        found += [_dot(first, second), _dot(second, second) - 1]
        found += [last[k] - _minor(first, second, k) for k in range(3)]
    below = [rows[i][j] - (i == j) for i in range(size, whole) for j in range(whole)]
    return [*found, *below]


def _dot(a: Row, b: Row) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))


def _minor(a: Row, b: Row, k: int) -> Fraction:
    """Entry k of a x b."""
    i, j = (k + 1) % 3, (k + 2) % 3
    return a[i] * b[j] - a[j] * b[i]


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
