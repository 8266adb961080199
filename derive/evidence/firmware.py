"""One image: an emitted package in one scalar, its self-test and the program that measures both,
for one machine at one level of optimisation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from derive.emit.render import environment
from derive.evidence.emitted import FLAGS, Emitted
from derive.evidence.machine import MEASURED, Machine
from derive.evidence.tool import run
from derive.native.header import Routine, parse

SECONDS = 60.0
"""After which a compiler is ended."""

ROUTINES = ("control", "tracking", "reaching", "plant")
"""The public routines that are run, in this order, of those that a package has."""

_ARGUMENT = {
    "state": "&one->state",
    "reference": "&one->reference",
    "force": "one->truth.force",
}
"""Inputs that a case of the self-test has."""


@dataclass(frozen=True)
class Image:
    """What is built: one package on one machine at one level."""

    emitted: Emitted
    machine: Machine
    level: str

    @property
    def is_measured(self) -> bool:
        """Whether instructions and stack are counted in it."""
        return self.level == MEASURED and self.emitted.scalar in self.machine.measured

    @property
    def title(self) -> str:
        """Scalar, machine and level, as a report names them."""
        return f"{self.emitted.scalar} {self.machine.name} {self.level}"


def routines(emitted: Emitted) -> tuple[Routine, ...]:
    """The public routines that are measured, as the package's header declares them."""
    declared = parse(emitted.header.read_text(encoding="utf-8")).routines
    names = (f"{emitted.prefix}_{name}" for name in ROUTINES)
    return tuple(declared[name] for name in names if name in declared)


def program(image: Image) -> str:
    """C text of the program that measures."""
    emitted = image.emitted
    public = routines(emitted)
    return environment().get_template("evidence/firmware.c.jinja").render(
        prefix=emitted.prefix,
        macro=emitted.macro,
        is_measured=image.is_measured,
        routines=[_called(routine, emitted.prefix) for routine in public],
        outputs=sorted(set(_outputs(public))),
    )  # fmt: skip


def build(image: Image, folder: Path) -> Path:
    """Compile and link an image in a folder of its own; raises ToolMissing, ToolFailed.

    Beside a measured image stands its call graph with the stack of every function.
    """
    emitted, machine = image.emitted, image.machine
    _write(image, folder)
    elf = folder / "image.elf"
    sources = [emitted.source, emitted.folder / "test" / f"{emitted.prefix}_test.c"]
    graph = ["-fcallgraph-info=su"] if image.is_measured else []
    script = [f"-T{folder / machine.board}.ld"] if machine.emulator else []
    run(
        [machine.compiler.path, *compiled(emitted, machine, image.level), *graph,
         f"-I{emitted.folder / 'test'}", f"-I{folder}", *map(str, sources), "firmware.c",
         f"{machine.board}.c", *script, *machine.libraries, "-o", str(elf)],
        SECONDS, folder,
    )  # fmt: skip
    return elf


def compiled(emitted: Emitted, machine: Machine, level: str) -> Sequence[str]:
    """Flags with which the emitted source is compiled for a machine."""
    return (*machine.flags, *FLAGS, level, f"-I{emitted.include}")


def _write(image: Image, folder: Path) -> None:
    """The rendered program and the files of its board."""
    board = image.machine.board
    names = ["board.h", f"{board}.c", *([f"{board}.ld"] if image.machine.emulator else [])]
    for name in names:
        text = environment().get_template(f"evidence/{name}").render()
        (folder / name).write_text(text, encoding="utf-8")
    (folder / "firmware.c").write_text(program(image), encoding="utf-8")


def _called(routine: Routine, prefix: str) -> dict[str, Any]:
    """How the template calls a routine, and where it finds what that wrote.

    What a caller keeps from call to call is written too, but the answer is a command or an
    acceleration.
    """
    name = routine.symbol.removeprefix(f"{prefix}_")
    return {
        "name": name,
        "symbol": routine.symbol,
        "answers": routine.result != "void",
        "arguments": ", ".join(_argument(one, prefix) for one in routine.parameters),
        "written": "nu_dot" if name == "plant" else "command",
        "is_guarded": int(name == "control"),
    }


def _argument(one: Any, prefix: str) -> str:
    if one.name == "params":
        return f"&{prefix}_defaults"
    own = f"output.{one.name}" if one.size else f"&output.{one.name}"
    return _ARGUMENT.get(one.name, own) if one.is_input else own


def _outputs(public: Sequence[Routine]) -> list[tuple[str, str]]:
    """(type, declarator) of all that the routines write."""
    return [
        (one.type, f"{one.name}[{one.size}]" if one.size else one.name)
        for routine in public
        for one in routine.parameters
        if not one.is_input
    ]
