"""The tangent bundle as derivations: Lemmas 1 and 2 exactly, on exact elements of every group."""

from typing import Any

import pytest
import sympy
from sympy import Matrix, Rational

from derive.control import tangent
from derive.control.kinematic import LAWS
from derive.lie.catalogue import GROUPS, named
from derive.lie.group import Group
from derive.verify.law import exact

each_law = pytest.mark.parametrize(("name", "law"), LAWS, ids=map("-".join, LAWS))
GAIN = Rational(3, 7)

State = tuple[Matrix, Matrix]


class Exact:
    """The bundle of a group and a law in exact numbers, from the derivations alone."""

    def __init__(self, group: Group, law: str) -> None:
        from derive.control.kinematic import laws_of

        self.group, self.law = group, laws_of(group)[law]
        points = exact.general(group)
        assert len(points) >= 3
        nus = [Matrix([Rational(i * 5 + j, 3 + j) for j in range(group.dim)]) for i in range(3)]
        stored = (group.store(point.g) for point in points)
        self.states: list[State] = list(zip(stored, nus, strict=False))
        self.rest = (Matrix(group.identity), sympy.zeros(group.dim, 1))

    def star(self, a: State, b: State) -> State:
        d = tangent.star(self.group, self.law)
        return _state(d, rate_gain=GAIN, g1=a[0], nu1=a[1], g2=b[0], nu2=b[1])

    def inverse(self, h: State) -> State:
        return _state(tangent.inverse(self.group), g=h[0], nu=h[1])

    def s(self, h: State) -> Matrix:
        d = tangent.sliding(self.group, self.law)
        return Matrix(exact.outputs(d, {"rate_gain": GAIN, "g": h[0], "nu": h[1]})["s"])

    def above(self, g: Matrix) -> State:
        return _state(tangent.above(self.group, self.law), rate_gain=GAIN, g=g)


def _state(d: Any, **given: Any) -> State:
    found = exact.outputs(d, given)
    return Matrix(found["g"]), Matrix(found["nu"])


def same(a: State, b: State) -> bool:
    return exact.vanishes([*(a[0] - b[0]), *(a[1] - b[1])])


@each_law
def test_star_is_a_group(name: str, law: str) -> None:
    b = Exact(GROUPS[name], law)
    x, y, z = b.states
    assert same(b.star(x, b.rest), x)
    assert same(b.star(b.rest, x), x)
    assert same(b.star(x, b.inverse(x)), b.rest)
    assert same(b.star(b.inverse(x), x), b.rest)
    assert same(b.star(b.star(x, y), z), b.star(x, b.star(y, z)))


@each_law
def test_h_is_a_subgroup_and_s_a_homomorphism(name: str, law: str) -> None:
    b = Exact(GROUPS[name], law)
    x, y, _ = b.states
    assert exact.vanishes(list(b.s(b.star(x, y)) - b.s(x) - b.s(y)))
    assert exact.vanishes(list(b.s(b.inverse(x)) + b.s(x)))
    assert not exact.vanishes(list(b.s(x)))
    h1, h2 = b.above(x[0]), b.above(y[0])
    assert exact.vanishes([*b.s(h1), *b.s(h2), *b.s(b.star(h1, h2)), *b.s(b.inverse(h1))])


@pytest.mark.parametrize("name", ["SO3 x R3", "S3 x SE2"])
def test_products_too(name: str) -> None:
    b = Exact(named(name), "log")
    x, y, z = b.states
    assert same(b.star(b.star(x, y), z), b.star(x, b.star(y, z)))
    assert same(b.star(x, b.inverse(x)), b.rest)


@pytest.mark.parametrize("name", GROUPS)
def test_the_product_and_the_inverse_are_those_of_matrices(name: str) -> None:
    group = GROUPS[name]
    b = Exact(group, next(law for one, law in LAWS if one == name))
    (g1, nu1), (g2, _), _ = b.states
    first, second = (Matrix(group.embed(g)) for g in (g1, g2))
    assert Matrix(group.embed(b.star(b.states[0], b.states[1])[0])) == first * second
    back, nu = b.inverse(b.states[0])
    assert Matrix(group.embed(back)) == first.inv()
    assert nu == -nu1
    assert _state(tangent.identity(group)) == b.rest
    assert g2 != g1


def test_the_formula_is_the_papers() -> None:
    """Eq. (BnyOp) on R3, where nu_u(g) = g: the three laws cancel; on SO3 they do not."""
    flat, turned = Exact(GROUPS["R3"], "log"), Exact(GROUPS["SO3"], "skew")
    for b, is_plain in ((flat, True), (turned, False)):
        x, y, _ = b.states
        off = b.star(x, y)[1] - x[1] - y[1]
        assert exact.vanishes(list(off)) == is_plain
    x, y, _ = turned.states
    vee = [GROUPS["SO3"].vee(g - g.T) / 2 for g in _rotations(turned, x, y)]
    wanted = x[1] + y[1] + GAIN * (vee[0] + vee[1] - vee[2])
    assert exact.vanishes(list(turned.star(x, y)[1] - wanted))


def _rotations(b: Exact, x: State, y: State) -> list[Matrix]:
    one, two = (Matrix(h[0]).reshape(3, 3) for h in (x, y))
    return [one, two, one * two]
