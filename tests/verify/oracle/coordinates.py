"""Coordinates of any group for the tests of its truth, and distances between them."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.oracle import matrix_truth

mp = matrix_truth.mp
TURNING = ("SO2", "SO3", "S3", "SE2", "SE3", "SE23")
NAMES = (*TURNING, "R1", "R3", "SE3 x R3", "SO3 x SO3", "S3 x SE2")
TINY = mp.mpf("1e-40")
AXES = {1: (mp.one,), 3: tuple(mp.mpf(x) / 7 for x in (2, -3, 6))}  # unit vectors
# The rotation's coordinates of each factor, and how many of translation there are per column.
PARTS = {"SO2": (1, 0, 0), "SO3": (3, 0, 0), "S3": (3, 0, 0), "SE2": (1, 2, 1), "SE3": (3, 3, 1),
         "SE23": (3, 3, 2), "R1": (0, 1, 1), "R3": (0, 3, 1)}  # fmt: skip


def blocks(name: str) -> list[int]:
    """Lengths of the coordinate blocks, each of one unit: rotation, then every column."""
    parts = (PARTS[one] for one in name.split(" x "))
    return [size for turn, width, count in parts for size in (turn, *(width,) * count) if size]


def pieces(name: str, x: Any) -> Iterator[tuple[Any, ...]]:
    left = list(x)
    assert sum(blocks(name)) == len(left)
    for size in blocks(name):
        yield tuple(left[:size])
        del left[:size]


def norm(x: Any) -> Any:
    return mp.sqrt(mp.fsum(mp.mpf(entry) ** 2 for entry in x))


def off(a: Any, b: Any) -> Any:
    """|a - b| / |b|, or |a| where b is 0."""
    return norm([x - y for x, y in zip(a, b, strict=True)]) / (norm(b) or 1)


def worst(name: str, a: Any, b: Any) -> Any:
    """The largest relative distance of any coordinate block."""
    pairs = zip(pieces(name, a), pieces(name, b), strict=True)
    return max(off(x, y) for x, y in pairs)


def draw(name: str, seed: int, count: int = 1) -> list[list[float]]:
    n = sum(blocks(name))
    return np.random.default_rng(seed).normal(size=(count, n)).tolist()  # type: ignore[no-any-return]


def at_angle(name: str, angle: Any, length: Any, seed: int = 1) -> list[Any]:
    """Coordinates with every rotation by that angle and translations of about that length."""
    x = []
    for one in name.split(" x "):
        turn, width, count = PARTS[one]
        x += [mp.mpf(angle) * entry for entry in AXES.get(turn, ())]
        shift = np.random.default_rng(seed).normal(size=width * count).tolist()
        x += [mp.mpf(length) * mp.mpf(entry) for entry in shift]
    return x


def matrix(rows: Any) -> Any:
    return mp.matrix([list(row) for row in rows])


def double(rows: Any) -> NDArray[np.float64]:
    return np.array([[float(entry) for entry in row] for row in rows])


def doubles(values: Any) -> list[float]:
    return [float(entry) for entry in values]


def spread(name: str, x: Any) -> Any:
    """Sum of x_i E_i as an mpmath matrix."""
    return sum((mp.mpf(s) * matrix(e) for s, e in zip(x, matrix_truth.basis(name), strict=True)),
               0 * matrix(matrix_truth.basis(name)[0]))  # fmt: skip
