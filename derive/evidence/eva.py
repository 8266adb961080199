"""Proof by abstract interpretation: what `control` can do, for all inputs at once.

Frama-C's Eva carries intervals through the emitted C from a driver of its own. Two runs:

any bits  every number of state and reference is any float, NaN and infinities too, params are
          within their ranges: no undefined behaviour, every statement reached, the whole command
          finite, a documented status, and zero from the first bad status on
in range  the inputs are finite and at most MAX_INPUT, and NaN or infinity anywhere is an alarm: no
          step overflows or divides by zero. On unit quaternions, where near -i no interval is
          good for more than one scale, the law is shown in boxes, which together are all.
"""

from __future__ import annotations

import csv
import re
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from derive.evidence.analysed import analysed, places, statements
from derive.evidence.emitted import Emitted
from derive.evidence.entry import ANY_BITS, IN_RANGE, SLICED, Start, driver_of
from derive.evidence.interface import interface
from derive.evidence.quaternion import is_sliced
from derive.evidence.tool import Tool, need, run
from derive.verify.check import Check
from derive.verify.limits import LIMITS

FRAMA_C = Tool("frama-c", "apt install frama-c-base")
PREPROCESSOR = Tool("gcc", "apt install gcc")
"""Which frama-c calls."""
SECONDS = 300.0
"""One run has to be done by then; it takes 1 to 5."""

OPTIONS = (
    *("-eva", "-eva-domains", "equality", "-eva-auto-loop-unroll", "64"),
    *("-eva-slevel", "0", "-eva-slevel-function", "eva_finite:9,eva_nan:9"),
    *("-eva-partition-history", "2", "-eva-interprocedural-history"),
    *("-eva-subdivide-non-linear", "4"),
    *("-eva-split-return", "full", "-eva-warn-key", "builtins:override=inactive"),
)
"""A state is kept apart by the last two branches it took: that is what follows |x| <= limit; and
x * x is taken apart into pieces, so that it is not negative."""

TRUSTED = ("Frama_C_", "eva_has_")
"""Functions without a body, whose specification is taken for granted."""

PROVED = ("Valid", "Considered valid", "Dead", "Unreachable")
ALARM, ASSERTION = "alarm", "user assertion"
_REACHED = re.compile(r"source\.c:(\d+): *\n? *Frama_C_show_each_reached")


@dataclass(frozen=True)
class Finding:
    """A property that is not proved: line 0 for one outside of the emitted source."""

    function: str
    line: int
    kind: str
    text: str

    def __str__(self) -> str:
        return f"{self.function}, line {self.line}: {self.kind}: {self.text}"


@dataclass(frozen=True)
class Found:
    """What one run came to. unreached: lines of the source, by number"""

    findings: tuple[Finding, ...]
    assertions: int
    properties: int
    unreached: tuple[int, ...]

    def of(self, is_assertion: bool) -> tuple[Finding, ...]:
        """Assertions that are not proved, or else alarms."""
        return tuple(one for one in self.findings if (one.kind == ASSERTION) == is_assertion)


def proofs(emitted: Emitted) -> Iterator[Check]:
    """The records of both runs; raises ToolMissing, ToolFailed, OSError, ValueError."""
    need(FRAMA_C, PREPROCESSOR)
    source = emitted.source.read_text(encoding="utf-8")
    free = ran(emitted, source, ANY_BITS)
    at, lines = places(source), len(tuple(statements(source)))
    unreached = tuple(f"{at[line]}, line {line}" for line in free.unreached)
    alarms, failed = (tuple(map(str, free.of(kind))) for kind in (False, True))
    subject = f"C {emitted.scalar}"
    yield _check("any bits: alarms", subject, "alarms", alarms, free.properties)
    yield _check("any bits: not proved", subject, "not proved", failed, free.assertions)
    yield _check("any bits: not reached", subject, "not reached", unreached, lines)
    strict, properties = overflows(emitted, source)
    yield _check("in range: alarms", subject, "overflows", tuple(map(str, strict)), properties)


def overflows(emitted: Emitted, source: str) -> tuple[tuple[Finding, ...], int]:
    """Alarms of the strict run, and of how many properties it had to decide."""
    whole = ran(emitted, source, IN_RANGE)
    law = f"{emitted.prefix}_law"
    others = tuple(one for one in whole.findings if one.function != law)
    if others == whole.findings or not is_sliced(interface(emitted)):
        return whole.findings, whole.properties
    apart = ran(emitted, source, SLICED)
    return (*others, *apart.findings), whole.properties + apart.properties


def is_clean(emitted: Emitted, source: str) -> bool:
    """Whether nothing is found in a source: what a defect has to end."""
    free = ran(emitted, source, ANY_BITS)
    return not free.findings and not free.unreached and not overflows(emitted, source)[0]


def ran(emitted: Emitted, source: str, start: Start) -> Found:
    """One run on a source in the place of the emitted one."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        text = analysed(source, is_marked=start is ANY_BITS)
        (folder / "source.c").write_text(text, encoding="utf-8")
        driver = driver_of(emitted, start)
        (folder / "driver.c").write_text(driver, encoding="utf-8")
        include = f"-cpp-extra-args=-I{emitted.include.absolute()}"
        floats = ("-warn-special-float", start.floats)
        command = [FRAMA_C.path, include, str(folder / "driver.c"), "-main", start.function]
        command += [
            *floats,
            *OPTIONS,
            "-then",
            "-report-csv",
            str(folder / "found.csv"),
        ]
        said = run(command, SECONDS, folder)  # whole paths: it does not go by the folder it is in
        reached = {int(line) for line in _REACHED.findall(said)}
        rows = _rows(folder / "found.csv")
    unreached = tuple(line for line in statements(source) if line not in reached)
    return _found(rows, unreached)


def _rows(path: Path) -> list[dict[str, str]]:
    """Every property with its status, as the Report plug-in writes them."""
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE))
    if not rows or "status" not in rows[0]:
        raise ValueError(f"{path.name}: expected one row a property, found {rows[:1]}")
    return rows


def _found(rows: list[dict[str, str]], unreached: tuple[int, ...]) -> Found:
    ours = [row for row in rows if row["file"].endswith(("source.c", "driver.c"))]
    own = [row for row in ours if not row["function"].startswith(TRUSTED)]
    findings = tuple(
        Finding(
            row["function"],
            int(row["line"]) if row["file"].endswith("source.c") else 0,
            row["property kind"],
            row["property"],
        )
        for row in own
        if row["status"] not in PROVED
    )
    assertions = sum(row["property kind"] == ASSERTION for row in own)
    return Found(findings, assertions, len(own), unreached)


def _check(
    name: str, subject: str, limit: str, found: tuple[str, ...], samples: int
) -> Check:  # fmt: skip
    first = found[0] if found else ""
    return Check(name, subject, float(len(found)), LIMITS[f"eva, {limit}"], samples, first, found)
