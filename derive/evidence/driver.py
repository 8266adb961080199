"""C drivers around an emitted source: rendered, compiled together with it, and run in bounds."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from derive.emit.render import environment
from derive.evidence.case import good
from derive.evidence.emitted import FLAGS, Emitted
from derive.evidence.interface import Interface, Member
from derive.evidence.tool import Tool, run
from derive.verify.plant import Plant

SECONDS = 120.0
"""A compiler has to be done by then."""

_POINTERS = {"params": "params", "command": "command"}


def written(template: str, interface: Interface, plant: Plant, folder: Path) -> Path:
    """The driver of that template, templates/evidence/TEMPLATE.c.jinja, in `folder`."""
    text = environment().get_template(f"evidence/{template}.c.jinja")
    path = folder / f"{interface.emitted.prefix}_{template}.c"
    folder.mkdir(parents=True, exist_ok=True)
    path.write_text(text.render(_context(interface, plant)), encoding="utf-8")
    return path


def compiled(
    compiler: Tool, emitted: Emitted, sources: Sequence[Path], flags: Sequence[str], program: Path
) -> Path:
    """The emitted source and `sources` as a program; raises ToolMissing, ToolFailed."""
    program.parent.mkdir(parents=True, exist_ok=True)
    files = [str(path.absolute()) for path in (emitted.source, *sources)]
    include = f"-I{emitted.include.absolute()}"
    output = ["-o", str(program.absolute()), "-lm"]
    command = [compiler.path, *FLAGS, *flags, include, *files, *output]
    run(command, SECONDS, program.parent)
    return program


def _context(interface: Interface, plant: Plant) -> dict[str, Any]:
    """What the templates of drivers lay out."""
    structs = interface.inputs
    pointers = _POINTERS | {name: f"&in->{name}" for name in structs}
    return {
        "prefix": interface.emitted.prefix,
        "macro": interface.emitted.macro,
        "real": interface.real,
        "bits": {"float": "uint32_t", "double": "uint64_t"}[interface.real],
        "inputs": structs,
        "members": interface.members(*structs),
        "judged": len(interface.members(*interface.judged)),
        "params": interface.structs["params"],
        "gains": [one for one in interface.structs["params"] if not one.is_array],
        "limit": _named(interface.structs["params"], "force_limit"),
        "command": interface.structs["command"],
        "control": interface.call("control", pointers),
        "law": interface.call(interface.law, pointers),
        "cases": good(plant, interface),
    }


def _named(members: Sequence[Member], name: str) -> Member | None:
    return next((one for one in members if one.name == name), None)
