"""The mechanics: the connection by its two laws, passivity, and the plant against numpy."""

from dataclasses import replace
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest
import sympy
from numpy.testing import assert_allclose
from sympy import ImmutableMatrix, Matrix, Rational

from derive.control.mechanics import (
    MechanicalSystem,
    definiteness,
    plant,
    residual,
    symmetric,
    take_system,
)
from derive.lie.catalogue import GROUPS
from derive.lie.group import Group
from derive.routine.derivation import Derivation, Quantity
from tests.evaluation import exactly
from tests.points import vector

FULL = (True,) * 6
PATTERNS = [FULL, (True, False, True, True, False, True), (True, False, False, True, False, True)]
each_group = pytest.mark.parametrize("group", GROUPS.values(), ids=GROUPS)
each_pattern = pytest.mark.parametrize("pattern", PATTERNS)
each_seed = pytest.mark.parametrize("seed", range(3))


def general(group: Group) -> tuple[MechanicalSystem, list[Matrix]]:
    """The group with an inertia all of symbols, and three velocities of symbols."""
    n = group.dim
    size = n * (n + 1) // 2
    entries = Matrix(sympy.symbols(f"J:{size}", real=True))
    system = MechanicalSystem(group, symmetric(entries, (True,) * size))
    return system, [Matrix(sympy.symbols(f"{name}:{n}", real=True)) for name in "xyz"]


def vanishes(value: Any) -> bool:
    return all(sympy.cancel(sympy.together(entry)) == 0 for entry in Matrix([value]))


def definite(rng: Random, size: int, pattern: tuple[bool, ...]) -> Any:
    """An exact symmetric matrix of that pattern whose diagonal outweighs the rest."""
    upper = [Fraction(rng.randint(-9, 9), 10) if there else Fraction(0) for there in pattern]
    matrix = np.full((size, size), Fraction(0))
    matrix[np.triu_indices(size)] = upper
    return matrix + matrix.T + np.diag([Fraction(rng.randint(20, 60), 10) for _ in range(size)])


def upper(matrix: Any) -> list[Any]:
    return list(matrix[np.triu_indices(len(matrix))])


@each_group
def test_the_connection_has_no_torsion(group: Group) -> None:
    system, (x, y, _) = general(group)
    torsion = system.connection(x, y) - system.connection(y, x) - group.bracket(x, y)
    assert vanishes(torsion)
    assert not vanishes(system.connection(x, y))


@each_group
def test_the_connection_is_metric(group: Group) -> None:
    """I(nabla_z x, y) + I(x, nabla_z y) = 0."""
    system, (x, y, z) = general(group)
    one, other = (system.flat(b).dot(system.connection(z, a)) for a, b in ((x, y), (y, x)))
    assert vanishes(Matrix([one + other]))


@each_group
def test_the_connection_along_itself_is_the_plant(group: Group) -> None:
    """nabla_nu nu = -I^-1 coad(nu) I nu: eq. (Rest) leads to eq. (EulerP)."""
    system, (x, *_) = general(group)
    assert vanishes(system.flat(system.connection(x, x)) + group.coad(x) * system.flat(x))


@each_group
def test_passivity(group: Group) -> None:
    """I(x, I^-1 coad(x) I y) = 0, the lemma of the appendix."""
    system, (x, y, _) = general(group)
    assert vanishes(Matrix([system.flat(x).dot(system.sharp(group.coad(x) * system.flat(y)))]))


def test_symmetric_fills_rows_and_keeps_zeros() -> None:
    entries = Matrix(sympy.symbols("a:6"))
    a = list(entries)
    assert symmetric(entries, FULL) == Matrix(
        [[a[0], a[1], a[2]], [a[1], a[3], a[4]], [a[2], a[4], a[5]]]
    )
    sparse = (True, False, True, True, False, True)
    assert symmetric(entries, sparse) == Matrix([[a[0], 0, a[2]], [0, a[3], 0], [a[2], 0, a[5]]])
    assert symmetric(entries[:1, :], (True,)) == Matrix([[a[0]]])


