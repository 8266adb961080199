"""The table of the package's own test, as its templates read it: text, and the bits of each answer.

What is true stands in the rows that come in; what the emitted code makes of them, to the last
bit, is computed here from its printed steps.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import cycle
from typing import Any

from derive.emit.layout import fold
from derive.emit.literal import exact, nearest
from derive.emit.program import ERROR, PAST, Given, Limit, Routine, bits, limited, pack, run
from derive.emit.side import axis, steps
from derive.emit.status import FIRST_BAD, STATUSES

WORDS = {"f32": "uint32_t", "f64": "uint64_t"}
"""Integers as wide as a number."""

DIGITS = 130
"""Of the arithmetic that the truth was found with."""

LARGEST = {"f32": (2.0 - 2.0**-23) * 2.0**127, "f64": sys.float_info.max}
"""Of all numbers."""

TRACE = {"f32": 2.0**-28, "f64": 2.0**-56}
"""Entries of about that size are no element of a group, and next to nothing beside 1."""

VALUE = {name: value for name, value, _ in STATUSES}

Row = Mapping[str, Any]
"""doc, given (input -> numbers) and the same `written`, status, and where that is good the outputs
(name -> numbers, largest error)."""


@dataclass(frozen=True)
class Code:
    """The emitted code of one scalar, to be called: routines by name, and the vehicle's numbers."""

    printed: Mapping[str, Any]
    routines: Mapping[str, Routine]
    params: Given
    limit: Limit
    scalar: str

    @property
    def size(self) -> dict[str, int]:
        """How many numbers each output of a command has, in order."""
        return {one["member"]: one["size"] for one in self.printed["command"]}

    @property
    def bare(self) -> list[Mapping[str, Any]]:
        """The public routines, which guard nothing."""
        return [one for one in self.printed["routines"] if one["is_public"]]

    def control(self, given: Given) -> dict[str, list[float]]:
        """The command for inputs that are good."""
        whole = {**self.params, **given}
        if self.printed["has_side"]:
            found = self.routines[PAST]({**whole, "g_e": self._nearer(whole)})
        else:
            found = self.routines[self.printed["main"]["symbol"]](whole)
        return found | {"force": limited(found["force"], self.limit, self.scalar)}

    def _nearer(self, whole: Given) -> list[float]:
        """The error, or its opposite: what is nearer, as no side is chosen yet."""
        g_e = self.routines[ERROR](whole)["g_e"]
        return [-x for x in g_e] if g_e[0] < 0 else g_e

    def answers(self, given: Given, force: Sequence[float]) -> list[str]:
        """Bits of what each bare routine writes, in the order in which it lies in memory."""
        whole, found = {**self.params, **given, "force": force}, []
        for one in self.bare:
            written = self.routines[one["symbol"]](whole)
            members = [name for name in self.size if name in written] or written
            found.append(self.bits([x for name in members for x in written[name]]))
        return found

    def bits(self, numbers: Sequence[float]) -> str:
        """As C writes them."""
        return f"0x{bits(numbers, self.scalar):08X}U"

    def text(self, value: float) -> str:
        """A number as C writes it."""
        return exact(value, self.scalar)


