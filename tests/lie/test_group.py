"""What follows from a basis, over every group, against numpy, scipy and exact rationals."""

from dataclasses import replace
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest
import sympy
from numpy.testing import assert_allclose
from scipy.linalg import expm
from sympy import Matrix, Rational

from derive.lie.cover import Let
from derive.lie.group import Group
from tests import points
from tests.groups import ALL, CHARTED, TURNED, each_group
from tests.points import embedded, vector

each_seed = pytest.mark.parametrize("seed", range(3))


def column(row: Any) -> Matrix:
    return Matrix([Rational(x.numerator, x.denominator) for x in map(Fraction, row)])


def point(group: Group, rng: Random) -> Matrix:
    """Stored numbers of an exact element, far from the identity as often as near."""
    return column(points.point(group, rng))


def fractions(matrix: Any) -> Any:
    """A matrix of sympy's rational numbers as an array of fractions."""
    return np.array([points.exact(x) for x in matrix], object).reshape(matrix.shape)


def plain(name: str, value: Any, *_: Any, **__: Any) -> Any:
    """A let that writes no step."""
    return value


as_it_is: Let = plain


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


def test_what_is_tested_has_and_lacks_logarithms_and_mirrors() -> None:
    """The lists of the tests, against what they are to cover."""
    assert {"SO2", "SE3", "SE23", "R3", "Heisenberg", "Random0", "SE3 x SO3"} <= set(CHARTED)
    assert {"SL2", "GL2", "SO4", "Sim2"} <= set(ALL) - set(CHARTED)
    assert set(TURNED) < set(ALL)


@each_group
def test_vee_inverts_hat(group: Group) -> None:
    x = Matrix(sympy.symbols(f"x:{group.dim}"))
    assert group.vee(group.hat(x)).expand() == x
    found = unhat(group, floats(group.hat(Matrix(range(group.dim)))))
    assert_allclose(found, range(group.dim), atol=1e-12)


@each_group
@each_seed
def test_embed_and_store_are_inverse_and_keep_products(group: Group, seed: int) -> None:
    rng = Random(seed)
    p, q = points.point(group, rng), points.point(group, rng)
    assert group.store(group.embed(column(p))) == column(p)
    np.testing.assert_array_equal(fractions(group.embed(column(p))), embedded(group, p))
    product = group.store(group.embed(column(p)) * group.embed(column(q)))
    assert product == column(points.stored(group, embedded(group, p) @ embedded(group, q)))


@each_group
@each_seed
def test_inverse_and_identity_are_those_of_matrices(group: Group, seed: int) -> None:
    p = points.point(group, Random(seed))
    g = group.embed(column(p))
    assert group.embed(Matrix(group.identity)) == sympy.eye(g.rows)
    wanted = points.inverse(embedded(group, p))
    np.testing.assert_array_equal(fractions(group.inverse(g)), wanted)
    assert group.store(group.inverse(g)) == column(points.stored(group, wanted))


@each_group
@each_seed
def test_the_error_is_the_product_with_the_inverse(group: Group, seed: int) -> None:
    rng = Random(seed)
    p, q = points.point(group, rng), points.point(group, rng)
    wanted = points.solve(embedded(group, p), embedded(group, q))
    found = group.error(as_it_is, column(p), column(q))
    assert Matrix(found).expand() == column(points.stored(group, wanted))
    assert group.long_error(column(p), column(q)) == column(points.stored(group, wanted))


@each_group
@each_seed
def test_the_pull_is_Ad_of_the_inverse(group: Group, seed: int) -> None:
    rng = Random(seed)
    p, x = points.point(group, rng), vector(rng, group.dim)
    g = embedded(group, p)
    wanted = points.vee(group, points.solve(g, points.hat(group, x) @ g))
    found = group.pull(as_it_is, column(p))("eta", column(x))
    assert Matrix(found).expand() == column(wanted)
    long = group.long_Ad(group.inverse(group.embed(column(p)))) * column(x)
    assert long == column(wanted)


