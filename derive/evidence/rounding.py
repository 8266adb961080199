"""How far a Horner scheme in floating point is from the same in exact numbers: Gappa's bound."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction

from derive.evidence.tool import Tool, ToolFailed, run

GAPPA = Tool("gappa", "apt install gappa")
FORMATS = {"float": "ieee_32", "double": "ieee_64"}
SECONDS = 60

_FOUND = re.compile(
    r"in \[(-?\d+)(?:b(-?\d+))?(?: \{[^}]*\})?, (-?\d+)(?:b(-?\d+))?(?: \{[^}]*\})?\]"
)


def rounding(kind: str, terms: Sequence[Fraction], low: Fraction, high: Fraction) -> Fraction:
    """Bound of |computed - exact| for every number w of the C type with low <= w <= high.

    Subtraction 1 - w and every step of the scheme round to nearest; terms: highest power first.
    Raises ToolMissing, ToolFailed.
    """
    command = [GAPPA.path]
    said = run(command, SECONDS, fed=script(kind, terms, low, high))
    found = _FOUND.search(said)
    if not found:
        raise ToolFailed(command, "gave no bound", said)
    low_end, low_power, high_end, high_power = found.groups()
    return max(abs(_dyadic(low_end, low_power)), abs(_dyadic(high_end, high_power)))


def script(kind: str, terms: Sequence[Fraction], low: Fraction, high: Fraction) -> str:
    """The question in Gappa's language: small letters are computed, large ones exact."""
    first, *rest = (_written(c) for c in terms)
    lines = [
        f"@rnd = float<{FORMATS[kind]}, ne>;",
        "w = rnd(W);",
        "z rnd= 1 - w;",
        "Z = 1 - w;",
        f"s0 = {first};",
        f"S0 = {first};",
    ]
    for i, term in enumerate(rest, 1):
        lines.append(f"s{i} rnd= s{i - 1} * z + ({term});")
        lines.append(f"S{i} = S{i - 1} * Z + ({term});")
    bounds = f"[{_written(low)}, {_written(high)}]"
    lines.append(f"{{ w in {bounds} -> s{len(rest)} - S{len(rest)} in ? }}")
    return "\n".join([*lines, ""])


def _written(value: Fraction) -> str:
    """An exact dyadic number, as Gappa takes it: 3b-1 is 3/2."""
    power = value.denominator.bit_length() - 1
    if value.denominator != 1 << power:
        raise ValueError(f"{value} is no number of a floating-point format")
    return f"{value.numerator}b-{power}"


def _dyadic(digits: str, power: str | None) -> Fraction:
    return Fraction(int(digits)) * Fraction(2) ** int(power or 0)
