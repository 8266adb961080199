"""Literals read back, by numpy's own decimal conversion, as the nearest binary number."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from derive.emit.literal import c_literal, decimal, nearest, python_name

FLOAT: dict[str, Any] = {"f32": np.float32, "f64": np.float64}
Number = np.floating[Any]
SCALARS = sorted(FLOAT)
LARGEST = {scalar: Fraction(float(np.finfo(kind).max)) for scalar, kind in FLOAT.items()}


def exact(number: Number) -> Fraction:
    return Fraction(*number.as_integer_ratio())


def read(text: str, scalar: str) -> Number:
    """What strtod makes of a text; float32 straight from the decimal, not by way of a double."""
    number: Number = FLOAT[scalar](text)
    return number


def is_nearest(number: Number, value: Fraction) -> bool:
    """Whether no neighbour is closer to value, and an even mantissa where two are as close."""
    kind = type(number)
    away = abs(exact(number) - value)
    sides = [np.nextafter(number, kind(side)) for side in (-np.inf, np.inf)]
    others = [abs(exact(side) - value) for side in sides if np.isfinite(side)]
    even = int(number.view(f"u{number.itemsize}")) % 2 == 0
    return all(away < other or (away == other and even) for other in others)


fractions = st.fractions(max_denominator=10**30) | st.builds(
    lambda mantissa, power: Fraction(mantissa) * Fraction(10) ** power,
    st.integers(-(10**18), 10**18),
    st.integers(-60, 15),
)
bits = st.integers(0, 2**64 - 1)


@pytest.mark.parametrize("scalar", SCALARS)
@given(value=fractions)
def test_the_nearest_number_is_printed(scalar: str, value: Fraction) -> None:
    assert is_nearest(read(decimal(value, scalar), scalar), value)


@pytest.mark.parametrize("scalar", SCALARS)
@given(value=fractions)
def test_nearest_is_what_numpy_reads_from_the_exact_decimal(scalar: str, value: Fraction) -> None:
    number = nearest(value, scalar)
    assert is_nearest(FLOAT[scalar](float(number)), value)
    assert exact(FLOAT[scalar](float(number))) == number


@pytest.mark.parametrize("scalar", SCALARS)
@given(pattern=bits)
def test_a_binary_number_survives_and_no_shorter_text_does(scalar: str, pattern: int) -> None:
    kind = FLOAT[scalar]
    size = np.dtype(kind).itemsize
    number = np.array([pattern % 2 ** (8 * size)], f"u{size}").view(kind)[0]
    if not np.isfinite(number):
        return
    text = decimal(exact(number), scalar)
    assert read(text, scalar) == number
    assert digits(text) <= digits(np.format_float_scientific(number, unique=True))


def digits(text: str) -> int:
    """How many significant digits a text has."""
    mantissa = re.sub(r"[-.]", "", text.partition("e")[0])
    return len(mantissa.strip("0")) or 1


@pytest.mark.parametrize(
    ("value", "scalar", "wanted"),
    [
        ("1", "f64", "1.0"),
        ("0", "f32", "0.0"),
        ("-1/2", "f64", "-0.5"),
        ("3.6046", "f64", "3.6046"),
        ("3.6046", "f32", "3.6046"),
        ("0.1", "f32", "0.1"),
        ("1e6", "f64", "1.0e6"),
        ("1e-290", "f64", "1.0e-290"),
        ("1/3", "f64", "0.3333333333333333"),
        ("1/3", "f32", "0.33333334"),
        ("16777217", "f32", "16777216.0"),  # a tie: to even, downwards
        ("16777219", "f32", "1.677722e7"),  # a tie: to even, upwards
        ("9007199254740993", "f64", "9007199254740992.0"),
        ("5e-324", "f64", "5.0e-324"),
        ("2.4e-324", "f64", "0.0"),
        ("1e-45", "f32", "1.0e-45"),
        ("7e-46", "f32", "0.0"),  # half the least denormal is 7.006e-46
        ("8e-46", "f32", "1.0e-45"),
    ],
)
def test_known_numbers(value: str, scalar: str, wanted: str) -> None:
    assert decimal(Fraction(value), scalar) == wanted


@pytest.mark.parametrize("scalar", SCALARS)
def test_a_tie_between_denormals_goes_to_even(scalar: str) -> None:
    least = exact(np.nextafter(FLOAT[scalar](0), FLOAT[scalar](1)))
    assert nearest(least / 2, scalar) == 0
    assert nearest(least * 3 / 2, scalar) == 2 * least
    assert nearest(least * 5 / 2, scalar) == 2 * least


@pytest.mark.parametrize("scalar", SCALARS)
def test_the_largest_number_is_printed(scalar: str) -> None:
    assert exact(read(decimal(LARGEST[scalar], scalar), scalar)) == LARGEST[scalar]


@pytest.mark.parametrize("scalar", SCALARS)
@given(value=fractions)
def test_a_c_literal_has_a_point_and_the_suffix_of_its_type(scalar: str, value: Fraction) -> None:
    suffix = {"f32": "F", "f64": ""}[scalar]
    assert re.fullmatch(rf"-?\d+\.\d+(e-?\d+)?{suffix}", c_literal(value, scalar))


def test_python_keywords_get_an_underscore() -> None:
    assert [python_name(name) for name in ("lambda", "k_s", "is")] == ["lambda_", "k_s", "is_"]
