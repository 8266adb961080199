"""Crafts and plans for the tests of sweeps: a vehicle per group, with what was emitted for it."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from derive import campaign, flight
from derive.simulate.chunk import Plan
from derive.simulate.craft import Craft
from derive.vehicle import Vehicle, load
from derive.vehicle.starter import starter
from tests.command import ROOT

KEPT = {
    "SO3": "paper_so3",
    "S3": "paper_s3",
    "SE2": "hovercraft",
    "SE3": "underwater",
    "SE3 x SO3": "two_bodies",
    "SL2": "sl2",
}
"""Group -> a vehicle of vehicles/; SL2 is a user's own."""


@cache
def vehicle(group: str) -> Vehicle:
    """A vehicle on that group."""
    if group in KEPT:
        return load(ROOT / "vehicles" / f"{KEPT[group]}.toml")
    with TemporaryDirectory() as folder:
        file = Path(folder) / "body.toml"
        file.write_text(starter("body", group))
        return load(file)


@cache
def craft(group: str) -> Craft:
    """The craft of that vehicle."""
    return flight.craft(vehicle(group), None)


def asked(runs: int = 20, **given: Any) -> campaign.Asked:
    """What a command line says; keys of Asked, and others for `given`."""
    plain: dict[str, Any] = {
        "runs": runs, "seed": 3, "backend": "numpy", "box": 0.8, "speed": 0.5,
        "settle": 1e-2, "rates": (20.0,), "chunk": 8,
    }  # fmt: skip
    errors: Mapping[str, Any] = {"duration": 2.0, "inertia_error": 0.1, "disturbance": (0.01,)}
    own = {key: value for key, value in given.items() if key in plain}
    other = {key: value for key, value in given.items() if key not in plain}
    return campaign.Asked(**{**plain, **own}, given={**errors, **other})


def plan(group: str = "SO3", **given: Any) -> Plan:
    """A short sweep's plan."""
    return campaign.plan(vehicle(group), None, asked(**given))
