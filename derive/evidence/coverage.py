"""Lines and branches of the emitted source that its own self-test runs through: all of them."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from derive.emit.render import environment
from derive.evidence import driver
from derive.evidence.emitted import Emitted
from derive.evidence.tool import Tool, ToolFailed, need, run
from derive.verify.check import Check
from derive.verify.limits import LIMITS

GCC = Tool("gcc", "apt install gcc")
GCOV = Tool("gcov", GCC.install)
FLAGS = ("-O0", "--coverage", "-fprofile-abs-path")
SECONDS = 60.0


@dataclass(frozen=True)
class Covered:
    """Lines with code and branches of one source, and those that were not taken, by line.

    lost: numbers of lines never run; untaken: line -> branches of it never taken
    """

    lines: int
    branches: int
    lost: tuple[int, ...]
    untaken: dict[int, int]

    @property
    def missed(self) -> int:
        """Lines and branches that were not taken."""
        return len(self.lost) + sum(self.untaken.values())

    def listed(self, source: Path) -> tuple[str, ...]:
        """What was missed, with the text that stands there."""
        text = source.read_text(encoding="utf-8").splitlines()
        lost = [(n, "never run") for n in self.lost]
        untaken = [(n, f"{count} of its branches never taken") for n, count in self.untaken.items()]
        return tuple(
            f"line {n}: {what}: {text[n - 1].strip()}" for n, what in sorted(lost + untaken)
        )


def coverage(emitted: Emitted, folder: Path) -> tuple[Check, ...]:
    """Lines and branches missed by the package's self-test, which has to pass; none may be.

    The checks for null pointers are switched on: they are there for the self-test alone.
    """
    need(GCC, GCOV)
    test = emitted.folder / "test"
    main = _alone(emitted, folder)
    flags = (f"-I{test.absolute()}", f"-D{emitted.name.upper()}_CHECK_POINTERS")
    found = covered(emitted, (test / f"{emitted.prefix}_test.c", main), folder, flags)
    return (
        Check(
            "self-test: lines and branches missed", emitted.prefix, float(found.missed),
            LIMITS["attack"], found.lines + found.branches,
            *_where(found.listed(emitted.source)),
        ),
    )  # fmt: skip


def _alone(emitted: Emitted, folder: Path) -> Path:
    """A program that runs the self-test of one scalar; the package's own runs all of them."""
    path = folder / f"{emitted.prefix}_alone.c"
    folder.mkdir(parents=True, exist_ok=True)
    text = environment().get_template("evidence/alone.c.jinja").render(prefix=emitted.prefix)
    path.write_text(text, encoding="utf-8")
    return path


def _where(listed: tuple[str, ...]) -> tuple[str, tuple[str, ...]]:
    return (listed[0] if listed else ""), listed


def covered(
    emitted: Emitted, sources: Sequence[Path], folder: Path, flags: Sequence[str] = ()
) -> Covered:
    """What a program of `sources`, which has to end with 0, runs through; ToolMissing, ToolFailed.

    folder: of the program and its counts; counts of an earlier run there are forgotten
    """
    gcov = GCOV.path
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.gc??"):
        old.unlink()
    program = folder / f"{emitted.prefix}_covered"
    driver.compiled(GCC, emitted, sources, (*FLAGS, *flags), program)
    run([str(program.absolute())], SECONDS, folder)
    counts = [path.name for path in folder.glob(f"*{emitted.source.stem}.gcda")]
    if len(counts) != 1:
        raise ToolFailed([str(program)], f"left {len(counts)} counts, not one", "")
    said = run(
        [gcov, "--json-format", "--stdout", "--branch-probabilities", *counts], SECONDS, folder
    )
    return read(said, emitted.source)


def read(said: str, source: Path) -> Covered:
    """gcov's JSON; raises ToolFailed where it does not speak of that source."""
    lines = _lines(said, source)
    if not lines:
        raise ToolFailed([GCOV.command], f"does not speak of {source.name}", said)
    counts: dict[int, int] = {}
    taken: dict[int, list[bool]] = {}
    for line in lines:  # a line of a function that is compiled twice comes twice
        number = line["line_number"]
        counts[number] = counts.get(number, 0) + line["count"]
        taken.setdefault(number, []).extend(one["count"] > 0 for one in line["branches"])
    untaken = {n: row.count(False) for n, row in taken.items() if not all(row)}
    return Covered(
        len(counts), sum(map(len, taken.values())),
        tuple(sorted(n for n, count in counts.items() if not count)), untaken,
    )  # fmt: skip


def _lines(said: str, source: Path) -> list[dict[str, Any]]:
    """The records of a source: gcov may write one document per line, and warnings between."""
    documents = (json.loads(row) for row in said.splitlines() if re.match(r"\s*\{", row))
    files = (file for document in documents for file in document["files"])
    return [line for file in files if Path(file["file"]).name == source.name
            for line in file["lines"]]  # fmt: skip
