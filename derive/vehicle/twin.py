"""Several vehicles in one call: they must not get into each other's way."""

from collections.abc import Sequence
from pathlib import Path

from derive.vehicle.file import Vehicle
from derive.vehicle.text import InputError


def refuse_twins(vehicles: Sequence[Vehicle]) -> None:
    """Raise InputError when two would share a folder, or macros in C, which are upper case."""
    sources: dict[str, str] = {}
    for vehicle in vehicles:
        other = sources.get(vehicle.name.upper())
        sources[vehicle.name.upper()] = vehicle.source
        if other is not None and Path(other).resolve() == Path(vehicle.source).resolve():
            found = f"the same file twice, the first time as {other}"
            expected = "each vehicle file once"
            raise InputError(vehicle.source, "", expected, found, "name it once in this call")
        if other is not None:
            raise InputError(
                file=vehicle.source,
                key="name",
                expected="names that differ in more than capitals, one for each vehicle",
                found=f"{vehicle.name!r} here, and in {other}",
                remedy="rename one of the two, or leave it out of this call",
            )
