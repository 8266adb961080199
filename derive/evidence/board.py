"""Runs an image, bounded, and reads its lines; templates/evidence/firmware.c.jinja says them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from derive.evidence.firmware import Image
from derive.evidence.tool import ToolFailed, run

SECONDS = 10.0
"""After which an emulator is ended; an image takes a tenth of a second, or a few when measured."""


@dataclass(frozen=True)
class Row:
    """What a routine gave in one case: status, FNV-1a of what it wrote, flags it raised."""

    status: int
    bits: int
    flags: int = 0


@dataclass
class Reading:
    """All that an image said; keys are routine and case.

    cost: instructions, counted twice; stack: bytes of a painted stack
    known: instructions of a known routine, expected and found
    """

    image: Image
    failures: int = -1
    golden: dict[int, Row] = field(default_factory=dict)
    rows: dict[tuple[str, int], Row] = field(default_factory=dict)
    known: tuple[int, int] = (0, 0)
    cost: dict[tuple[str, int], tuple[int, int]] = field(default_factory=dict)
    stack: dict[tuple[str, int], int] = field(default_factory=dict)


def read(image: Image, elf: Path, seconds: float) -> Reading:
    """Run an image to its end; raises ToolMissing, ToolFailed."""
    machine = image.machine
    emulator = [machine.emulator.path, *machine.options] if machine.emulator else []
    command = [*emulator, str(elf)]
    said = run(command, seconds, elf.parent)
    try:
        return parsed(image, said)
    except ValueError as error:
        raise ToolFailed(command, f"said what cannot be read: {error}", said) from None


def parsed(image: Image, said: str) -> Reading:
    """The lines of an image; raises ValueError on one that is not known, or when some are lost."""
    reading = Reading(image)
    *lines, last = said.splitlines() or [""]
    for line in lines:
        word, *words = line.split() or [""]
        if word not in _LINES:
            raise ValueError(repr(line))
        _LINES[word](reading, words)
    if not last.startswith("end "):
        raise ValueError(f"it does not end in `end`: {last!r}")
    if (written := int(last.split()[1])) != len(lines):
        raise ValueError(f"{written} lines were written, {len(lines)} arrived")
    return reading


def _test(reading: Reading, words: list[str]) -> None:
    reading.failures = int(words[0])


def _golden(reading: Reading, words: list[str]) -> None:
    case, *row = map(int, words)
    reading.golden[case] = Row(*row)


def _row(reading: Reading, words: list[str]) -> None:
    case, *row = map(int, words[1:])
    reading.rows[words[0], case] = Row(*row)


def _known(reading: Reading, words: list[str]) -> None:
    expected, found = map(int, words)
    reading.known = (expected, found)


def _cost(reading: Reading, words: list[str]) -> None:
    case, once, again = map(int, words[1:])
    reading.cost[words[0], case] = (once, again)


def _stack(reading: Reading, words: list[str]) -> None:
    case, size = map(int, words[1:])
    reading.stack[words[0], case] = size


_LINES: dict[str, Callable[[Reading, list[str]], None]] = {
    "test": _test, "golden": _golden, "row": _row, "known": _known, "cost": _cost,
    "stack": _stack,
}  # fmt: skip
