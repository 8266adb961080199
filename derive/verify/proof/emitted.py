"""The laws that are derived for the code and their rates, proved at exact points.

Every step is evaluated as it is derived, cases and roots included, and differentiated by the
chain rule, step by step; see point. Random points meet each branch of a law.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import sympy
from sympy import Expr, Matrix, Rational, Symbol

from derive.control.kinematic import KinematicLaw, apply
from derive.lie.group import Group
from derive.routine.derivation import Derivation, Quantity
from derive.verify.proof.dual import Dual, Walk, shown
from derive.verify.proof.exponential import derivative
from derive.verify.proof.model import numbers
from derive.verify.proof.point import Point, assigned, evaluated, points
from derive.verify.proof.statement import Fact, Statement, vanish

COUNT = 8
"""Points of a law: enough to meet every branch, which a test confirms."""

EXACT = "exact points, error < 2^-40"
"""Random points, 2^61 values for each free number, degrees below 2^20."""


@dataclass(frozen=True)
class Lawful:
    """A law on a group, and its steps as they are derived."""

    group: Group
    law: KinematicLaw

    @cached_property
    def derivation(self) -> Derivation:
        """From g and nu_e to nu_u and nu_u_dot."""
        d, n = Derivation(self.law.name, "", ""), self.group.dim
        g = d.take(Quantity("g", self.group.size, "", ""))
        nu_e = d.take(Quantity("nu_e", n, "", ""))
        value, rate, _ = apply(self.law, d, self.group, g, nu_e)
        d.give(Quantity("nu_u", n, "", ""), value)
        d.give(Quantity("nu_u_dot", n, "", ""), rate)
        return d.pruned()


def flow(group: Group, stored: Matrix, nu: Matrix) -> Matrix:
    """Rate of the stored numbers, (k, 1), along g' = g hat(nu); they are linear in g."""
    nothing = group.store(sympy.zeros(group.basis[0].rows))
    return group.store(group.embed(stored) * group.hat(nu)) - nothing


def only(d: Derivation, output: str) -> Derivation:
    """The steps that one output needs."""
    return replace(d, outputs=[row for row in d.outputs if row[0].name == output]).pruned()


def inputs(d: Derivation, **values: Any) -> dict[Expr, Any]:
    """Symbols of the inputs with their values; those that are not named are zero."""
    rows = ((q, values.get(q.name, sympy.zeros(q.size, 1))) for q in d.inputs)
    return {s: x for q, row in rows for s, x in assigned(q.symbols(), row).items()}


def output(d: Derivation, name: str, known: Mapping[Symbol, Dual], rate: bool = False) -> Matrix:
    """The value of an output, (k, 1), or its rate."""
    (entries,) = (entries for quantity, entries in d.outputs if quantity.name == name)
    walk = Walk(dict(known), {}, None)
    return Matrix([shown(walk(entry)[rate]) for entry in entries])


Law = Callable[[Lawful, Point, Matrix], tuple[Matrix, Matrix]]


def as_derived(of: Lawful, point: Point, nu: Matrix) -> tuple[Matrix, Matrix]:
    """nu_u and nu_u_dot of the code, each (n, 1)."""
    d = of.derivation
    known = evaluated(d, inputs(d, g=point.stored, nu_e=nu), point)
    return output(d, "nu_u", known), output(d, "nu_u_dot", known)


def _is_differential(of: Lawful, claim: Law) -> Iterator[Fact]:
    """exp(nu_u) = g and exp(nu_u)' = g hat(nu), which is what D log is."""
    rng = random.Random(of.group.name)
    for point in points(of.group, COUNT):
        nu = numbers(of.group.dim, rng)
        log, rate = claim(of, point, nu)
        yield vanish("log exp x = x", log - point.x)
        yield vanish("exp(log g)' = g hat(nu)", _off(of.group, point, rate, nu))


def _off(group: Group, point: Point, rate: Matrix, nu: Matrix) -> list[Rational]:
    """exp(x)' - exp(x) hat(nu) with x' = rate, of each factor."""
    factors = group.factors or (group,)
    if not group.factors:
        pieces = [(point.stored, point.x, rate, nu)]
    else:
        rows = (group.split_velocity(v) for v in (point.x, rate, nu))
        pieces = list(zip(group.split_element(point.stored), *rows, strict=True))
    found: list[Rational] = []
    for one, turn, (stored, x, x_dot, y) in zip(factors, point.turns, pieces, strict=True):
        change = derivative(one.hat(x), one.hat(x_dot), turn)
        found += list(change - one.embed(stored) * one.hat(y))
    return found


def _is_rate(of: Lawful, claim: Law) -> Iterator[Fact]:
    rng = random.Random(of.group.name)
    d = only(of.derivation, "nu_u")
    for point in points(of.group, COUNT, seed=1):
        nu = numbers(of.group.dim, rng)
        moves = inputs(d, g=flow(of.group, point.stored, nu))
        truth = output(d, "nu_u", evaluated(d, inputs(d, g=point.stored), point, moves), rate=True)
        yield vanish("nu_u' along g' = g hat(nu)", claim(of, point, nu)[1] - truth)


def _seen(of: Lawful, point: Point, nu: Matrix, *coefficients: Rational) -> tuple[Matrix, Matrix]:
    """nu_u, and a series in ad of it in the place of its rate."""
    log, _ = as_derived(of, point, nu)
    power, total = nu, 0 * nu
    for coefficient in coefficients:
        total, power = total + coefficient * power, of.group.bracket(log, power)
    return log, total


def _scaled(factor: Rational, which: int) -> Law:
    """The value or the rate times a factor."""

    def claim(of: Lawful, point: Point, nu: Matrix) -> tuple[Matrix, Matrix]:
        pair = list(as_derived(of, point, nu))
        pair[which] *= factor
        return pair[0], pair[1]

    return claim


_HALF = sympy.S.Half

STATEMENTS = (
    Statement(
        "log' is D log, as emitted", "eq. (KinCtrlLawSO3)", EXACT, "logarithm", _is_differential,
        as_derived,
        {
            "twice the logarithm": _scaled(sympy.S(2), 0),
            "half the rate": _scaled(_HALF, 1),
            "1 + z/2 for z/(1 - e^-z)": lambda of, p, nu: _seen(of, p, nu, 1, _HALF),
            "nu as a spatial velocity": lambda of, p, nu: (
                as_derived(of, p, nu)[0],
                as_derived(of, p, nu)[1] - of.group.bracket(p.x, nu),
            ),
        },
    ),
    Statement(
        "nu_u' is D nu_u, as emitted", "def. (KctrLaw)", EXACT, "law", _is_rate, as_derived,
        {
            "the sign of nu_u'": _scaled(-sympy.S.One, 1),
            "half the rate": _scaled(_HALF, 1),
            "nu itself": lambda of, p, nu: _seen(of, p, nu, 1),
        },
    ),
)  # fmt: skip
"""Statements about the laws that are derived for the code."""
