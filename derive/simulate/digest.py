"""What a scenario comes to in numbers: energies, settling times, peaks, sampled trajectories."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from derive.simulate import claim_table
from derive.simulate.claim import Judged
from derive.simulate.craft import Craft
from derive.simulate.flight import Flight
from derive.simulate.invariant import Watched, facts
from derive.simulate.plain import plain
from derive.simulate.reading import energy, settling, until
from derive.simulate.scenario import ENTRANTS, FLOWN, SCENARIOS, SECONDS

SCHEMA = 1
SAMPLES = 601  # of a trajectory, at most; the first and the last are among them
SETTLED = {"height": (1e-2, 1e-4, 1e-6, 1.3e-7), "rate_error": (1e-2, 1e-3, 3e-4)}
"""Thresholds of Psi and of |nu_e| in rad/s."""

KEPT = ("t", "g", "nu", "g_r", "height", "s", "force")
UNITS = {"t": "s", "g": "1, row by row", "nu": "rad/s", "g_r": "1, row by row",
         "height": "1, tr(1 - R_e)/2", "s": "rad/s", "force": "N m", "energy": "N m sqrt(s)",
         "rate_error": "rad/s", "settled": "s"}  # fmt: skip


def figures(flight: Flight) -> dict[str, Any]:
    """Energy and peaks by SECONDS, and settling times in the whole flight; None where it does not.

    A settled value stays at or below its threshold to the end.
    """
    shown = until(flight, SECONDS)
    values = {"height": flight.height, "rate_error": flight.rate_error()}
    return {
        "energy": energy(flight, SECONDS),
        "settled": {name: {f"{one:g}": settling(flight, values[name], one) for one in each}
                    for name, each in SETTLED.items()},
        "peak": {"force": float(shown.effort().max()), "height": float(shown.height.max()),
                 "rate_error": float(shown.rate_error().max())},
    }  # fmt: skip


def trajectory(flight: Flight) -> dict[str, Any]:
    """At most SAMPLES instants of the first SECONDS, as lists."""
    shown = until(flight, SECONDS)
    last = len(shown.t) - 1
    at = np.unique(np.linspace(0, last, min(SAMPLES, last + 1)).round().astype(int))
    return {name: getattr(shown, name)[at].tolist() for name in KEPT}


def as_json(
    number: int,
    vehicle: str,
    backend: str,
    crafts: Sequence[Craft],
    flights: Mapping[str, Flight],
    watched: Mapping[str, Watched],
    claims: Sequence[Judged],
    differences: Sequence[str],
) -> str:
    """The file of one scenario; flights by controller. What is not finite is null."""
    one = SCENARIOS[number]
    each = {
        craft.controller: {
            "title": ENTRANTS[craft.controller].title, "law": craft.law,
            "gains": dict(craft.gains), **figures(flights[craft.controller]),
            "invariants": facts(watched[craft.controller]),
            "trajectory": trajectory(flights[craft.controller]),
        }
        for craft in crafts
    }  # fmt: skip
    whole = {
        "schema": SCHEMA, "vehicle": vehicle, "scenario": number, "title": one.title,
        "start": one.spelled, "seconds": SECONDS, "flown": FLOWN, "backend": backend,
        "inertia": list(crafts[0].inertia), "differs_from_paper": list(differences),
        "units": UNITS, "controllers": each,
        "claims": claim_table.rows([c for c in claims if c.claim.scenario == number]),
    }  # fmt: skip
    return json.dumps(plain(whole), ensure_ascii=False, allow_nan=False) + "\n"


def table(number: int, flights: Mapping[str, Flight]) -> str:
    """The figures of one scenario as aligned text."""
    heads = [f"Ψ≤{x:g}" for x in SETTLED["height"]] + [f"Ω≤{x:g}" for x in SETTLED["rate_error"]]
    one = SCENARIOS[number]
    columns = "".join(f"{head:>10}" for head in heads)
    lines = [
        f"scenario {number}, {one.title}: {one.spelled}",
        f"  {'':<16}{'energy':>9}{'max ‖τ‖':>9}{columns}",
    ]
    for name, flight in flights.items():
        found = figures(flight)
        times = [t for each in found["settled"].values() for t in each.values()]
        told = "".join(f"{'not' if t is None else format(t, '.2f'):>10}" for t in times)
        lines.append(f"  {ENTRANTS[name].title:<16}{found['energy']:>9.4f}"
                     f"{found['peak']['force']:>9.3f}{told}")  # fmt: skip
    return "\n".join(lines)
