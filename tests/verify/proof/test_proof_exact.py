"""Exact points and what is computed at them, against scipy, mpmath and sympy's own calculus."""

from __future__ import annotations

import random
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy
from scipy.linalg import expm
from sympy import QQ, Abs, Matrix, Piecewise, Rational, Symbol, diag, sqrt, symbols

from derive.control.kinematic import laws_of
from derive.lie.group import Group
from derive.lie.kernel import H, K
from derive.verify.proof.differential import KINDS, _kernel, _series, coefficients
from derive.verify.proof.dual import Walk, root
from derive.verify.proof.emitted import COUNT, Lawful, inputs
from derive.verify.proof.exponential import (
    Turn,
    derivative,
    exponential,
    one_parameter,
    square_of_pair,
)
from derive.verify.proof.model import N, element
from derive.verify.proof.point import Point, evaluated, points
from tests.verify.groups import AFFINE, EVERY, SIMILAR, SL3, SO4

TURNING = [name for name, group in EVERY.items() if group.chart and not group.factors]


def floats(matrix: Matrix) -> np.ndarray:
    return np.array(matrix.evalf(30).tolist(), float)


def at_true_angle(square: Rational) -> Turn:
    """The functions themselves, to 40 digits."""
    with mpmath.workdps(50):
        theta = mpmath.sqrt(mpmath.mpf(int(square.p)) / int(square.q))
        if not theta:
            return Turn(*map(sympy.S, (0, 1, 1, sympy.S.Half)))
        values = mpmath.cos(theta), mpmath.sin(theta) / theta, (1 - mpmath.cos(theta)) / theta**2
        return Turn(square, *(Rational(mpmath.nstr(value, 45)) for value in values))


@pytest.mark.parametrize("name", TURNING)
def test_the_exponential_is_that_of_scipy_at_the_true_angle(name: str) -> None:
    group, rng = EVERY[name], random.Random(name)
    for _ in range(5):
        x = Matrix([Rational(rng.randint(-20, 20), 7) for _ in range(group.dim)])
        y = Matrix([Rational(rng.randint(-20, 20), 7) for _ in range(group.dim)])
        X, Y, h = group.hat(x), group.hat(y), 1e-6
        turn = at_true_angle(square_of_pair(X))
        truth = expm(floats(X))
        slope = (expm(floats(X) + h * floats(Y)) - expm(floats(X) - h * floats(Y))) / (2 * h)
        found = floats(exponential(X, turn)), floats(derivative(X, Y, turn))
        for value, right, relative in zip(found, (truth, slope), (1e-12, 1e-6), strict=True):
            np.testing.assert_allclose(value, right, rtol=0, atol=relative * abs(right).max())


@pytest.mark.parametrize("t", [Rational(1, 3), Rational(-5, 2)])
@pytest.mark.parametrize("square", [Rational(2), Rational(-3)])
def test_a_turn_is_a_point_of_its_conic_and_doubles(square: Rational, t: Rational) -> None:
    turn = Turn.at(square, t)
    assert turn.cosine**2 + square * turn.sine**2 == 1
    assert turn.versine == (1 - turn.cosine) / square
    double = turn.double
    assert double.cosine == 2 * turn.cosine**2 - 1
    assert double.square == 4 * square
    assert double.sine == turn.sine * turn.cosine
    assert double.versine == (1 - double.cosine) / double.square


@pytest.mark.parametrize(
    "generator",
    [
        Matrix([[0, 1, 2], [0, 0, 3], [0, 0, 0]]),
        diag(1, -1, 0),
        diag(2, 2, -4),
        Matrix([[0, -2, 1], [2, 0, 0], [0, 0, 0]]),
        Matrix([[0, 2], [1, 0]]),
        Matrix([[1, 1, 0], [0, 1, 0], [0, 0, -2]]),
    ],
)
def test_an_element_of_one_parameter_obeys_what_the_exponential_obeys(generator: Matrix) -> None:
    """It commutes with the generator, as exp(t E) does, and has its invariants and determinant."""
    g = one_parameter(generator, Rational(1, 3))
    assert g != g**0
    assert g * generator == generator * g
    flow = expm(0.37 * floats(generator))
    kept = [
        P for P in quadratic_forms(generator) if np.allclose(flow.T @ floats(P) @ flow, floats(P))
    ]
    assert all(g.T * P * g == P for P in kept)
    if generator.trace() == 0:
        assert g.det() == 1


def quadratic_forms(generator: Matrix) -> list[Matrix]:
    m = generator.rows
    unknown = Matrix(m, m, symbols(f"p:{m * m}"))
    rows = list(generator.T * unknown + unknown * generator)
    return [Matrix(m, m, list(one)) for one in Matrix(rows).jacobian(list(unknown)).nullspace()]


@pytest.mark.parametrize("group", [SL3, AFFINE, SIMILAR, SO4], ids=lambda group: group.name)
def test_elements_are_of_the_group_though_cayley_leaves_it(group: Group) -> None:
    g = element(group, random.Random(5))
    assert not any(group.residual(group.store(g)))
    assert g * group.inverse(g) == sympy.eye(g.rows)
    for e in group.basis:
        moved = g * e * g.inv()
        assert group.hat(group.vee(moved)) == moved


@pytest.mark.parametrize("matrix", [diag(sqrt(2), 0), Matrix([[0, 0, 2], [1, 0, 0], [0, 1, 0]])])
def test_other_eigenvalues_are_refused(matrix: Matrix) -> None:
    with pytest.raises((ValueError, TypeError, sympy.polys.polyerrors.CoercionFailed)):
        one_parameter(matrix, Rational(1, 2))
    with pytest.raises(ValueError, match="besides 0 and one pair"):
        exponential(diag(1, 2))


