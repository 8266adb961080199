"""The printed data of a whole vehicle: its routines in every target and scalar.

Which derivations there are is the caller's business; here they become what templates read.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from derive.emit import printer
from derive.emit.literal import python_name
from derive.emit.printed import Printed, kernels, routine
from derive.emit.status import FIRST_BAD, STATUSES
from derive.emit.target import TARGETS
from derive.routine.derivation import Derivation

CORE = "law"
"""Symbol of the guarded law's body, which also reports its clearance."""


def package(
    name: str,
    main: Derivation,
    public: Sequence[Derivation],
    inner: Sequence[Derivation],
    facts: Mapping[str, Any],
    border: Derivation | None = None,
) -> Printed:
    """{target: {scalar: data}} for one vehicle; facts go to every template as they are.

    border: from what drivers measure to a configuration, for the example
    """
    dialects = {
        ("c99", "f32"): printer.c99("f32", f"{name}_f32"),
        ("c99", "f64"): printer.c99("f64", f"{name}_f64"),
        ("numpy", "f64"): printer.numpy(),
    }
    return {
        target: {
            scalar: {
                **_one(main, public, inner, facts, dialects[target, scalar], target),
                "border": routine(border, dialects[target, scalar]) if border else None,
            }
            for scalar in TARGETS[target].scalars
        }
        for target in TARGETS
    }


def _one(
    main: Derivation,
    public: Sequence[Derivation],
    inner: Sequence[Derivation],
    facts: Mapping[str, Any],
    dialect: printer.Dialect,
    target: str,
) -> Printed:
    derivations = [main, *public, *inner]
    shape = facts["element_shape"]
    printed = [_declared(routine(d, dialect), d not in inner, shape) for d in derivations]
    printed[0].update(symbol=CORE, public_writes=["command"])
    scalar = dialect.scalar if target == "c99" else "f64"
    return {
        **facts,
        "main": printed[0],
        "routines": printed,
        "residual": next((one for one in printed if one["name"] == "residual"), None),
        "kernels": kernels(derivations, scalar),
        "structs": _structs(printed[0]),
        "command": [out for out in printed[0]["outputs"] if out["holder"] == "command"],
        "statuses": [list(status) for status in STATUSES],
        "first_bad": FIRST_BAD,
    }


def _declared(one: Printed, is_public: bool, shape: Sequence[int]) -> Printed:
    """Add how a routine is called: what holds its inputs, its arguments, what it writes."""
    for entry in one["inputs"]:
        is_element = entry["member"] == "g"
        entry["argument"] = _argument(entry)
        entry["shape"] = tuple(shape) if is_element else (entry["size"],)
    inputs = one["inputs"]
    writes = list(dict.fromkeys(out["holder"] or out["member"] for out in one["outputs"]))
    return {
        **one,
        "symbol": one["name"],
        "is_public": is_public,
        "holders": list(dict.fromkeys(e["holder"] for e in inputs if e["holder"])),
        "arguments": [e["argument"] for e in inputs if e["holder"] != "params"],
        "has_reference": any(e["holder"] == "reference" for e in inputs),
        "writes": writes,
        "public_writes": writes,
    }


def _argument(entry: Printed) -> str:
    """Name of an input as an argument: params by their member, all others by their own name."""
    if entry["holder"] != "params":
        return str(entry["name"])
    return python_name(str(entry["member"]))


def _structs(main: Printed) -> list[Printed]:
    """params, state, reference, command: the fields in the order of the main routine."""
    fields = main["inputs"] + [out for out in main["outputs"] if out["holder"]]
    holders = dict.fromkeys(field["holder"] for field in fields)
    return [
        {"name": holder, "fields": [field for field in fields if field["holder"] == holder]}
        for holder in holders
    ]
