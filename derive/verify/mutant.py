"""Mutants of a derivation and of its kernel, made mechanically: nothing is picked by hand.

Of every expression: each term negated, dropped, and off by 1e-9; each pair of entries of one
quantity exchanged; each condition turned round and each case left out; each kernel function
taken one order higher. Of every polynomial: each coefficient likewise.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations

import sympy
from sympy import Add, Expr, Mul, Piecewise, Pow, Rational, Symbol

from derive.lie.kernel import NAMES, Arc, coefficients
from derive.routine.derivation import Derivation
from derive.verify.limits import LIMITS

_OFF = 1 + Rational(str(LIMITS["coefficient"].figure))


@dataclass(frozen=True)
class Mutant:
    """One change: to the term of one symbol of a step, or to a polynomial when symbol is None."""

    what: str
    symbol: Symbol | None
    value: Expr | None = None
    kernel: int = 0
    polynomial: tuple[Fraction, ...] = ()


def of_steps(d: Derivation) -> Iterator[Mutant]:
    """Every mutant of every term of a derivation."""
    rows = {symbol: owner for owner in _inputs(d) for symbol in owner}
    rows |= {symbol: symbols for symbols in _steps(d) for symbol in symbols}
    for symbol, value in d.terms():
        for what, changed in (*_root(value), *_inside(value), *_exchanges(value, rows)):
            if changed != value:
                yield Mutant(f"{symbol}: {what}", symbol, changed)


def of_kernel(order: int, scalar: str) -> Iterator[Mutant]:
    """Every mutant of the polynomial of Arc(order, .), constant term first."""
    terms = coefficients(order, scalar)
    for power, term in enumerate(terms):
        for what, new in (("negated", -term), ("dropped", Fraction(0)),
                          ("off by 1e-9", term * Fraction(_OFF.p, _OFF.q))):  # fmt: skip
            changed = (*terms[:power], new, *terms[power + 1 :])
            yield Mutant(f"kernel {order}, z^{power} {what}", None, None, order, changed)
    for i, j in combinations(range(len(terms)), 2):
        swapped = list(terms)
        swapped[i], swapped[j] = terms[j], terms[i]
        yield Mutant(
            f"kernel {order}, z^{i} and z^{j} exchanged", None, None, order, tuple(swapped)
        )


def kernel_orders(d: Derivation) -> list[int]:
    """Orders of the kernel functions a derivation calls."""
    return sorted({int(call.args[0]) for _, value in d.terms() for call in value.atoms(Arc)})


def _root(value: Expr) -> Iterator[tuple[str, Expr]]:
    if not isinstance(value, Piecewise):
        yield "negated", -value
        yield "off by 1e-9", _OFF * value


def _inside(value: Expr) -> Iterator[tuple[str, Expr]]:
    """Changes below the root, wherever it is."""
    if isinstance(value, Add):
        for i, term in enumerate(value.args):
            others = value.args[:i] + value.args[i + 1 :]
            yield f"{term} negated", Add(*others, -term)
            yield f"{term} dropped", Add(*others)
            yield f"{term} off by 1e-9", Add(*others, _OFF * term)
            yield from ((what, Add(*others, new)) for what, new in _inside(term))
    elif isinstance(value, Mul):
        for i, factor in enumerate(value.args):
            others = value.args[:i] + value.args[i + 1 :]
            yield from ((what, Mul(*others, new)) for what, new in _inside(factor))
    elif isinstance(value, Pow):
        yield from ((what, Pow(new, value.exp)) for what, new in _inside(value.base))
    elif isinstance(value, Piecewise):
        yield from _cases(value)
    elif isinstance(value, sympy.Abs):
        yield "absolute value dropped", value.args[0]
    elif isinstance(value, Arc):
        order = int(value.args[0])
        other = order + 1 if order + 1 < len(NAMES) else order - 1
        yield "next kernel function", Arc(other, value.args[1])


def _cases(value: Piecewise) -> Iterator[tuple[str, Expr]]:
    pairs = [tuple(pair) for pair in value.args]
    for i, (case, condition) in enumerate(pairs):
        for what, new in (*_root(case), *_inside(case)):
            yield f"case {i}, {what}", _piecewise(pairs, i, (new, condition))
        if condition != sympy.true:
            for turned in _turned(condition):
                yield f"condition {i} turned round: {turned}", _piecewise(pairs, i, (case, turned))
            yield f"case {i} left out", _piecewise(pairs, i, None)


def _turned(condition: sympy.Basic) -> Iterator[sympy.Basic]:
    """Each comparison of a condition in turn the other way round."""
    if not isinstance(condition, sympy.And):
        yield sympy.Not(condition)
        return
    for one in sorted(condition.args, key=sympy.default_sort_key):
        yield sympy.And(sympy.Not(one), *(other for other in condition.args if other != one))


def _piecewise(pairs: list[tuple[Expr, ...]], i: int, new: tuple[Expr, ...] | None) -> Expr:
    kept = [*pairs[:i], *([new] if new else []), *pairs[i + 1 :]]
    return kept[0][0] if len(kept) == 1 else Piecewise(*kept, evaluate=False)


def _exchanges(value: Expr, rows: dict[Symbol, tuple[Symbol, ...]]) -> Iterator[tuple[str, Expr]]:
    """Each pair of entries of one quantity exchanged, where at least one of them occurs."""
    present = value.free_symbols
    quantities = {rows[symbol] for symbol in present if symbol in rows}
    for row in sorted(quantities, key=str):
        for a, b in combinations(row, 2):
            if a in present or b in present:
                exchanged = value.xreplace({a: b, b: a})
                yield f"{a} and {b} exchanged", exchanged


def _inputs(d: Derivation) -> list[tuple[Symbol, ...]]:
    return [
        tuple(s for s, used in zip(q.symbols(), d.used(q), strict=True) if used) for q in d.inputs
    ]


def _steps(d: Derivation) -> list[tuple[Symbol, ...]]:
    return [tuple(symbol for symbol, _ in step.terms) for step in d.steps]
