"""The controller of a vehicle file: its gains, the law it has of its own, where it exists."""

from fractions import Fraction

from derive.control.table import CONTROLLERS, Gain
from derive.vehicle.key import HOMES
from derive.vehicle.number import positive
from derive.vehicle.text import Table, described, quoted

LEAST_GAIN = Fraction(1, 10**9)
LARGEST_GAIN, LARGEST_RATE = Fraction(10**6), Fraction(10**4)
RATE = "1/s"
EVERYWHERE = "gsmc"


def gains_of(top: Table, name: str) -> tuple[tuple[str, Fraction], ...]:
    """The gains of that controller, each in its unit, and no others; raises InputError."""
    gains, takes = top.table("gains"), CONTROLLERS[name]
    for key in gains.values:
        _refuse_foreign(gains, key, name)
    gains.only(takes.names, HOMES)
    return tuple((gain.name, _gain(gains, gain)) for gain in takes.gains)


def _gain(gains: Table, gain: Gain) -> Fraction:
    """One gain, in its unit."""
    number = f"{gain.name} = 1.0, or another positive number without quotes"
    remedy = f"write {number}, in {gain.unit}, below [gains]"
    most = LARGEST_RATE if gain.unit == RATE else LARGEST_GAIN
    return positive(gains, gain.name, most, remedy, LEAST_GAIN)


def _refuse_foreign(gains: Table, key: str, name: str) -> None:
    """Raise InputError for a gain of other controllers."""
    known = CONTROLLERS[name].names
    owners = [other for other, one in CONTROLLERS.items() if key in one.names]
    if key in known or not owners:
        return
    others = " or ".join(f'"{other}"' for other in owners)
    remedy = f"give {' and '.join(known)}, or write controller = {others} above the tables"
    expected = f"one of the keys {', '.join(known)}, the gains of {name}"
    raise gains.fault(key, expected, f"a gain of {', '.join(owners)}", remedy)


def check_controller(top: Table, name: str, group: str, law: str) -> None:
    """Raise InputError unless the controller exists on that group and goes with that law."""
    takes = CONTROLLERS[name]
    if not takes.exists_on(group):
        there = ", ".join(other for other, one in CONTROLLERS.items() if one.exists_on(group))
        places = " and ".join(takes.groups)
        found = f"{quoted(name)}, which exists on {places} only: {takes.why}"
        remedy = f'write controller = "{EVERYWHERE}", which exists on every group, with its gains'
        raise top.fault("controller", f"one that exists on {group}: {there}", found, remedy)
    if takes.law not in (None, law):
        expected = f'nothing, or "{takes.law}": {name} has an attitude error of its own'
        remedy = f'leave law out, or write controller = "{EVERYWHERE}" for that law, with its gains'
        raise top.fault("law", expected, described(law), remedy)


def law_by_default(name: str, usual: str) -> str:
    """The law of a file that names none."""
    return CONTROLLERS[name].law or usual
