"""What follows from a basis, over every group, against numpy, scipy and exact rationals."""

from collections.abc import Callable
from dataclasses import replace
from random import Random
from typing import Any

import numpy as np
import pytest
import sympy
from numpy.testing import assert_allclose
from scipy.linalg import expm
from sympy import Matrix, Rational

from derive.lie.catalogue import GROUPS
from derive.lie.group import Group
from tests.points import PRODUCTS, STORED, unit, vector

SEEDS = range(4)
Move = Callable[[Any], Any]
each_group = pytest.mark.parametrize("group", GROUPS.values(), ids=GROUPS)
each_seed = pytest.mark.parametrize("seed", SEEDS)


def column(row: Any) -> Matrix:
    return Matrix([Rational(x) for x in row])


def point(group: Group, rng: Random) -> Matrix:
    """Stored numbers of an exact element, far from the identity as often as near."""
    return column(STORED[group.name](unit(vector(rng))))


def floats(matrix: Any) -> Any:
    return np.array(matrix.tolist(), dtype=float)


def flattened(x: Any) -> Any:
    return floats(x).ravel()


def unhat(group: Group, a: Any) -> Any:
    """Coordinates of a matrix of the algebra, by least squares on the basis."""
    stacked = np.stack([flattened(e) for e in group.basis], axis=1)
    found, *_ = np.linalg.lstsq(stacked, a.ravel(), rcond=None)
    assert_allclose(stacked @ found, a.ravel(), atol=1e-11)
    return found


def test_the_tests_know_every_group() -> None:
    assert set(STORED) == set(PRODUCTS) == set(GROUPS)


@each_group
def test_vee_inverts_hat(group: Group) -> None:
    x = Matrix(sympy.symbols(f"x:{group.dim}"))
    assert group.vee(group.hat(x)) == x
    assert_allclose(unhat(group, floats(group.hat(Matrix(range(group.dim))))), range(group.dim))


@each_group
@each_seed
def test_embed_and_store_are_inverse_and_keep_products(group: Group, seed: int) -> None:
    rng = Random(seed)
    p, q = point(group, rng), point(group, rng)
    assert group.store(group.embed(p)) == p
    product = group.store(group.embed(p) * group.embed(q))
    assert product == column(PRODUCTS[group.name](p, q))


@each_group
@each_seed
def test_inverse_and_identity_are_those_of_matrices(group: Group, seed: int) -> None:
    g = group.embed(point(group, Random(seed)))
    unity = group.embed(Matrix(group.identity))
    assert unity == sympy.eye(g.rows)
    assert group.inverse(g) * g == unity
    assert group.embed(group.store(group.inverse(g))) == g.inv()


@each_group
@each_seed
def test_Ad_is_conjugation(group: Group, seed: int) -> None:
    rng = Random(seed)
    g, y = group.embed(point(group, rng)), column(vector(rng, group.dim))
    wanted = floats(g) @ floats(group.hat(y)) @ np.linalg.inv(floats(g))
    assert_allclose(floats(group.hat(group.Ad(g) * y)), wanted, atol=1e-12)


@each_group
@each_seed
def test_short_Ad_is_Ad_by_its_definition(group: Group, seed: int) -> None:
    g = group.embed(point(group, Random(seed)))
    assert group.Ad(g) == group.long_Ad(g)


@each_group
@each_seed
def test_ad_is_the_derivative_of_Ad(group: Group, seed: int) -> None:
    """Along the whole one-parameter subgroup: Ad(exp x) = exp(ad x)."""
    x = column(vector(Random(seed), group.dim))
    g = expm(floats(group.hat(x)))
    columns = [unhat(group, g @ floats(e) @ np.linalg.inv(g)) for e in group.basis]
    assert_allclose(expm(floats(group.ad(x))), np.stack(columns, axis=1), atol=1e-10)


@each_group
@each_seed
def test_the_bracket_is_the_commutator(group: Group, seed: int) -> None:
    rng = Random(seed)
    x, y = column(vector(rng, group.dim)), column(vector(rng, group.dim))
    a, b = floats(group.hat(x)), floats(group.hat(y))
    assert_allclose(flattened(group.bracket(x, y)), unhat(group, a @ b - b @ a), atol=1e-12)


@each_group
def test_jacobi_holds(group: Group) -> None:
    x, y, z = (Matrix(sympy.symbols(f"{name}:{group.dim}")) for name in "xyz")
    turns = ((x, y, z), (y, z, x), (z, x, y))
    total = sum((group.bracket(a, group.bracket(b, c)) for a, b, c in turns), 0 * x)
    assert total.expand() == 0 * x
    assert group.bracket(x, group.bracket(y, z)).expand() != 0 * x


@each_group
@each_seed
def test_coad_is_the_dual_of_the_bracket_without_a_sign(group: Group, seed: int) -> None:
    """<coad(x) a; y> = <a; [x, y]>, the bracket being numpy's commutator."""
    rng = Random(seed)
    x, y, a = (column(vector(rng, group.dim)) for _ in range(3))
    left, right = floats(group.hat(x)), floats(group.hat(y))
    wanted = flattened(a) @ unhat(group, left @ right - right @ left)
    assert float((group.coad(x) * a).dot(y)) == pytest.approx(wanted, abs=1e-12)


@each_group
@each_seed
def test_the_residual_vanishes_on_the_group(group: Group, seed: int) -> None:
    value = group.residual(point(group, Random(seed)))
    assert value == 0 * value


OFF: dict[str, Move] = {
    "nothing": lambda g: 0 * g,
    "longer": lambda g: g * Rational(1001, 1000),
    "shorter": lambda g: g * Rational(999, 1000),
    "first entry off": lambda g: g + Matrix([Rational(1, 1000)] + [0] * (len(g) - 1)),
    "last entry off": lambda g: g + Matrix([0] * (len(g) - 1) + [Rational(1, 1000)]),
}
HIDDEN: dict[str, tuple[Move, ...]] = {
    "SO3": (
        lambda g: -g,  # a reflection has the lengths and angles of a rotation
        lambda g: (g.reshape(3, 3) * sympy.diag(2, Rational(1, 2), 1)).reshape(9, 1),
    ),
}
"""Group name -> what some of its equations alone would let pass."""


@each_group
@each_seed
def test_the_residual_sees_what_is_off_the_group(group: Group, seed: int) -> None:
    g = point(group, Random(seed))
    for move in (*OFF.values(), *HIDDEN.get(group.name, ())):
        assert max(map(abs, group.residual(move(g)))) > Rational(1, 10**5)


@each_group
def test_a_dependent_basis_is_refused(group: Group) -> None:
    first, *rest = group.basis
    dependent = replace(group, basis=(*rest, sum(rest, 0 * first)))
    with pytest.raises(ValueError, match=f"{group.name}: .* dependent"):
        dependent.vee(first)
