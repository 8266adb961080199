"""The published JSON Schema says what the reader of vehicle files says."""

import json
import re
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from derive.control.table import CONTROLLERS
from derive.emit.target import SCALARS
from derive.lie import basis
from derive.vehicle import body as vehicle_body
from derive.vehicle import check as vehicle_check
from derive.vehicle import controller as vehicle_controller
from derive.vehicle import experiment as vehicle_experiment
from derive.vehicle import file as vehicle
from derive.vehicle import group as vehicle_group
from derive.vehicle import key as vehicle_key
from derive.vehicle import limits as vehicle_limits
from derive.vehicle import number as vehicle_number

SCHEMA: dict[str, Any] = json.loads(
    (Path(__file__).parents[2] / "docs" / "vehicle.schema.json").read_text(encoding="utf-8")
)
KEYS: dict[str, Any] = SCHEMA["properties"]


TABLES = {
    "": (SCHEMA, vehicle_key.TOP_KEYS),
    "emit": (KEYS["emit"], vehicle_key.EMIT_KEYS),
    "limits": (KEYS["limits"], vehicle_key.LIMIT_KEYS),
    "options": (KEYS["options"], vehicle_key.OPTION_KEYS),
    "reference": (KEYS["reference"], vehicle_key.REFERENCE_KEYS),
    "simulate": (KEYS["simulate"], vehicle_key.SIMULATE_KEYS),
    "body": (SCHEMA["$defs"]["body"], vehicle_key.BODY_KEYS),
    "group": (SCHEMA["$defs"]["group"], vehicle_key.GROUP_KEYS),
}


@pytest.mark.parametrize("table", TABLES)
def test_keys_are_those_of_the_reader(table: str) -> None:
    described, known = TABLES[table]
    assert tuple(described["properties"]) == known
    assert not described["additionalProperties"]


def test_ranges_of_a_flight_are_those_of_the_reader() -> None:
    described = KEYS["simulate"]["properties"]
    for key, (least, most, _) in vehicle_experiment.SCALARS.items():
        bounds = described[key]["minimum"], described[key]["maximum"]
        assert bounds == (float(least), float(most))
    for key in vehicle_experiment.COLUMNS:
        assert described[key]["$ref"] == "#/$defs/column"
    reference = KEYS["reference"]["properties"]
    assert tuple(reference["kind"]["enum"]) == tuple(vehicle_experiment.KINDS)
    least, most, _ = vehicle_experiment.SCALARS["duration"]
    bounds = reference["duration"]["minimum"], reference["duration"]["maximum"]
    assert bounds == (float(least), float(most))


def test_version_is_that_of_the_reader() -> None:
    assert KEYS["schema"]["const"] == vehicle.SCHEMA


def test_options_are_left_out_for_false() -> None:
    options = KEYS["options"]["properties"].values()
    assert {(option["type"], option["default"]) for option in options} == {("boolean", False)}


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
    either = [set(way["required"]) for way in SCHEMA["oneOf"]]
    assert either == [{"inertia"}, {"body"}]
    assert required == {*SCHEMA["required"], "inertia"}


def test_gains_are_those_of_each_controller() -> None:
    gains = {
        rule["if"]["properties"]["controller"]["const"]: rule["then"]["properties"]["gains"]
        for rule in SCHEMA["allOf"]
    }
    known = {name: one.names for name, one in CONTROLLERS.items()}
    assert {name: tuple(rule["properties"]) for name, rule in gains.items()} == known
    assert {name: tuple(rule["required"]) for name, rule in gains.items()} == known
    units = {name: tuple(gain.unit for gain in one.gains) for name, one in CONTROLLERS.items()}
    described = {name: rule["properties"].values() for name, rule in gains.items()}
    assert {name: tuple(g["description"] for g in of) for name, of in described.items()} == units
    for gain in (gain for of in described.values() for gain in of):
        is_rate = gain["description"] == vehicle_controller.RATE
        assert gain["$ref"] == f"#/$defs/{'rate' if is_rate else 'gain'}"

    assert not any(rule["additionalProperties"] for rule in gains.values())
    is_implied = {  # a rule without "required" applies to a file that leaves the controller out
        rule["if"]["properties"]["controller"]["const"]: "required" not in rule["if"]
        for rule in SCHEMA["allOf"]
    }
    assert is_implied == {name: name == vehicle.DEFAULT_CONTROLLER for name in CONTROLLERS}


