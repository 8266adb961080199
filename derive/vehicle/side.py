"""The shorter way round on S3: whether `control` takes it, and how long it keeps to its choice."""

from __future__ import annotations

from fractions import Fraction

from derive.control.table import CONTROLLERS
from derive.vehicle.number import number
from derive.vehicle.text import Table, described, quoted

GROUP = "S3"
LEAST, MOST = Fraction(1, 1000), Fraction(1, 2)
USUAL = Fraction(1, 10)
EVEN = ("sign_vec",)
"""Laws that are the same for q and -q: there is nothing to choose."""


def hysteresis(top: Table, group: str, controller: str, law: str) -> Fraction | None:
    """cos of half the angle by which the other way has to be shorter; None to choose none.

    Raises InputError where there is no choice.
    """
    if not _is_asked(top):
        if "hysteresis" in top.values:
            remedy = "write shortest = true above the tables, or leave hysteresis out"
            raise top.fault("hysteresis", "shortest = true", "no such choice", remedy)
        return None
    _check_choice(top, group, controller, law)
    return _margin(top)


def _is_asked(top: Table) -> bool:
    value = top.values.get("shortest", False)
    if not isinstance(value, bool):
        remedy = "write shortest = true, or leave it out for false"
        found = described(value)
        raise top.fault("shortest", "true or false, without quotes", found, remedy)
    return value


def _check_choice(top: Table, group: str, controller: str, law: str) -> None:
    """Raise InputError unless the law tells q_e from -q_e, and the error is one quaternion."""
    if group != GROUP:
        expected = f'group = "{GROUP}", whose laws tell q from -q: one attitude, two ways to it'
        remedy = "leave shortest out: a law of rotation matrices takes the shorter way by itself"
        if GROUP in group.split(" x "):
            remedy = "leave shortest out, or take SO3 for the factor S3: there is no other way"
        raise top.fault("shortest", expected, f"group = {quoted(group)}", remedy)
    if law in EVEN:
        expected = "a law that tells q from -q"
        found = f"law = {quoted(law)}, which takes the shorter way by itself"
        remedy = 'leave shortest out, or write law = "vec": twice as much, and with hysteresis'
        raise top.fault("shortest", expected, found, remedy)
    if not CONTROLLERS[controller].has_reference:
        expected = "a controller with a reference, whose error may be taken with either sign"
        remedy = 'write controller = "gsmc", and give it the identity at rest for a reference'
        raise top.fault("shortest", expected, f"controller = {quoted(controller)}", remedy)


def _margin(top: Table) -> Fraction:
    given = top.values.get("hysteresis", USUAL)
    value = number(given)
    if value is None or not LEAST <= value <= MOST:
        expected = "a number from 0.001 to 0.5, the cosine of half an error angle"
        remedy = "write hysteresis = 0.1, which is half a turn and 11 degrees; noise needs some"
        raise top.fault("hysteresis", expected, described(given), remedy)
    return value
