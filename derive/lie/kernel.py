"""The special functions of rotation logarithms: definition, derivative, polynomial.

With the unit quaternion (w, v) of half angle u, w = cos u and s = |v| = sin u, the
logarithm is the rotation vector 2 k(w) v, where k(w) = u / sin u = arccos(w) / sqrt(1 - w^2).
As a function of z = 1 - w it is the Gauss series 2F1(1, 1; 3/2; z/2): analytic for w in
(-1, 1], so w = 1 is an ordinary point. Its derivatives form one closed family,

    Arc(n, w) = (-1)^n k^(n)(w),    d/dw Arc(n, w) = -Arc(n + 1, w),

named k, h, m for n = 0, 1, 2. Identities that tests hold them to, with s^2 = 1 - w^2:
s^2 h = 1 - w k and s^2 Arc(n+1) = n^2 Arc(n-1) - (2n+1) w Arc(n).
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import mpmath
import sympy

from derive.lie.minimax import minimax

NAMES = ("k", "h", "m")
"""Printed names of Arc(0, .), Arc(1, .), Arc(2, .)."""

DEGREES = {"f32": (9, 11, 13), "f64": (21, 23, 25)}
"""Degree of the polynomial in z on [0, 1] per scalar: below half an ulp of truncation."""

_DIGITS = 50

TINY = sympy.Symbol("TINY", positive=True)
"""A positive number that rounds away beside any normal one: keeps divisors from being zero."""

SMALL = sympy.Symbol("SMALL", positive=True)
"""Added to a divisor that vanishes at a pole; its inverse cube does not overflow."""

FLOOR = sympy.Symbol("FLOOR", positive=True)
"""Added to a squared sine that is divided by and multiplied with again: it rounds away there."""

CUT = sympy.Symbol("CUT", positive=True)
"""Least sine that an error beyond pi is divided by: where a law is refused, it stays bounded."""

LEAST = sympy.Symbol("LEAST", positive=True)
"""Least square of a quaternion's length: below that of any unit quaternion."""

NOISE = sympy.Symbol("NOISE", positive=True)
"""Of the terms of a determinant: what rounding may make of one that is zero."""

CONSTANTS = (TINY, SMALL, FLOOR, CUT, LEAST, NOISE)
"""All of them: zero in the maths, and a number in each scalar."""


class Arc(sympy.Function):
    """Arc(n, w), dimensionless: the n-th derivative of arccos(w)/sqrt(1 - w^2), sign (-1)^n."""

    nargs = (2,)
    is_real = True

    def fdiff(self, argindex: int = 2) -> sympy.Expr:
        """d/dw Arc(n, w) = -Arc(n + 1, w); the order n is not a variable."""
        if argindex != 2:
            raise sympy.core.function.ArgumentIndexError(self, argindex)
        order, w = self.args
        return -Arc(order + 1, w)

    def _eval_evalf(self, prec: int) -> sympy.Expr:
        order, w = self.args
        w = w._eval_evalf(prec + 20)
        if w is None or not w.is_number:
            return self
        with mpmath.workprec(prec + 20):
            value = exact(int(order), mpmath.mpf(w._to_mpmath(prec + 20)))
        return sympy.Float._new(value._mpf_, prec)


def K(w: sympy.Expr) -> sympy.Expr:
    """k(w) = arccos(w)/sqrt(1 - w^2), dimensionless; eq. (KinCtrlLawS3)."""
    return Arc(0, w)


def H(w: sympy.Expr) -> sympy.Expr:
    """h(w) = -k'(w), dimensionless: s^2 h = 1 - w k."""
    return Arc(1, w)


def M(w: sympy.Expr) -> sympy.Expr:
    """m(w) = k''(w), dimensionless: s^2 m = k - 3 w h."""
    return Arc(2, w)


def exact(order: int, w: mpmath.mpf) -> mpmath.mpf:
    """Arc(order, w) for w in (-1, 1] by the Gauss series, to mpmath's working precision."""
    lost = max(0, -int(mpmath.mag(1 + w)))  # near -1, by 1 - (1 - w)/2 within the series
    with mpmath.extraprec(lost + 10):
        n = mpmath.mpf(order)
        lead = mpmath.factorial(n) ** 2 / (mpmath.rf(mpmath.mpf(3) / 2, n) * mpmath.mpf(2) ** n)
        value = lead * mpmath.hyp2f1(1 + n, 1 + n, n + mpmath.mpf(3) / 2, (1 - w) / 2)
    return +value


@cache
def coefficients(order: int, scalar: str) -> tuple[Fraction, ...]:
    """Polynomial of Arc(order, 1 - z) on z in [0, 1], constant term first, exact rationals.

    Least relative error, and reproducible on every machine: each number has 50 digits.
    """
    with mpmath.workdps(_DIGITS):
        fit = minimax(cache(lambda z: exact(order, 1 - z)), DEGREES[scalar][order])
        return tuple(_rational(c) for c in fit)


def _rational(value: mpmath.mpf) -> Fraction:
    sign, mantissa, exponent, _ = value._mpf_
    return (-1 if sign else 1) * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