x, y = symbols("x y", real=True)


@pytest.mark.parametrize(
    "value",
    [
        x**2 * y - 3 / x + Rational(1, 7),
        sqrt(x**2 + 2 * x * y + y**2) + 1 / sqrt(4 * y**2),
        Abs(x - 5 * y) ** 3,
        Piecewise((x, x >= y), (y**2, (y > 0) & (x < 1)), (sympy.S.One, True)),
        -x * y + sympy.pi * x,
    ],
)
def test_a_walk_finds_value_and_rate(value: sympy.Expr) -> None:
    at, moves, pi = (
        {x: Rational(2, 3), y: Rational(5, 4)},
        {x: Rational(1, 2), y: Rational(-3)},
        QQ(22, 7),
    )
    known = {one: (QQ(at[one].p, at[one].q), QQ(moves[one].p, moves[one].q)) for one in at}
    found = Walk(known, {}, pi)(value)
    freed = value.subs(sympy.pi, Rational(22, 7))
    slope = sum(sympy.diff(freed, one) * moves[one] for one in at)
    assert Fraction(int(found[0].numerator), int(found[0].denominator)) == freed.subs(at)
    assert Fraction(int(found[1].numerator), int(found[1].denominator)) == slope.subs(at)


def test_what_is_not_rational_is_refused() -> None:
    walk = Walk({x: (QQ(2), QQ(0))}, {}, QQ(3))
    for value in (sqrt(x), x ** Rational(1, 3), sympy.sin(x)):
        with pytest.raises(ValueError, match=r"rational|square|no rule"):
            walk(value)
    with pytest.raises(ValueError, match="no square"):
        root(QQ(-4, 9))
    with pytest.raises(KeyError):
        walk(K(x))


def test_the_kernel_is_differentiated_within_its_family() -> None:
    kernel = {(0, QQ(1, 2)): QQ(7), (1, QQ(1, 2)): QQ(11)}
    walk = Walk({x: (QQ(1, 2), QQ(3))}, kernel, QQ(3))
    assert walk(K(x)) == (QQ(7), QQ(-33))
    with pytest.raises(KeyError):
        walk(H(x))


@pytest.mark.parametrize("name", ["SO3", "S3", "SE3", "SE2"])
def test_the_formal_kernel_keeps_the_identities_of_the_true_one(name: str) -> None:
    for point in points(EVERY[name], COUNT):
        for (order, w), k in point.kernel.items():
            if order:
                continue
            h, m, square = point.kernel[1, w], point.kernel[2, w], 1 - w**2
            assert square * h == 1 - w * k
            assert square * m == k - 3 * w * h


def branches(name: str, step: str) -> set[object]:
    """Which cases of a step the points of a law meet."""
    group = EVERY[name]
    of = Lawful(group, laws_of(group)["log"])
    _, term = of.derivation.step(step).terms[0]
    met = set()
    for point in points(group, COUNT):
        d = of.derivation
        known = evaluated(d, inputs(d, g=point.stored), point)
        walk = Walk(dict(known), point.kernel, None)
        met.add(next(case for case, when in term.args if walk.holds(when)))
    return met


@pytest.mark.parametrize(
    ("name", "step", "cases"),
    [
        ("SO3", "column", 4),
        ("SE3", "column", 4),
        ("SO2", "column", 3),
        ("SE2", "column", 3),
        ("S3", "k", 2),
    ],
)
def test_the_points_of_a_law_meet_every_branch(name: str, step: str, cases: int) -> None:
    assert len(branches(name, step)) == cases


@pytest.mark.parametrize("name", ["SE3", "SE23", "S3", "SE3 x SO3", "SL3"])
def test_degrees_are_far_below_what_the_error_is_stated_for(name: str) -> None:
    """A rational function of degree d in numbers of b bits has some d b bits."""
    group = EVERY[name]
    law = next(iter(laws_of(group).values()))
    of = Lawful(group, law)
    (point,) = points(group, 1)
    assert isinstance(point, Point)
    d = of.derivation
    moving = Matrix([Rational(2 * k + 1, N) for k in range(group.dim)])
    known = evaluated(d, inputs(d, g=point.stored, nu_e=moving), point)
    bits = max(int(value.numerator).bit_length() for value, _ in known.values())
    assert bits / 61 < 2**12


@pytest.mark.parametrize("kind", KINDS)
def test_the_polynomial_is_f_at_numbers_too(kind: tuple[int, int]) -> None:
    """At z = i phi, with phi, C and S true, in mpmath."""
    zeros, turns = kind
    if not turns:
        z = Symbol("z")
        truth = sympy.series(z / (1 - sympy.exp(-z)), z, 0, zeros).removeO()
        assert _series(zeros) == [truth.coeff(z, n) for n in range(zeros)]
        return
    with mpmath.workdps(30):
        angle = mpmath.mpf("1.3")
        numbers = {
            Symbol("phi"): angle,
            Symbol("C"): mpmath.cos(angle / 2),
            Symbol("S"): mpmath.sin(angle / 2),
        }
        p = [sympy.sympify(c).subs(numbers) for c in coefficients(zeros, turns, *_kernel())]
        z = mpmath.mpc(0, angle)
        value = sum(mpmath.mpmathify(sympy.N(c, 30)) * z**n for n, c in enumerate(p))
        assert abs(value - z / (1 - mpmath.exp(-z))) < 1e-14
