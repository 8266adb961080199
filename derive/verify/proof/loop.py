"""The loop that is derived for the code, law and plant, closed at exact points: W' = -2 k_s W.

The rate of s is that of the code's own s by the chain rule, step by step, so that no rate which
the code writes is taken for granted; nu' is what the code's plant makes of the code's force.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy
from sympy import Matrix, Rational

from derive.control.kinematic import KinematicLaw
from derive.control.mechanics import plant
from derive.control.sliding import reaching, tracking
from derive.lie.group import Group
from derive.routine.derivation import Derivation
from derive.verify.proof.algebra import Inertia
from derive.verify.proof.emitted import EXACT, flow, inputs, only, output
from derive.verify.proof.model import number, numbers
from derive.verify.proof.point import Point, evaluated, points
from derive.verify.proof.statement import Fact, Statement, vanish


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
    known = evaluated(d, inputs(d, **taken), e)
    force = output(d, "force", known)
    acceleration = evaluated(motion, inputs(motion, **{**state, "force": force}), e)
    nu_dot = output(motion, "nu_dot", acceleration)
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
    known = evaluated(short, inputs(short, **state), point, inputs(short, **rates))
    return output(short, "s", known), output(short, "s", known, rate=True)


STATEMENTS = (
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
"""Statements about the loop that is derived for the code."""
