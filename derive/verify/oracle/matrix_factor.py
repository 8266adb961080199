"""The groups that are no products, with 130 digits and written from the conventions alone.

All are matrices [[B, T], [0, 1]] with B orthogonal: in R^n B is 1, and a quaternion is its left
product. Coordinates are those of B, the rotation, then T column by column.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import chain

from derive.verify.oracle.matrix_function import (
    Matrix,
    Number,
    Vector,
    combine,
    identity,
    orthogonal_nearest,
    product,
    transpose,
)
from derive.verify.oracle.precise import mp

Entries = dict[tuple[int, int], Number]


@dataclass(frozen=True)
class Factor:
    """Matrices [[B, T], [0, 1]], (m, m), with an n-dimensional algebra, kept as k numbers.

    size:    of B
    columns: of T
    turns:   generators of B, (size, size) each
    embed:   k stored numbers to rows, as they are
    store:   matrix to k stored numbers
    stored:  k
    sheets:  1 where B turns by the angle of rotation, 2 where by half of it
    axes:    directions of B that no single rotation moves
    """

    size: int
    columns: int
    turns: tuple[Matrix, ...]
    embed: Callable[["Factor", Vector], Matrix]
    store: Callable[["Factor", Matrix], Vector]
    stored: int
    sheets: int = 1
    axes: int = 0

    @cached_property
    def whole(self) -> int:
        """m, size of the matrices."""
        return self.size + self.columns

    @cached_property
    def basis(self) -> tuple[Matrix, ...]:
        """The n generators, (m, m) each: the turns, then one per entry of T."""
        units = [(i, self.size + j) for j in range(self.columns) for i in range(self.size)]
        turns = (_matrix(self.whole, dict(_nonzero(turn))) for turn in self.turns)
        return (*turns, *(_matrix(self.whole, {at: mp.one}) for at in units))

    @property
    def dim(self) -> int:
        """n, dimension of the algebra."""
        return len(self.basis)

    def hat(self, x: Sequence[Number]) -> Matrix:
        """Coordinates (n,) to sum x_i E_i, (m, m)."""
        return combine(*zip(x, self.basis, strict=True))

    def vee(self, a: Matrix) -> Vector:
        """Coordinates (n,) of a: the E_i are orthogonal, and what is no sum of them is dropped."""
        return tuple(
            mp.fsum(weight * a[i][j] for (i, j), weight in weights) for weights in self._weights
        )

    @cached_property
    def _weights(self) -> list[list[tuple[tuple[int, int], Number]]]:
        entries = [list(_nonzero(each)) for each in self.basis]
        squares = [mp.fsum(value**2 for _, value in each) for each in entries]
        return [
            [(at, value / square) for at, value in each]
            for each, square in zip(entries, squares, strict=True)
        ]

    def parts(self, a: Matrix) -> tuple[Matrix, Matrix]:
        """B (size, size) and T (size, columns)."""
        upper = a[: self.size]
        return tuple(row[: self.size] for row in upper), tuple(row[self.size :] for row in upper)

    def joined(self, block: Matrix, columns: Matrix) -> Matrix:
        """[[B, T], [0, 1]]."""
        upper = ((*b, *t) for b, t in zip(block, columns, strict=True))
        return (*upper, *identity(self.whole)[self.size :])

    def element(self, numbers: Vector) -> Matrix:
        """Stored numbers to the matrix, B replaced by its orthogonal polar factor."""
        return self.onto(self.embed(self, numbers))

    def keep(self, a: Matrix) -> Vector:
        """Matrix to the k stored numbers."""
        return self.store(self, a)

    def onto(self, a: Matrix) -> Matrix:
        """The same with B on the group; ValueError where no rotation is nearest."""
        block, columns = self.parts(a)
        return self.joined(orthogonal_nearest(block), columns)

    def inverse(self, a: Matrix) -> Matrix:
        """a^-1 = [[B^T, -B^T T], [0, 1]]."""
        block, columns = self.parts(a)
        back = transpose(block)
        return self.joined(back, combine((-1, product(back, columns))))

    def angle(self, a: Matrix) -> Number:
        """Rotation angle, rad: 0 to pi, on S3 to 2 pi; 0 where nothing turns."""
        half = mp.mpf(0.5)
        skew = self.vee(combine((half, a), (-half, self.inverse(a))))[: len(self.turns)]
        sine = mp.sqrt(mp.fsum(x**2 for x in skew)) / self.sheets
        trace = mp.fsum(a[i][i] for i in range(self.size))
        return self.sheets * mp.atan2(sine, (trace - self.axes) / (self.size - self.axes))


def _matrix(size: int, entries: Entries) -> Matrix:
    return tuple(tuple(entries.get((i, j), mp.zero) for j in range(size)) for i in range(size))


def _nonzero(a: Matrix) -> Iterator[tuple[tuple[int, int], Number]]:
    return (((i, j), x) for i, row in enumerate(a) for j, x in enumerate(row) if x)


def _turn(size: int, i: int, j: int) -> Matrix:
    """Generator of the rotation from axis i towards axis j."""
    return _matrix(size, {(j, i): mp.one, (i, j): -mp.one})


def _left_half(i: int, j: int, k: int) -> Matrix:
    """p -> e_i p/2 on quaternions, scalar first: e_i e_j = e_k, e_i e_k = -e_j, e_i e_i = -1."""
    half = mp.mpf(0.5)
    return _matrix(4, {(i, 0): half, (0, i): -half, (k, j): half, (j, k): -half})


_PLANE = (_turn(2, 0, 1),)
_SPACE = (_turn(3, 1, 2), _turn(3, 2, 0), _turn(3, 0, 1))
_HALVES = (_left_half(1, 2, 3), _left_half(2, 3, 1), _left_half(3, 1, 2))


def _rows(factor: Factor, numbers: Vector) -> Matrix:
    """A whole matrix, row by row; the lower rows are those of the group."""
    width = factor.whole
    rows = tuple(numbers[i : i + width] for i in range(0, len(numbers), width))
    return factor.joined(*factor.parts(rows))


def _left_product(factor: Factor, q: Vector) -> Matrix:
    """The matrix of p -> q p."""
    return combine((q[0], identity(4)), *zip((2 * x for x in q[1:]), factor.turns, strict=True))


def _shift(factor: Factor, t: Vector) -> Matrix:
    """The matrix of x -> x + t."""
    return factor.joined(identity(factor.size), tuple((x,) for x in t))


def _flat(_: Factor, a: Matrix) -> Vector:
    return tuple(chain.from_iterable(a))


def _first_column(_: Factor, a: Matrix) -> Vector:
    return tuple(row[0] for row in a)


def _last_column(_: Factor, a: Matrix) -> Vector:
    return tuple(row[-1] for row in a[:-1])


def _matrices(turns: tuple[Matrix, ...], columns: int) -> Factor:
    """Rotations and `columns` vectors, kept as whole matrices."""
    size = len(turns[0])
    return Factor(size, columns, turns, _rows, _flat, (size + columns) ** 2, axes=size % 2)


_FACTORS = {
    "SO2": _matrices(_PLANE, 0),
    "SO3": _matrices(_SPACE, 0),
    "SE2": _matrices(_PLANE, 1),
    "SE3": _matrices(_SPACE, 1),
    "SE23": _matrices(_SPACE, 2),  # columns: velocity, position
    "S3": Factor(4, 0, _HALVES, _left_product, _first_column, 4, sheets=2),
}


@cache
def factors(name: str) -> tuple[Factor, ...]:
    """The factors of "SE3", "R6", "SO3 x R3" …, in order; ValueError for an unknown one."""
    return tuple(map(_factor, name.split(" x ")))


def _factor(name: str) -> Factor:
    if vectors := re.fullmatch(r"R([1-9]\d?)", name):
        size = int(vectors[1])
        return Factor(size, 1, (), _shift, _last_column, size)
    if name not in _FACTORS:
        raise ValueError(f"unknown group {name!r}: {', '.join(_FACTORS)}, R1 to R99 or a product")
    return _FACTORS[name]
