"""The claims told: for the screen, for Markdown, and as rows for a file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from itertools import groupby
from typing import Any

from derive.simulate.claim import Judged

HEAD = ("where", "the paper says", "measured", "at the threshold", "verdict", "LSF corrected")


def text(claims: Sequence[Judged]) -> str:
    """A verdict and its statement per line, the numbers below; place by place."""
    lines: list[str] = []
    for place, ones in groupby(claims, lambda one: one.claim.place):
        lines += ["", place]
        for one in ones:
            found = one.printed
            lines.append(f"  {found.verdict:<28} {one.claim.says}")
            at = f", at {found.threshold}" if found.threshold else ""
            lines.append(f"  {'':<28} {found.measured}{at}")
            if one.corrected.verdict != found.verdict:
                other = one.corrected
                lines.append(f"  {'':<28} LSF corrected: {other.verdict}; {other.measured}")
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
    """A table; what is measured is with LSF as printed."""
    lines = [_row(HEAD), _row(["---"] * len(HEAD))]
    for one in claims:
        found, other = one.printed, one.corrected
        told = (one.claim.place, one.claim.says, found.measured, found.threshold,
                f"**{found.verdict}**", other.verdict)  # fmt: skip
        lines.append(_row([cell.replace("|", "\\|") for cell in told]))
    return "\n".join(lines) + "\n"


def brief(claims: Sequence[Judged]) -> str:
    """The same in three columns: place and statement, what was measured and where, the verdict."""
    lines = [_row(("the paper says", "measured", "verdict")), _row(["---"] * 3)]
    for one in claims:
        found = one.printed
        at = f", at {found.threshold}" if found.threshold else ""
        said, measured = f"{one.claim.place}: {one.claim.says}", f"{found.measured}{at}"
        lines.append(_row([cell.replace("|", "\\|") for cell in (said, measured, found.verdict)]))
    return "\n".join(lines) + "\n"


def _row(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
