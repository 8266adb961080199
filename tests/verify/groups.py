"""Groups on which the paper's statements are decided in tests, and what is known of each.

Besides the catalogue: products, groups of one's own of every kind (nilpotent, affine, special
linear, similarities) and a change of basis that nobody listed.
"""

from __future__ import annotations

import sympy
from sympy import Matrix, Rational, diag

from derive.lie.catalogue import GROUPS, named
from derive.lie.family import rebased
from derive.lie.group import Group
from derive.lie.own import of_matrices


def _one(size: int, *entries: tuple[int, int, int]) -> Matrix:
    made = sympy.zeros(size, size)
    for i, j, value in entries:
        made[i, j] = value
    return made


def _own(name: str, *made: Matrix) -> Group:
    return of_matrices(name, made, ("1/s",) * len(made))


def _turn(size: int, i: int, j: int) -> Matrix:
    return _one(size, (j, i, 1), (i, j, -1))


HEISENBERG = _own("Heisenberg", *(_one(3, (i, j, 1)) for i, j in ((0, 1), (1, 2), (0, 2))))
SL2 = _own("SL2", _one(2, (0, 1, 1)), _one(2, (1, 0, 1)), diag(1, -1))
SL3 = _own(
    "SL3",
    *(_one(3, (i, j, 1)) for i in range(3) for j in range(3) if i != j),
    diag(1, -1, 0),
    diag(0, 1, -1),
)
AFFINE = _own("Aff1", diag(1, 0), _one(2, (0, 1, 1)))
SIMILAR = _own("Sim2", _turn(3, 0, 1), _one(3, (0, 2, 1)), _one(3, (1, 2, 1)), diag(1, 1, 0))
SO4 = _own("SO4", *(_turn(4, i, j) for j in range(4) for i in range(j)))
REBASED = rebased(
    GROUPS["SE2"],
    "SE2 rebased",
    Matrix([[1, 2, 0], [0, 1, Rational(1, 3)], [1, 0, 1]]),
    ("1/s",) * 3,
)

EVERY = {
    group.name: group
    for group in (
        *GROUPS.values(), named("SE3 x SO3"), named("S3 x R2"), named("SO2 x SO2"),
        HEISENBERG, SL2, SL3, AFFINE, SIMILAR, REBASED,
    )
}  # fmt: skip
"""By name."""

COMMUTING = {name for name, group in EVERY.items() if not any(map(any, group.structure))}
