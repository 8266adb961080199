"""The mechanics: the connection by its two laws, passivity, and the plant against numpy."""

from collections.abc import Callable
from itertools import pairwise
from random import Random
from typing import Any

import numpy as np
import pytest
import sympy
from numpy.testing import assert_allclose
from sympy import Matrix, Rational

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
from derive.verify.oracle.precise import mp
from tests.control.drawn import Pattern, definite, diagonal, full, numbers, sparse, square
from tests.evaluation import exactly
from tests.groups import ALL, each_group
from tests.oracle import distance, norm, truth
from tests.points import point, vector

FULL = (True,) * 6
PATTERNS: dict[str, Callable[[Group], Pattern]] = {
    "full": full,
    "partial": sparse,
    "diagonal": lambda group: tuple(
        place in diagonal(group.dim) for place in range(len(full(group)))
    ),
}
OPTIONS = ((), ("momentum",), ("external",), ("external", "momentum"))
SMALL = {name: group for name, group in ALL.items() if group.dim <= 3}
each_small = pytest.mark.parametrize("group", SMALL.values(), ids=SMALL)
each_curved = pytest.mark.parametrize(
    "group",
    [group for group in SMALL.values() if any(map(any, group.structure))],
    ids=[name for name, group in SMALL.items() if any(map(any, group.structure))],
)
each_pattern = pytest.mark.parametrize("pattern", PATTERNS)
each_seed = pytest.mark.parametrize("seed", range(2))


def general(group: Group) -> tuple[MechanicalSystem, list[Matrix]]:
    """The group with an inertia all of symbols, and three velocities of symbols."""
    n = group.dim
    size = n * (n + 1) // 2
    entries = Matrix(sympy.symbols(f"J:{size}", real=True))
    system = MechanicalSystem(group, symmetric(entries, (True,) * size))
    return system, [Matrix(sympy.symbols(f"{name}:{n}", real=True)) for name in "xyz"]


def vanishes(value: Any) -> bool:
    return all(sympy.cancel(sympy.together(entry)) == 0 for entry in Matrix([value]))


@each_curved
def test_the_connection_has_no_torsion(group: Group) -> None:
    system, (x, y, _) = general(group)
    torsion = system.connection(x, y) - system.connection(y, x) - group.bracket(x, y)
    assert vanishes(torsion)
    assert not vanishes(system.connection(x, y))


@each_small
def test_the_connection_is_metric(group: Group) -> None:
    """I(nabla_z x, y) + I(x, nabla_z y) = 0."""
    system, (x, y, z) = general(group)
    one, other = (system.flat(b).dot(system.connection(z, a)) for a, b in ((x, y), (y, x)))
    assert vanishes(Matrix([one + other]))


@each_small
def test_the_connection_along_itself_is_the_plant(group: Group) -> None:
    """nabla_nu nu = -I^-1 coad(nu) I nu: eq. (Rest) leads to eq. (EulerP)."""
    system, (x, *_) = general(group)
    assert vanishes(system.flat(system.connection(x, x)) + group.coad(x) * system.flat(x))


@each_small
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
@pytest.mark.parametrize("options", OPTIONS, ids=map("-".join, OPTIONS))
def test_the_plant_is_eulers_equation(group: Group, pattern: str, options: tuple[str, ...]) -> None:
    """I nu' = coad(nu) (I nu + h) + force + external, with the inverse inertia."""
    zeros = PATTERNS[pattern](group)
    given = numbers(group, len(options), zeros)
    found = exactly(plant(group, zeros, options), **given)["nu_dot"]
    extras = {name: given[name] for name in options}
    wanted = truth(group).plant(given["inertia"], given["nu"], given["force"], **extras)
    assert distance(found, wanted) < mp.mpf("1e-60") * (1 + norm(wanted))
    taken = [quantity.name for quantity in plant(group, zeros, options).inputs]
    assert set(taken) == {"inertia", "nu", "force", *options}


@each_group
@each_pattern
def test_the_pivots_are_ratios_of_leading_minors(group: Group, pattern: str) -> None:
    zeros = PATTERNS[pattern](group)
    upper = definite(group, Random(3), zeros)
    found = exactly(definiteness(group, zeros), inertia=upper)["pivot"]
    inertia = square(upper).astype(float)
    minors = [1.0, *(np.linalg.det(inertia[:k, :k]) for k in range(1, group.dim + 1))]
    wanted = [b / a for a, b in pairwise(minors)]
    assert_allclose(np.array(found, float), wanted, rtol=1e-11)


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
    upper = np.array(rows)[np.triu_indices(3)].tolist()
    pivot = exactly(definiteness(GROUPS["S3"], FULL), inertia=upper)["pivot"]
    assert min(pivot) < 0


@pytest.mark.parametrize(
    "rows",
    [
        [[0, 1, 1], [1, 2, 0], [1, 0, 3]],
        [[1, 1, 1], [1, 1, 0], [1, 0, 3]],
        [[0, 0, 0], [0, 0, 0], [0, 0, 0]],
    ],
)
def test_a_pivot_that_is_zero_divides_nothing(rows: list[list[int]]) -> None:
    upper = np.array(rows)[np.triu_indices(3)].tolist()
    pivot = exactly(definiteness(GROUPS["S3"], FULL), inertia=upper)["pivot"]
    assert min(pivot) <= 0
    assert all(mp.isfinite(one) for one in pivot)


@each_seed
@pytest.mark.parametrize("name", ["SE3", "SO4", "Random1"])
def test_solve_is_exact_in_six_dimensions_as_in_three(name: str, seed: int) -> None:
    rng, group = Random(seed), ALL[name]
    pattern = sparse(group, seed)
    upper, a = definite(group, rng, pattern), vector(rng, 6)
    d = Derivation("solving", "", "")
    system = take_system(d, group, pattern)
    right = d.take(Quantity("a", 6, "N m", "", place="a"))
    d.give(Quantity("x", 6, "1", "", place="x"), system.solve(d, right))
    found = exactly(d, inertia=upper, a=a)["x"]
    wanted = Matrix(6, 6, list(map(Rational, square(upper).ravel()))).LUsolve(Matrix(a))
    for x, exact in zip(found, wanted, strict=True):
        assert abs(x * int(exact.q) - int(exact.p)) < 1e-45


@each_group
def test_the_residual_is_that_of_the_group(group: Group) -> None:
    stored = [Rational(k, 7) for k in range(2, 2 + group.size)]
    found = exactly(residual(group), g=stored) if residual(group).outputs else {"residual": ()}
    wanted = group.residual(Matrix(stored))
    assert_allclose(np.array(found["residual"], float), np.array(wanted, float).ravel(), rtol=1e-14)
    on = exactly(residual(group), g=point(group, Random(2)))
    assert not any(abs(x) > mp.mpf("1e-120") for x in on.get("residual", ()))
