"""How far a kernel polynomial is from the function it stands for: a bound, in exact arithmetic.

k(w) = arccos(w)/sqrt(1 - w^2) is the solution of (1 - w^2) k' = w k - 1 that is regular at
w = 1, h = -k', m = k''. In z = 1 - w that equation gives k = sum a_j z^j with a_0 = 1 and
a_j = a_(j-1) j/(2j + 1): all positive, each less than half the one before. What a partial sum
leaves out is less than a multiple of its last term; and the emitted polynomial less the partial sum
is a polynomial with rational coefficients, which is expanded about the middle of each piece of
the domain and bounded term by term.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from typing import Any

from derive.evidence.tool import Tool, ToolMissing

ORDERS = {"k": 0, "h": 1, "m": 2}
"""Derivatives of k, in w, their signs alternating."""

FLINT = Tool("python-flint", "pip install gsmc-derive[evidence]", "installed for this Python")

LENGTH = 100  # terms of the series: less than 2^-90 is left out
PIECE = Fraction(1, 192)  # short beside the ripple of the error


def truncation(name: str, terms: Sequence[Fraction], low: Fraction, high: Fraction) -> Fraction:
    """Bound of |p(z)/f(z) - 1| for low <= z <= high within [-1, 1], exact function f.

    terms: of p, the highest power first. Raises ToolMissing without python-flint.
    """
    flint = _flint()
    f = flint.fmpq_poly([_rational(c) for c in _series(name)])
    error = flint.fmpq_poly([_rational(c) for c in reversed(terms)]) - f
    worst, start = Fraction(0), low
    while start < high:
        end = min(start + PIECE, high)
        half, middle = (end - start) / 2, (end + start) / 2
        local = error(flint.fmpq_poly([_rational(middle), _rational(half)]))
        largest = sum((abs(_fraction(c)) for c in local.coeffs()), _tail(name))
        worst = max(worst, largest / least(name, start))
        start = end
    return worst


def least(name: str, z: Fraction) -> Fraction:
    """A lower bound of the exact function from z in [-1, 1] on: all of them grow with z."""
    total = Fraction(0)
    for c in reversed(_series(name)):
        total = total * z + c
    return total - _tail(name)


def _tail(name: str) -> Fraction:
    """More than what the series leaves out on [-1, 1]: its terms fall by 3/4 at least."""
    return 4 * _series(name)[-1]


@cache
def _series(name: str) -> tuple[Fraction, ...]:
    """Taylor coefficients in z of k, or of a derivative of it, all positive."""
    order = ORDERS[name]
    a = [Fraction(1)]
    for j in range(1, LENGTH + order):
        a.append(a[-1] * j / (2 * j + 1))
    for _ in range(order):
        a = [j * a[j] for j in range(1, len(a))]
    return tuple(a)


def _flint() -> Any:
    try:
        import flint
    except ImportError:
        raise ToolMissing(FLINT) from None
    return flint


def _rational(value: Fraction) -> Any:
    return _flint().fmpq(value.numerator, value.denominator)


def _fraction(value: Any) -> Fraction:
    return Fraction(int(value.p), int(value.q))
