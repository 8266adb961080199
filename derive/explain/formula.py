"""Exact expressions as formulas: entry by entry, or as one of vectors where all entries agree.

Precedence and order are decided here, spelling in a Notation. Numbers stay exact.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

import sympy
from sympy import Expr, ImmutableMatrix, Piecewise, Symbol

from derive.explain.notation import Notation
from derive.explain.text import TEXT
from derive.lie.kernel import NAMES, Arc
from derive.routine.cost import shared_coefficient

TALLEST = 16
"""Entries of a column; more of them stand below one another, where a page can break."""

ALL = ":"
"""The index that stands for every entry, and is not shown."""


def spell(value: Expr, n: Notation) -> str:
    """One expression."""
    if value.is_Symbol:
        return n.symbol(value.name.removesuffix(f"_{ALL}"))
    if value.is_Rational:
        return _number(Fraction(value.p, value.q), n)
    for kind, rule in _RULES:
        if isinstance(value, kind):
            return rule(value, n)
    raise TypeError(f"no rule spells {type(value).__name__}: {value}")


def function_name(call: Expr) -> str:
    """Name of a special function as the paper and the code have it: k, h, m."""
    return NAMES[int(call.args[0])] if isinstance(call, Arc) else str(call.func.__name__)


def display(name: str, entries: Sequence[Expr], sizes: Mapping[str, int], n: Notation) -> str:
    """A displayed formula of a quantity; sizes: of every vector by name, scalars left out.

    In this order: a scalar, a vector whose entries all say the same, cases, a column, rows.
    """
    left = n.symbol(name)
    whole = entries[0] if name not in sizes else _of_vectors(name, entries, sizes)
    if whole is not None:
        return _displayed([(left, whole)], n)
    if all(isinstance(entry, Piecewise) for entry in entries):
        return _equation(left, _cases_of_columns(entries, n), n)
    is_wide = any(len(spell(entry, TEXT)) > n.width for entry in entries)
    if n.is_flat or is_wide or len(entries) > TALLEST:
        return _displayed([(n.symbol(f"{name}_{i}"), e) for i, e in enumerate(entries)], n)
    return _equation(left, n.column([spell(entry, n) for entry in entries]), n)


def matrix_of(name: str, value: ImmutableMatrix, n: Notation) -> str:
    """A displayed matrix of numbers."""
    rows = [[spell(entry, n) for entry in value[i, :]] for i in range(value.rows)]
    return _equation(n.symbol(name), n.matrix(rows), n)


def _equation(left: str, right: str, n: Notation) -> str:
    return n.single % f"{left}{n.relation % '='}{right}"


def _displayed(equations: Sequence[tuple[str, Expr]], n: Notation) -> str:
    """Equations below one another, long sums over several lines."""
    rows = [
        (left if k == 0 else "", line)
        for left, value in equations
        for k, line in enumerate(_broken(value, n))
    ]
    return _equation(*rows[0], n) if len(rows) == 1 else n.rows(rows)


def _of_vectors(name: str, entries: Sequence[Expr], sizes: Mapping[str, int]) -> Expr | None:
    """a = b + c for a_i = b_i + c_i, where b and c are as long as a; None where entries differ."""
    peers = [one for one, size in sizes.items() if size == sizes[name]]
    found = {
        entry.xreplace(
            {Symbol(f"{p}_{i}", real=True): Symbol(f"{p}_{ALL}", real=True) for p in peers}
        )
        for i, entry in enumerate(entries)
    }
    whole = found.pop()
    indexed = (str(symbol).rpartition("_") for symbol in whole.free_symbols)
    mentioned = {name for name, _, index in indexed if index != ALL}
    is_free = not found and mentioned.isdisjoint(sizes) and not whole.has(Piecewise)
    return whole if is_free else None


def _cases_of_columns(entries: Sequence[Expr], n: Notation) -> str:
    conditions = [condition for _, condition in entries[0].args]
    if any([when for _, when in entry.args] != conditions for entry in entries):
        return n.column([spell(entry, n) for entry in entries])
    columns = (n.column([spell(entry.args[i][0], n) for entry in entries])
               for i in range(len(conditions)))  # fmt: skip
    return n.cases(list(zip(columns, (_condition(c, n) for c in conditions), strict=True)))


def _condition(value: sympy.Basic, n: Notation) -> str:
    """A comparison or a conjunction of them; empty where nothing is asked."""
    if value == sympy.true:
        return ""
    if isinstance(value, sympy.And):
        ordered = sorted(value.args, key=sympy.default_sort_key)
        return n.both.join(_condition(one, n) for one in ordered)
    operator = str(value.rel_op)
    relation = n.relation % n.relations.get(operator, operator)
    return spell(value.lhs, n) + relation + spell(value.rhs, n)


def _broken(value: Expr, n: Notation) -> list[str]:
    """The lines of a sum whose text is too wide for one, also where it is multiplied by others."""
    others, terms = _sum_within(value)
    if not terms or len(spell(value, TEXT)) <= n.width:
        return [spell(value, n)]
    lines: list[list[Expr]] = [[]]
    for term in _ordered(terms):
        if lines[-1] and len(TEXT.plus.join(spell(t, TEXT) for t in [*lines[-1], term])) > n.width:
            lines.append([])
        lines[-1].append(term)
    shown = [_joined(terms, n, is_first=k == 0) for k, terms in enumerate(lines)]
    if others != 1:
        shown[0] = spell(others, n) + n.product + n.opening + shown[0]
        shown[-1] += n.closing
    return shown


def _sum_within(value: Expr) -> tuple[Expr, Sequence[Expr]]:
    """The terms of a sum that is a factor of value, and the other factors; no terms without one."""
    if value.is_Add:
        return shared_coefficient(value)
    sums = [one for one in sympy.Mul.make_args(value) if one.is_Add]
    if not sums:
        return value, ()
    shared, terms = shared_coefficient(sums[0])
    return shared * sympy.Mul(*(one for one in sympy.Mul.make_args(value) if one != sums[0])), terms


def _ordered(terms: Sequence[Expr]) -> list[Expr]:
    """A positive term first, where there is one; otherwise by name and number."""
    return sorted(terms, key=lambda term: (_is_negative(term), _counted(term)))


def _counted(value: Expr) -> str:
    """Its text, in which 2 comes before 10."""
    return re.sub(r"\d+", lambda found: found[0].zfill(4), str(value))


def _joined(terms: Sequence[Expr], n: Notation, *, is_first: bool = True) -> str:
    line = ""
    for k, term in enumerate(terms):
        is_leading = is_first and k == 0
        before, after = ("", n.minus) if is_leading else (n.plus, n.less)
        line += (after if _is_negative(term) else before) + _factor(
            -term if _is_negative(term) else term, n
        )
    return line.lstrip()


def _sum(value: Expr, n: Notation) -> str:
    shared, bare = shared_coefficient(value)
    if shared == 1:
        return _joined(_ordered(bare), n)
    return spell(shared, n) + n.product + n.group % _joined(_ordered(bare), n)


def _product(value: Expr, n: Notation) -> str:
    if _is_negative(value):
        return n.minus + _factor(-value, n)
    coefficient, rest = value.as_coeff_Mul()
    over, under = sympy.fraction(rest if sympy.fraction(rest)[1] == 1 else value)
    factors = (f for f in sympy.Mul.make_args(over) if f != 1)
    above = sorted(factors, key=_place)
    if under == 1:
        above = [coefficient] * (coefficient != 1) + above
        return n.product.join(_factor(f, n) for f in above)
    below = sympy.Mul.make_args(under)
    return n.fraction % (_part(above or [sympy.S.One], n), _part(below, n, is_below=True))


def _part(factors: Sequence[Expr], n: Notation, *, is_below: bool = False) -> str:
    """Above or below the line of a fraction."""
    if len(factors) == 1 and not n.is_flat:
        return spell(factors[0], n)
    line = n.product.join(_factor(f, n) for f in factors)
    return n.group % line if n.is_flat and is_below and len(factors) > 1 else line


def _is_negative(term: Expr) -> bool:
    return bool(term.as_coeff_Mul()[0] < 0)


def _place(factor: Expr) -> str:
    """Scalars come before entries of vectors, as they are kept; these by name and number."""
    return _counted(factor) if _is_entry(factor) else ""


def _is_entry(factor: Expr) -> bool:
    """Whether an index stands in it."""
    indices = (str(symbol).rpartition("_")[2] for symbol in factor.free_symbols)
    return any(index == ALL or index.isdigit() for index in indices)


def _factor(value: Expr, n: Notation) -> str:
    line = spell(value, n)
    return n.group % line if value.is_Add and shared_coefficient(value)[0] == 1 else line


def _power(value: Expr, n: Notation) -> str:
    base, exponent = value.args
    if exponent == sympy.S.Half:
        return n.root % spell(base, n)
    if exponent.is_negative:
        return _product(value, n)
    is_atom = base.is_Symbol or (base.is_Rational and base.is_Integer)
    return n.power % (spell(base, n) if is_atom else n.group % spell(base, n), spell(exponent, n))


def _number(value: Fraction, n: Notation) -> str:
    sign = n.minus if value < 0 else ""
    top, bottom = (n.symbol(str(part)) for part in (abs(value.numerator), value.denominator))
    return sign + (top if value.denominator == 1 else n.fraction % (top, bottom))


def _call(value: Expr, n: Notation) -> str:
    arguments = value.args[1:] if isinstance(value, Arc) else value.args
    return n.call % (n.symbol(function_name(value)), ", ".join(spell(a, n) for a in arguments))


_RULES: tuple[tuple[type, Callable[[Expr, Notation], str]], ...] = (
    (sympy.Add, _sum),
    (sympy.Mul, _product),
    (sympy.Pow, _power),
    (sympy.Abs, lambda value, n: n.absolute % spell(value.args[0], n)),
    (Piecewise, lambda value, n: n.cases([(spell(v, n), _condition(c, n)) for v, c in value.args])),
    (sympy.Function, _call),
    (type(sympy.pi), lambda value, n: n.symbol("pi")),
)
