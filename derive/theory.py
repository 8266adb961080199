"""What is known of a vehicle's kinematic law: the table of the Definition, and the warnings."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from derive.vehicle import InputError, Vehicle, resolve
from derive.vehicle.group import group_of

if TYPE_CHECKING:
    from derive.lie.group import Group
    from derive.verify.law.report import LawReport


def laws(vehicle: Vehicle | None, group: str | None, progress: Callable[[str], None]) -> LawReport:
    """Judge the laws of the vehicle's group, of the group of that name, or of the catalogue.

    Raises InputError for a group that nobody knows.
    """
    from derive.lie.catalogue import GROUPS
    from derive.verify.law.report import report

    if vehicle is not None:
        resolve(vehicle)
        return report([group_of(vehicle)], progress, vehicle.law)
    return report([_known(group)] if group else list(GROUPS.values()), progress)


def _known(name: str) -> Group:
    """A group by the name that an option gives."""
    from derive.vehicle.group import made, normal
    from derive.vehicle.lookup import look_up

    try:
        look_up("--group", normal(name))
    except InputError as fault:
        remedy = fault.remedy.replace("write group = ", "give --group ")
        raise InputError("--group", "", fault.expected, fault.found, remedy) from None
    return made(normal(name), None)


def refuse_both(vehicle: Vehicle | None, group: str | None) -> None:
    """Raise InputError when a group is named twice."""
    if vehicle is not None and group is not None:
        expected = "a vehicle file or a group"
        raise InputError("--group", "", expected, "both", f"leave one out: {vehicle.source} is "
                         f"on {vehicle.group}")  # fmt: skip


def cautions(vehicle: Vehicle, group: Group) -> list[str]:
    """What `derive emit` warns of, each a line; group is the vehicle's, which resolved."""
    from derive.control import caution
    from derive.control.kinematic import laws_of

    if vehicle.own is None:
        found = list(caution.cautions(group, vehicle.law, laws_of(group)))
        asked = f"derive laws --group {_quoted(group.name)}"
    else:
        found, asked = _judged(group, vehicle.law), "derive laws with this file"
    told = [f"law {vehicle.law} on {group.name} {one}; see {asked}" for one in found]
    return told + (_unguarded(group) if vehicle.own else [])


def _judged(group: Group, law: str) -> list[str]:
    """Of a group that no table knows: its laws are judged now."""
    from derive.control.matrix_law import keeps_odd_powers
    from derive.verify.law.consequence import cautions as of_verdict
    from derive.verify.law.report import report

    try:
        verdicts = report([group]).verdicts
    except (ArithmeticError, LookupError, ValueError) as fault:  # the sampling, not the code
        return [f"could not be judged ({fault})"]
    found = of_verdict(next(one for one in verdicts if one.law == law), verdicts)
    if not found and law == "skew" and not keeps_odd_powers(group):
        found.append("is g - g^-1 only as far as the algebra reaches, which odd powers leave: that "
                     "V falls is shown near the identity alone")  # fmt: skip
    return found


def _unguarded(group: Group) -> list[str]:
    """The guard of a group of one's own may not see every direction off the group."""
    from derive.lie.own import unseen

    count = unseen(group)
    if not count:
        return []
    directions = "one direction" if count == 1 else f"{count} directions"
    return [f"control cannot see whether g has left {group.name} in {directions}: keep g on the "
            "group"]  # fmt: skip


def _quoted(name: str) -> str:
    return f"'{name}'" if " " in name else name
