"""Every single bit of every input turned over: nothing breaks, and how much of it is noticed.

A flip is harmful when it changes the force of the bare law, of a parameter also that of `control`,
by more than a thousandth of its length. It is found when `control` answers with a status from 16
on, or, for a parameter, when `check_params` refuses it; harmful there: in any of the states.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from derive.evidence import driver
from derive.evidence.emitted import Emitted
from derive.evidence.interface import interface
from derive.evidence.tool import Tool, ToolFailed, run
from derive.verify.check import Check
from derive.verify.limits import LIMITS, published
from derive.verify.plant import Plant

GCC = Tool("gcc", "apt install gcc")
FLAGS = ("-O2",)
SECONDS = 60.0


@dataclass(frozen=True)
class Tally:
    """Flips of one member of the inputs or parameters: all, harmful, harmful and found.

    spared: refused though harmless
    """

    member: str
    tried: int
    harmful: int
    found: int
    spared: int

    @property
    def rate(self) -> float:
        """Share of the harmful ones that are found; 1 where none does harm."""
        return self.found / self.harmful if self.harmful else 1.0

    def __str__(self) -> str:
        share = f" ({100 * self.rate:.1f} %)" if self.harmful else ""
        return (
            f"{self.member}: {self.found} of {self.harmful} harmful flips found{share}, "
            f"{self.tried} tried"
        )


@dataclass(frozen=True)
class Flips:
    """What became of all flips; broken: answers that break a promise; refused: cases not good."""

    tallies: tuple[Tally, ...]
    broken: int
    refused: int
    first: tuple[str, ...]

    def over(self, name: str, *prefixes: str) -> Tally:
        """Those of all members that begin so, together."""
        chosen = [one for one in self.tallies if one.member.startswith(prefixes)]
        sums = (sum(getattr(one, what) for one in chosen) for what in _SUMMED)
        return Tally(name, *sums)


_SUMMED = ("tried", "harmful", "found", "spared")


def flips(emitted: Emitted, plant: Plant, folder: Path) -> Flips:
    """Turn every bit over; raises ToolMissing, ToolFailed."""
    source = driver.written("flip", interface(emitted), plant, folder)
    program = folder / f"{emitted.prefix}_flip"
    driver.compiled(GCC, emitted, [source], FLAGS, program)
    said = run([str(program.absolute())], SECONDS)
    broken = re.search(r"^WRONGS (\d+)$", said, re.MULTILINE)
    if not broken:
        raise ToolFailed([str(program)], "did not count to its end", said)
    rows = re.findall(r"^MEMBER (\S+) (\d+) (\d+) (\d+) (\d+)$", said, re.MULTILINE)
    return Flips(
        tuple(Tally(member, *map(int, numbers)) for member, *numbers in rows),
        int(broken[1]),
        len(re.findall(r"^CASE ", said, re.MULTILINE)),
        tuple(re.findall(r"^(?:WRONG:|CASE| ) .*$", said, re.MULTILINE)),
    )


def flip(emitted: Emitted, plant: Plant, folder: Path) -> tuple[Check, Check]:
    """Promises broken by a flip, none allowed; and of harmful flips the share that is not found.

    The rates by member are in the details.
    """
    known, found = interface(emitted), flips(emitted, plant, folder)
    inputs = found.over("state and reference", *(f"{name}." for name in known.inputs))
    params = found.over("params", "params.")
    return (
        Check(
            "bit flips: promises broken", emitted.prefix, float(found.broken + found.refused),
            LIMITS["attack"], inputs.tried + params.tried,
            found.first[0] if found.first else "",
            (*map(str, (inputs, *found.tallies)), *found.first),
        ),
        Check(
            "bit flips: harmful, not found", emitted.prefix, 100 * (1 - inputs.rate),
            published("%"), inputs.harmful, inputs.member,
        ),
    )  # fmt: skip
