"""Values and rates of expressions in rational numbers alone, both in one walk; nothing is rounded.

A root has to be of a square, a case has to be decided, and a special function is looked up.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from math import isqrt
from typing import Any

import sympy
from sympy import QQ, Abs, Add, Expr, Mul, Piecewise, Pow, Rational, Symbol

from derive.lie.kernel import Arc

Dual = tuple[Any, Any]
"""A rational number and its rate."""

Kernel = Mapping[tuple[int, Any], Any]
"""(order, w) -> Arc(order, w)."""

NOTHING = QQ(0)


class Walk:
    """Evaluates expressions over symbols of which value and rate are known.

    known: symbol -> dual, which the caller may extend; constants: other atoms, that rest
    """

    def __init__(self, known: dict[Symbol, Dual], kernel: Kernel, pi: Any) -> None:
        self.known, self.kernel, self.pi = known, kernel, pi
        self.found: dict[Expr, Dual] = {}

    def __call__(self, value: Expr) -> Dual:
        """The dual of an expression; ValueError where it is not rational."""
        if value.is_Symbol:
            return self.known[value]
        if value not in self.found:
            self.found[value] = self._of(value)
        return self.found[value]

    def _of(self, value: Expr) -> Dual:
        if value.is_Rational:
            return exact(value), NOTHING
        if value is sympy.pi:
            return self.pi, NOTHING
        for kind, rule in _RULES:
            if isinstance(value, kind):
                return rule(self, value)
        raise ValueError(f"no rule finds the exact value of {value}")

    def holds(self, condition: Any) -> bool:
        """A comparison or a conjunction."""
        if condition in (sympy.true, sympy.false):
            return bool(condition)
        if isinstance(condition, sympy.And):
            return all(self.holds(one) for one in condition.args)
        left, right = self(condition.lhs)[0], self(condition.rhs)[0]
        return bool(_COMPARE[condition.rel_op](left, right))


_COMPARE: dict[str, Callable[[Any, Any], Any]] = {
    ">=": operator.ge, ">": operator.gt, "<=": operator.le, "<": operator.lt,
}  # fmt: skip


def exact(value: Any) -> Any:
    """A rational number of sympy as one of QQ."""
    return QQ(int(value.p), int(value.q))


def shown(value: Any) -> Rational:
    """And back."""
    return Rational(int(value.numerator), int(value.denominator))


def _sum(walk: Walk, value: Expr) -> Dual:
    parts = [walk(one) for one in value.args]
    return sum((a for a, _ in parts), NOTHING), sum((b for _, b in parts), NOTHING)


def _product(walk: Walk, value: Expr) -> Dual:
    total, rate = QQ(1), NOTHING
    for a, b in (walk(one) for one in value.args):
        total, rate = total * a, rate * a + total * b
    return total, rate


def _power(walk: Walk, value: Expr) -> Dual:
    base, exponent = value.args
    a, b = walk(base)
    if abs(exponent) == sympy.S.Half:
        a = root(a)
        a, b = (a, b / (2 * a)) if b else (a, NOTHING)
        exponent = 2 * exponent
    n = int(exponent)
    if n != exponent:
        raise ValueError(f"{value} is not rational")
    return a**n, n * a ** (n - 1) * b if b else NOTHING


def root(value: Any) -> Any:
    """The square root of the square of a rational number; ValueError of another."""
    parts = int(value.numerator), int(value.denominator)
    roots = [isqrt(abs(part)) for part in parts]
    if [one * one for one in roots] != list(parts):
        raise ValueError("the root of a number that is no square")
    return QQ(*roots)


def _size(walk: Walk, value: Expr) -> Dual:
    a, b = walk(value.args[0])
    return (a, b) if a >= 0 else (-a, -b)


def _case(walk: Walk, value: Expr) -> Dual:
    return next(walk(one) for one, when in value.args if walk.holds(when))


def _special(walk: Walk, value: Expr) -> Dual:
    """d/dw Arc(n, w) = -Arc(n + 1, w)."""
    order, (w, moves) = int(value.args[0]), walk(value.args[1])
    rate = -walk.kernel[order + 1, w] * moves if moves else NOTHING
    return walk.kernel[order, w], rate


_RULES: tuple[tuple[type, Callable[[Walk, Expr], Dual]], ...] = (
    (Add, _sum), (Mul, _product), (Pow, _power), (Abs, _size), (Piecewise, _case), (Arc, _special),
)  # fmt: skip
