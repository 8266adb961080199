"""Each kernel polynomial against its function: what is proved, and what was found by trying all.

The domain is that of the emitted code: w is the cosine of half an angle, 0 <= w <= 1 but for a few
roundings, so it is bounded up to 1 + 8 eps. The error is relative to the exact function, in eps of
the scalar: truncation by python-flint plus rounding by Gappa, piece by piece. In float it stands
beside the maximum over every number w of the domain.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import pairwise

from derive.evidence.emitted import Emitted
from derive.evidence.exhaust import Largest, largest
from derive.evidence.polynomial import DIGITS, Polynomial, polynomials
from derive.evidence.rounding import rounding
from derive.evidence.truncation import ORDERS, least, truncation
from derive.verify.check import Check
from derive.verify.limits import EPS, LIMITS

CUTS = tuple(Fraction(c) for c in ("0", "1/128", "1/32", "1/16", "1/8", "1/4", "1/2"))
"""Where the domain of w is cut: finer at 0, where the terms of a polynomial are large."""

PAST = 8
"""How many eps beyond 1 roundings may carry w: it is a quotient of a number and its norm."""


@dataclass(frozen=True)
class Bound:
    """Relative errors, worst over the pieces: of the whole, and of each cause; low, high: of w."""

    whole: Fraction
    truncation: Fraction
    rounding: Fraction
    low: Fraction
    high: Fraction


@cache
def bound(one: Polynomial) -> Bound:
    """What is proved of a polynomial; raises ToolMissing, ToolFailed."""
    eps = Fraction(2) ** (1 - DIGITS[one.type])
    cuts = (*CUTS, 1 + PAST * eps)
    return max((_piece(one, *ends) for ends in pairwise(cuts)), key=lambda piece: piece.whole)


def _piece(one: Polynomial, low: Fraction, high: Fraction) -> Bound:
    cut = truncation(one.name, one.terms, 1 - high, 1 - low)
    rounded = rounding(one.type, one.terms, low, high) / least(one.name, 1 - high)
    return Bound(cut + rounded, cut, rounded, low, high)


def bounds(one: Emitted) -> Iterator[Check]:
    """The proved bound of each kernel polynomial of a source; raises ToolMissing, ToolFailed."""
    for polynomial in polynomials(one):
        found, eps = bound(polynomial), EPS[one.scalar]
        parts = f"truncation {float(found.truncation) / eps:.2f} + rounding " \
                f"{float(found.rounding) / eps:.2f} eps"  # fmt: skip
        yield Check(
            f"kernel {polynomial.name}: proved", one.scalar, float(found.whole) / eps,
            LIMITS[f"kernel {polynomial.name}"], len(CUTS),
            f"{float(found.low):g} <= w <= {float(found.high):g}", (parts,),
        )  # fmt: skip


def maxima(one: Emitted, step: int = 1) -> Iterator[Check]:
    """The largest error of each polynomial in float over every number; none in double.

    step: 1 for all, else one cell in so many. Its limit is the proof of `bounds`, where that can be
    had: a larger error than is proved would be a fault of one of the two.
    """
    kinds = {polynomial.name: polynomial for polynomial in polynomials(one)}
    if one.scalar != "f32" or not kinds:
        return
    found = largest(one, {name: ORDERS[name] for name in kinds}, 2 * PAST, step)
    for name in kinds:
        yield _maximum(one, name, found[name], step)
    for name, polynomial in kinds.items():
        proved = float(bound(polynomial).whole)
        yield Check(
            f"kernel {name}: largest over proved", one.scalar, found[name].error / proved,
            LIMITS["kernel proof"], found[name].evaluations,
        )  # fmt: skip


def _maximum(one: Emitted, name: str, found: Largest, step: int) -> Check:
    numbers = "every number w" if step == 1 else f"one cell of w in {step}"
    return Check(
        f"kernel {name}: largest", one.scalar, found.error / EPS[one.scalar],
        LIMITS[f"kernel {name}"], found.evaluations, f"w = {found.at:.9g}", (numbers,),
    )  # fmt: skip