def selftest(
    printed: Mapping[str, Any], program: str, rows: Sequence[Row], identity: Sequence[float],
    values: Mapping[str, Any], scalar: str,
) -> dict[str, Any]:  # fmt: skip
    """What the templates of the test of one scalar read.

    printed: of that scalar; program: of its routines; identity: of the group, as it is stored;
    values: of the vehicle, as `render` has them
    """
    code = Code(
        printed, run(program), _params(printed, values, scalar), limit_of(values, scalar), scalar
    )
    nothing, n = [0.0] * sum(code.size.values()), printed["dim"]
    return {
        "cases": [_case(code, row) for row in rows],
        "bare": [one["name"] for one in code.bare],
        "with_null": _with_null(printed, f"{values['name']}_{scalar}"),
        "outputs": list(code.size),
        "word": WORDS[scalar],
        "width": 8 * len(pack(nothing, scalar)) // len(nothing),
        "zero_bits": code.bits(nothing),
        "digits": DIGITS,
        "diagonal": [i * n - i * (i - 1) // 2 for i in range(n)],
        "identity": [code.text(x) for x in identity],
        **_hollow(code),
        **_strays(printed["strays"], scalar),
        "largest": exact(LARGEST[scalar], scalar),
        **_sided(values, scalar),
        "first_good": next(i for i, row in enumerate(rows) if VALUE[row["status"]] < FIRST_BAD),
    }


def _with_null(printed: Mapping[str, Any], name: str) -> list[list[str]]:
    """Arguments of control, each time with another pointer that is null."""
    holders = [one for one in printed["main"]["holders"] if one != "params"]
    written = (f"&{one}" for one in printed["main"]["guarded_writes"])
    good = [f"&{name}_defaults", *(f"&one->{one}" for one in holders), *written]
    return [[*good[:i], "NULL", *good[i + 1 :]] for i in range(len(good))]


def _sided(values: Mapping[str, Any], scalar: str) -> dict[str, Any]:
    """The steps to and fro across half a turn, where the shorter way round is taken."""
    margin = values["hysteresis"]
    return {} if margin is None else {"steps": steps(margin, scalar), "axis": axis(scalar)}


def _hollow(code: Code) -> dict[str, Any]:
    """Inputs that are next to no element, and the bits of each bare routine.

    No bits where it comes to a division by zero: what control refuses has no promise.
    """
    inputs = [one for one in code.printed["main"]["inputs"] if one["holder"] != "params"]
    sizes = {one["name"]: TRACE[code.scalar] if one["member"] == "g" else 0.25 for one in inputs}
    digits = cycle(range(-3, 4))
    given = {one["name"]: [next(digits) * sizes[one["name"]] for _ in range(one["size"])]
             for one in inputs}  # fmt: skip
    try:
        found = code.answers(given, [0.0] * code.printed["dim"])
    except (ZeroDivisionError, ValueError, OverflowError):
        found = []
    return {"hollow": found, "hollow_inputs": written(code.printed, given, code.scalar)}


def _strays(found: Sequence[Mapping[str, Any]], scalar: str) -> dict[str, Any]:
    """The ways off the group, all of as many numbers: what is added to no number is zero."""
    most = max((len(one["shares"]) for one in found), default=0)

    def filled(one: Mapping[str, Any]) -> list[tuple[int, float]]:
        return [*one["shares"], *[(0, 0.0)] * (most - len(one["shares"]))]

    return {
        "most_moved": most,
        "strays": [
            {
                "is_reference": int(one["holder"] == "reference"),
                "places": [place for place, _ in filled(one)],
                "shares": [_text(share, scalar) for _, share in filled(one)],
            }
            for one in found
        ],
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


def limit_of(values: Mapping[str, Any], scalar: str) -> Limit:
    """The force limits of a vehicle, none of one without."""
    force = tuple(_kept(x, scalar) for x in values["force_limit"])
    return Limit(force, values["saturation"] == "direction")


def _kept(value: Fraction, scalar: str) -> float:
    return float(nearest(value, scalar))


def written(printed: Mapping[str, Any], given: Mapping[str, Sequence[float]], scalar: str) -> str:
    """State and reference of a row as C initialises them, which no inertia changes."""
    return "\n".join(
        braces([[_text(x, scalar) for x in given[field["name"]]] for field in one["fields"]])
        for one in printed["structs"]
        if one["name"] in ("state", "reference")
    )


def braces(members: Sequence[Sequence[str]]) -> str:
    """A struct inside another, each of its members on lines of its own."""
    each = [f"{{{', '.join(member)}}}" for member in members]
    lines = ("{" + each[0], *each[1:])
    ends = [","] * (len(lines) - 1) + ["},"]
    return "\n".join(
        fold(f"{' ' * (8 if place == 0 else 9)}{line}{end}", 10)
        for place, (line, end) in enumerate(zip(lines, ends, strict=True))
    )


def _case(code: Code, row: Row) -> dict[str, Any]:
    """One row as text; of a refused one the command is zero and nothing bare is called."""
    zero = {name: [0.0] * count for name, count in code.size.items()}
    is_good = VALUE[row["status"]] < FIRST_BAD
    outputs = row["outputs"] if is_good else {name: (x, 0.0) for name, x in zero.items()}
    command = code.control(row["given"]) if is_good else zero
    answers = code.answers(row["given"], command["force"]) if is_good else ["0U"] * len(code.bare)
    return {
        "doc": row["doc"],
        "inputs": row["written"],
        "truth": braces([[code.text(float(x)) for x in outputs[name][0]] for name in zero]),
        "allowed": [_bound(outputs[name][1], code.scalar) for name in zero],
        "status": row["status"],
        "bits": code.bits([x for name in zero for x in command[name]]),
        "bare": answers,
    }


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
