"""The groups that tests run over: those of the catalogue, products, a user's own, and random ones.

A random group is made here and listed nowhere: a random change of basis of a random semidirect
product. The same test functions run over it as over SE3.
"""

from collections.abc import Sequence
from contextlib import AbstractContextManager
from fractions import Fraction
from random import Random
from typing import Any
from unittest.mock import patch

import pytest
from sympy import Matrix, Rational

from derive.lie import chart
from derive.lie.catalogue import GROUPS, SO2, SO3, named
from derive.lie.family import rebased, semidirect
from derive.lie.group import Group
from derive.lie.own import of_basis

Rows = Sequence[Sequence[Fraction]]


def matrix(size: int, **entries: int) -> Rows:
    """Rows of a matrix (size, size), zero but for entries by place: a12 in row 1, column 2."""
    rows = [[Fraction(0)] * size for _ in range(size)]
    for place, value in entries.items():
        rows[int(place[1]) - 1][int(place[2]) - 1] = Fraction(value)
    return rows


def _turn(size: int, i: int, j: int) -> Rows:
    return matrix(size, **{f"a{j}{i}": 1, f"a{i}{j}": -1})


def _shift(size: int, i: int, j: int) -> Rows:
    return matrix(size, **{f"a{i}{j}": 1})


BASES: dict[str, list[Rows]] = {
    "Heisenberg": [_shift(3, 1, 2), _shift(3, 2, 3), _shift(3, 1, 3)],
    "SL2": [_shift(2, 1, 2), _shift(2, 2, 1), matrix(2, a11=1, a22=-1)],
    "Aff1": [matrix(2, a11=1), _shift(2, 1, 2)],
    "GL2": [_shift(2, i, j) for i in (1, 2) for j in (1, 2)],
    "SO4": [_turn(4, i, j) for i in range(1, 5) for j in range(i + 1, 5)],
    "SL3": [
        *(_shift(3, i, j) for i in (1, 2, 3) for j in (1, 2, 3) if i != j),
        matrix(3, a11=1, a22=-1),
        matrix(3, a22=1, a33=-1),
    ],
    "Sim2": [
        matrix(3, a21=1, a12=-1), matrix(3, a11=1, a22=1), _shift(3, 1, 3), _shift(3, 2, 3)
    ],
    "Lorentz": [matrix(3, a12=1, a21=1), matrix(3, a13=1, a31=1), _turn(3, 2, 3)],
}  # fmt: skip
"""Groups that a user might describe, by their bases alone."""

OWN = {name: of_basis(name, basis, ["1/s"] * len(basis)) for name, basis in BASES.items()}


def invertible(rng: Random, size: int) -> Matrix:
    """A random matrix of small rational numbers, sparse enough to be read, never singular."""
    while True:
        entries = [Rational(rng.randint(-2, 2), rng.randint(1, 3)) for _ in range(size**2)]
        found = Matrix(size, size, entries)
        if found.det() != 0:
            return found


def _carried(seed: int) -> tuple[Group, Matrix]:
    """Rotations of the plane or of space, some columns of translation, and a random basis."""
    rng = Random(seed)
    base, turned = ((SO2, chart.of_plane), (SO3, chart.of_space))[seed % 2]
    units = [rng.choice(("m/s", "m/s^2", "mol/s")) for _ in range(rng.randint(1, 3 - seed % 2))]
    whole = semidirect(base, f"Carried{seed}", units, turned)
    basis = invertible(rng, whole.dim)
    return rebased(whole, f"Random{seed}", basis, ("1/s",) * whole.dim), basis


_MADE = [_carried(seed) for seed in range(4)]
MADE = {group.name: group for group, _ in _MADE}
REBASED = {group.name: basis for group, basis in _MADE}
"""Basis of each random group in the coordinates of its semidirect product."""


def listed() -> AbstractContextManager[Any]:
    """As if the groups made here were records of the catalogue: all that adding one takes."""
    return patch.dict(GROUPS, MADE)


_NAMES = ("R1", "R6", "SO3 x R3", "SE3 x SO3", "S3 x SE2", "Random0 x R2", "SO2 x Random2")
with listed():
    ALL: dict[str, Group] = {**GROUPS, **OWN, **{name: named(name) for name in _NAMES}}
"""Every group that the tests run over."""

NAMED = tuple(GROUPS)
"""The names in the catalogue."""

CHARTED = tuple(name for name, group in ALL.items() if group.chart or group.factors)
"""Names of the groups with a logarithm."""

each_group = pytest.mark.parametrize("group", ALL.values(), ids=ALL)

TURNED = {"SO2": 2, "SO3": 3, "SE2": 2, "SE3": 3, "SE23": 3, "SO4": 4} | {
    f"Random{seed}": 2 + seed % 2 for seed in range(4)
}
"""Rows of the rotation in the corner of a group's matrices."""
