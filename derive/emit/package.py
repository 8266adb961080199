"""The printed data of a whole vehicle: its routines in every target and scalar.

Which derivations there are is the caller's business; here they become what templates read.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from derive.emit import printer
from derive.emit.literal import python_name
from derive.emit.printed import Printed, kernels, routine
from derive.emit.status import FIRST_BAD, STATUSES
from derive.emit.target import TARGETS
from derive.routine.derivation import Derivation

CORE = "law"
"""Symbol of the guarded law's body, which also reports its clearance."""

SIDE = {
    "name": "side",
    "fields": [
        {
            "holder": "side",
            "member": "sign",
            "size": 1,
            "unit": "1",
            "doc": "of the error that is driven to the identity; 0: not decided",
            "is_scalar": True,
        }
    ],
}
"""What a controller that takes the shorter way round keeps from call to call."""


@dataclass(frozen=True)
class Parts:
    """The derivations of a vehicle, by what becomes of them.

    main: the law that `control` guards; public: the others that may be called
    error, law: main from the configurations to g_e, None without a reference, and the rest
    seen: error as far as law reads it
    drift: square of the distance of g_e from the group; None where there is none
    apart: positive for what has an inverse; None where no inverse divides
    inner: what only check_params calls
    border: from what drivers measure to a configuration, for the example
    """

    main: Derivation
    public: Sequence[Derivation]
    error: Derivation | None
    seen: Derivation | None
    law: Derivation
    drift: Derivation | None
    apart: Derivation | None
    inner: Sequence[Derivation]
    border: Derivation | None = None


def package(name: str, parts: Parts, facts: Mapping[str, Any]) -> Printed:
    """{target: {scalar: data}} for one vehicle; facts go to every template as they are."""
    dialects = {
        ("c99", "f32"): printer.c99("f32", f"{name}_f32"),
        ("c99", "f64"): printer.c99("f64", f"{name}_f64"),
        ("numpy", "f64"): printer.numpy(),
    }
    return {
        target: {
            scalar: _one(parts, facts, dialects[target, scalar])
            for scalar in TARGETS[target].scalars
        }
        for target in TARGETS
    }


def _one(parts: Parts, facts: Mapping[str, Any], dialect: printer.Dialect) -> Printed:
    """The data of one scalar of one target."""

    def declared(d: Derivation | None, is_public: bool = False) -> Printed | None:
        return _declared(routine(d, dialect), is_public, facts["element_shape"]) if d else None

    main = declared(parts.main, True) or {}
    core = declared(parts.law) or {}
    has_side = facts["has_side"]
    main.update(symbol=CORE, public_writes=["command"])
    main["guarded_writes"] = ["side", "command"] if has_side else ["command"]
    more = _margins(main, facts, parts.drift is not None)
    near = next(out for out in main["outputs"] if out["member"] == "clearance")
    has_cut = has_side or not near["entries"][0][0].isdigit()
    public = [declared(d, True) for d in parts.public]
    inner = [declared(d) for d in parts.inner]
    whole = [parts.main, *parts.public, *parts.inner]
    return {
        **facts,
        "main": main,
        "routines": [main, *public, *inner],
        "error": declared(parts.error),
        "seen": declared(parts.seen),
        "core": core,
        "passed": [e for one in core["inputs"] if one["name"] == "g_e" for e in one["entries"]],
        "drift": declared(parts.drift),
        "apart": declared(parts.apart),
        "margins": more,
        "has_cut": has_cut,
        "bounds": _bounds(main, facts, has_drift=parts.drift is not None, has_cut=has_cut),
        "kernels": kernels(whole, dialect.scalar),
        "structs": _structs(main, more) + [SIDE] * has_side,
        "command": [out for out in main["outputs"] if out["holder"] == "command"],
        "statuses": [list(status) for status in STATUSES],
        "first_bad": FIRST_BAD,
        "border": declared(parts.border),
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


def _margins(main: Printed, facts: Mapping[str, Any], has_drift: bool) -> list[Printed]:
    """Fields of params that only the guard reads."""
    force = next(out for out in main["outputs"] if out["member"] == "force")
    drift = "largest distance of the error from the group"
    limit = ("force_limit", force["size"], force["unit"], "largest force of each coordinate", False)
    found = [limit] if facts["saturation"] else []
    found += [("max_drift", 1, "1", drift, True)] if has_drift else []
    names = ("member", "size", "unit", "doc", "is_scalar")
    return [{**dict(zip(names, one, strict=True)), "holder": "params"} for one in found]


def _bounds(
    main: Printed, facts: Mapping[str, Any], *, has_drift: bool, has_cut: bool
) -> list[str]:
    """Names of the constants that the guard of such a vehicle reads."""
    needs = {
        "MAX_INPUT": True,
        "MAX_ENTRY": any(facts["is_bounded"]),
        "MAX_REACH": not all(facts["is_bounded"]),
        "LEAST_DRIFT": has_drift,
        "MOST_DRIFT": has_drift,
        "NEAR_CUT": has_cut and not facts["has_side"],
        "HYSTERESIS": facts["has_side"],
        "REFUSED_CUT": facts["is_pole"] and has_cut,
        "MAX_PARAM": True,
        "MIN_GAIN": True,
        "MAX_RATE": any(one["unit"] == "1/s" for one in main["inputs"]),
    }
    return [name for name, is_needed in needs.items() if is_needed]


def _structs(main: Printed, more: Sequence[Printed]) -> list[Printed]:
    """params, state, reference, command: the fields in the order of the main routine."""
    fields = main["inputs"] + [out for out in main["outputs"] if out["holder"]]
    holders = dict.fromkeys(field["holder"] for field in fields)
    fields = [*fields, *more]
    return [
        {"name": holder, "fields": [field for field in fields if field["holder"] == holder]}
        for holder in holders
    ]
