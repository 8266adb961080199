"""Lemma 3 for the log law on every group, and the emitted rate of log on SO3 and S3.

With x = phi u a rotation vector and C, S the cosine and sine of half of phi, everything is a
polynomial in phi, C, S, u and nu; it vanishes on the group if and only if it is zero modulo
C^2 + S^2 - 1 and u.u - 1, which are their own Groebner basis.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache

import sympy
from sympy import QQ, Matrix, ring

from derive.control.kinematic import LAWS, KinematicLaw, apply
from derive.lie.group import Group
from derive.lie.kernel import H, K
from derive.routine.derivation import Derivation, Quantity
from derive.verify.proof.algebra import Algebra, Scalar, Setting, Vector
from derive.verify.proof.statement import Fact, Statement, vanish

Drift = Callable[[Algebra, list[Scalar], Vector], Vector]


def drift(a: Algebra, f: list[Scalar], x: Vector) -> Vector:
    """x' / lambda with nu = -lambda x: -f(ad_x) x, any f with f(0) = f[0], here to 2nd order."""
    power = -x
    total: Vector = f[0] * power
    for coefficient in f[1:]:
        power = a.bracket(x, power)
        total = total + coefficient * power
    return total


def _decays(setting: Setting, claim: Drift) -> Iterator[Fact]:
    """D log(x) = f(ad_x), f(z) = z/(1 - e^-z), f(0) = 1; its other coefficients stay symbols."""
    a, (x, second, third) = setting.with_vectors("x", "second third")
    ad_x_x = a.bracket(x, x)
    yield vanish("ad_x x = 0", ad_x_x.entries)
    off = claim(a, [a.zero + 1, second, third], x) + x
    yield vanish("x' = -lambda x", off.entries)


EXPONENTIAL: dict[str, Callable[[Matrix, sympy.Expr, sympy.Expr], Matrix]] = {
    "SO3": lambda X, C, S: X**0 + 2 * S * C * X + 2 * S**2 * X**2,
    "S3": lambda X, C, S: C * X**0 + 2 * S * X,
}
"""exp(phi hat(u)) as a matrix from hat(u), cos(phi/2) and sin(phi/2)."""

phi, C, S = sympy.symbols("phi C S")
u = Matrix(sympy.symbols("u:3"))
nu = Matrix(sympy.symbols("nu:3"))


@cache
def _formulas(group: Group, law: KinematicLaw) -> tuple[Matrix, Matrix, dict[str, sympy.Expr]]:
    """nu_u and nu_u_dot of the product's own law in w, v, k, h and nu_e, steps put in."""
    d = Derivation("log", "", "")
    g = d.take(Quantity("g", len(group.identity), "1", "configuration"))
    nu_e = d.take(Quantity("nu_e", group.dim, "rad/s", "velocity"))
    log, rate, _ = apply(law, d, group, g, nu_e)
    w, v = d.step("w").symbols[0], d.step("v").symbols
    known: dict[sympy.Expr, sympy.Expr] = {}
    for step in d.steps:
        if not {w, *v} & set(step.symbols):
            for symbol, formula in zip(step.symbols, step.formula, strict=True):
                known[symbol] = formula.xreplace(known)
    known |= {d.lowered[K(w)]: K(w), d.lowered[H(w)]: H(w)}
    names = {"w": w, "v": Matrix(v), "nu": nu_e, "k": K(w), "h": H(w)}
    return log.xreplace(known), rate.xreplace(known), names


Rates = Callable[[Group, sympy.Expr, Matrix, sympy.Expr, sympy.Expr], tuple[Matrix, Matrix]]


def emitted(
    group: Group, w: sympy.Expr, v: Matrix, k: sympy.Expr, h: sympy.Expr
) -> tuple[Matrix, Matrix]:
    """nu_u and nu_u_dot as they are derived for the emitted code, along nu."""
    log, rate, names = _formulas(group, LAWS[group.name, "log"])
    given = {names["w"]: w, names["k"]: k, names["h"]: h}
    given |= dict(zip([*names["v"], *names["nu"]], [*v, *nu], strict=True))
    return log.xreplace(given), rate.xreplace(given)


def _is_differential(group: Group, claim: Rates) -> Iterator[Fact]:
    k = phi / (2 * S)
    log, rate = claim(group, C, S * u, k, (1 - C * k) / S**2)
    yield _in_ideal("nu_u = phi u", S * (log - phi * u))
    hat = group.hat(u)
    g = EXPONENTIAL[group.name](hat, C, S)
    by_angle = g.diff(S) * C / 2 - g.diff(C) * S / 2
    yield _in_ideal("g = exp(phi hat(u))", by_angle - g * hat)
    scaled = (S * rate).expand()
    angular = u.dot(scaled)
    turning = scaled - u * angular
    g_dot = phi * by_angle * angular
    for i in range(3):
        g_dot += g.diff(u[i]) * turning[i]
    yield _in_ideal("exp(nu_u)' = exp(nu_u) hat(nu)", g_dot - phi * S * g * group.hat(nu))


def _in_ideal(what: str, values: Matrix) -> Fact:
    """Zero modulo C^2 + S^2 - 1 and u.u - 1, times S^2, which no formula here divides by more."""
    polynomials, *_ = ring([phi, C, S, *u, *nu], QQ)
    ideal = [polynomials.from_expr(e) for e in (C**2 + S**2 - 1, u.dot(u) - 1)]
    cleared = ((S**2 * value).expand() for value in values)
    return vanish(what, (polynomials.from_expr(value).rem(ideal) for value in cleared))


STATEMENTS = (
    Statement(
        "Lemma 3, log law: on H log g(t) = e^(-lambda t) log g(0)", "lem. (SldLieSubG)",
        "polynomials", "algebra", _decays, drift,
        {
            "twice the logarithm at the same lambda": lambda a, f, x: drift(
                a, [2 * f[0], *f[1:]], x
            ),
            "the sign of nu_u": lambda a, f, x: -drift(a, f, x),
            "ad* for ad": lambda a, f, x: -x - f[1] * a.coad(x, x),
        },
    ),
    Statement(
        "log' is D log, as emitted", "eq. (KinCtrlLawSO3)", "modulo C^2+S^2-1, u.u-1", "rotation",
        _is_differential, emitted,
        {
            "the sign of v x nu": lambda group, w, v, k, h: (
                emitted(group, w, v, k, h)[0], emitted(group, w, -v, k, h)[1]
            ),
            "the sign of h": lambda group, w, v, k, h: emitted(group, w, v, k, -h),
            "half the rate": lambda group, w, v, k, h: (
                emitted(group, w, v, k, h)[0], emitted(group, w, v, k, h)[1] / 2
            ),
        },
    ),
)  # fmt: skip
"""Statements about the logarithm."""
