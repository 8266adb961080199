"""The kernel polynomials as an emitted source has them: read from its text, and from nothing else.

The one thing decided here is what counts as such a polynomial: a function of w that takes
z = 1 - w and then Horner's steps `sum = sum * z + c`. Anything else under the name is an error.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction

from derive.evidence.emitted import Emitted

DIGITS = {"float": 24, "double": 53}
"""Binary digits of a number of each C type; kernel coefficients are far from subnormal."""

_FUNCTION = re.compile(
    r"^/\* Kernel function (?P<name>\w+)\(w\).*?\*/\n"
    r"static inline (?P<type>float|double) \w+_(?P=name)\(const (?P=type) w\)\n"
    r"\{\n(?P<body>.*?)^\}",
    re.MULTILINE | re.DOTALL,
)
_NUMBER = r"(\d+\.\d+(?:e[+-]?\d+)?)F?"
_ARGUMENT = re.compile(rf"const (?:float|double) z = {_NUMBER} - w;")
_FIRST = re.compile(rf"(?:float|double) sum = (-?){_NUMBER};")
_NEXT = re.compile(rf"sum = sum \* z ([+-]) {_NUMBER};")


@dataclass(frozen=True)
class Polynomial:
    """A kernel function: its name (k, h, m), its C type, its Horner scheme in z = 1 - w.

    terms: what the compiler makes of the literals, exactly; the highest power first
    """

    name: str
    type: str
    terms: tuple[Fraction, ...]


def polynomials(one: Emitted) -> tuple[Polynomial, ...]:
    """All that a source has, none when its law needs none; raises ValueError on a strange one."""
    return read(one.source.read_text(encoding="utf-8"))


def read(text: str) -> tuple[Polynomial, ...]:
    """The same of a source's text."""
    found = tuple(
        Polynomial(one["name"], one["type"], _terms(one["name"], one["type"], one["body"]))
        for one in _FUNCTION.finditer(text)
    )
    if len(found) != text.count("/* Kernel function "):
        raise ValueError("a kernel function is not of the emitted kind: its head differs")
    return found


def _terms(name: str, kind: str, body: str) -> tuple[Fraction, ...]:
    argument, first, *rest, last = (line.strip() for line in body.splitlines())
    start, steps = _FIRST.fullmatch(first), [_NEXT.fullmatch(line) for line in rest]
    one = _ARGUMENT.fullmatch(argument)
    if not (one and float(one[1]) == 1 and start and all(steps) and last == "return sum;"):
        raise ValueError(f"{name} is not Horner's scheme in 1 - w, as emitted code has it:\n{body}")
    pairs = [start.groups(), *(step.groups() for step in steps if step)]
    return tuple((-1 if sign == "-" else 1) * rounded(digits, kind) for sign, digits in pairs)


def rounded(digits: str, kind: str) -> Fraction:
    """A decimal literal as a C compiler stores it: rounded once, to nearest, half to even."""
    exact, bits = Fraction(digits), DIGITS[kind]
    if not exact:
        return exact
    power = exact.numerator.bit_length() - exact.denominator.bit_length() - bits
    unit = Fraction(2) ** power
    while exact >= unit * 2**bits:
        unit *= 2
    return round(exact / unit) * unit
