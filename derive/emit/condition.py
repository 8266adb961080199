"""What the C guard compares: each comparison holds for a good number, and fails for NaN.

Written `fabs(x) <= limit` of a bare x wherever that can be: the proof follows no other form.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

Data = Mapping[str, Any]
"""The printed data of a vehicle in one scalar, with its names and numbers."""


def conditions(data: Data) -> dict[str, Any]:
    """Lists of conditions, by the name that templates know them by.

    judged: of every number that is read; far: whether what fails these may still be on the group
    given:  that a force can be given as it is; within: that it is within its limits
    usable: what can be cut by coordinate
    bound_of: name of the largest value of each gain
    """
    size = range(data["dim"])
    within = [_at_most(data, f"command->force[{i}]", f"params->force_limit[{i}]") for i in size]
    finite = [f"isfinite(command->force[{i}])" for i in size]
    limits = [f"params->force_limit[{i}] >= {data['number'](0)}" for i in size]
    return {
        "judged": [*_error(data), *_read(data)],
        "far": list(_far(data)),
        "given": within if data["saturation"] else finite,
        "within": within,
        "usable": [one for pair in zip(finite, limits, strict=True) for one in pair],
        "bound_of": gain_bounds(data),
    }


def gain_bounds(data: Data) -> dict[str, str]:
    """Name of the largest value of each gain, in any language."""
    return {
        one["member"]: "MAX_RATE" if one["unit"] == "1/s" else "MAX_PARAM"
        for one in _held(data, "params")
    }


def _error(data: Data) -> Iterator[str]:
    """Of the entries of the error that the law or the residual reads."""
    readers = [data["core"], data["drift"] or {"inputs": ()}]
    entries = [
        entry
        for reader in readers
        for one in reader["inputs"]
        if one["name"] == "g_e"
        for entry in one["entries"]
    ]
    for name, index in sorted(dict.fromkeys(map(tuple, entries)), key=lambda entry: entry[1]):
        yield _at_most(data, name, _bound(data, index))


def _read(data: Data) -> Iterator[str]:
    """Of the numbers of state and reference; where there is an error, it bounds the group's."""
    for one in _held(data, "state", "reference"):
        for i in range(one["size"]):
            is_element = one["member"] == "g"
            if data["error"] and is_element and data["is_bounded"][i]:
                continue
            is_input = data["error"] or not is_element
            bound = f"{data['macro']}_MAX_INPUT" if is_input else _bound(data, i)
            yield _at_most(data, f"{one['holder']}->{one['member']}[{i}]", bound)


def _far(data: Data) -> Iterator[str]:
    """Of the entries that the group leaves free: within reach, the others must be to blame."""
    error = data["error"]
    for one in error["outputs"] if error else data["main"]["inputs"]:
        if one["member"] != ("g_e" if error else "g"):
            continue
        for i in range(one["size"]):
            name = f"g_e_{i}" if error else f"state->g[{i}]"
            if not data["is_bounded"][i] and (not error or one["entries"][i] == name):
                yield _at_most(data, name, f"{data['macro']}_MAX_REACH")


def _held(data: Data, *holders: str) -> list[Data]:
    return [one for one in data["main"]["inputs"] if one["holder"] in holders]


def _bound(data: Data, index: int) -> str:
    name = "MAX_ENTRY" if data["is_bounded"][index] else "MAX_REACH"
    return f"{data['macro']}_{name}"


def _at_most(data: Data, name: str, limit: str) -> str:
    return f"fabs{data['scalar'].suffix}({name}) <= {limit}"
