"""States of any group over angles and translations, and the truth of their logarithm and rate.

Truth comes from matrix functions with 130 digits, of the stored numbers as they were rounded.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.oracle import matrix_truth as truth
from derive.verify.oracle.matrix_factor import factors

Array = NDArray[Any]
Numbers = Sequence[Any]
Pair = tuple[Array, Array]
"""A number as the sum of two doubles, (N, n) each: 32 digits of the truth."""

ANGLES = (
    *(0.0, 1e-300, 1e-12, 1e-8, 1e-6, 1e-4, 1e-2, 0.1, 0.5, 1.0, 2.0, 3.0),
    *(np.pi - 1e-2, np.pi - 1e-4, np.pi - 1e-6),
)
LENGTHS = (1e-6, 1e-3, 1.0, 1e3, 1e6)
FEW = 3
SCALAR = {"f32": np.float32, "f64": np.float64}


@dataclass(frozen=True)
class Block:
    """Coordinates that are judged together; column is that of a translation, None of a turn."""

    factor: int
    rows: slice
    turn: slice | None
    column: int | None

    @property
    def name(self) -> str:
        """Rotation or translation."""
        return "rotation" if self.column is None else "translation"


def blocks(name: str) -> Iterator[Block]:
    """Rotation, then every column of translation, factor by factor."""
    start = 0
    for i, one in enumerate(factors(name)):
        turn = slice(start, start + len(one.turns)) if one.turns else None
        if turn:
            yield Block(i, turn, turn, None)
        start += len(one.turns)
        for column in range(one.columns):
            yield Block(i, slice(start, start + one.size), turn, column)
            start += one.size


@dataclass(frozen=True)
class States:
    """N states in a scalar, and what is true of them.

    x: (N, n) that g was made of; g: (N, k); nu: (N, n); lengths: of each block's translation,
    (N, blocks); log and rate: the truth
    """

    x: Array
    g: Array
    nu: Array
    lengths: Array
    log: Pair
    rate: Pair


def _direction(random: np.random.Generator, size: int) -> Array:
    x = random.normal(size=size)
    return np.asarray(x / np.linalg.norm(x))


def _drawn(name: str, angle: float, length: float, random: np.random.Generator) -> Pair:
    """Coordinates with that angle and length in every block, and a velocity of mixed size."""
    parts = list(blocks(name))
    x, nu = (np.zeros(parts[-1].rows.stop) for _ in range(2))
    for one in parts:
        size = one.rows.stop - one.rows.start
        x[one.rows] = _direction(random, size) * (angle if one.column is None else length)
        scale = 1.0 if one.column is None else length ** random.uniform(-1, 1)
        nu[one.rows] = random.normal(size=size) * scale
    return x, nu


def _ladder(name: str, each: int) -> Iterator[tuple[float, float]]:
    """Every angle with every length `each` times; a few times where there is only one of them."""
    kinds = {one.name for one in blocks(name)}
    lengths = LENGTHS if "translation" in kinds else (1.0,) * FEW
    angles = ANGLES if "rotation" in kinds else (0.0,) * FEW
    return ((a, p) for a in angles for p in lengths for _ in range(each))


def states(
    name: str, scalar: str, each: int, tell: Callable[[str], None] = lambda _: None
) -> States:
    """States of a group, `each` for every angle and length."""
    random, kind = np.random.default_rng([each, *name.encode()]), SCALAR[scalar]
    ladder, rows = list(_ladder(name, each)), []
    for count, (angle, length) in enumerate(ladder):
        tell(f"{name} {scalar}: truth of state {count + 1} of {len(ladder)}")
        x, nu = _drawn(name, angle, length, random)
        g = truth.store(name, truth.exp(name, x.tolist()))
        stored, speed = (np.array([float(v) for v in each], kind) for each in (g, nu))
        rows.append((x, stored, speed, *_judged(name, stored.tolist(), speed.tolist())))
    columns: list[Any] = list(zip(*rows, strict=True))
    xs, elements, speeds, lengths = map(np.array, columns[:4])
    return States(xs, elements, speeds, lengths, _pair(columns[4]), _pair(columns[5]))


def _judged(name: str, stored: Numbers, nu: Numbers) -> tuple[list[float], Numbers, Numbers]:
    """Lengths of the translations, logarithm and rate of the stored element."""
    g, parts = truth.element(name, stored), factors(name)
    lengths = []
    for one in blocks(name):
        _, columns = parts[one.factor].parts(g[one.factor])
        lengths.append(0.0 if one.column is None else _length(columns, one.column))
    return lengths, truth.log(name, g), truth.rate(name, g, nu)


def _length(columns: Sequence[Sequence[Any]], column: int) -> float:
    return float(np.linalg.norm([float(row[column]) for row in columns]))


def _pair(rows: Sequence[Sequence[Any]]) -> Pair:
    high = np.array([[float(x) for x in row] for row in rows])
    low = [[float(x - h) for x, h in zip(row, head, strict=True)]
           for row, head in zip(rows, high.tolist(), strict=True)]  # fmt: skip
    return high, np.array(low)
