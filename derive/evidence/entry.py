"""The driver that Eva starts from: which inputs there are, and what is to hold.

All of it is read from what is emitted: the structs from the header, the ranges of the parameters
from check_params, and the entries that the law takes from its own head.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

from derive.emit.render import environment
from derive.emit.status import FIRST_BAD, STATUSES
from derive.evidence.emitted import Emitted
from derive.evidence.interface import Interface, Member, interface
from derive.evidence.quaternion import boxes


@dataclass(frozen=True)
class Start:
    """Where a run begins. floats: what Eva takes for an alarm among them"""

    function: str
    floats: str


ANY_BITS = Start("any_bits", "none")
IN_RANGE = Start("in_range", "non-finite")
SLICED = Start("sliced", "non-finite")


def driver_of(emitted: Emitted, start: Start) -> str:
    """C text of the driver, which includes source.c; raises OSError, ValueError."""
    source = emitted.source.read_text(encoding="utf-8")
    template = environment().get_template("evidence/eva.c.jinja")
    return template.render(_context(emitted, source, start))


def _context(emitted: Emitted, source: str, start: Start) -> dict[str, Any]:
    """What the template lays out."""
    face = interface(emitted)
    pointers = {"params": "&params", "command": "&command"}
    pointers |= {name: f"&{name}" for name in face.inputs}
    params = face.structs["params"]
    return {
        "prefix": emitted.prefix,
        "macro": emitted.macro,
        "real": face.real,
        "source": "source.c",
        "is_strict": start.floats != "none",
        "inputs": face.inputs,
        "structs": face.structs,
        "members": face.members(*face.inputs),
        "parameters": [_ranged(one, emitted, source) for one in params],
        "limit": next((one for one in params if one.name == "force_limit"), None),
        "command": face.structs["command"],
        "control": face.call("control", pointers),
        "others": _others(face, pointers),
        "law": _law(emitted, source) if start is SLICED else "",
        "boxes": boxes(emitted.scalar) if start is SLICED else (),
        "statuses": [value for _, value, _ in STATUSES],
        "first_bad": FIRST_BAD,
        "bad_params": next(value for name, value, _ in STATUSES if name == "BAD_PARAMS"),
    }


def _ranged(one: Member, emitted: Emitted, source: str) -> tuple[Member, str, str]:
    """A member of params with the least and the largest value that check_params lets pass."""
    if re.search(rf"inspect\(params->{one.name}, {one.count}, {emitted.macro}_MAX_PARAM\)", source):
        return one, f"-{emitted.macro}_MAX_PARAM", f"{emitted.macro}_MAX_PARAM"
    field = rf"params->{one.name}(?:\[i\])?"
    found = re.search(rf"{field} >=?\s+(\S+) &&\s+{field} <=\s+(\w+)", source)
    if not found:
        raise ValueError(f"{emitted.source.name}: check_params looks at no range of {one.name}")
    return one, found[1], found[2]


def _others(face: Interface, pointers: dict[str, str]) -> tuple[str, ...]:
    """Calls of the public routines besides control and check_params; arrays are of the command."""
    prefix = f"{face.emitted.prefix}_"
    arrays = {True: "command.force", False: "command.s"}
    return tuple(
        f"{one.symbol}("
        + ", ".join(
            pointers.get(p.type.removeprefix(prefix)) or arrays[p.is_input] for p in one.parameters
        )
        + ")"
        for name, one in face.routines.items()
        if name not in ("control", "check_params")
    )


def _law(emitted: Emitted, source: str) -> str:
    """A call of the law past the error, whose entries come by value."""
    found = re.search(rf"\b{emitted.prefix}_law\(([^)]*)\)\s*\{{", source)
    if not found:
        raise ValueError(f"{emitted.source.name}: there is no {emitted.prefix}_law")
    names = [one.split("*")[-1].split()[-1] for one in found[1].split(",")]
    given = [name if name.startswith("g_e") else f"&{name}" for name in names]
    return f"{emitted.prefix}_law({', '.join(given)})"
