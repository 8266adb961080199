"""`shortest` and `hysteresis`: what a file may say, and how it is told otherwise."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from derive.vehicle import InputError, Vehicle, load, resolve, side
from derive.vehicle.starter import starter

SCHEMA: dict[str, Any] = json.loads(
    (Path(__file__).parents[2] / "docs" / "vehicle.schema.json").read_text(encoding="utf-8")
)["properties"]


def read(folder: Path, *lines: str, group: str = "S3", law: str = "log") -> Vehicle:
    n = {"S3 x R3": 6}.get(group, 3)
    diagonal = [[float(3 + i // 3) if i == j else 0.0 for j in range(n)] for i in range(n)]
    text = ['name = "body"', f'group = "{group}"', f'law = "{law}"', f"inertia = {diagonal}"]
    path = folder / "body.toml"
    path.write_text("\n".join([*text, "gains = {lambda = 0.5, k_s = 1}", *lines]), encoding="utf-8")
    return load(path)


@pytest.mark.parametrize(
    ("lines", "hysteresis"),
    [
        ((), None),
        (("shortest = false",), None),
        (("shortest = true",), Fraction(1, 10)),
        (("shortest = true", "hysteresis = 0.25"), Fraction(1, 4)),
        (("shortest = true", "hysteresis = 0.5"), Fraction(1, 2)),
        (("shortest = true", "hysteresis = 1e-3"), Fraction(1, 1000)),
    ],
)
def test_the_choice_is_off_unless_asked_for(
    tmp_path: Path, lines: tuple[str, ...], hysteresis: Fraction | None
) -> None:
    assert read(tmp_path, *lines).hysteresis == hysteresis


@pytest.mark.parametrize("law", ["log", "half_log", "mrp", "cayley", "vec"])
def test_every_law_that_tells_the_two_apart_has_the_choice(tmp_path: Path, law: str) -> None:
    vehicle = read(tmp_path, "shortest = true", law=law)
    assert vehicle.hysteresis == side.USUAL
    assert resolve(vehicle).dim == 3


@pytest.mark.parametrize(
    ("group", "law", "lines", "key", "found", "remedy"),
    [
        ("SO3", "log", ("shortest = true",), "shortest", "group = 'SO3'", "takes the shorter"),
        ("SE3", "log", ("shortest = true",), "shortest", "group = 'SE3'", "takes the shorter"),
        ("S3 x R3", "log", ("shortest = true",), "shortest", "'S3 x R3'", "take SO3"),
        ("S3", "sign_vec", ("shortest = true",), "shortest", "by itself", 'law = "vec"'),
        ("S3", "log", ("shortest = 1",), "shortest", "1", "write shortest = true"),
        ("S3", "log", ('shortest = "yes"',), "shortest", "the string 'yes'", "shortest = true"),
        ("S3", "log", ("hysteresis = 0.1",), "hysteresis", "no such choice", "shortest = true"),
        ("SO3", "log", ("shortest = false", "hysteresis = 0.1"), "hysteresis", "no such", "leave"),
        *(("S3", "log", ("shortest = true", f"hysteresis = {given}"), "hysteresis", found, "0.1")
          for given, found in (("0", "0"), ("0.0009", "0.0009"), ("0.51", "0.51"), ("-0.1", "-0.1"),
                               ("true", "the boolean true"), ("nan", "nan"), ("[0.1]", "array"))),
    ],
)  # fmt: skip
def test_where_there_is_no_choice_it_is_told(
    tmp_path: Path, group: str, law: str, lines: tuple[str, ...], key: str, found: str, remedy: str
) -> None:
    with pytest.raises(InputError) as caught:
        read(tmp_path, *lines, group=group, law=law)
    assert caught.value.key == key
    assert found in caught.value.found
    assert remedy in caught.value.remedy


def test_a_law_without_a_reference_has_no_second_error(tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        read(tmp_path, "shortest = true", 'controller = "reaching"')
    assert (caught.value.key, caught.value.found) == ("shortest", "controller = 'reaching'")
    assert 'controller = "gsmc"' in caught.value.remedy


def test_below_a_table_it_is_sent_to_the_top(tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        read(tmp_path, "[emit]", "shortest = true")
    assert caught.value.remedy == "move shortest to the top of the file, above the first [table]"


def test_the_schema_says_the_same() -> None:
    told = SCHEMA["hysteresis"]
    assert (told["minimum"], told["maximum"]) == (float(side.LEAST), float(side.MOST))
    assert told["default"] == float(side.USUAL)
    assert (SCHEMA["shortest"]["type"], SCHEMA["shortest"]["default"]) == ("boolean", False)


def test_a_new_file_offers_it_where_it_exists(tmp_path: Path) -> None:
    offered = starter("body", side.GROUP)
    path = tmp_path / "body.toml"
    path.write_text(offered.replace("# shortest", "shortest"), encoding="utf-8")
    assert load(path).hysteresis == side.USUAL
    assert "shortest" not in starter("body", "SO3")
