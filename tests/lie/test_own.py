"""A user's group from its basis alone: what follows of its elements, and what is refused."""

from fractions import Fraction
from random import Random

import numpy as np
import pytest
import sympy
from sympy import Matrix

from derive.control.matrix_law import keeps_odd_powers
from derive.lie.catalogue import SO3, named
from derive.lie.family import semidirect
from derive.lie.group import Group
from derive.lie.own import of_basis, of_matrices, unseen
from tests import points
from tests.groups import ALL, BASES, OWN, each_group, matrix
from tests.own import GALILEAN
from tests.points import embedded, point, vector

each_own = pytest.mark.parametrize("name", OWN)

DIMENSIONS = {
    "Heisenberg": 3, "SL2": 3, "Aff1": 2, "GL2": 4, "SO4": 6, "SL3": 8, "Sim2": 4, "Lorentz": 3
}  # fmt: skip


def test_every_own_group_has_its_dimension() -> None:
    assert {name: group.dim for name, group in OWN.items()} == DIMENSIONS


@each_own
def test_it_keeps_the_basis_that_was_given(name: str) -> None:
    found = [[list(map(Fraction, row)) for row in e.tolist()] for e in OWN[name].basis]
    assert found == [[list(row) for row in e] for e in BASES[name]]
    assert OWN[name].shape == (len(BASES[name][0]),) * 2


@each_group
def test_no_direction_off_the_group_is_unseen(group: Group) -> None:
    """To first order; in what the residual sees there are no others."""
    assert unseen(group) == 0


@each_own
def test_a_logarithm_is_there_where_every_element_is_unipotent(name: str) -> None:
    group = OWN[name]
    drawn = [embedded(group, point(group, Random(seed))) for seed in range(6)]
    off = [np.linalg.matrix_power(g - points.eye(len(g)), len(g)) for g in drawn]
    assert (group.chart is not None) == (not any(power.any() for power in off))


@each_own
def test_odd_powers_stay_in_the_algebra_but_of_traceless_matrices_of_three(name: str) -> None:
    group = OWN[name]
    X = points.hat(group, vector(Random(3), group.dim))
    stay = all(points.is_in_algebra(group, np.linalg.matrix_power(X, p)) for p in (3, 5, 7))
    assert keeps_odd_powers(group) == stay == (name != "SL3")


@pytest.mark.parametrize("name", ["SO2", "SO3", "SE2"])
def test_a_basis_of_the_catalogue_gives_its_group(name: str) -> None:
    """As own.of_basis sees it, without its logarithm: the same inverse, residuals as sharp."""
    listed = named(name)
    group = of_matrices("Mine", [Matrix(e) for e in listed.basis], listed.units)
    for seed in range(3):
        p = Matrix([Fraction(x) for x in point(listed, Random(seed))])
        assert not any(group.residual(p))
        g = group.embed(p)
        assert g == listed.embed(p)
        assert group.inverse(g).expand() == listed.inverse(g)
        assert any(group.residual(p + Matrix([0] * (len(p) - 1) + [Fraction(1, 9)])))
    assert unseen(group) == 0


@pytest.mark.parametrize("name", ["SE3", "SE23"])
def test_a_group_that_carries_is_sealed_by_forms_on_the_dual(name: str) -> None:
    """R R^T = 1 is g B g^T = B with B = diag(1, 1, 1, 0); the inverse is that of blocks."""
    listed = named(name)
    group = of_matrices("Mine", [Matrix(e) for e in listed.basis], listed.units)
    assert unseen(group) == 0
    p = Matrix([Fraction(x) for x in point(listed, Random(1))])
    assert not any(group.residual(p))
    g = group.embed(p)
    assert group.inverse(g) * g == g**0
    assert any(group.residual(Matrix(list(sympy.diag(2, Fraction(1, 2), *[1] * (g.rows - 2))))))


def test_a_galilean_motion_has_an_inverse_of_blocks() -> None:
    numbers = Matrix(range(1, 26))
    g = GALILEAN.embed(numbers)
    g[:3, :3] = Matrix([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    assert GALILEAN.inverse(g) == g.inv()
    assert not any(GALILEAN.residual(Matrix(list(g))))
    assert unseen(GALILEAN) == 0


def test_large_matrices_without_a_form_are_refused() -> None:
    """Every axis stretched at a rate of its own: no bilinear form, and cofactors of five rows."""
    basis = [matrix(5, a11=1, a22=2, a33=3, a44=4, a55=5)]
    with pytest.raises(ValueError, match=r"Wide: no bilinear form gives the inverse .* 5 rows"):
        of_basis("Wide", basis, ["1/s"])


def test_a_semidirect_product_without_a_chart_has_no_logarithm() -> None:
    assert semidirect(SO3, "Bare", ("m/s",), None).chart is None
    assert ALL["SE3"].chart is not None
