"""Numbers and names as source text: the shortest decimal that reads back as the nearest.

Floating point enters the product here and in the printer, nowhere else. sympy is not needed.
"""

from __future__ import annotations

import keyword
import struct
from fractions import Fraction

MANTISSA_BITS = {"f32": 24, "f64": 53}
LEAST_EXPONENT = {"f32": -149, "f64": -1074}
SUFFIX = {"f32": "F", "f64": ""}


def nearest(value: Fraction, scalar: str) -> Fraction:
    """The binary number of that scalar nearest to value, ties to even; range is not checked."""
    if value == 0:
        return value
    exponent = abs(value.numerator).bit_length() - value.denominator.bit_length()
    if abs(value) < Fraction(2) ** exponent:
        exponent -= 1
    ulp = Fraction(2) ** max(exponent - MANTISSA_BITS[scalar] + 1, LEAST_EXPONENT[scalar])
    return round(value / ulp) * ulp


def decimal(value: Fraction, scalar: str) -> str:
    """Shortest decimal text of the binary number nearest to value, always with a point."""
    target = nearest(value, scalar)
    digits = 17 if scalar == "f64" else 9
    texts = (f"{float(target):.{count}g}" for count in range(1, digits + 1))
    text = next(text for text in texts if nearest(Fraction(text), scalar) == target)
    mantissa, mark, exponent = text.partition("e")
    if "." not in mantissa:
        mantissa += ".0"
    return f"{mantissa}e{int(exponent)}" if mark else mantissa


def c_literal(value: Fraction, scalar: str) -> str:
    """A C99 constant of that scalar's type."""
    return decimal(value, scalar) + SUFFIX[scalar]


def python_name(name: str) -> str:
    """A name as Python spells it: a keyword gets a trailing underscore."""
    return f"{name}_" if keyword.iskeyword(name) else name


def exact(value: float, scalar: str) -> str:
    """Shortest decimal text of a number that the scalar holds, as C has its constants."""
    kind = {"f32": "f", "f64": "d"}[scalar]
    held = struct.pack(kind, value)
    texts = (f"{value:.{count}g}" for count in range(1, 18))
    text = (
        repr(value)
        if scalar == "f64"
        else next(one for one in texts if struct.pack(kind, float(one)) == held)
    )
    mantissa, mark, exponent = text.partition("e")
    mantissa += "" if "." in mantissa else ".0"
    return (f"{mantissa}e{int(exponent)}" if mark else mantissa) + SUFFIX[scalar]
