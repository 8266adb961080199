"""Emitted headers are read without a preprocessor, and nothing is guessed."""

import pytest

from derive.native.header import number, parse
from tests.native import toy

HEADER = parse((toy.HERE / "toy.h").read_text(encoding="utf-8"))


def test_routines_are_read_with_their_parameters() -> None:
    names = ["check_params", "control", "tracking", "reaching", "plant"]
    assert list(HEADER.routines) == [f"toy_f64_{name}" for name in names]
    plant = HEADER.routines["toy_f64_plant"]
    assert plant.result == "void"
    assert [(p.name, p.size, p.is_input) for p in plant.parameters] == [
        ("params", None, True),
        ("state", None, True),
        ("force", 2, True),
        ("nu_dot", 2, False),
    ]
    assert HEADER.routines["toy_f64_control"].result == "toy_f64_status"


def test_macros_with_a_number_are_constants() -> None:
    assert HEADER.constants == {
        "TOY_F64_MAX_NU": 1.0e3,
        "TOY_F64_MARGIN": -0.125,
        "TOY_F64_ORDER": 16.0,
        "TOY_F64_LONG": 2.5,
        "TOY_F64_IS_C": 1.0,
    }


@pytest.mark.parametrize("word", ["#", "__attribute__", 'extern "C"', "comment", "include"])
def test_declarations_are_plain_c(word: str) -> None:
    assert word not in HEADER.declarations


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1", 1.0),
        ("-2.5e-3", -2.5e-3),
        ("((3.0F))", 3.0),
        ("3.0L", 3.0),
        ("10UL", 10.0),
        ("0x1.8p+1", 3.0),
        ("0x1.8p+1F", 3.0),
        ("0xFFu", 255.0),
        ("name", None),
        ("1.0 + 2.0", None),
        ("", None),
    ],
)
def test_numbers_are_c_literals(text: str, value: float | None) -> None:
    assert number(text) == value


def test_a_prototype_of_another_kind_is_refused() -> None:
    with pytest.raises(ValueError, match="double x"):
        parse("void toy_f64_other(double x);")
