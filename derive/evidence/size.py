"""Section sizes at -Os: tracking alone with what it calls, and with control; nothing mutable."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from derive.evidence.emitted import Emitted
from derive.evidence.firmware import SECONDS, compiled, routines
from derive.evidence.machine import Machine
from derive.evidence.promise import promise
from derive.evidence.tool import run
from derive.verify.check import Check
from derive.verify.limits import LIMITS

LEVEL = "-Os"

_APART = ("-ffunction-sections", "-fdata-sections", "-Wl,--gc-sections")
"""So that the linker leaves out what nobody calls."""

_SECTIONS = (".text", ".rodata", ".data", ".bss")


def checks(emitted: Emitted, machine: Machine, folder: Path) -> Iterator[Check]:
    """Sizes of a package's code in one scalar; raises ToolMissing, ToolFailed."""
    subject = f"{emitted.scalar} {machine.name} {LEVEL}"
    names = {routine.symbol.removeprefix(f"{emitted.prefix}_") for routine in routines(emitted)}
    main = "tracking" if "tracking" in names else "reaching"
    for what, kept in (("text", (main,)), ("text, guarded", (main, "control"))):
        sizes = linked(emitted, machine, folder, kept)
        rest = ", ".join(f"{name} {size} B" for name, size in sizes.items() if name != ".text")
        limit = promise(what, "B", emitted, machine)
        yield Check(f".text, {' and '.join(kept)}", subject, sizes[".text"], limit, 1, rest)
    sizes = linked(emitted, machine, folder, tuple(sorted(names)))
    mutable = sizes[".data"] + sizes[".bss"]
    yield Check("mutable, all routines", subject, mutable, LIMITS["mutable"], 1)


def linked(emitted: Emitted, machine: Machine, folder: Path,
           kept: tuple[str, ...]) -> Mapping[str, int]:  # fmt: skip
    """Bytes by section of some routines with all they call, of the library too."""
    elf = folder / f"{'_'.join(kept)}.elf"
    roots = [f"-Wl,-u,{emitted.prefix}_{name}" for name in kept]
    run(
        [machine.compiler.path, *compiled(emitted, machine, LEVEL), *_APART, *roots,
         f"-Wl,-e,{emitted.prefix}_{kept[0]}", str(emitted.source), "-lm", "-o", str(elf)],
        SECONDS, folder,
    )  # fmt: skip
    return _read(run([machine.sizer.path, "-A", str(elf)], SECONDS, folder))


def _read(said: str) -> dict[str, int]:
    """The table of `size -A`; a section that is not there has no bytes."""
    rows = (line.split() for line in said.splitlines())
    found = {row[0]: int(row[1]) for row in rows if len(row) == 3 and row[1].isdigit()}
    return {name: found.get(name, 0) for name in _SECTIONS}
