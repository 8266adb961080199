"""EVIDENCE.md: what was measured on which files, with what, and what was not; for a reviewer.

It holds neither dates nor times nor places of files: the same tools on the same package give the
same bytes.
"""

from __future__ import annotations

import tomllib
from typing import Any

from derive import __version__
from derive.emit.render import environment
from derive.evidence.gather import Evidence, Section
from derive.evidence.lack import Lack
from derive.evidence.markdown import quoted, shown, table
from derive.evidence.stamp import hashes, sealed
from derive.evidence.summary import lines
from derive.evidence.version import versions
from derive.verify.check import Check, figure
from derive.verify.limits import Limit

WHOLE = "Everything was run."
"""In the first lines of a page that lacks nothing."""

LESS = "**This page is partial**: not everything was run."
"""The first line of another."""

LACKING = {False: "**not run**", True: "**in part**"}
"""In the place of a result, by whether some of it was run."""

LISTED = 12
"""Details of a check that are shown at most."""

SHORT = 300
"""Characters up to which the details of a check are one paragraph."""

SCALARS = {"f32": "float (f32)", "f64": "double (f64)"}

_HEAD = ("check", "on", "measured", "at most", "of", "result", "worst at")


def page(evidence: Evidence) -> str:
    """The page."""
    work = evidence.work
    facts = tomllib.loads(work.texts["MANIFEST.toml"])
    text = environment().get_template("evidence/EVIDENCE.md.jinja").render(
        name=work.name,
        version=__version__,
        facts=facts,
        scalars=" and ".join(SCALARS[one.scalar] for one in work.packages),
        hashes=table(("file", "SHA-256"), [quoted(*row) for row in hashes(work.texts).items()]),
        count=len(evidence.all_checks),
        failed=[_failure(work.name, check) for check in evidence.failed],
        whole=f" {WHOLE}" if evidence.is_whole else "",
        partial="" if evidence.is_whole else _partial(evidence),
        summary=table(("promise", "at most", "measured", "of", "result"), _summary(evidence)),
        kinds=[_section(work.name, section) for section in evidence.sections],
        missing=[shown(str(one)) for one in evidence.missing],
        left_out=evidence.left_out,
        versions=table(("tool", "version", "for"), versions()),
    )  # fmt: skip
    return sealed(text)


def _partial(evidence: Evidence) -> str:
    """What the page lacks, in a sentence."""
    tools = dict.fromkeys(tool for one in evidence.missing for tool in one.tools)
    reasons = []
    if tools:
        reasons.append(f"{len(evidence.missing)} measurements for want of {', '.join(tools)}")
    if evidence.left_out:
        reasons.append(f"{len(evidence.left_out)} for a quick run")
    return f"{LESS} Missing, whole or in part: {'; '.join(reasons)}. See the end of the page."


def _summary(evidence: Evidence) -> list[tuple[str, ...]]:
    rows: list[tuple[str, ...]] = [
        (line.promise.text, _limit(line.worst.limit), _measured(line.worst),
         f"{line.samples:,}", _verdict(line.worst))
        for line in lines(evidence.all_checks)
    ]  # fmt: skip
    for one in evidence.missing:
        what = f"{shown(one.what)}: no {' and no '.join(one.tools)} here"
        rows.append((what, "", "", "", LACKING[one.is_part]))
    return rows


def _section(name: str, section: Section) -> dict[str, Any]:
    checks = section.checks
    rows = [*(_row(name, check) for check in checks), *map(_lacking, section.missing)]
    return {
        "key": section.kind.key,
        "table": table(_HEAD, rows) if rows else "",
        "details": [_details(name, check) for check in checks if len(check.details) > 1],
    }


def _lacking(one: Lack) -> tuple[str, ...]:
    """The row of what was not measured."""
    return shown(one.what), one.subject, "", "", "", LACKING[one.is_part], shown(one.why)


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
