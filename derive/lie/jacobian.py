"""The exact differential of the logarithm: one formula for all groups.

Along g' = g hat(nu) the coordinates x = log g move with x' = f(ad_x) nu, f(z) = z/(1 - e^-z).
Reduced by the minimal polynomial of ad_x, f is a polynomial with analytic coefficients. With
one rotation of half angle u, y = x/(2 k), Y = ad_y and s = sin u it is

    nu + k Y nu + h Y^2 nu + (h^2 - k m/2) (Y^4 + s^2 Y^2) nu,

the last term only where the roots +-i s of Y are double; where ad_x is nilpotent, f is the
series 1 + z/2 + z^2/12 - z^4/720 + …, which ends. No inverse, no trigonometry, nothing cancels.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy
from sympy import Matrix, Poly, Rational, Symbol

from derive.lie.chart import Chart
from derive.lie.cover import Let
from derive.lie.group import Group
from derive.lie.kernel import H, K, M


@dataclass(frozen=True)
class Spectrum:
    """Minimal polynomial z^zeros (z^2 + phi^2)^turns of a generic ad_x.

    still: the rows of ad_x (ad_x^2 + phi^2) that vanish for every x
    """

    zeros: int
    turns: int
    still: tuple[int, ...]


@cache
def spectrum(group: Group) -> Spectrum:
    """The minimal polynomial of ad, exactly, at a rational point in general position.

    Raises ValueError where it is of another kind: then no closed form is known here.
    """
    A = group.ad(Matrix([Rational(7 + 5 * i * i, 11 + 2 * i) for i in range(group.dim)]))
    square = _square(group, A)
    one = sympy.eye(group.dim)
    turns = 0
    if square:
        turns = next((c for c in (1, 2) if not any(A**2 * (A**2 + square * one) ** c)), 0)
    rest = (A**2 + square * one) ** turns
    zeros = next((a for a in range(1, group.dim + 1) if not any(A**a * rest)), 0)
    if not zeros or (square and not (turns and zeros <= 2)):
        raise ValueError(f"{group.name}: ad has a minimal polynomial of another kind")
    once = A * (A**2 + square * one)
    still = tuple(i for i in range(group.dim) if not any(once[i, :]))
    return Spectrum(zeros, turns, still)


def _square(group: Group, A: Matrix) -> Rational:
    """phi^2 of the one pair of eigenvalues +-i phi of A, zero where A is nilpotent."""
    z = Symbol("z")
    _, factors = sympy.factor_list(A.charpoly(z).as_expr(), z)
    found = {Poly(factor, z) for factor, _ in factors} - {Poly(z, z)}
    if not found:
        return sympy.S.Zero
    first = found.pop()
    leading, middle, last = first.all_coeffs() if first.degree() == 2 else (1, 1, 0)
    if found or middle or last / leading <= 0 or not _turns_everywhere(group):
        raise ValueError(f"{group.name}: ad has eigenvalues besides 0 and one pair +-i phi")
    return last / leading


def _turns_everywhere(group: Group) -> bool:
    """Whether phi^2, the trace of -ad_x^2 up to a factor, is nowhere negative."""
    n, C = group.dim, group.structure
    return bool(Matrix(n, n, lambda i, j: -(C[i] * C[j]).trace()).is_positive_semidefinite)


def log_rate(let: Let, group: Group, chart: Chart, nu: Matrix) -> Matrix:
    """Rate of the logarithm, (n, 1), along g' = g hat(nu), as an expression over its steps."""
    if group.first:
        first, basis = group.first
        old = let("nu_old", basis * nu, first.unit, "nu_e in the first basis")
        rate = let("rate_old", log_rate(let, first, chart, old), first.unit, "rate of log there")
        return basis.inv() * rate
    kind = spectrum(group)
    ad_y = group.ad(chart.scaled)
    if not kind.turns or chart.w is None:
        return _finite(let, group, ad_y, kind.zeros, nu)
    w = chart.w
    turn = let("turn", ad_y * nu, group.unit, "Y nu_e, Y = ad of y")
    bend = let("bend", ad_y * turn, group.unit, "Y Y nu_e")
    value = nu + K(w) * turn + H(w) * bend
    if kind.turns == 1:
        return value
    let("m", M(w), "1", "-dh/dw", stands_for=M(w))
    double = H(w) ** 2 - K(w) * M(w) / 2
    if chart.short_tail:
        rows = chart.short_tail(let, bend)
    else:
        square = let("square", chart.square, "1", "s^2")
        moved = list(ad_y * bend + square * turn)
        kept = [sympy.S.Zero if i in kind.still else x for i, x in enumerate(moved)]
        rows = ad_y * let("twist", Matrix(kept), group.unit, "(Y^2 + s^2) Y nu_e")
    tail = let("tail", rows, group.unit, "(Y^2 + s^2) Y^2 nu_e")
    return value + let("twofold", double, "1", "h^2 - k m/2, of the double root") * tail


def _finite(let: Let, group: Group, ad_x: Matrix, zeros: int, nu: Matrix) -> Matrix:
    """The series of f up to the power that vanishes; B_1 = +1/2."""
    power, total = nu, nu
    for order in range(1, zeros):
        power = let(f"bracket_{order}", ad_x * power, group.unit, "ad_x, once more")
        total = total + sympy.bernoulli(order) / sympy.factorial(order) * power
    return total
