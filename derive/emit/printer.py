"""Exact expression to source text, in one language and one precision.

Two dialects differ in how they spell a root, an absolute value, a kernel call and a
condition; precedence, signs and the order of terms are the same, so C and numpy round alike.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

import sympy
from sympy import Expr

from derive.emit.literal import c_literal, decimal
from derive.emit.target import CONSTANTS
from derive.lie.kernel import NAMES, Arc
from derive.routine.cost import shared_coefficient


@dataclass(frozen=True)
class Dialect:
    """How one target spells what differs between languages; each takes printed text.

    absolute and compared take an operand: the text in parentheses where it has several terms.
    """

    scalar: str
    number: Callable[[Fraction, str], str]
    root: str
    absolute: str
    kernel: str
    compared: str
    both: str


def c99(scalar: str, prefix: str) -> Dialect:
    """C99 in one precision; kernel functions carry the prefix."""
    suffix = "f" if scalar == "f32" else ""
    absolute = f"fabs{suffix}({{}})"
    kernel = f"{prefix}_{{name}}({{}})"
    return Dialect(scalar, c_literal, f"sqrt{suffix}({{}})", absolute, kernel, "{}", " && ")


def numpy(scalar: str = "f64") -> Dialect:
    """numpy; conditions look at real parts, so that a complex step runs through."""
    absolute = "np.where({0}.real < 0.0, -{0}, {0})"
    return Dialect(scalar, decimal, "np.sqrt({})", absolute, "_{name}({})", "{}.real", " & ")


def text(value: Expr, dialect: Dialect) -> str:
    """One expression as source text."""
    if value.is_Symbol:
        return _symbol(value, dialect)
    if value.is_Rational:
        return dialect.number(Fraction(value.p, value.q), dialect.scalar)
    for kind, rule in _RULES:
        if isinstance(value, kind):
            return rule(value, dialect)
    raise TypeError(f"no rule prints {type(value).__name__}: {value}")


def _symbol(value: Expr, dialect: Dialect) -> str:
    if value.name in CONSTANTS:
        return dialect.number(CONSTANTS[value.name][dialect.scalar], dialect.scalar)
    return str(value)


def _pi(value: Expr, dialect: Dialect) -> str:
    return dialect.number(Fraction(str(value.evalf(30))), dialect.scalar)


def _sum(value: Expr, dialect: Dialect) -> str:
    content, bare = shared_coefficient(value)
    terms = [_signed(term) for term in bare]
    if all(is_negative for is_negative, _ in terms):
        content, terms = -content, [(False, term) for _, term in terms]
    if content == -1:
        return f"-({_joined(terms, dialect)})"
    if content != 1:
        return f"{text(content, dialect)}*({_joined(terms, dialect)})"
    return _joined(terms, dialect)


def _joined(terms: list[tuple[bool, Expr]], dialect: Dialect) -> str:
    """Terms with their signs between them, a positive one first."""
    first = next(i for i, (is_negative, _) in enumerate(terms) if not is_negative)
    terms.insert(0, terms.pop(first))
    signed = (("- " if is_negative else "+ ", term) for is_negative, term in terms)
    return " ".join(sign + _factor(term, dialect) for sign, term in signed)[2:]


def _signed(term: Expr) -> tuple[bool, Expr]:
    return (True, -term) if term.could_extract_minus_sign() else (False, term)


def _product(value: Expr, dialect: Dialect) -> str:
    is_negative, value = _signed(value)
    # Not as_numer_denom, which would bring sums to a common denominator.
    coefficient, rest = value.as_coeff_Mul()
    over, under = sympy.fraction(rest)
    factors = [f for f in (coefficient, *sympy.Mul.make_args(over)) if f != 1]
    line = "*".join(_factor(f, dialect) for f in factors or [sympy.S.One])
    if under != 1:
        below = "*".join(_factor(f, dialect) for f in sympy.Mul.make_args(under))
        is_product = under.is_Mul or (under.is_Pow and under.exp.is_Integer)
        line += f"/({below})" if is_product else f"/{below}"
    return f"-{line}" if is_negative else line


def _factor(value: Expr, dialect: Dialect) -> str:
    if isinstance(value, sympy.Add) or value.is_negative:
        return f"({text(value, dialect)})"
    return text(value, dialect)


def _operand(value: Expr, dialect: Dialect) -> str:
    line = text(value, dialect)
    return line if value.is_Atom else f"({line})"


def _absolute(value: Expr, dialect: Dialect) -> str:
    return dialect.absolute.format(_operand(value.args[0], dialect))


def _power(value: Expr, dialect: Dialect) -> str:
    base, exponent = value.args
    if exponent == sympy.S.Half:
        return dialect.root.format(text(base, dialect))
    if exponent.is_Integer and exponent > 0:
        return "*".join([_factor(base, dialect)] * int(exponent))
    if exponent.is_negative:
        return _product(value, dialect)
    raise TypeError(f"no rule prints the power {value}")


def _kernel(value: Expr, dialect: Dialect) -> str:
    order, w = value.args
    return dialect.kernel.format(text(w, dialect), name=NAMES[int(order)])


def condition(value: sympy.Basic, dialect: Dialect) -> str:
    """A comparison or a conjunction of comparisons as source text."""
    if isinstance(value, sympy.And):
        ordered = sorted(value.args, key=sympy.default_sort_key)
        return dialect.both.join(f"({condition(one, dialect)})" for one in ordered)
    left, right = (_compared(side, dialect) for side in (value.lhs, value.rhs))
    return f"{left} {value.rel_op} {right}"


def _compared(side: Expr, dialect: Dialect) -> str:
    if side.is_Rational:
        return text(side, dialect)
    return dialect.compared.format(_operand(side, dialect))


_RULES: tuple[tuple[type, Callable[[Expr, Dialect], str]], ...] = (
    (sympy.Add, _sum),
    (sympy.Mul, _product),
    (sympy.Pow, _power),
    (Arc, _kernel),
    (sympy.Abs, _absolute),
    (type(sympy.pi), _pi),
)
