"""A report as one page of HTML that needs nothing but itself."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from derive.emit.render import environment
from derive.verify.check import figure
from derive.verify.limits import Limit

if TYPE_CHECKING:
    from derive.verify.check import Check, Report


def page(report: Report) -> str:
    """The page: a verdict, what failed, every check with its figure against its limit."""
    failed = [check for check in report.checks if not check.is_ok]
    context = {
        "vehicle": report.vehicle,
        "ok": report.ok,
        "failed": [_row(check) for check in failed],
        "rows": [_row(check) for check in report.checks],
        "skipped": report.skipped,
        "limits": {
            check.limit.name: check.limit for check in report.checks if check.limit.is_promised
        }.values(),
    }
    return environment().get_template("report/verify.html.jinja").render(context)


def _row(check: Check) -> dict[str, object]:
    return {
        "check": check,
        "measured": f"{figure(check.measured)}{_unit(check.limit)}",
        "limit": f"{check.limit.text}{_unit(check.limit) if check.limit.is_promised else ''}",
        "share": _share(check),
        "verdict": "ok" if check.is_ok else "failed",
    }


def _unit(limit: Limit) -> str:
    return "" if limit.unit == "relative" else f" {limit.unit}"


def _share(check: Check) -> int:
    """How much of its limit a check uses, in percent; 100 for whatever does not pass."""
    if not check.is_ok:
        return 100
    share = check.measured / check.limit.figure if check.limit.figure else 0.0
    return math.ceil(100 * max(share, 0.0))
