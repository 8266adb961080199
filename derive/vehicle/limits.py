"""The [limits] table of a vehicle file: what the actuators give, and what drift is fine."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from derive.vehicle.key import HOMES, LIMIT_KEYS
from derive.vehicle.number import number
from derive.vehicle.text import Table, described

LEAST, MOST = Fraction(1, 10**6), Fraction(10**9)
LEAST_DRIFT, MOST_DRIFT = Fraction(1, 10**6), Fraction(1, 10)
WAYS = ("direction", "axis")


@dataclass(frozen=True)
class Limits:
    """What `control` keeps to.

    force: largest force of each of n coordinates, N m and N; empty where there is no limit
    saturation: "direction" keeps the direction of the force, "axis" cuts each coordinate by
        itself; empty where there is no limit
    drift: largest distance of the error from the group; None for that of each scalar
    """

    force: tuple[Fraction, ...] = ()
    saturation: str = ""
    drift: Fraction | None = None


def limits(top: Table, n: int) -> Limits:
    """The limits of a vehicle of dimension n. Raises InputError."""
    table = top.table("limits")
    table.only(LIMIT_KEYS, HOMES)
    if "saturation" in table.values and "force" not in table.values:
        remedy = "write force = ..., or leave saturation out"
        raise table.fault("saturation", "a force to be limited", "no force", remedy)
    force = _force(table, n) if "force" in table.values else ()
    way = table.choice("saturation", WAYS, WAYS[0]) if force else ""
    return Limits(force, way, _drift(table) if "drift" in table.values else None)


def _force(table: Table, n: int) -> tuple[Fraction, ...]:
    """n positive numbers, or one that stands for all of them."""
    given = table.values["force"]
    rows = given if isinstance(given, list) else [given] * n
    expected = f"{n} numbers, or one for all, each from 1e-6 to 1e9, in N m and N"
    remedy = "write what the actuators give in either direction, without quotes"
    if len(rows) != n:
        raise table.fault("force", expected, described(given), remedy)
    found = []
    for place, one in enumerate(rows, start=1):
        value = number(one)
        if value is None or not LEAST <= value <= MOST:
            where = f"force, entry {place}" if rows is given else "force"
            raise table.fault(where, expected, described(one), remedy)
        found.append(value)
    return tuple(found)


def _drift(table: Table) -> Fraction:
    value = number(table.values["drift"])
    if value is None or not LEAST_DRIFT <= value <= MOST_DRIFT:
        found = described(table.values["drift"])
        remedy = "write drift = 1e-4, or leave it out for 1e-4 in float and 1e-6 in double"
        raise table.fault("drift", "a number from 1e-6 to 0.1", found, remedy)
    return value
