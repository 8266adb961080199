"""What is derived for the code, proved at exact points: laws, their rates, and W.

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
from sympy import Expr, Matrix, Rational

from derive.control.kinematic import KinematicLaw, apply
from derive.control.mechanics import plant
from derive.control.sliding import reaching, tracking
from derive.lie.group import Group
from derive.routine.derivation import Derivation, Quantity
from derive.verify.proof.algebra import Inertia
from derive.verify.proof.exponential import derivative
from derive.verify.proof.model import number, numbers
from derive.verify.proof.point import Point, assigned, evaluated, moved, points
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

    def known(self, point: Point, nu: Matrix) -> dict[Expr, Any]:
        """Every symbol at a point that moves with nu."""
        return evaluated(self.derivation, _inputs(self.derivation, g=point.stored, nu_e=nu), point)


def flow(group: Group, stored: Matrix, nu: Matrix) -> Matrix:
    """Rate of the stored numbers, (k, 1), along g' = g hat(nu); they are linear in g."""
    nothing = group.store(sympy.zeros(group.basis[0].rows))
    return group.store(group.embed(stored) * group.hat(nu)) - nothing


def only(d: Derivation, output: str) -> Derivation:
    """The steps that one output needs."""
    return replace(d, outputs=[row for row in d.outputs if row[0].name == output]).pruned()


def _inputs(d: Derivation, **values: Any) -> dict[Expr, Any]:
    """Symbols of the inputs with their values; those that are not named are zero."""
    rows = ((q, values.get(q.name, sympy.zeros(q.size, 1))) for q in d.inputs)
    return {s: x for q, row in rows for s, x in assigned(q.symbols(), row).items()}


def _output(d: Derivation, name: str, known: Mapping[Expr, Any]) -> Matrix:
    """The value of an output, (k, 1), or its rate where known has rates."""
    (entries,) = (entries for quantity, entries in d.outputs if quantity.name == name)
    return Matrix([known.get(entry, 0) if entry.is_Symbol else entry for entry in entries])


Law = Callable[[Lawful, Point, Matrix], tuple[Matrix, Matrix]]


def as_derived(of: Lawful, point: Point, nu: Matrix) -> tuple[Matrix, Matrix]:
    """nu_u and nu_u_dot of the code, each (n, 1)."""
    known = of.known(point, nu)
    return _output(of.derivation, "nu_u", known), _output(of.derivation, "nu_u_dot", known)


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
        known = evaluated(d, _inputs(d, g=point.stored), point)
        rates = _inputs(d, g=flow(of.group, point.stored, nu))
        truth = _output(d, "nu_u", moved(d, known, rates, point))
        yield vanish("nu_u' along g' = g hat(nu)", claim(of, point, nu)[1] - truth)


@dataclass(frozen=True)
class Steered:
    """A vehicle: group, law, inertia (n, n) or None for a random one, and its options."""

    group: Group
    law: KinematicLaw
    inertia: Inertia | None = None
    options: tuple[str, ...] = ()

    @cached_property
    def routines(self) -> tuple[Derivation, ...]:
        """Those with a force, then the plant; every entry of the inertia present."""
        n = self.group.dim
        given = (True,) * (n * (n + 1) // 2)
        laws = (write(self.group, self.law, given, self.options) for write in (tracking, reaching))
        return *laws, plant(self.group, given, self.options)

    def tensor(self, rng: random.Random) -> Matrix:
        """The inertia, (n, n): the vehicle's, or a random positive definite one."""
        if self.inertia is not None:
            return Matrix(
                [[Rational(x.numerator, x.denominator) for x in row] for row in self.inertia]
            )
        n = self.group.dim
        lower = Matrix(n, n, lambda i, j: Rational(rng.randint(1, 9), 9) if j <= i else 0)
        return lower * lower.T


Wrong = Mapping[str, int]
"""Factor of each input that a false law takes otherwise; none for the law as it is derived."""


def _decays(of: Steered, claim: Wrong) -> Iterator[Fact]:
    *laws, motion = of.routines
    for d in laws:
        yield from _closed(of, d, motion, claim)


def _closed(of: Steered, d: Derivation, motion: Derivation, claim: Wrong) -> Iterator[Fact]:
    """s' by the chain rule through the code of s, nu' by that of the plant."""
    group, rng = of.group, random.Random(of.group.name)
    (e,), (r,) = points(group, 1, seed=2), points(group, 1, seed=3)
    start = group.embed(r.stored) if d.name == "tracking" else sympy.eye(group.basis[0].rows)
    tensor = of.tensor(rng)
    state: dict[str, Any] = {q.name: numbers(q.size, rng) for q in d.inputs}
    state |= {q.name: [abs(number(rng))] for q in d.inputs if q.is_scalar}
    upper = [tensor[i, j] for i in range(group.dim) for j in range(i, group.dim)]
    state |= {"g": group.store(start * group.embed(e.stored)), "g_r": r.stored, "inertia": upper}
    taken = {name: [claim.get(name, 1) * x for x in row] for name, row in state.items()}
    known = evaluated(d, _inputs(d, **taken), e)
    force = _output(d, "force", known)
    acceleration = evaluated(motion, _inputs(motion, **{**state, "force": force}), e)
    nu_dot = _output(motion, "nu_dot", acceleration)
    s, s_dot = _sliding(group, d, state, nu_dot, e)
    momentum = tensor * state["nu"] + state.get("momentum", sympy.zeros(group.dim, 1))
    gain = state["reach_gain"][0]
    off = tensor * s_dot - group.coad(s) * momentum + gain * tensor * s
    yield vanish(f"{d.name}: I s' = ad*_s (I nu) - k_s I s", off)
    yield vanish(f"{d.name}: W' = -2 k_s W", s.T * tensor * (s_dot + gain * s))


def _sliding(
    group: Group, d: Derivation, state: Mapping[str, Any], nu_dot: Matrix, point: Point
) -> tuple[Matrix, Matrix]:
    """s and its rate, each (n, 1)."""
    short = only(d, "s")
    rates = {"g": flow(group, state["g"], state["nu"]), "nu": nu_dot}
    if "nu_r" in state:
        rates |= {"g_r": flow(group, state["g_r"], state["nu_r"]), "nu_r": state["nu_r_dot"]}
    known = evaluated(short, _inputs(short, **state), point)
    change = moved(short, known, _inputs(short, **rates), point)
    return _output(short, "s", known), _output(short, "s", change)


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
    Statement(
        "W' = -2 k_s W, as emitted", "thm. (TckCtrl)", EXACT, "vehicle", _decays, {},
        {
            "twice k_s": {"reach_gain": 2},
            "the sign of lambda": {"rate_gain": -1},
            "the sign of nu": {"nu": -1},
            "another inertia": {"inertia": 2},
        },
    ),
    Statement(
        "a known force leaves it so, as emitted", "eq. (ELeq)", EXACT, "external", _decays, {},
        {"force left out": {"external": 0}, "force added": {"external": -1}},
    ),
    Statement(
        "so does internal momentum, as emitted", "eq. (EulerP)", EXACT, "momentum", _decays, {},
        {"momentum left out": {"momentum": 0}, "the sign of momentum": {"momentum": -1}},
    ),
)  # fmt: skip
"""Statements about what is derived for the code."""
