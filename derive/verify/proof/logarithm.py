"""Lemma 3 for the law `log`, on every group: on H the logarithm shrinks and does not turn."""

from __future__ import annotations

from collections.abc import Callable, Iterator

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
)  # fmt: skip
"""Statements about the sliding mode."""
