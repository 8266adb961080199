"""Whether matrices span a Lie algebra: exact, on fractions, without computer algebra.

The brackets of matrices obey Jacobi's identity by themselves, so it is not asked for.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from math import gcd, lcm, sqrt

Matrix = tuple[tuple[Fraction, ...], ...]
Basis = tuple[Matrix, ...]

LARGEST_SIZE = 6  # rows of a matrix
LARGEST_DIMENSION = 12  # matrices of a basis


class BadBasis(ValueError):
    """Matrices that are no basis of a Lie algebra; says what was expected and what to do."""

    def __init__(self, expected: str, found: str, remedy: str) -> None:
        super().__init__(expected, found, remedy)
        self.expected = expected
        self.found = found
        self.remedy = remedy

    def __str__(self) -> str:
        return f"expected {self.expected}; found {self.found}; {self.remedy}"


def check(basis: Basis) -> None:
    """Raise BadBasis unless the n matrices (m, m) are independent and closed under the bracket."""
    _check_shapes(basis)
    _check_closed(basis, _echelon(basis))


def bracket(a: Matrix, b: Matrix) -> Matrix:
    """[a, b] = a b - b a, (m, m)."""
    m = len(a)
    return tuple(
        tuple(sum((a[i][k] * b[k][j] - b[i][k] * a[k][j] for k in range(m)), Fraction())
              for j in range(m))
        for i in range(m)
    )  # fmt: skip


def _check_shapes(basis: Basis) -> None:
    """Raise BadBasis unless there are 1 to 12 matrices, all square, of one size from 1 to 6."""
    if not 1 <= len(basis) <= LARGEST_DIMENSION:
        expected = f"1 to {LARGEST_DIMENSION} matrices, one for each coordinate of a velocity"
        raise BadBasis(expected, f"{len(basis)} of them", "give the matrices E_1, E_2, ... there")
    for number, matrix in enumerate(basis, start=1):
        m = len(matrix)
        if not 1 <= m <= LARGEST_SIZE or any(len(row) != m for row in matrix):
            expected = f"square matrices of 1 to {LARGEST_SIZE} rows"
            remedy = "give every row as many entries as the matrix has rows"
            raise BadBasis(expected, f"E_{number} with {_shape(matrix)}", remedy)
        if m != len(basis[0]):
            expected = f"matrices of one size, {len(basis[0])} by {len(basis[0])} as E_1"
            remedy = "fill the smaller ones up with zeros, or remove what does not belong"
            raise BadBasis(expected, f"E_{number}, which is {m} by {m}", remedy)


def _shape(matrix: Matrix) -> str:
    lengths = sorted({len(row) for row in matrix})
    entries = " and ".join(map(str, lengths)) or "no"
    return f"{len(matrix)} row{'s' * (len(matrix) != 1)} of {entries} entries"


def _echelon(basis: Basis) -> list[list[int]]:
    """The matrices as rows in echelon form; raises BadBasis for the first that adds nothing."""
    echelon: list[list[int]] = []
    for number, matrix in enumerate(basis, start=1):
        rest = _reduced(matrix, echelon)
        if not any(rest):
            is_zero = not any(map(any, matrix))
            before = "E_1" if number == 2 else f"E_1 to E_{number - 1}"
            what = "is zero" if is_zero else f"is a combination of {before}"
            remedy = f"remove E_{number}, or give the matrix that was meant"
            raise BadBasis("linearly independent matrices", f"E_{number} {what}", remedy)
        echelon.append(rest)
    return echelon


def _check_closed(basis: Basis, echelon: list[list[int]]) -> None:
    """Raise BadBasis for the first pair whose bracket is no combination of the basis."""
    for (i, a), (j, b) in combinations(enumerate(basis, start=1), 2):
        outside = bracket(a, b)
        if any(_reduced(outside, echelon)):
            away = sqrt(_squared_distance(outside, basis))
            raise BadBasis(
                "a basis closed under the bracket: every [E_i, E_j] a combination of E_1, E_2, ...",
                f"[E_{i}, E_{j}], which is {away:.6g} away from the nearest such combination "
                "(root of the sum of the squares of the entries)",
                f"add [E_{i}, E_{j}] = E_{i} E_{j} - E_{j} E_{i} to the basis, or mend the two",
            )


def _reduced(matrix: Matrix, echelon: list[list[int]]) -> list[int]:
    """A multiple of the matrix, less what the rows take away of it; zero if in their span.

    Whole numbers without a common factor: so they stay as short as they can be.
    """
    rest = _whole(matrix)
    for row in echelon:
        pivot = next(place for place, entry in enumerate(row) if entry)
        if rest[pivot]:
            pairs = zip(rest, row, strict=True)
            rest = _shortest([row[pivot] * mine - rest[pivot] * other for mine, other in pairs])
    return rest


def _whole(matrix: Matrix) -> list[int]:
    """Entries row by row, times what makes all of them whole."""
    entries = list(_flat(matrix))
    scale = lcm(*(entry.denominator for entry in entries))
    return _shortest([entry.numerator * (scale // entry.denominator) for entry in entries])


def _shortest(entries: Sequence[int]) -> list[int]:
    common = gcd(*entries) or 1
    return [entry // common for entry in entries]


def _flat(matrix: Matrix) -> Iterator[Fraction]:
    return (entry for row in matrix for entry in row)


def _squared_distance(matrix: Matrix, basis: Basis) -> Fraction:
    """Squared distance of a matrix from the span: the last pivot of all their dot products."""
    vectors = [list(_flat(each)) for each in (*basis, matrix)]
    gram = [[sum(map(Fraction.__mul__, a, b), Fraction()) for b in vectors] for a in vectors]
    for _ in basis:
        first, *rest = gram
        gram = [
            [
                mine - row[0] / first[0] * other
                for mine, other in zip(row[1:], first[1:], strict=True)
            ]
            for row in rest
        ]
    return gram[0][0]
