"""A check: what was measured on what, against which limit, and where it was worst."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from typing import Any

from derive.verify.limits import Limit


@dataclass(frozen=True)
class Check:
    """One line of evidence; a measurement that is not a number never passes.

    worst: where it was worst; details: what a machine may want to list besides
    """

    name: str
    subject: str
    measured: float
    limit: Limit
    samples: int
    worst: str = ""
    details: tuple[str, ...] = ()

    @property
    def is_ok(self) -> bool:
        """Whether the measurement is within the limit."""
        return self.measured <= self.limit.figure


@dataclass(frozen=True)
class Report:
    """All checks of one vehicle, and what could not be checked on this machine, with the reason."""

    vehicle: str
    checks: tuple[Check, ...]
    skipped: tuple[str, ...] = ()

    @property
    def ok(self) -> bool:
        """Whether every check passed."""
        return all(check.is_ok for check in self.checks)

    def table(self) -> str:
        """Columns check, on, worst figure, limit, samples, verdict, worst input."""
        head = ("check", "on", "worst", "limit", "samples", "", "worst at")
        rows = [head, *(_row(check) for check in self.checks)]
        widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
        lines = ["  ".join(f"{cell:{w}}" for cell, w in zip(row, widths, strict=True)).rstrip()
                 for row in rows]  # fmt: skip
        failed = sum(not check.is_ok for check in self.checks)
        verdict = f"{len(self.checks)} checks, {failed} failed" + "".join(
            f"\nnot checked: {reason}" for reason in self.skipped
        )
        return "\n".join([f"{self.vehicle}: derivatives and properties", *lines, verdict])

    def as_json(self) -> str:
        """The same for machines."""
        checks = [{**_plain(check), "ok": check.is_ok} for check in self.checks]
        body = {
            "vehicle": self.vehicle,
            "ok": self.ok,
            "checks": checks,
            "skipped": list(self.skipped),
        }
        return json.dumps(body, indent=2) + "\n"

    def as_html(self) -> str:
        """The same as a page of its own."""
        from derive.verify.page import page

        return page(self)


def figure(measured: float) -> str:
    """Three digits, and a count in full."""
    is_count = measured == measured // 1 and abs(measured) < 1e7
    return f"{measured:.0f}" if is_count else f"{measured:.3g}"


def _plain(check: Check) -> dict[str, Any]:
    """For JSON, which has no infinity: a limit that does not exist has no figure."""
    plain = asdict(check)
    if not check.limit.is_promised:
        plain["limit"]["figure"] = None
    return plain


def _row(check: Check) -> tuple[str, ...]:
    unit = "" if check.limit.unit == "relative" else f" {check.limit.unit}"
    return (
        check.name,
        check.subject,
        f"{figure(check.measured)}{unit}",
        f"{check.limit.text}{unit}" if check.limit.is_promised else check.limit.text,
        str(check.samples),
        "ok" if check.is_ok else "FAILED",
        check.worst,
    )