@each_group
@each_pattern
@each_seed
def test_the_plant_is_eulers_equation(group: Group, pattern: tuple[bool, ...], seed: int) -> None:
    rng = Random(seed)
    inertia, nu, force = definite(rng, 3, pattern), vector(rng), vector(rng)
    found = exactly(plant(group, pattern), inertia=upper(inertia), nu=nu, force=force)["nu_dot"]
    rate = np.array(nu)
    left = np.cross(inertia @ rate, rate) + np.array(force)
    wanted = np.linalg.solve(inertia.astype(float), left.astype(float))
    assert_allclose(np.array(found, float), wanted, rtol=1e-12, atol=1e-13)


@each_pattern
@each_seed
def test_the_pivots_are_ratios_of_leading_minors(pattern: tuple[bool, ...], seed: int) -> None:
    inertia = definite(Random(seed), 3, pattern)
    d = definiteness(GROUPS["SO3"], pattern)
    found = exactly(d, inertia=upper(inertia))["pivot"]
    minors = [np.linalg.det(inertia[:k, :k].astype(float)) for k in range(1, 4)]
    wanted = [minors[0], minors[1] / minors[0], minors[2] / minors[1]]
    assert_allclose(np.array(found, float), wanted, rtol=1e-12)


@pytest.mark.parametrize(
    "rows",
    [
        [[-1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[1, 2, 0], [2, 1, 0], [0, 0, 5]],
        [[2, 1, 2], [1, 2, 2], [2, 2, 2]],
    ],
)
def test_an_indefinite_inertia_has_a_negative_pivot(rows: list[list[int]]) -> None:
    assert np.linalg.eigvalsh(rows)[0] < 0
    pivot = exactly(definiteness(GROUPS["S3"], FULL), inertia=upper(np.array(rows)))["pivot"]
    assert min(pivot) < 0


def turn(i: int, j: int) -> ImmutableMatrix:
    return ImmutableMatrix(4, 4, lambda r, c: ((r, c) == (j, i)) - ((r, c) == (i, j)))


def six() -> Group:
    """A group of dimension 6 in all that the mechanics ask of one: the rotations of R^4."""
    basis = tuple(turn(i, j) for i in range(4) for j in range(i))
    return replace(GROUPS["SO3"], name="SO4", basis=basis, units=("rad/s",) * 6)


@each_seed
def test_solve_is_exact_in_six_dimensions_as_in_three(seed: int) -> None:
    rng = Random(seed)
    pattern = tuple(rng.random() < 0.7 or place in (0, 6, 11, 15, 18, 20) for place in range(21))
    inertia, a = definite(rng, 6, pattern), vector(rng, 6)
    d = Derivation("solving", "", "")
    system = take_system(d, six(), pattern)
    right = d.take(Quantity("a", 6, "N m", "", place="a"))
    d.give(Quantity("x", 6, "1", "", place="x"), system.solve(d, right))
    found = exactly(d, inertia=upper(inertia), a=a)["x"]
    wanted = Matrix(6, 6, list(map(Rational, inertia.ravel()))).LUsolve(Matrix(a))
    for x, exact in zip(found, wanted, strict=True):
        assert abs(x * int(exact.q) - int(exact.p)) < 1e-45
    assert_allclose(inertia.astype(float) @ np.array(found, float), np.array(a, float), atol=1e-13)


@each_group
def test_the_residual_is_that_of_the_group(group: Group) -> None:
    stored = [Rational(k, 7) for k in range(2, 2 + len(group.identity))]
    found = exactly(residual(group), g=stored)["residual"]
    wanted = group.residual(Matrix(stored))
    assert_allclose(np.array(found, float), np.array(wanted, float).ravel(), rtol=1e-15)
