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
GL2 = group("GL2", *(unit(2, (i, j, 1)) for i in range(2) for j in range(2)))
SO4 = group("SO4", *(unit(4, (i, j, -1), (j, i, 1)) for i in range(4) for j in range(i + 1, 4)))
POSE = group("Pose", unit(3, (0, 2, 1)), unit(3, (1, 2, 1)), unit(3, (1, 0, 1), (0, 1, -1)))
"""SE(2) with its angle last."""
GALILEAN = group(
    "Galilean",
    *(unit(5, (j, i, 1), (i, j, -1)) for i, j in ((1, 2), (2, 0), (0, 1))),
    *(unit(5, (i, 3, 1)) for i in range(3)),
    *(unit(5, (i, 4, 1)) for i in range(3)),
    unit(5, (3, 4, 1)),
)
"""Rotation, velocity, position, time."""
SPIRAL = group("Spiral", unit(3, (0, 0, 1), (1, 1, 2)), unit(3, (1, 2, 1)))
"""Odd powers of its algebra leave it, and its guard does not see every direction off it."""
