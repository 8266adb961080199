"""A user's group from its basis alone, with 130 digits: elements are whole matrices, as stored."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

from derive.verify.oracle.matrix_function import (
    Matrix,
    Number,
    Vector,
    combine,
    inverse,
    product,
    solve,
    times,
    transpose,
)
from derive.verify.oracle.precise import mp


@dataclass(frozen=True)
class Own:
    """Matrices (m, m) around exp of the span of n of them; nothing is put on the group.

    generators: the basis, exact, as mpf
    """

    generators: tuple[Matrix, ...]
    sheets = 1
    columns = 0
    turns: tuple[Matrix, ...] = ()

    @property
    def basis(self) -> tuple[Matrix, ...]:
        """The n generators, (m, m) each."""
        return self.generators

    @property
    def whole(self) -> int:
        """m, size of the matrices."""
        return len(self.generators[0])

    @property
    def stored(self) -> int:
        """k, how many numbers are kept."""
        return self.whole**2

    @property
    def dim(self) -> int:
        """n, dimension of the algebra."""
        return len(self.generators)

    def hat(self, x: Sequence[Number]) -> Matrix:
        """Coordinates (n,) to sum x_i E_i, (m, m)."""
        return combine(*zip(x, self.generators, strict=True))

    def vee(self, a: Matrix) -> Vector:
        """Coordinates (n,) of the sum of E_i that is nearest to a."""
        return times(self._left_inverse, tuple(chain.from_iterable(a)))

    @cached_property
    def _left_inverse(self) -> Matrix:
        rows = tuple(tuple(chain.from_iterable(e)) for e in self.generators)
        return solve(product(rows, transpose(rows)), rows)[0]

    def element(self, numbers: Vector) -> Matrix:
        """Stored numbers, row by row, to the matrix, as they are."""
        return tuple(numbers[i : i + self.whole] for i in range(0, self.stored, self.whole))

    def keep(self, a: Matrix) -> Vector:
        """Matrix to stored numbers, row by row."""
        return tuple(chain.from_iterable(a))

    def onto(self, a: Matrix) -> Matrix:
        """The matrix itself: how to put it on the group is not known."""
        return a

    def inverse(self, a: Matrix) -> Matrix:
        """a^-1, of the matrix."""
        return inverse(a)

    def angle(self, _: Matrix) -> Number:
        """No rotation is known of."""
        return mp.zero
