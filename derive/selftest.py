"""The package's own test: what is kept of it with a derivation, and its tables for one vehicle.

The truth comes from `verify`, the text and the bits from `emit`; neither knows of the other here.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from derive.emit.selftest import selftest, written
from derive.emit.target import TARGETS
from derive.vehicle import Vehicle
from derive.verify.combined import Limits, answers

if TYPE_CHECKING:
    from derive.verify.plant import Plant

CODE = "c99"
"""The target that tests itself."""


def plant_of(vehicle: Vehicle) -> Plant:
    """What the truth is told of a vehicle."""
    from derive.verify.plant import Plant

    return Plant(
        vehicle.group,
        vehicle.law,
        vehicle.inertia,
        tuple(value for _, value in vehicle.gains),
        vehicle.controller,
        own=vehicle.own.basis if vehicle.own else None,
        options=vehicle.options,
        force_limit=vehicle.limits.force,
        saturation=vehicle.limits.saturation,
        max_drift=vehicle.limits.drift,
        hysteresis=vehicle.hysteresis,
    )


def kept(vehicle: Vehicle, printed: Mapping[str, Any], *, is_pole: bool) -> dict[str, Any]:
    """All that does not depend on the vehicle's numbers; nothing for a group without a truth.

    printed: {target: {scalar: data}}; is_pole: whether the law has a pole
    """
    from derive.emit.program import program
    from derive.verify.golden import golden, is_known

    judged, scalars = plant_of(vehicle), TARGETS[CODE].scalars
    if not is_known(judged):
        return {}
    found = golden(judged, is_pole=is_pole, scalars=scalars)
    for scalar, rows in found["rows"].items():
        for row in rows:
            row["written"] = written(printed[CODE][scalar], row["given"], scalar)
    programs = {scalar: program(printed[CODE][scalar], scalar) for scalar in scalars}
    return {"programs": programs, **found}


def tables(
    vehicle: Vehicle, found: Mapping[str, Any], printed: Mapping[str, Any],
    values: Mapping[str, Any],
) -> dict[str, Any]:  # fmt: skip
    """What the templates of the test read, by scalar; nothing where nothing was kept.

    found: as `kept` gives it; printed: {scalar: data} of the C; values: as `render` takes them
    """
    if not found:
        return {}
    programs, identity = found["programs"], found["identity"]
    rows = {scalar: _rows(vehicle, found, scalar, values) for scalar in printed}
    return {
        scalar: selftest(data, programs[scalar], rows[scalar], identity, values, scalar)
        for scalar, data in printed.items()
    }


def _rows(
    vehicle: Vehicle, found: Mapping[str, Any], scalar: str, values: Mapping[str, Any]
) -> list[dict[str, Any]]:
    """The kept rows, each with what is true of its command for this inertia and these gains."""
    limits = Limits(values["force_limit"], values["saturation"] == "direction")
    told = answers(
        found, scalar, vehicle.controller, vehicle.inertia, vehicle.gains, limits,
        is_own=vehicle.own is not None,
    )  # fmt: skip
    pairs = zip(found["rows"][scalar], told, strict=True)
    return [{**row, "status": x.status, "outputs": x.outputs} for row, x in pairs if x]
