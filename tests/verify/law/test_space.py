"""The oracles of the Definition: numpy groups, exact elements, cuts and equilibria."""

from dataclasses import replace
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy
from sympy import Matrix, Rational, Symbol

from derive.control import tangent
from derive.control.kinematic import LAWS
from derive.lie.catalogue import GROUPS, named
from derive.lie.group import Group
from derive.verify.law import cut, exact, rest, slope
from derive.verify.law.cloud import cloud
from derive.verify.law.place import named as place_of
from derive.verify.law.place import numbers, where
from derive.verify.law.space import Space, turning
from tests.own import HEISENBERG, SL2, SO4, SPIRAL

EVERY = [*GROUPS.values(), named("S3 x SE2"), SL2, HEISENBERG]
each = pytest.mark.parametrize("group", EVERY, ids=[group.name for group in EVERY])


@each
def test_exp_and_log_are_those_of_matrices(group: Group) -> None:
    space = Space(group)
    x = np.random.default_rng(0).normal(size=group.dim)
    wanted = mpmath.expm(mpmath.matrix(space.hat(x).tolist()))
    np.testing.assert_allclose(space.exp(x), np.array(wanted.tolist(), float), atol=1e-13)
    small = 0.3 * x
    np.testing.assert_allclose(space.log(space.exp(small)), small, atol=1e-12)
    np.testing.assert_allclose(space.exp(1e-160 * x)[space.hat(x) != 0],
                               (space.one + 1e-160 * space.hat(x))[space.hat(x) != 0])  # fmt: skip


@each
def test_what_is_stored_is_what_the_group_reads(group: Group) -> None:
    space = Space(group)
    g = space.exp(np.random.default_rng(1).normal(size=group.dim))
    back = group.embed(Matrix([sympy.Float(x, 30) for x in space.store(g)]))
    np.testing.assert_allclose(np.array(back, float), g, atol=1e-14)


@pytest.mark.parametrize("angle", [0.3, 2.0, np.pi - 1e-6, 4.0, 6.2])
def test_angles(angle: float) -> None:
    x = np.array([0.0, 0.6, -0.8]) * angle
    assert Space(GROUPS["S3"]).angles(Space(GROUPS["S3"]).exp(x)) == pytest.approx([angle])
    folded = angle if angle < np.pi else 2 * np.pi - angle
    both = Space(named("SO3 x R3 x SO3"))
    found = both.angles(both.exp(np.array([*x, 1, 2, 3, 0.1, 0, 0])))
    assert found == pytest.approx([folded, 0.1], abs=1e-9)
    assert Space(GROUPS["SE3"]).angles(Space(GROUPS["SE3"]).exp(np.array([*x, 5, 6, 7]))) == (
        pytest.approx([folded], abs=1e-9)
    )


def test_what_turns_is_seen_in_the_basis_and_not_in_the_units() -> None:
    turns = {"SO2": 1, "SO3": 3, "S3": 3, "SE2": 1, "SE3": 3, "SE23": 3, "R3": 0}
    assert {name: turning(group) for name, group in GROUPS.items()} == turns
    for units in (("rad/s",) * 3, ("m/s", "rad/s", "1/s")):
        for group in (*GROUPS.values(), SL2, HEISENBERG, SO4):
            named_otherwise = replace(group, units=(units * 3)[: group.dim])
            assert turning(named_otherwise) == turns.get(group.name, 0)
    order = [GROUPS["SE2"].basis[i] for i in (1, 2, 0)]
    assert turning(replace(GROUPS["SE2"], basis=tuple(order))) == 0


def test_a_whole_turn_is_the_identity_but_on_s3() -> None:
    assert [name for name, group in GROUPS.items() if Space(group).whole is not None] == ["S3"]
    assert Space(GROUPS["S3"]).reach == 2 * np.pi
    whole = Space(GROUPS["S3"]).whole
    assert whole is not None
    np.testing.assert_allclose(whole, -np.eye(4), atol=1e-14)


@each
def test_exact_elements_are_on_the_group(group: Group) -> None:
    points = [*exact.general(group), *exact.turned(group)]
    assert len(exact.general(group)) >= 3
    for point in points:
        assert Matrix(group.embed(group.store(point.g))) == point.g
        assert exact.vanishes(list(group.residual(group.store(point.g))))
    space = Space(group)
    for point in exact.turned(group):
        angles = space.angles(np.array(point.g, float))
        assert max(angles) == pytest.approx({"pi": np.pi, "2 pi": 2 * np.pi}[point.where])
    assert bool(exact.turned(group)) == bool(space.turns)