def test_group_and_law_are_those_of_each_controller() -> None:
    """What a controller has of its own, and nothing of the others."""
    then = {
        rule["if"]["properties"]["controller"]["const"]: rule["then"]["properties"]
        for rule in SCHEMA["allOf"]
    }
    for name, one in CONTROLLERS.items():
        assert then[name].get("law", {}).get("const") == one.law
        assert tuple(then[name].get("group", {}).values()) == one.groups


def test_bounds_are_those_of_the_reader() -> None:
    assert KEYS["inertia"]["$ref"] == "#/$defs/matrix"
    matrix = SCHEMA["$defs"]["matrix"]
    row = matrix["items"]
    assert matrix["maxItems"] == row["maxItems"] == vehicle_number.LARGEST_DIMENSION
    assert row["items"]["maximum"] == -row["items"]["minimum"] == vehicle_number.LARGEST_ENTRY
    assert SCHEMA["$defs"]["gain"]["maximum"] == vehicle_controller.LARGEST_GAIN
    assert SCHEMA["$defs"]["rate"]["maximum"] == vehicle_controller.LARGEST_RATE
    for one in ("gain", "rate"):
        assert SCHEMA["$defs"][one]["minimum"] == float(vehicle_controller.LEAST_GAIN)
    assert SCHEMA["$defs"]["positive"]["maximum"] == vehicle_number.LARGEST_ENTRY
    center = SCHEMA["$defs"]["body"]["properties"]["center"]["items"]
    assert center["maximum"] == -center["minimum"] == vehicle_body.LARGEST_ARM
    assert KEYS["name"]["maxLength"] == vehicle_check.LONGEST_NAME
    assert KEYS["name"]["pattern"] == f"^{vehicle_check.NAME.pattern}$"
    for suffix in vehicle_check.SCALAR_SUFFIXES:
        assert re.search(KEYS["name"]["not"]["pattern"], "body" + suffix)


def test_limits_are_those_of_the_reader() -> None:
    keys = KEYS["limits"]["properties"]
    force = SCHEMA["$defs"]["force"]
    assert (force["minimum"], force["maximum"]) == bounds(vehicle_limits.LEAST, vehicle_limits.MOST)
    one, each = keys["force"]["anyOf"]
    assert one == each["items"] == {"$ref": "#/$defs/force"}
    assert each["maxItems"] == vehicle_number.LARGEST_DIMENSION
    drift = keys["drift"]["minimum"], keys["drift"]["maximum"]
    least = vehicle_limits.LEAST_DRIFT
    assert drift == bounds(min(least.values()), vehicle_limits.MOST_DRIFT)
    assert f"at least {vehicle_limits.WORDS['f32']} where float" in keys["drift"]["description"]
    assert tuple(keys["saturation"]["enum"]) == vehicle_limits.WAYS
    assert keys["saturation"]["default"] == vehicle_limits.WAYS[0]
    assert KEYS["limits"]["dependentRequired"] == {"saturation": ["force"]}
    assert {one.most_drift for one in SCALARS.values()} == {vehicle_limits.MOST_DRIFT}
    told = [f"{float(one.max_drift):.0e}".replace("e-0", "e-") for one in SCALARS.values()]
    assert f"{told[0]} in float and {told[1]} in double" in keys["drift"]["description"]


def bounds(least: Fraction, most: Fraction) -> tuple[float, float]:
    return float(least), float(most)


def test_a_group_of_ones_own_is_bounded_as_by_the_reader() -> None:
    group = SCHEMA["$defs"]["group"]["properties"]
    sizes = [group["basis"][key] for key in ("minItems", "maxItems")]
    assert sizes == [1, basis.LARGEST_DIMENSION]
    assert group["units"]["maxItems"] == basis.LARGEST_DIMENSION
    rows = group["basis"]["items"]
    assert rows["maxItems"] == rows["items"]["maxItems"] == basis.LARGEST_SIZE
    number, ratio = SCHEMA["$defs"]["exact"]["oneOf"]
    assert number["maximum"] == -number["minimum"] == vehicle_group.LARGEST_PART
    for pattern, own in (
        (ratio["pattern"], vehicle_group.RATIO),
        (group["name"]["pattern"], vehicle_group.WORD),
        (group["units"]["items"]["pattern"], vehicle_group.UNIT),
    ):
        assert pattern == f"^{own.pattern}$"
    assert group["name"]["maxLength"] == vehicle_group.LONGEST_WORD
