"""What the guard judges: the error, how far it is off the group, and which of its entries grow.

A law sees both configurations only through g_e = g_r^-1 g. Whatever is wrong with them either
shows there, or cannot move the force.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import sympy
from sympy import Expr, Matrix, Poly, Symbol

from derive.control.port import ERROR
from derive.lie.group import Group
from derive.lie.kernel import NOISE, TINY
from derive.routine.derivation import Derivation, Quantity


@dataclass(frozen=True)
class Guarded:
    """A guarded law in its parts.

    error: from both configurations to g_e; None where the law has no reference
    seen:  the same, as far as the law reads it
    law:   what is left of it: it takes g_e, or the configuration itself
    drift: square of the distance from the group; None where all numbers are elements
    apart: how far an element is from none that has an inverse; None where nothing is divided by
    is_bounded: which stored numbers the group keeps at most 1
    """

    error: Derivation | None
    seen: Derivation | None
    law: Derivation
    drift: Derivation | None
    apart: Derivation | None
    is_bounded: tuple[bool, ...]


def guarded(group: Group, main: Derivation) -> Guarded:
    """The parts of a law. Raises ValueError where it sees a configuration past the error."""
    error, seen, law = None, None, main
    if any(step.quantity.name == ERROR for step in main.steps):
        error, law = main.parted(ERROR)
        if any(q.member == "g" for q in law.inputs):
            raise ValueError(f"{main.name}: {ERROR} is not all it knows of the configurations")
        quantity, entries = error.outputs[0]
        read = zip(entries, law.used(quantity), strict=True)
        seen = replace(error, outputs=[(quantity, tuple(x for x, is_read in read if is_read))])
        seen = seen.pruned().needing()
    return Guarded(error, seen, law, _drift(group, error), _apart(group), bounded(group))


def _drift(group: Group, error: Derivation | None) -> Derivation | None:
    """Sum of the squares of what vanishes on the group alone.

    What of a stored configuration is fixed, so that the error does not read it, is held here.
    """
    d = Derivation("drift", "square of the distance from the group", "")
    if error is None:
        g = d.take(Quantity("g", group.size, "1", "configuration", place="state.g"))
        rows = list(group.residual(g))
    else:
        quantity, entries = error.outputs[0]
        d.take(quantity)
        rows = [row for row in group.residual(Matrix(entries)) if row != 0]
        for configuration in error.inputs:
            d.take(configuration)
            rows += _fixed(group, configuration, error.used(configuration))
    if not rows:
        return None
    off = d.let("off", Matrix(rows), "1", "what vanishes on the group, and only there")
    total = d.let("drift", off.dot(off), "1", "square of the distance from the group")
    near = "square of the distance from the group"
    d.give(Quantity("drift", 1, "1", near, is_scalar=True, place="drift"), total)
    return d.needing()


def _apart(group: Group) -> Derivation | None:
    """Positive where the determinant that the inverse divides by is no rounded zero."""
    d = Derivation("apart", "what a determinant is beyond rounding, positive for an element", "")
    g = d.take(Quantity("g", group.size, "1", "an element, or none", place="g"))
    entries = group.inverse(group.embed(g))
    divisor = sympy.lcm_list([sympy.denom(sympy.together(entry)) for entry in entries])
    if not divisor.free_symbols:
        return None
    terms = sympy.Add.make_args(sympy.expand(divisor))
    det = d.let("det", sum(terms, sympy.S.Zero), "1", "what the inverse divides by")
    size = d.let("size", sum(map(sympy.Abs, terms), sympy.S.Zero), "1", "of its terms")
    left = d.let("left", sympy.Abs(det) - NOISE * size - TINY, "1", "what is left of it")
    d.give(Quantity("apart", 1, "1", "beyond rounding", is_scalar=True, place="apart"), left)
    return d.pruned().needing()


def _fixed(group: Group, configuration: Quantity, is_read: tuple[bool, ...]) -> list[Expr]:
    """The rows of the residual that speak of stored numbers nobody reads, and of no others."""
    symbols = configuration.symbols()
    unread = {symbol for symbol, read in zip(symbols, is_read, strict=True) if not read}
    rows = group.residual(Matrix(symbols))
    return [row for row in rows if row.free_symbols and row.free_symbols <= unread]


def bounded(group: Group) -> tuple[bool, ...]:
    """Which stored numbers are at most 1 on the group, as far as its equations say so plainly.

    A sum of squares that is 1 bounds what is squared; what equals products of bounded numbers,
    two of them at most, is bounded as well.
    """
    symbols = tuple(Symbol(f"x_{i}", real=True) for i in range(group.size))
    rows = [Poly(row, *symbols) for row in group.residual(Matrix(symbols))]
    found = set(_squared(rows))
    found |= {entry for row in rows for entry in _solved(row, found)}
    return tuple(symbol in found for symbol in symbols)


def _squared(rows: Iterable[Poly]) -> Iterable[Expr]:
    """What is squared in a row that is a sum of squares less one."""
    for row in rows:
        terms = row.terms()
        squares = [(power, c) for power, c in terms if any(power)]
        is_sum = all(sum(power) == 2 == max(power) and c == 1 for power, c in squares)
        if is_sum and row.eval(dict.fromkeys(row.gens, 0)) == -1:
            yield from row.free_symbols


def _solved(row: Poly, known: set[Expr]) -> Iterable[Expr]:
    """The one number that stands alone in a row whose other terms are products of known ones."""
    alone = [gen for gen in row.gens if row.coeff_monomial(gen) in (1, -1) and gen not in known]
    rest = row.as_expr() - sum((row.coeff_monomial(gen) * gen for gen in alone), sympy.S.Zero)
    if len(alone) == 1 and rest.free_symbols <= known and len(Poly(rest, *row.gens).terms()) <= 2:
        yield alone[0]