def test_no_exact_elements_where_cayley_leaves_the_group() -> None:
    assert exact.general(SPIRAL) == ()


def test_exact_outputs_are_exact() -> None:
    group = GROUPS["SE3"]
    d = tangent.kinematics(group, LAWS["SE3", "log"])
    point = exact.general(group)[1]
    found = exact.outputs(d, {"g": group.store(point.g)})["nu_u"]
    assert not any(value.atoms(sympy.Float) for value in found)
    wanted = Space(group).log(np.array(point.g, float))
    np.testing.assert_allclose([float(value.evalf(30)) for value in found], wanted, atol=1e-12)
    assert exact.vanishes([sympy.sqrt(8) - 2 * sympy.sqrt(2), sympy.S.Zero])
    assert not exact.vanishes([Rational(1, 10**40)])
    assert not exact.vanishes([Symbol("x")])


def test_a_jump_is_found_where_it_is_and_its_size() -> None:
    space = Space(GROUPS["SO3"])

    def law(g: Any) -> Any:
        x = space.store(g)[..., [7, 2, 3]]
        return np.where(x[..., :1] > 0.123, x + 0.5, x)

    along = [cut.Curve(space, space.one, x) for x in np.eye(3)]
    found = cut.cuts(law, along[:1])
    assert [one.size for one in found] == pytest.approx([0.75**0.5] * 3)
    assert [float(np.sin(one.angles[0])) for one in found] == pytest.approx([0.123] * 3)
    assert not any(one.is_steep for one in found)
    assert cut.cuts(lambda g: space.store(g)[..., [7, 2, 3]], along) == []


def test_a_pole_has_no_bound_and_is_steep() -> None:
    space = Space(GROUPS["SO2"])
    curve = cut.Curve(space, space.one, np.ones(1))
    found = cut.cuts(lambda g: g[..., 1, :1] / (1 + g[..., 0, :1] + 1e-30), [curve])
    assert [(one.size, one.is_steep) for one in found] == [(np.inf, True)]


def test_equilibria_of_a_law_with_known_ones() -> None:
    """sin(2 phi) on SO2 vanishes at pi, which attracts, and at pi/2, which repels."""
    space = Space(GROUPS["SO2"])
    starts, _ = cloud(space, 60, np.random.default_rng(0))
    found = rest.rests(
        space, lambda g: 2 * g[..., 0, :1] * g[..., 1, :1], lambda g: np.ones(len(g)), starts
    )
    kinds = {(round(float(one.angles[0]) / np.pi, 6), one.dimension, one.repels) for one in found}
    assert kinds == {(0.5, 0, True), (1.0, 0, False)}


def test_the_fall_of_a_known_function() -> None:
    space = Space(GROUPS["SO3"])
    phi = np.array([0.1, 1.0, 3.0])
    g = space.exp(phi[:, None] * np.array([0.0, 0.6, 0.8]))
    nu = np.array([[0.0, 0.6, 0.8], [0.0, 6.0, 8.0], [0.8, 0.0, 0.0]])
    found = slope.fall(space, slope.values(space, "Psi"), g, nu)
    np.testing.assert_allclose(found, [np.sin(0.1), 10 * np.sin(1.0), 0.0], atol=1e-10)


def test_places_in_words() -> None:
    s3, both = Space(GROUPS["S3"]), Space(named("S3 x SO3"))
    for x, told in (((np.pi, 0, 0), "q0 = 0"), ((0, 0, 2 * np.pi), "-i"), ((1, 0, 0), "angle 1")):
        g = s3.exp(np.array(x))
        assert place_of(s3, g, s3.angles(g)) == told
    g = both.exp(np.array([0.5, 0, 0, 0, np.pi, 0]))
    assert place_of(both, g, both.angles(g)) == "rotations by pi of factor 2"
    assert where(s3, exact.general(GROUPS["S3"])[0]) == "general position"
    assert numbers([Rational(1, 3), 1e-14, 2.5, sympy.pi]) == "(1/3, 0, 2.5, 3.142)"
