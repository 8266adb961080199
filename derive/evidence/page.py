"""EVIDENCE.md: what was measured on which files, with what, and what was not; for a reviewer.

It holds neither dates nor times nor places of files: the same tools on the same package give the
same bytes.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from typing import Any

from derive import __version__
from derive.emit.render import environment
from derive.evidence.gather import Evidence
from derive.evidence.stamp import hashes
from derive.evidence.summary import lines
from derive.evidence.version import versions
from derive.verify.check import Check, figure
from derive.verify.limits import Limit

WHOLE = "Everything was run."
"""In the first lines of a page that lacks nothing."""

LESS = "**Not everything was run**: what is left out stands at the end."
"""In those of another."""

LISTED = 12
"""Details of a check that are shown at most."""

SHORT = 300
"""Characters up to which the details of a check are one paragraph."""

SCALARS = {"f32": "float (f32)", "f64": "double (f64)"}

_PLACE = re.compile(r"(?<![\w/.)\]])/(?:[\w.+-]+/)+")
_HEAD = ("check", "on", "measured", "at most", "of", "result", "worst at")


def page(evidence: Evidence) -> str:
    """The page."""
    work = evidence.work
    facts = tomllib.loads(work.texts["MANIFEST.toml"])
    return environment().get_template("evidence/EVIDENCE.md.jinja").render(
        name=work.name,
        version=__version__,
        facts=facts,
        scalars=" and ".join(SCALARS[one.scalar] for one in work.packages),
        hashes=table(("file", "SHA-256"), [_quoted(*row) for row in hashes(work.texts).items()]),
        count=len(evidence.all_checks),
        failed=[_failure(work.name, check) for check in evidence.failed],
        whole=WHOLE if evidence.is_whole else LESS,
        summary=table(("promise", "at most", "measured", "of", "result"), _summary(evidence)),
        kinds=[_section(evidence, kind.key, checks) for kind, checks in evidence.checks],
        missing=[shown(text) for text in evidence.missing],
        left_out=evidence.left_out,
        versions=table(("tool", "version", "for"), versions()),
    )  # fmt: skip


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table of Markdown, its columns but the last one below the other for who reads the text."""
    both = [head, *rows]
    widths = [max(3, *(len(row[i]) for row in both)) for i in range(len(head) - 1)]
    rule = ["-" * width for width in (*widths, 3)]
    return "\n".join(_joined(row, (*widths, 0)) for row in (head, rule, *rows))


def _joined(row: Sequence[str], widths: Sequence[int]) -> str:
    return f"| {' | '.join(f'{cell:{width}}' for cell, width in zip(row, widths, strict=True))} |"


def shown(text: str) -> str:
    """Words of a tool as they can stand in a table: one line, no markup, no place of a file."""
    line = " ".join(_PLACE.sub("", text).split())
    return re.sub(r"([|*<\\`])", r"\\\1", line)


def _quoted(*words: str) -> tuple[str, ...]:
    return tuple(f"`{word}`" for word in words)


def _summary(evidence: Evidence) -> list[tuple[str, ...]]:
    return [
        (line.promise.text, _limit(line.worst.limit), _measured(line.worst),
         f"{line.samples:,}", _verdict(line.worst))
        for line in lines(evidence.all_checks)
    ]  # fmt: skip


def _section(evidence: Evidence, key: str, checks: Sequence[Check]) -> dict[str, Any]:
    name = evidence.work.name
    return {
        "key": key,
        "table": table(_HEAD, [_row(name, check) for check in checks]) if checks else "",
        "details": [_details(name, check) for check in checks if len(check.details) > 1],
    }


def _details(name: str, check: Check) -> dict[str, Any]:
    """What a check tells besides: the first lines, or a paragraph where it is short."""
    lines = [shown(line) for line in check.details[:LISTED]]
    if more := len(check.details) - len(lines):
        lines.append(f"and {more} more")
    paragraph = "; ".join(lines)
    return {
        "check": f"`{check.name}`, {_subject(name, check)}",
        "paragraph": paragraph if len(paragraph) <= SHORT else "",
        "lines": lines,
    }


def _failure(name: str, check: Check) -> str:
    """A check that failed, in a line."""
    found = f"{_measured(check)}, at most {_limit(check.limit)}"
    where = f"; {shown(check.worst)}" if check.worst else ""
    return f"{shown(check.name)}, {_subject(name, check)}: {found}{where}"


def _row(name: str, check: Check) -> tuple[str, ...]:
    one = check.details if len(check.details) == 1 else ()
    return (
        shown(check.name), _subject(name, check), _measured(check), _limit(check.limit),
        f"{check.samples:,}", _verdict(check),
        "; ".join(shown(text) for text in dict.fromkeys((check.worst, *one)) if text),
    )  # fmt: skip


def _subject(name: str, check: Check) -> str:
    """What it was measured on, without the vehicle's name: the page has that above."""
    return shown(check.subject.removeprefix(f"{name}_"))


def _measured(check: Check) -> str:
    return f"{figure(check.measured)}{_unit(check.limit)}"


def _limit(limit: Limit) -> str:
    return f"{limit.text}{_unit(limit)}" if limit.is_promised else "published"


def _unit(limit: Limit) -> str:
    return "" if limit.unit == "relative" else f" {limit.unit}"


def _verdict(check: Check) -> str:
    return "ok" if check.is_ok else "**FAILED**"
