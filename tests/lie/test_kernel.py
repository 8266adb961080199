"""The kernel functions against arccos, mpmath's derivatives and their own identities."""

from fractions import Fraction
from itertools import pairwise
from math import factorial, prod
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy

from derive.emit.literal import nearest
from derive.lie.kernel import DEGREES, NAMES, Arc, H, K, M, coefficients, exact

mp: Any = mpmath.mp.clone()
mp.dps = 60
ORDERS = range(len(NAMES))
PRECISIONS = [(scalar, order) for scalar in DEGREES for order in ORDERS]
POINTS = ["-0.999999999", "-0.9", "-0.3", "0", "1e-30", "0.5", "0.999", "0.99999999999999999999"]
TRUNCATION = {
    ("f32", 0): "1.2e-8", ("f32", 1): "5.9e-9", ("f32", 2): "1.8e-9",
    ("f64", 0): "5.2e-18", ("f64", 1): "5.4e-18", ("f64", 2): "3e-18",
}  # fmt: skip
"""Largest |p/f - 1| before any rounding. The double figures have no better polynomial."""
ROUNDED = (0.5, 0.5, 1)
"""Largest error in eps by order, the coefficients rounded and all else exact."""
COMPUTED = (1, 2, 4)
"""Largest error in eps by order, Horner's rule rounded at every step."""
TYPES: dict[str, Any] = {"f32": np.float32, "f64": np.float64}

w = sympy.Symbol("w", real=True)


def kernel(order: int, at: Any) -> Any:
    """The function under test, in 60 digits."""
    with mpmath.workdps(60):
        return mp.mpf(exact(order, mpmath.mpf(at._mpf_))._mpf_)


def ratio(at: Any) -> Any:
    return mp.acos(at) / mp.sqrt((1 - at) * (1 + at))


def horner(row: list[Any], z: Any) -> Any:
    value = row[-1]
    for c in row[-2::-1]:
        value = value * z + c
    return value


def series(order: int, z: Any) -> Any:
    """Gauss's series in long double, differentiated term by term: all terms are positive."""
    row = [np.longdouble(1)]
    for n in range(90):
        row.append(row[-1] * np.longdouble(n + 1) / np.longdouble(2 * n + 3))
    for _ in range(order):
        row = [np.longdouble(n) * c for n, c in enumerate(row)][1:]
    return horner(row, z)


def truncation(order: int, row: tuple[Fraction, ...], count: int) -> list[Any]:
    """p/f - 1 over [0, 1], densest at its ends."""
    numbers = [mp.mpf(c.numerator) / c.denominator for c in row]
    places = [(1 - mp.cos(mp.pi * i / count)) / 2 for i in range(count + 1)]
    return [horner(numbers, z) / kernel(order, 1 - z) - 1 for z in places]


@pytest.mark.parametrize("at", POINTS)
def test_k_is_the_angle_over_its_sine(at: str) -> None:
    c = mp.mpf(at)
    with mp.workdps(90):
        wanted = ratio(c)
    assert abs(kernel(0, c) / wanted - 1) < mp.mpf("1e-55")


@pytest.mark.parametrize("at", POINTS[:-1])
@pytest.mark.parametrize("order", [1, 2, 3])
def test_each_order_is_a_derivative_of_k(order: int, at: str) -> None:
    c = mp.mpf(at)
    with mp.workdps(150):
        wanted = (-1) ** order * mp.diff(ratio, c, order)
    assert abs(kernel(order, c) / wanted - 1) < mp.mpf("1e-40")


@pytest.mark.parametrize("order", range(6))
def test_one_is_an_ordinary_point(order: int) -> None:
    wanted = Fraction(factorial(order) ** 2, prod(range(1, 2 * order + 2, 2)))
    assert abs(kernel(order, mp.one) * wanted.denominator / wanted.numerator - 1) < mp.mpf("1e-58")


