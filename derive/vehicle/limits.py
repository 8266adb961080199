"""The [limits] table of a vehicle file: what the actuators give, and what drift is fine."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from derive.vehicle.key import HOMES, LIMIT_KEYS
from derive.vehicle.number import number
from derive.vehicle.text import Table, described

LEAST, MOST = Fraction(1, 10**9), Fraction(10**9)
WORDS = {"f32": "2e-6", "f64": "1e-14"}
LEAST_DRIFT = {scalar: Fraction(word) for scalar, word in WORDS.items()}
"""By scalar: the error of two correctly rounded elements is no nearer to the group than that."""

MOST_DRIFT = Fraction(1, 10)
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


def limits(top: Table, n: int, scalars: Sequence[str]) -> Limits:
    """The limits of a vehicle of dimension n, emitted in some scalars. Raises InputError."""
    table = top.table("limits")
    table.only(LIMIT_KEYS, HOMES)
    if "saturation" in table.values and "force" not in table.values:
        remedy = "write force = ..., or leave saturation out"
        raise table.fault("saturation", "a force to be limited", "no force", remedy)
    force = _force(table, n) if "force" in table.values else ()
    way = table.choice("saturation", WAYS, WAYS[0]) if force else ""
    return Limits(force, way, _drift(table, scalars) if "drift" in table.values else None)


def _force(table: Table, n: int) -> tuple[Fraction, ...]:
    """n positive numbers, or one that stands for all of them."""
    given = table.values["force"]
    rows = given if isinstance(given, list) else [given] * n
    expected = f"{n} numbers, or one for all, each from 1e-9 to 1e9, in N m and N"
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


def _drift(table: Table, scalars: Sequence[str]) -> Fraction:
    """A number that the params of every scalar may hold."""
    value = number(table.values["drift"])
    coarsest = max(scalars, key=LEAST_DRIFT.__getitem__)
    if value is not None and LEAST_DRIFT[coarsest] <= value <= MOST_DRIFT:
        return value
    expected = f"a number from {WORDS[coarsest]} to 0.1"
    remedy = "write drift = 1e-4, or leave it out for 1e-4 in float and 1e-6 in double"
    if value is not None and any(LEAST_DRIFT[one] <= value <= MOST_DRIFT for one in scalars):
        expected += f", since rounding to {coarsest} alone leads that far off the group"
        remedy += ', or write scalars = ["f64"] below [emit]'
    raise table.fault("drift", expected, described(table.values["drift"]), remedy)
