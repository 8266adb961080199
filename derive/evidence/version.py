"""Which versions of the tools measured: their numbers alone, the same on every like machine."""

from __future__ import annotations

import re
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version

from derive.evidence.tool import Tool, ToolFailed, ToolMissing, run

SECONDS = 20.0


@dataclass(frozen=True)
class Asked:
    """A command that tells its version; does: what it is used for."""

    command: str
    does: str
    option: str = "--version"


COMMANDS = (
    Asked("gcc", "compiler of this machine"),
    Asked("clang", "compiler of this machine, sanitizers, libFuzzer"),
    Asked("arm-none-eabi-gcc", "compiler of Cortex-M"),
    Asked("riscv64-unknown-elf-gcc", "compiler of RISC-V"),
    Asked("qemu-system-arm", "Cortex-M4F and Cortex-M7"),
    Asked("qemu-system-riscv32", "RV32"),
    Asked("qemu-system-riscv64", "RV64"),
    Asked("frama-c", "Eva", "-version"),
    Asked("gappa", "bounds of rounding"),
    Asked("gcov", "coverage"),
    Asked("nm", "symbols of object files"),
    Asked("clang-tidy", "bugprone, cert and analyzer checks"),
    Asked("cppcheck", "MISRA C:2012"),
    Asked("doxygen", "documentation of the headers"),
)

PACKAGES = {
    "python-flint": "bounds of truncation",
    "mpmath": "truth in 130 digits",
    "casadi": "automatic differentiation",
    "numpy": "the emitted numpy module",
}
"""Python's, by what they are used for."""


def versions() -> list[tuple[str, str, str]]:
    """(name, version, use) of every tool; of one that is not there, that."""
    rows = [(one.command, _told(one), one.does) for one in COMMANDS]
    return rows + [(name, _installed(name), does) for name, does in PACKAGES.items()]


def _told(one: Asked) -> str:
    """The first number of what a command says, remarks in brackets left out."""
    try:
        said = run([Tool(one.command, "").path, one.option], SECONDS)
    except ToolMissing:
        return "not here"
    except (ToolFailed, OSError):
        return "does not tell"
    found = re.search(r"\d+(?:\.\d+)+", re.sub(r"\(.*?\)", "", said))
    return found[0] if found else "does not tell"


def _installed(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "not here"
