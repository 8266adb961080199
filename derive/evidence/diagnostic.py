"""What three compilers and clang-tidy say of an emitted package: nothing, under the lists here."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from derive.emit.deviation import LONGEST
from derive.evidence.emitted import FLAGS, Emitted
from derive.evidence.tool import Tool, absent, need, run
from derive.native.compile import WARNINGS_C
from derive.verify.check import Check
from derive.verify.limits import LIMITS

COMPILERS = {
    "gcc": Tool("gcc", "apt install gcc"),
    "clang": Tool("clang", "apt install clang"),
    "arm-none-eabi-gcc": Tool(
        "arm-none-eabi-gcc", "apt install gcc-arm-none-eabi libnewlib-arm-none-eabi"
    ),
}
"""Who must be silent."""

M4F = ("-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard")
MACHINE = {"gcc": (), "clang": (), "arm-none-eabi-gcc": M4F}
"""What each compiles for; the first two for this machine."""

WARNINGS = {
    "gcc": (*WARNINGS_C["gcc"], "-Wvla", "-Walloca"),
    "clang": WARNINGS_C["clang"],  # -Weverything has both
    "arm-none-eabi-gcc": (*WARNINGS_C["gcc"], "-Wvla", "-Walloca"),
}

TIDY = Tool("clang-tidy", "apt install clang-tidy")
ASKED = ("bugprone-*", "cert-*", "clang-analyzer-*")
LEFT_OUT = {
    "bugprone-easily-swappable-parameters": "an int beside a scalar is told apart by -Wconversion, "
    "and no function takes two of a kind; `control` takes structs, each of its own type",
}
"""Checks of clang-tidy that are not asked for, with the reason."""

SECONDS = 120

_SAID = re.compile(r"^\S+?:\d+:(?:\d+:)? (?:fatal )?(?:warning|error): .*$", re.MULTILINE)
_LONG = re.compile(r"warning: function '(\w+)' exceeds.*?\n(?:.*\n){2}.*note: (\d+) lines")


def compiled(one: Emitted) -> Iterator[Check]:
    """Warnings of each compiler that is here, then ToolMissing for the others; ToolFailed."""
    lost = tuple(absent(tuple(COMPILERS.values())))
    for name, tool in COMPILERS.items():
        if tool in lost:
            continue
        said = [line for file in units(one) for line in _warned(one, name, tool, file)]
        yield _none(f"{name}: warnings", one, said, len(units(one)))
    need(*lost)


def units(one: Emitted) -> tuple[Path, ...]:
    """The source, and what of the example and the self-test includes a header of its scalar."""
    around = sorted([*one.folder.glob("example/*.c"), *one.folder.glob("test/*.c")])
    return (one.source, *(p for p in around if f'"{one.prefix}' in p.read_text(encoding="utf-8")))


def _places(one: Emitted) -> tuple[str, ...]:
    return (f"-I{one.include}", f"-I{one.folder / 'test'}")


def _warned(one: Emitted, name: str, tool: Tool, file: Path) -> list[str]:
    flags = (*FLAGS, "-O2", *MACHINE[name], *WARNINGS[name], *_places(one))
    command = [tool.path, *flags, "-c", str(file), "-o", "/dev/null"]
    return _SAID.findall(run(command, SECONDS, codes=(0, 1)))


def tidied(one: Emitted) -> Iterator[Check]:
    """Findings of clang-tidy, and functions that are long without a row, or short with one."""
    checks = ",".join(["-*", *ASKED, *(f"-{name}" for name in LEFT_OUT)])
    said = [line for file in units(one) for line in _SAID.findall(_tidy(one, file, checks))]
    yield _none("clang-tidy: bugprone, cert, analyzer", one, said, len(units(one)))
    found, told = set(_long(one)), set(_listed(one))
    unlike = [f"{name}: {lines} lines" for name, lines in sorted(found ^ told)]
    yield _none(f"functions over {LONGEST} lines: no row", one, unlike, len(found | told))


def _tidy(one: Emitted, file: Path, checks: str, *options: str) -> str:
    words = ("--quiet", "--header-filter=.*", f"--checks={checks}", *options)
    flags = ("--", *FLAGS, *_places(one))
    return run([TIDY.path, *words, str(file), *flags], SECONDS, codes=(0, 1))


def _long(one: Emitted) -> list[tuple[str, int]]:
    """(function, lines) as clang-tidy counts them: from brace to brace."""
    name = "readability-function-size"
    sizes = {"LineThreshold": LONGEST, "StatementThreshold": 10**6}
    options = ", ".join(f"{{key: {name}.{key}, value: {n}}}" for key, n in sizes.items())
    said = _tidy(one, one.source, f"-*,{name}", f"--config={{CheckOptions: [{options}]}}")
    return [(function, int(lines)) for function, lines in _LONG.findall(said)]


def _listed(one: Emitted) -> list[tuple[str, int]]:
    text = (one.folder / "DEVIATIONS.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `(\w+)` \| (\d+) \|$", text, re.MULTILINE)
    return [(name, int(lines)) for name, lines in rows if name.startswith(one.prefix)]


def _none(name: str, one: Emitted, said: Sequence[str], samples: int) -> Check:
    """A check that nothing was said; paths are cut down to the file."""
    lines = [re.sub(r"^\S*/", "", line) for line in said]
    first = lines[0] if lines else ""
    limit = LIMITS["findings"]
    return Check(name, one.scalar, len(lines), limit, samples, first, tuple(lines[1:10]))
