"""The claims told: for the screen, for Markdown, and as rows for a file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from itertools import groupby
from typing import Any

from derive.simulate.claim import Judged
from derive.simulate.judge import Finding

MEASURED = "measured, LSF as printed"
HEAD = ("where", "the paper says", MEASURED, "at the threshold", "verdict",
        "verdict, LSF corrected")  # fmt: skip


def text(claims: Sequence[Judged]) -> str:
    """A verdict and its statement per line, the numbers below; place by place."""
    lines = [
        "",
        "what the paper says, with LSF as printed; LSF corrected where its verdict differs",
    ]
    for place, ones in groupby(claims, lambda one: one.claim.place):
        lines += ["", place]
        for one in ones:
            found = one.printed
            lines.append(f"  {found.verdict:<30} {one.claim.says}")
            lines.append(f"  {'':<30} {_told(found)}")
            if one.differs:
                other = one.corrected
                lines.append(f"  {'':<30} LSF corrected: {other.verdict}; {other.measured}")
    return "\n".join(lines[1:])


def rows(claims: Sequence[Judged]) -> list[dict[str, Any]]:
    """One record per claim, as plain data."""
    return [
        {"name": one.claim.name, "scenario": one.claim.scenario, "where": one.claim.place,
         "says": one.claim.says, "lsf_printed": asdict(one.printed),
         "lsf": asdict(one.corrected)}
        for one in claims
    ]  # fmt: skip


def markdown(claims: Sequence[Judged]) -> str:
    """A table; the numbers are with LSF as printed, the verdicts with both of its forms."""
    lines = [_row(HEAD), _row(["---"] * len(HEAD))]
    for one in claims:
        found, other = one.printed, one.corrected
        told = (one.claim.place, one.claim.says, found.measured, found.threshold,
                f"**{found.verdict}**", other.verdict)  # fmt: skip
        lines.append(_row([cell.replace("|", "\\|") for cell in told]))
    return "\n".join(lines) + "\n"


def brief(claims: Sequence[Judged]) -> str:
    """The same in three columns: place and statement, what was measured and where, the verdict.

    With it the one that LSF corrected gets, where that is another.
    """
    lines = [_row(("the paper says", MEASURED, "verdict")), _row(["---"] * 3)]
    for one in claims:
        other = f"; with LSF corrected: {one.corrected.verdict}" if one.differs else ""
        told = (f"{one.claim.place}: {one.claim.says}", _told(one.printed),
                f"{one.printed.verdict}{other}")  # fmt: skip
        lines.append(_row([cell.replace("|", "\\|") for cell in told]))
    return "\n".join(lines) + "\n"


def _told(found: Finding) -> str:
    """What was measured, and at which threshold."""
    return f"{found.measured}, at {found.threshold}" if found.threshold else found.measured


def _row(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
