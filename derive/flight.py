"""The route of a closed loop: vehicle -> craft -> loop -> files."""

from __future__ import annotations

from pathlib import Path

from derive import pipeline
from derive.simulate.craft import Craft
from derive.vehicle import Vehicle, check_facts, resolve


def craft(vehicle: Vehicle, cached: Path | None) -> Craft:
    """The vehicle as the simulator takes it, emitted files included. Raises InputError."""
    check_facts(vehicle, resolve(vehicle))
    n, own = len(vehicle.inertia), vehicle.own
    return Craft(
        name=vehicle.name,
        group=vehicle.group,
        law=vehicle.law,
        controller=vehicle.controller,
        inertia=tuple(float(vehicle.inertia[i][j]) for i in range(n) for j in range(i, n)),
        gains=tuple((name, float(value)) for name, value in vehicle.gains),
        files=tuple(sorted(pipeline.texts(vehicle, cached).items())),
        options=vehicle.options,
        own=own.basis if own else None,
        units=own.units if own else (),
    )
