"""The published JSON Schema says what the reader of vehicle files says."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from derive import vehicle, vehicle_check
from derive.control.table import CONTROLLERS

SCHEMA: dict[str, Any] = json.loads(
    (Path(__file__).parents[1] / "docs" / "vehicle.schema.json").read_text(encoding="utf-8")
)
KEYS: dict[str, Any] = SCHEMA["properties"]


def test_keys_are_those_of_the_reader() -> None:
    assert tuple(KEYS) == vehicle.TOP_KEYS
    assert tuple(KEYS["emit"]["properties"]) == vehicle.EMIT_KEYS
    assert not SCHEMA["additionalProperties"]
    assert not KEYS["emit"]["additionalProperties"]
    assert KEYS["schema"]["const"] == vehicle.SCHEMA


def test_choices_and_defaults_are_those_of_the_reader() -> None:
    emit = KEYS["emit"]["properties"]
    for key, known in (("scalars", vehicle.SCALARS), ("targets", vehicle.TARGETS)):
        assert tuple(emit[key]["items"]["enum"]) == known == tuple(emit[key]["default"])
    assert tuple(KEYS["controller"]["enum"]) == tuple(CONTROLLERS)
    assert KEYS["controller"]["default"] == vehicle.DEFAULT_CONTROLLER
    assert KEYS["law"]["default"] == vehicle.DEFAULT_LAW


def test_required_keys_are_those_the_reader_misses(tmp_path: Path) -> None:
    lines = ['name = "body"', 'group = "SO3"', "inertia = [[1]]", "gains = {lambda = 1, k_s = 1}"]
    required = set()
    path = tmp_path / "body.toml"
    for line in lines:
        path.write_text("\n".join(other for other in lines if other != line), encoding="utf-8")
        with pytest.raises(vehicle.InputError) as caught:
            vehicle.load(path)
        required.add(caught.value.key.partition(".")[0])
    path.write_text("\n".join(lines), encoding="utf-8")
    vehicle.load(path)
    assert required == set(SCHEMA["required"])


def test_gains_are_those_of_each_controller() -> None:
    gains = {
        rule["if"]["properties"]["controller"]["const"]: rule["then"]["properties"]["gains"]
        for rule in SCHEMA["allOf"]
    }
    assert {name: tuple(rule["properties"]) for name, rule in gains.items()} == CONTROLLERS
    assert {name: tuple(rule["required"]) for name, rule in gains.items()} == CONTROLLERS
    assert not any(rule["additionalProperties"] for rule in gains.values())
    is_implied = {  # a rule without "required" applies to a file that leaves the controller out
        rule["if"]["properties"]["controller"]["const"]: "required" not in rule["if"]
        for rule in SCHEMA["allOf"]
    }
    assert is_implied == {name: name == vehicle.DEFAULT_CONTROLLER for name in CONTROLLERS}


def test_bounds_are_those_of_the_reader() -> None:
    row = KEYS["inertia"]["items"]
    assert KEYS["inertia"]["maxItems"] == row["maxItems"] == vehicle.LARGEST_DIMENSION
    assert row["items"]["maximum"] == -row["items"]["minimum"] == vehicle.LARGEST_ENTRY
    assert SCHEMA["$defs"]["gain"]["maximum"] == vehicle.LARGEST_GAIN
    assert KEYS["name"]["maxLength"] == vehicle_check.LONGEST_NAME
    assert KEYS["name"]["pattern"] == f"^{vehicle_check.NAME.pattern}$"
    for suffix in vehicle_check.SCALAR_SUFFIXES:
        assert re.search(KEYS["name"]["not"]["pattern"], "body" + suffix)
