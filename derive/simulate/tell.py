"""One run told: a table for the screen, and everything as JSON."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

import numpy as np

from derive.control.motion import measure
from derive.lie.group import Group
from derive.simulate.flight import Flight
from derive.simulate.invariant import Invariant, facts
from derive.simulate.pilot import REFUSED
from derive.simulate.plain import plain
from derive.simulate.reading import settled_instant, settling
from derive.simulate.runs import Setting

SCHEMA = 1
SAMPLES = 1000  # of a trajectory, at most; the first and the last are kept
THRESHOLDS = (1e-2, 1e-4, 1e-6)
KEPT = ("t", "g", "nu", "g_r", "nu_r", "height", "nu_e", "s", "force", "energy", "status")


def figures(flight: Flight, crossings: int, settle: float) -> dict[str, float | None]:
    """What a run comes to, by name; None where it does not settle.

    settle: what both the height and |nu_e| have to stay at or below; told by instants, as in a
            sweep, while the height alone is told between them, as for the paper's scenarios
    """
    both = np.maximum(flight.height, flight.rate_error())
    settled = {f"settled, both to {settle:g}": settled_instant(flight.t, both, settle)}
    settled |= {f"settled to {one:g}": settling(flight, flight.height, one) for one in THRESHOLDS}
    return {
        "first height": float(flight.height[0]),
        "last height": float(flight.height[-1]),
        "last |nu_e|": float(flight.rate_error()[-1]),
        **settled,
        "energy": float(flight.energy[-1]),
        "peak |force|": float(flight.effort().max()),
        "peak |nu_e|": float(flight.rate_error().max()),
        "crossings of the cut": crossings,
        "saturated instants": int(np.any(flight.force != flight.asked, axis=1).sum()),
        "refused instants": int((flight.status >= REFUSED).sum()),
    }


def table(
    head: str, group: Group, found: dict[str, float | None], watched: Sequence[Invariant]
) -> str:
    """Both as aligned text."""
    far = measure(group)
    units = {"energy": f"{group.force_unit} sqrt(s)", "peak |force|": group.force_unit,
             "last |nu_e|": group.unit, "peak |nu_e|": group.unit}  # fmt: skip
    lines = [head, f"  height: {far.name} = {far.doc} [{far.unit}]", ""]
    for name, value in found.items():
        unit = units.get(name, "s" if name.startswith("settled") else "")
        told = "not settled" if value is None else f"{value:.6g} {unit}".rstrip()
        lines.append(f"  {name:<24} {told}")
    lines.append("")
    for one in watched:
        number = "" if one.why else f"  {one.measured:.2g}, at most {one.limit:g}"
        lines.append(f"  {one.name:<31} {one.verdict}{number}")
    return "\n".join(lines)


def as_json(
    head: dict[str, Any],
    group: Group,
    setting: Setting,
    flight: Flight,
    found: dict[str, float | None],
    watched: Sequence[Invariant],
) -> str:
    """The run as one JSON object; an infinite or missing number is null."""
    rows = np.unique(np.linspace(0, len(flight.t) - 1, min(SAMPLES, len(flight.t))).astype(int))
    samples = {name: getattr(flight, name)[rows].tolist() for name in KEPT}
    whole = {
        "schema": SCHEMA,
        **head,
        "setting": asdict(setting),
        "units": _units(group),
        "figures": found,
        "invariants": facts(watched),
        "trajectory": samples,
    }  # fmt: skip
    return json.dumps(plain(whole), indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def _units(group: Group) -> dict[str, str]:
    """Of what the trajectory holds."""
    speed, force = group.unit, group.force_unit
    return {
        "t": "s", "g": group.storage, "nu": speed, "g_r": group.storage, "nu_r": speed,
        "height": measure(group).unit, "nu_e": speed, "s": speed, "force": force,
        "energy": f"({force}) sqrt(s)", "status": "1",
    }  # fmt: skip
