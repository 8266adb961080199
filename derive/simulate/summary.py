"""A sweep in a few numbers: shares, quantiles, and the runs that are worth a second look."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.simulate.chunk import Rows
from derive.simulate.pilot import REFUSED

QUANTILES = (0.05, 0.5, 0.95)
MEASURED = {
    "settling_time": "s",
    "energy": "force sqrt(s)",
    "peak_force": "force",
    "final_height": "height",
    "final_rate": "velocity",
}
"""Columns whose quantiles are told, and their units; settling times are of settled runs."""

SHOWN = 5  # runs that failed


def summary(rows: Rows) -> dict[str, Any]:
    """What stands in summary.json."""
    settled = rows["settled"]
    times = np.where(settled, rows["settling_time"], -np.inf)
    slowest = int(np.argmax(times)) if settled.any() else None
    worst, counts = np.unique(rows["worst_status"], return_counts=True)
    return {
        "runs": len(settled),
        "settled": int(settled.sum()),
        "share_settled": float(settled.sum() / len(settled)),
        "quantiles": {name: _quantiles(rows[name]) for name in MEASURED},
        "crossings": int(rows["crossings"].sum()),
        "runs_that_cross": int((rows["crossings"] > 0).sum()),
        "worst_status": {str(status): int(n) for status, n in zip(worst, counts, strict=True)},
        "largest_drift": _number(float(np.max(rows["drift"]))),
        "slowest": None if slowest is None else _named(rows, slowest),
        "failed": [_named(rows, int(i)) for i in np.flatnonzero(~settled)[:SHOWN]],
    }


def text(found: Mapping[str, Any]) -> str:
    """The same for people."""
    share = 100 * found["share_settled"]
    lines = [
        f"settled    {found['settled']} of {found['runs']} runs, {share:.2f} %",
        *_refused(found),
        f"crossings  {found['crossings']} of the cut, in {found['runs_that_cross']} runs",
        "",
        f"{'':14}{'5 %':>12}{'50 %':>12}{'95 %':>12}",
    ]
    for name, unit in MEASURED.items():
        values = found["quantiles"][name] or [None] * len(QUANTILES)
        cells = "".join(f"{'-' if x is None else f'{x:.4g}':>12}" for x in values)
        lines.append(f"{name:14}{cells}  {unit}")
    return "\n".join(lines)


def _refused(found: Mapping[str, Any]) -> list[str]:
    """How many runs met a state that the controller refused, where there are any."""
    runs = sum(n for status, n in found["worst_status"].items() if int(status) >= REFUSED)
    return [f"refused    a state in {runs} of {found['runs']} runs"] if runs else []


def _quantiles(values: NDArray[Any]) -> list[float] | None:
    """Of the finite ones; None where there are none."""
    finite = values[np.isfinite(values)]
    return [float(q) for q in np.quantile(finite, QUANTILES)] if len(finite) else None


def _named(rows: Rows, i: int) -> dict[str, Any]:
    names = ("run", "seed", "rate", "settling_time", "final_height", "final_rate")
    return {name: _number(rows[name][i].item()) for name in names}


def _number(value: float) -> float | None:
    """None in the place of what JSON has no word for."""
    return value if np.isfinite(value) else None
