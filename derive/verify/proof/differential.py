"""D log = f(ad_x), f(z) = z/(1 - e^-z), as a polynomial in ad_x: which one, and why it is that.

A polynomial p stands for f on a matrix if it has f's values, and derivatives up to the
multiplicity, at the roots of the minimal polynomial z^a (z^2 + phi^2)^c (Hermite). They are
compared as elements of Q(i)(phi, C, S) modulo C^2 + S^2 - 1, where e^(-i phi) = (C - i S)^2.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import sympy
from sympy import QQ, Expr, Matrix, Rational, ring

from derive.control.kinematic import laws_of
from derive.lie.group import Group
from derive.lie.jacobian import Spectrum, spectrum
from derive.verify.proof.emitted import COUNT, EXACT, Lawful, as_derived
from derive.verify.proof.exponential import Turn
from derive.verify.proof.model import numbers
from derive.verify.proof.point import points
from derive.verify.proof.statement import Fact, Statement, vanish

phi, C, S, i, z, e = sympy.symbols("phi C S i z e")

KINDS = (
    *((zeros, 0) for zeros in range(1, 9)),
    *((zeros, turns) for zeros in (1, 2) for turns in (1, 2)),
)
"""Multiplicities (a, c) of 0 and of +-i phi for which the formula of lie.jacobian is made."""

Coefficients = Callable[[int, int, Expr, Expr, Expr, Expr], list[Expr]]


def coefficients(zeros: int, turns: int, k: Expr, h: Expr, m: Expr, square: Expr) -> list[Expr]:
    """Of p(z), constant first: nu + k Y nu + … of lie.jacobian with Y = z/(2 k)."""
    if not turns:
        return [sympy.bernoulli(n) / sympy.factorial(n) for n in range(zeros)]
    double = h**2 - k * m / 2 if turns == 2 else sympy.S.Zero
    scaled = [sympy.S.One, k, h + double * square, sympy.S.Zero, double]
    return [one / (2 * k) ** n for n, one in enumerate(scaled)]


def _interpolates(_: object, claim: Coefficients) -> Iterator[Fact]:
    for zeros, turns in KINDS:
        p = sum(one * z**n for n, one in enumerate(claim(zeros, turns, *_kernel())))
        what = f"p = f on z^{zeros} (z^2 + phi^2)^{turns}"
        at_zero = [p.diff(z, n).subs(z, 0) / sympy.factorial(n) for n in range(zeros)]
        yield vanish(f"{what}, at 0", _residues(at_zero, _series(zeros)))
        f = z / (1 - e)
        slope = f.diff(z) - e * f.diff(e)  # e = e^-z
        root = {z: i * phi, e: (C - i * S) ** 2}
        there = [value.subs(root) for value in (f, slope)[:turns]]
        found = [value.subs(root) for value in (p, sympy.diff(p, z))[:turns]]
        yield vanish(f"{what}, at i phi", _residues(found, there))


def _kernel() -> tuple[Expr, Expr, Expr, Expr]:
    """k, h, m and s^2 at half the angle phi."""
    k = phi / (2 * S)
    h = (1 - C * k) / S**2
    return k, h, (k - 3 * C * h) / S**2, S**2


def _series(count: int) -> list[Rational]:
    """Of f at 0, by long division of 1 by (1 - e^-z)/z."""
    below = [Rational((-1) ** n, sympy.factorial(n + 1)) for n in range(count)]
    found: list[Rational] = []
    for n in range(count):
        found.append(int(n == 0) - sum(below[n - j] * one for j, one in enumerate(found)))
    return found


def _residues(found: Sequence[Expr], truth: Sequence[Expr]) -> list[Any]:
    """Numerators of the differences modulo i^2 + 1 and C^2 + S^2 - 1; no denominator is zero."""
    polynomials, *_ = ring([phi, C, S, i], QQ)
    ideal = [polynomials.from_expr(one) for one in (C**2 + S**2 - 1, i**2 + 1)]
    residues = []
    for a, b in zip(found, truth, strict=True):
        over, under = sympy.fraction(sympy.together(a - b))
        if not polynomials.from_expr(sympy.expand(under)).rem(ideal):
            raise ZeroDivisionError(under)
        residues.append(polynomials.from_expr(sympy.expand(over)).rem(ideal))
    return residues


@dataclass(frozen=True)
class Reduction:
    """What is claimed of a group: the minimal polynomial of its ad, and p for it.

    factor: of phi^2
    """

    kind: Callable[[Group], Spectrum] = spectrum
    p: Coefficients = coefficients
    factor: int = 1


def _is_reduced(group: Group, claim: Reduction) -> Iterator[Fact]:
    """At exact points x; the rate as it is derived for the code."""
    kind, rng = claim.kind(group), random.Random(group.name)
    of = Lawful(group, laws_of(group)["log"])
    for point in points(group, COUNT, seed=4):
        (half,), nu = point.halves, numbers(group.dim, rng)
        A = group.ad(point.x)
        square = 4 * half.square * claim.factor * A**0
        yield vanish("ad^a (ad^2 + phi^2)^c = 0", A**kind.zeros * (A**2 + square) ** kind.turns)
        value = _horner(claim.p(kind.zeros, kind.turns, *_values(half)), A, nu)
        yield vanish("x' = p(ad_x) nu", as_derived(of, point, nu)[1] - value)


def _values(half: Turn) -> tuple[Rational, Rational, Rational, Rational]:
    """k, h, m and s^2 at an exact point; any numbers where nothing turns."""
    k, square = 1 / half.sine, (half.square or 1) * half.sine**2
    h = (1 - half.cosine * k) / square
    return k, h, (k - 3 * half.cosine * h) / square, square


def _horner(p: Sequence[Rational], A: Matrix, nu: Matrix) -> Matrix:
    total = 0 * nu
    for one in reversed(p):
        total = A * total + one * nu
    return total


def _fewer(group: Group) -> Spectrum:
    kind = spectrum(group)
    return replace(kind, zeros=kind.zeros - 1)


def _wrong(change: str, *given: Any) -> list[Expr]:
    """The polynomial with one thing changed."""
    zeros, turns, k, h, m, square = given
    if change == "h":
        return coefficients(zeros, turns, k, -h, m, square)
    if change == "m":
        return coefficients(zeros, turns, k, h, 2 * m, square)
    if change == "twice":
        return [2 * one for one in coefficients(*given)]
    return [(-1) ** n * one for n, one in enumerate(coefficients(*given))]


STATEMENTS = (
    Statement(
        "D log is this polynomial in ad", "mathematics, f(z) = z/(1-e^-z)", "modulo C^2+S^2-1",
        "reduction", _interpolates, coefficients,
        {
            "the sign of h": partial(_wrong, "h"),
            "h^2 - k m for h^2 - k m/2": partial(_wrong, "m"),
            "f(-z)": partial(_wrong, "z"),
        },
    ),
    Statement(
        "minimal polynomial of ad, and log' as that", "eq. (KinCtrlLawSO3)", EXACT, "spectrum",
        _is_reduced, Reduction(),
        {
            "one factor z fewer": Reduction(kind=_fewer),
            "twice the polynomial": Reduction(p=partial(_wrong, "twice")),
            "f(-z)": Reduction(p=partial(_wrong, "z")),
            "twice phi^2": Reduction(factor=2),
        },
    ),
)  # fmt: skip
"""Statements about the differential of the logarithm."""
