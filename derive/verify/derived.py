"""What is judged, as `lie` and `control` derive it: the group and the law of a vehicle."""

from __future__ import annotations

from functools import cache

from derive.control.controller import Routines, routines
from derive.control.kinematic import laws_of
from derive.lie.catalogue import named
from derive.lie.group import Group
from derive.lie.own import of_basis
from derive.verify.plant import Plant


@cache
def lie_group(vehicle: Plant) -> Group:
    """The group of a vehicle, its own or the catalogue's."""
    if vehicle.own is None:
        return named(vehicle.group)
    return of_basis(vehicle.group, vehicle.own, ("1/s",) * len(vehicle.own))


def has_pole(vehicle: Plant) -> bool:
    """Whether its law has a pole, near which `control` refuses good states too."""
    return laws_of(lie_group(vehicle))[vehicle.law].is_pole and vehicle.hysteresis is None


def parts_of(vehicle: Plant) -> Routines:
    """Every derivation that the vehicle is emitted with."""
    group, n = lie_group(vehicle), len(vehicle.inertia)
    pattern = tuple(vehicle.inertia[i][j] != 0 for i in range(n) for j in range(i, n))
    law = laws_of(group)[vehicle.law]
    return routines(group, law, vehicle.controller, pattern, vehicle.options)