@each_group
@each_seed
def test_Ad_is_conjugation(group: Group, seed: int) -> None:
    rng = Random(seed)
    p, y = points.point(group, rng), vector(rng, group.dim)
    g = embedded(group, p)
    wanted = points.vee(group, g @ points.hat(group, y) @ points.inverse(g))
    assert group.Ad(group.embed(column(p))) * column(y) == column(wanted)


@each_group
@each_seed
def test_short_Ad_is_Ad_by_its_definition(group: Group, seed: int) -> None:
    g = group.embed(point(group, Random(seed)))
    assert group.Ad(g) == group.long_Ad(g)


@each_group
@each_seed
def test_ad_is_the_derivative_of_Ad(group: Group, seed: int) -> None:
    """Along the whole one-parameter subgroup: Ad(exp x) = exp(ad x)."""
    x = column(vector(Random(seed), group.dim)) / 4
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
    """Of the structure constants; where the bracket is not zero, its own double is not either."""
    units = [Matrix(sympy.eye(group.dim)[:, i]) for i in range(group.dim)]
    total = 0
    for i, x in enumerate(units):
        for j, y in enumerate(units[:i]):
            inner = group.bracket(x, y)
            assert inner == -group.bracket(y, x)
            total += any(inner)
            for z in units[:j]:
                outer = group.bracket(z, inner) + group.bracket(x, group.bracket(y, z))
                assert outer == -group.bracket(y, group.bracket(z, x))
    is_abelian = group.name in ("SO2", "R1", "R3", "R6")
    assert bool(total) != is_abelian


@each_group
@each_seed
def test_coad_is_the_dual_of_the_bracket_without_a_sign(group: Group, seed: int) -> None:
    """<coad(x) a; y> = <a; [x, y]>, the bracket being numpy's commutator."""
    rng = Random(seed)
    x, y, a = (column(vector(rng, group.dim)) for _ in range(3))
    left, right = floats(group.hat(x)), floats(group.hat(y))
    wanted = flattened(a) @ unhat(group, left @ right - right @ left)
    assert float((group.coad(x) * a).dot(y)) == pytest.approx(wanted, rel=1e-12, abs=1e-12)


@each_group
@each_seed
def test_the_residual_vanishes_on_the_group(group: Group, seed: int) -> None:
    value = group.residual(point(group, Random(seed)))
    assert value == 0 * value


@each_group
@each_seed
def test_the_residual_sees_every_direction_off_the_group(group: Group, seed: int) -> None:
    """g + t d leaves the group at once where g^-1 d is not in the algebra."""
    p, small = points.point(group, Random(seed)), Fraction(1, 1000)
    g = embedded(group, p)
    for k in range(group.size):
        moved = [x + small * (i == k) for i, x in enumerate(p)]
        direction = points.solve(g, embedded(group, moved) - g)
        value = group.residual(column(moved))
        if not points.is_in_algebra(group, direction):
            assert max(map(abs, value)) > Rational(1, 10**6), k


@each_group
@each_seed
def test_the_residual_sees_what_fewer_equations_would_let_pass(group: Group, seed: int) -> None:
    """Reflections, and columns of other lengths with the same determinant."""
    p = points.point(group, Random(seed))
    for stored in reflected(group, p):
        assert max(map(abs, group.residual(column(stored)))) > Rational(1, 10**5)


def reflected(group: Group, p: list[Any]) -> list[list[Any]]:
    """Elements whose rotation is mirrored, or stretched to the same volume."""
    found, start = [], 0
    for one in group.factors or (group,):
        if size := TURNED.get(one.name):
            part = embedded(one, p[start : start + one.size])
            for scale in ((-1, 1), (2, Fraction(1, 2))):
                bent = part.copy()
                bent[:size, :2] = bent[:size, :2] * np.array(scale)
                found.append([*p[:start], *bent.ravel(), *p[start + one.size :]])
        start += one.size
    return found


several = pytest.mark.parametrize(
    "group", [g for g in ALL.values() if g.dim > 1], ids=[n for n, g in ALL.items() if g.dim > 1]
)


@several
def test_a_dependent_basis_is_refused(group: Group) -> None:
    first, *rest = group.basis
    dependent = replace(group, basis=(*rest, sum(rest, 0 * first)))
    with pytest.raises(ValueError, match=f"{group.name}: .* dependent"):
        dependent.vee(first)