@pytest.mark.parametrize("at", POINTS)
def test_the_family_obeys_its_identities(at: str) -> None:
    c = mp.mpf(at)
    k, h, m, third = (kernel(order, c) for order in range(4))
    square = (1 - c) * (1 + c)
    for left, right, scale in (
        (square * h, 1 - c * k, 1),
        (square * m, k - 3 * c * h, k),
        (square * third, 4 * h - 5 * c * m, 4 * h),
    ):
        assert abs(left - right) < mp.mpf("1e-55") * (abs(scale) + abs(left))


def test_differentiation_stays_in_the_family() -> None:
    assert [K(w), H(w), M(w)] == [Arc(order, w) for order in ORDERS]
    for order in range(5):
        assert sympy.diff(Arc(order, w), w) == -Arc(order + 1, w)
    with pytest.raises(sympy.core.function.ArgumentIndexError):
        Arc(2, w).fdiff(1)


def test_the_chain_rule_runs_through_it() -> None:
    slope = sympy.diff(w * K(w**2) ** 3, w).subs(w, sympy.Rational(3, 5)).evalf(45)
    with mp.workdps(100):
        wanted = mp.diff(lambda x: x * ratio(x * x) ** 3, mp.mpf(3) / 5)
    assert abs(mp.mpf(slope._mpf_) / wanted - 1) < mp.mpf("1e-42")


@pytest.mark.parametrize("digits", [15, 50, 200])
def test_it_evaluates_to_the_digits_asked_for(digits: int) -> None:
    value = K(sympy.Rational(1, 3)).evalf(digits)
    with mp.workdps(digits + 20):
        error = mp.mpf(value._mpf_) / ratio(mp.mpf(1) / 3) - 1
        assert abs(error) < mp.mpf(10) ** (1 - digits)


def test_of_a_symbol_it_stays_itself() -> None:
    assert K(w).evalf(30) == K(w)
    assert (K(w) + sympy.pi).evalf(5).has(K(w))


@pytest.mark.parametrize(("scalar", "order"), PRECISIONS)
def test_truncation_is_within_its_limit(scalar: str, order: int) -> None:
    errors = truncation(order, coefficients(order, scalar), 500)
    assert max(map(abs, errors)) < mp.mpf(TRUNCATION[scalar, order])


@pytest.mark.parametrize(("scalar", "order"), PRECISIONS)
def test_no_polynomial_of_that_degree_is_better(scalar: str, order: int) -> None:
    """de la Vallee-Poussin: an error that swings degree + 2 times bounds every other's below."""
    row = coefficients(order, scalar)
    errors = truncation(order, row, 500)
    turns = [b for a, b, c in zip(errors, errors[1:], errors[2:], strict=False)
             if (b - a) * (c - b) < 0]  # fmt: skip
    swings = [errors[0], *turns, errors[-1]]
    assert len(row) == DEGREES[scalar][order] + 1
    assert len(swings) == len(row) + 1
    assert all(a * b < 0 for a, b in pairwise(swings))
    assert min(map(abs, swings)) > mp.mpf("0.99") * max(map(abs, swings))


@pytest.mark.parametrize(("scalar", "order"), PRECISIONS)
def test_rounding_the_coefficients_stays_within_its_limit(scalar: str, order: int) -> None:
    rounded = tuple(nearest(c, scalar) for c in coefficients(order, scalar))
    limit = ROUNDED[order] * np.finfo(TYPES[scalar]).eps
    assert max(map(abs, truncation(order, rounded, 150))) < limit


@pytest.mark.parametrize(("scalar", "order"), PRECISIONS)
def test_horner_stays_within_its_limit(scalar: str, order: int) -> None:
    """Over every 61st number of the grid of floats in [1/2, 1], and a grid below."""
    kind = TYPES[scalar]
    dense = np.arange(2**23, 2**24, 61, dtype=np.int64) / 2**24
    at = np.concatenate([dense, np.linspace(0, 0.5, 40001), [1.0]]).astype(kind)
    row = [kind(float(c)) for c in coefficients(order, scalar)]
    value = horner(row, kind(1) - at)
    assert value.dtype == kind
    error = value / series(order, 1 - at.astype(np.longdouble)) - 1
    assert np.abs(error).max() < COMPUTED[order] * np.finfo(kind).eps
