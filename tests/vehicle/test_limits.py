"""The [limits] table: what it means, and every way it can be wrong with one message each."""

import tomllib
from fractions import Fraction
from pathlib import Path

import pytest

from derive.emit.target import SCALARS
from derive.vehicle import InputError, Vehicle, load
from derive.vehicle.limits import LEAST, LEAST_DRIFT, MOST, MOST_DRIFT, WAYS, Limits
from derive.vehicle.starter import starter

BODY = 'name = "b"\ngroup = "SO3"\ninertia = [[3, 0, 0], [0, 3, 0], [0, 0, 3]]\n'
GAINS = "[gains]\nlambda = 0.5\nk_s = 1\n"


def with_limits(folder: Path, lines: str, head: str = "", foot: str = "[limits]\n") -> Vehicle:
    path = folder / "b.toml"
    path.write_text(BODY + head + GAINS + foot + lines, encoding="utf-8")
    return load(path)


def refusal(folder: Path, lines: str, head: str = "", foot: str = "[limits]\n") -> InputError:
    with pytest.raises(InputError) as caught:
        with_limits(folder, lines, head, foot)
    return caught.value


SMALL, TINY = Fraction(1, 10**6), Fraction(1, 10**9)


@pytest.mark.parametrize(
    ("lines", "limits"),
    [
        ("", Limits()),
        ("force = 2", Limits((Fraction(2),) * 3, "direction")),
        ("force = 0.1", Limits((Fraction(1, 10),) * 3, "direction")),
        ("force = [1e-9, 2, 1e9]", Limits((TINY, Fraction(2), Fraction(10**9)), "direction")),
        ('force = 1\nsaturation = "axis"', Limits((Fraction(1),) * 3, "axis")),
        ('saturation = "direction"\nforce = 1', Limits((Fraction(1),) * 3, "direction")),
        ("drift = 0.1", Limits(drift=Fraction(1, 10))),
        ("drift = 2e-6", Limits(drift=2 * SMALL)),
        ('drift = 2e-6\n[emit]\nscalars = ["f32"]', Limits(drift=2 * SMALL)),
        ('drift = 1e-14\n[emit]\nscalars = ["f64"]', Limits(drift=Fraction(1, 10**14))),
        ("drift = 1e-3\nforce = 1", Limits((Fraction(1),) * 3, "direction", SMALL * 1000)),
    ],
)
def test_what_a_table_means(tmp_path: Path, lines: str, limits: Limits) -> None:
    assert with_limits(tmp_path, lines).limits == limits


def test_without_a_table_there_is_no_limit(tmp_path: Path) -> None:
    assert with_limits(tmp_path, "", foot="").limits == Limits((), "", None)


def test_one_limit_stands_for_as_many_as_the_inertia_has_rows(tmp_path: Path) -> None:
    path = tmp_path / "b.toml"
    text = BODY.replace("SO3", "R1").replace("[[3, 0, 0], [0, 3, 0], [0, 0, 3]]", "[[3]]")
    path.write_text(text + GAINS + "[limits]\nforce = 2\n", encoding="utf-8")
    assert load(path).limits.force == (Fraction(2),)


FORCE = "3 numbers, or one for all, each from 1e-9 to 1e9, in N m and N"
GIVES = "write what the actuators give in either direction, without quotes"
DRIFT = "a number from 2e-6 to 0.1"
FINE = "write drift = 1e-4, or leave it out for 1e-4 in float and 1e-6 in double"


@pytest.mark.parametrize(
    ("value", "where", "found"),
    [
        ("0", "force", "0"),
        ("-1", "force", "-1"),
        ("9.9e-10", "force", "9.9e-10"),
        ("1000000000.1", "force", "1000000000.1"),
        ("nan", "force", "nan"),
        ("inf", "force", "inf"),
        ("1e999999999", "force", "1e999999999"),
        ("true", "force", "the boolean true"),
        ('"1"', "force", "the string '1'"),
        ("{x = 1}", "force", "a table"),
        ("[]", "force", "an array of 0"),
        ("[1, 1]", "force", "an array of 2"),
        ("[1, 1, 1, 1]", "force", "an array of 4"),
        ("[0, 1, 1]", "force, entry 1", "0"),
        ("[1, -2, 1]", "force, entry 2", "-2"),
        ('[1, 1, "1"]', "force, entry 3", "the string '1'"),
        ("[1, 1, inf]", "force, entry 3", "inf"),
        ("[1, [1], 1]", "force, entry 2", "an array of 1"),
        ("[1, 1, false]", "force, entry 3", "the boolean false"),
    ],
)
def test_a_force_that_is_none_is_told(tmp_path: Path, value: str, where: str, found: str) -> None:
    error = refusal(tmp_path, f"force = {value}")
    assert error.key == f"limits.{where}"
    assert (error.expected, error.found, error.remedy) == (FORCE, found, GIVES)


