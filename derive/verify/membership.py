"""What the guard's own numbers must be, exactly: distance from the group, pivots of an inertia."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from itertools import permutations
from typing import Any

Row = Sequence[Fraction]


def residual(factors: Sequence[str], g: Row) -> list[Fraction] | None:
    """Of each factor R^T R - 1 (upper triangle), det R - 1 and the rows below; |q|^2 - 1.

    None for a factor that is not known, a user's group.
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
    gram = [
        sum((a * b for a, b in zip(columns[i], columns[j], strict=True)), Fraction(-(i == j)))
        for i in range(size)
        for j in range(i, size)
    ]
    below = [rows[i][j] - (i == j) for i in range(size, whole) for j in range(whole)]
    return [*gram, determinant(columns) - 1, *below]


def determinant(a: Sequence[Row]) -> Fraction:
    """By Leibniz's sum, for the 2 or 3 rows there are."""
    total = Fraction(0)
    for order in permutations(range(len(a))):
        swaps = sum(x > y for i, x in enumerate(order) for y in order[i + 1 :])
        term = Fraction((-1) ** swaps)
        for i, j in enumerate(order):
            term *= a[i][j]
        total += term
    return total


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
