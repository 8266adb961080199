"""The table of the package's own test, as its templates read it: text, and the bits of each answer.

What is true stands in the rows that come in; what the emitted code makes of them, to the last
bit, is computed here from its printed steps.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from derive.emit.literal import exact, nearest
from derive.emit.program import Given, Routine, bits, pack, run
from derive.emit.status import FIRST_BAD, STATUSES

WORDS = {"f32": "uint32_t", "f64": "uint64_t"}
"""Integers as wide as a number."""

DIGITS = 130
"""Of the arithmetic that the truth was found with."""

VALUE = {name: value for name, value, _ in STATUSES}

Row = Mapping[str, Any]
"""doc, given (input -> numbers), status, and outputs (name -> numbers, largest error) if good."""


def selftest(
    printed: Mapping[str, Any], program: str, rows: Sequence[Row], values: Mapping[str, Any],
    scalar: str,
) -> dict[str, Any]:  # fmt: skip
    """What the templates of the test of one scalar read.

    printed: of that scalar; program: of its routines; values: of the vehicle, as `render` has them
    """
    routines, params = run(program), _params(printed, values, scalar)
    command = [0.0] * sum(one["size"] for one in printed["command"])
    n = printed["dim"]
    return {
        "cases": [_case(printed, routines, row, params, scalar) for row in rows],
        "bare": [one["name"] for one in _bare(printed)],
        "outputs": [one["member"] for one in printed["command"]],
        "word": WORDS[scalar],
        "width": 8 * len(pack(command, scalar)) // len(command),
        "zero_bits": _hash(command, scalar),
        "digits": DIGITS,
        "diagonal": [i * n - i * (i - 1) // 2 for i in range(n)],
        "first_good": next(i for i, row in enumerate(rows) if row["status"] == "OK"),
    }


def _params(printed: Mapping[str, Any], values: Mapping[str, Any], scalar: str) -> Given:
    """Inertia and gains by the names of the inputs, as the scalar stores them."""
    stored = {"inertia": values["inertia"], **{name: [x] for name, x in values["gains"]}}
    return {
        one["name"]: [_kept(x, scalar) for x in stored[one["member"]]]
        for routine in printed["routines"]
        for one in routine["inputs"]
        if one["holder"] == "params"
    }


def _kept(value: Fraction, scalar: str) -> float:
    return float(nearest(value, scalar))


def _bare(printed: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """The public routines that have no guarded twin."""
    public = (one for one in printed["routines"] if one["is_public"])
    return [one for one in public if one["symbol"] == one["name"]]


def _case(
    printed: Mapping[str, Any], routines: Mapping[str, Routine], row: Row, params: Given,
    scalar: str,
) -> dict[str, Any]:  # fmt: skip
    """One row as text; of a refused one the command is zero and nothing bare is called."""
    size = {one["member"]: one["size"] for one in printed["command"]}
    is_good = VALUE[row["status"]] < FIRST_BAD
    zero = {name: ([0.0] * count, 0.0) for name, count in size.items()}
    outputs = row["outputs"] if is_good else zero
    given = {**params, **row["given"]}
    found = {name: numbers for name, (numbers, _) in zero.items()}
    if is_good:
        found = routines[printed["main"]["symbol"]](given)
    given |= {"force": found["force"]}
    structs = {one["name"]: one["fields"] for one in printed["structs"]}
    return {
        "doc": row["doc"],
        **{
            holder: [[_text(x, scalar) for x in row["given"][field["name"]]] for field in fields]
            for holder, fields in structs.items()
            if holder in ("state", "reference")
        },
        "truth": [[_text(float(x), scalar) for x in outputs[name][0]] for name in size],
        "allowed": [_bound(outputs[name][1], scalar) for name in size],
        "status": row["status"],
        "bits": _hash([x for name in size for x in found[name]], scalar),
        "bare": [
            _hash(_flat(printed, one, routines, given), scalar) if is_good else "0U"
            for one in _bare(printed)
        ],
    }


def _flat(
    printed: Mapping[str, Any], one: Mapping[str, Any], routines: Mapping[str, Routine],
    given: Given,
) -> list[float]:  # fmt: skip
    """All that a routine writes, in the order in which it lies in memory."""
    found = routines[one["symbol"]](given)
    members = [out["member"] for out in printed["command"] if out["member"] in found]
    return [x for name in members or found for x in found[name]]


def _hash(numbers: Sequence[float], scalar: str) -> str:
    return f"0x{bits(numbers, scalar):08X}U"


def _bound(value: float, scalar: str) -> str:
    """Three digits of a largest error are enough."""
    return exact(float(f"{value:.2e}"), scalar)


def _text(value: float, scalar: str) -> str:
    """A number as C writes it; what is none by the names that the test gives it."""
    if math.isnan(value):
        return "NOT_A_NUMBER"
    if math.isinf(value):
        return "INFINITE" if value > 0 else "-INFINITE"
    return exact(value, scalar)
