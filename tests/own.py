"""Groups of one's own, for the tests: given by bases alone."""

from fractions import Fraction

from derive.lie.group import Group
from derive.lie.own import of_basis


def unit(m: int, *entries: tuple[int, int, int]) -> list[list[Fraction]]:
    """A matrix (m, m) of zeros but for (row, column, value)."""
    rows = [[Fraction(0)] * m for _ in range(m)]
    for i, j, value in entries:
        rows[i][j] = Fraction(value)
    return rows


def group(name: str, *basis: list[list[Fraction]]) -> Group:
    """The group of that basis, units 1/s."""
    return of_basis(name, basis, ["1/s"] * len(basis))


SL2 = group("SL2", unit(2, (0, 1, 1)), unit(2, (1, 0, 1)), unit(2, (0, 0, 1), (1, 1, -1)))
HEISENBERG = group("Heisenberg", unit(3, (0, 1, 1)), unit(3, (1, 2, 1)), unit(3, (0, 2, 1)))
SPIRAL = group("Spiral", unit(3, (0, 0, 1), (1, 1, 2)), unit(3, (1, 2, 1)))
"""Odd powers of its algebra leave it, and its guard does not see every direction off it."""
