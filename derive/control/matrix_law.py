"""Laws of any matrix group: its logarithm, where that has a closed form, and two that need none.

skew    vee(g - g^-1)/2                 rate vee(g nu^ + nu^ g^-1)/2
cayley  2 vee((g - 1)(g + 1)^-1) = 2 c  rate nu + [c, nu] - vee(c^ nu^ c^)
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import sympy
from sympy import Matrix, Rational, eye

from derive.control.law import KinematicLaw, Written
from derive.lie.cover import Let
from derive.lie.group import Group
from derive.lie.jacobian import log_rate
from derive.lie.kernel import TINY

Write = Callable[[Let, Group, Matrix], Written]


def _log(let: Let, group: Group, g_e: Matrix) -> Written:
    """The group's chart and its exact differential."""
    if group.chart is None:
        raise ValueError(f"{group.name} has no closed-form logarithm")
    chart = group.chart(let, g_e)
    return Written(chart.log, lambda let, nu_e: log_rate(let, group, chart, nu_e), chart.clearance)


def _skew(let: Let, group: Group, g_e: Matrix) -> Written:
    """Odd part of g; no logarithm is needed."""
    g = group.embed(g_e)
    back = group.inverse(g)

    def rate(let: Let, nu_e: Matrix) -> Matrix:
        flow = group.hat(nu_e)
        return group.vee(g * flow + flow * back) / 2

    return Written(group.vee(g - back) / 2, rate, sympy.S.One)


def _cayley(let: Let, group: Group, g_e: Matrix) -> Written:
    """Cayley's map backwards; its rate needs no further inverse."""
    if group.chart is not None and (chart := group.chart(let, g_e)).tangent is not None:
        half, clearance = chart.tangent(let), chart.clearance
    else:
        half, clearance = _quotient(let, group, group.embed(g_e))
    c = let("c", half, group.log_unit, "vee of (g_e - 1)(g_e + 1)^-1")
    matrix = group.hat(c)

    def rate(let: Let, nu_e: Matrix) -> Matrix:
        bend = group.vee(matrix * group.hat(nu_e) * matrix)
        return nu_e + group.bracket(c, nu_e) - bend

    return Written(2 * c, rate, clearance)


def _quotient(let: Let, group: Group, g: Matrix) -> tuple[Matrix, sympy.Expr]:
    """vee((g - 1)(g + 1)^-1) by the adjugate of g + 1 (Faddeev and LeVerrier), and the clearance.

    The clearance is |det(g + 1)|/2^m, 1 at the identity.
    """
    m = g.rows
    a, adjugate, trace = g + eye(m), eye(m), sympy.S.One
    for order in range(1, m + 1):
        product = a * adjugate
        trace = let(f"trace_{order}", product.trace() / order, "1", "a coefficient of det(g + z)")
        if order < m:
            entries = Matrix(list(trace * eye(m) - product))
            adjugate = let(f"minor_{order}", entries, "1", "towards the adjugate").reshape(m, m)
    inverse = let("inverse", trace / (trace**2 + TINY), "1", "1/det(g + 1), finite at a pole")
    value = inverse * group.vee((g - eye(m)) * adjugate)
    return value, let("distance", sympy.Abs(trace) / 2**m, "1", "|det(g + 1)|/2^m")


def _in_first(write: Write) -> Write:
    """The law as computed in the first basis of a group that is in another one."""

    def moved(let: Let, group: Group, g_e: Matrix) -> Written:
        if group.first is None:
            return write(let, group, g_e)
        first, basis = group.first
        there, back = write(let, first, g_e), basis.inv()
        value = let("law_old", there.value, first.log_unit, "the law in the first basis")

        def rate(let: Let, nu_e: Matrix) -> Matrix:
            old = let("nu_old", basis * nu_e, first.unit, "nu_e in the first basis")
            return back * let("rate_old", there.rate(let, old), first.unit, "rate of the law there")

        return Written(back * value, rate, there.clearance)

    return moved


IDENTITY = KinematicLaw("log", _log, "the element itself")
"""On R^n all laws agree."""


@cache
def laws_of(group: Group) -> dict[str, KinematicLaw]:
    """The laws of a group that is no product and has no quaternion."""
    if not any(map(any, group.structure)) and group.chart and group.short_error:
        return {"log": IDENTITY}
    laws = []
    if group.chart:
        laws.append(KinematicLaw("log", _log, "the logarithm"))
    laws.append(KinematicLaw("skew", _in_first(_skew), "vee(g - g^-1)/2"))
    if keeps_odd_powers(group):
        doc = "2 vee((g - 1)(g + 1)^-1)"
        laws.append(KinematicLaw("cayley", _in_first(_cayley), doc, is_pole=True))
    return {law.name: law for law in laws}


@cache
def keeps_odd_powers(group: Group) -> bool:
    """Whether X^3, X^5, … of X in the algebra are in it too, so that odd laws do not leave it.

    Decided exactly at one rational point in general position.
    """
    X = group.hat(Matrix([Rational(7 + 5 * i * i, 11 + 2 * i) for i in range(group.dim)]))
    power = X
    for _ in range(X.rows):
        power = power * X * X
        if group.hat(group.vee(power)) != power:
            return False
    return True