@pytest.mark.parametrize(
    ("value", "found"),
    [
        ("0", "0"),
        ("-1e-3", "-0.001"),
        ("9.9e-15", "9.9e-15"),
        ("0.11", "0.11"),
        ("1", "1"),
        ("nan", "nan"),
        ("inf", "inf"),
        ("true", "the boolean true"),
        ('"1e-4"', "the string '1e-4'"),
        ("[1e-4]", "an array of 1"),
    ],
)
def test_a_drift_that_is_none_is_told(tmp_path: Path, value: str, found: str) -> None:
    error = refusal(tmp_path, f"drift = {value}")
    assert error.key == "limits.drift"
    assert (error.expected, error.found, error.remedy) == (DRIFT, found, FINE)


@pytest.mark.parametrize(
    ("value", "scalars", "least"),
    [
        ("1.9e-6", '["f32", "f64"]', "2e-6"),
        ("1e-14", '["f64", "f32"]', "2e-6"),
        ("1.9e-6", '["f32"]', "2e-6"),
        ("9.9e-15", '["f64"]', "1e-14"),
    ],
)
def test_a_drift_that_rounding_alone_exceeds_is_told(
    tmp_path: Path, value: str, scalars: str, least: str
) -> None:
    """What is too near for float may do for double, and the message says so."""
    error = refusal(tmp_path, f"drift = {value}\n[emit]\nscalars = {scalars}")
    more = ", since rounding to f32 alone leads that far off the group" if "," in scalars else ""
    assert error.expected == f"a number from {least} to 0.1{more}"
    only = ', or write scalars = ["f64"] below [emit]'
    assert Fraction(error.found) == Fraction(value)
    assert error.remedy == FINE + (only if more else "")


@pytest.mark.parametrize(
    ("lines", "key", "expected", "found", "remedy"),
    [
        ('saturation = "axis"', "saturation", "a force to be limited", "no force", "write force"),
        ('force = 1\nsaturation = "Axis"', "saturation", "direction, axis", "'Axis'", '= "axis"'),
        ('force = 1\nsaturation = ""', "saturation", "direction, axis", "''", "the nearest is"),
        ("force = 1\nsaturation = 1", "saturation", "direction, axis", "1", "in quotes"),
        ("force = 1\nsaturation = true", "saturation", "direction", "boolean true", "in quotes"),
        ("forces = 1", "forces", "force, saturation, drift", "an unknown key", "write force"),
        ("max_drift = 1e-3", "max_drift", "force, saturation, drift", "unknown", "write drift"),
        ("k_s = 1", "k_s", "force, saturation, drift", "unknown", "move k_s below [gains]"),
        ("force_limit = 1", "force_limit", "drift", "unknown", "move force_limit below [simulate]"),
    ],
)
def test_every_other_mistake_is_told(
    tmp_path: Path, lines: str, key: str, expected: str, found: str, remedy: str
) -> None:
    error = refusal(tmp_path, lines)
    assert error.key == f"limits.{key}"
    assert expected in error.expected
    assert found in error.found
    assert remedy in error.remedy


@pytest.mark.parametrize("key", ["force", "saturation", "drift"])
@pytest.mark.parametrize(
    ("head", "foot", "where"), [("{} = 1\n", "", ""), ("", "{} = 1\n", "gains.")]
)
def test_a_key_in_another_table_is_sent_here(
    tmp_path: Path, key: str, head: str, foot: str, where: str
) -> None:
    error = refusal(tmp_path, "", head.format(key), foot.format(key))
    assert error.key == f"{where}{key}"
    assert error.remedy == f"move {key} below [limits]"


@pytest.mark.parametrize("line", ["limits = 1", "limits = [1, 1, 1]", 'limits = "axis"'])
def test_what_is_no_table_is_told(tmp_path: Path, line: str) -> None:
    error = refusal(tmp_path, "", head=line + "\n", foot="")
    assert error.key == "limits"
    assert error.remedy == "write [limits] on a line of its own, and its keys below it"


def test_the_bounds_are_those_of_the_emitted_params() -> None:
    """What the reader accepts, check_params accepts in both scalars."""
    for scalar in SCALARS.values():
        assert scalar.min_gain <= LEAST
        assert scalar.max_param >= MOST
        assert scalar.least_drift == LEAST_DRIFT[scalar.name] < scalar.max_drift
        assert scalar.max_drift <= MOST_DRIFT == scalar.most_drift


@pytest.mark.parametrize("group", ["SO3", "SE3", "R2"])
def test_the_starter_shows_limits_that_load(tmp_path: Path, group: str) -> None:
    """Commented out: nothing is limited; with the marks taken away: the table it shows."""
    text = starter("b", group)
    path = tmp_path / "b.toml"
    path.write_text(text, encoding="utf-8")
    assert load(path).limits == Limits()
    lines = text.splitlines()
    first = lines.index("# [limits]")
    shown = [line.removeprefix("# ") for line in lines[first : first + 4]]
    path.write_text("\n".join([*lines[:first], *shown, *lines[first + 4 :]]), encoding="utf-8")
    told = tomllib.loads("\n".join(shown))["limits"]
    limits = load(path).limits
    assert set(limits.force) == {Fraction(str(told["force"]))}
    assert limits.saturation == told["saturation"] in WAYS
    assert limits.drift == Fraction(str(told["drift"]))
