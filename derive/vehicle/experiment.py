"""What a vehicle file says of flights: the motion to follow, and what a closed loop meets.

Nothing here changes what is emitted. Left out, a vehicle is flown for 30 s to rest at the identity
from an error of half a unit and a velocity of a tenth in every coordinate.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from derive.vehicle.key import HOMES, REFERENCE_KEYS, SIMULATE_KEYS
from derive.vehicle.number import LARGEST_ENTRY, MODERATE, is_moderate, number
from derive.vehicle.text import Table, described, shown

KINDS = {"rest": ("g_r",), "rate": ("g_r", "nu_r"), "slew": ("g_r", "along", "duration"),
         "file": ("file",)}  # fmt: skip
"""Kind of reference -> the keys that belong to it, the needed ones last."""

Numbers = tuple[Fraction, ...]

LONGEST, FASTEST = Fraction(10**6), Fraction(10**6)  # s, Hz


@dataclass(frozen=True)
class Course:
    """The motion to follow, as written: its kind and the numbers of that kind.

    g_r:     stored numbers where it starts; empty for the identity
    nu_r:    rate: constant body velocity (n,)
    along:   slew: it ends at g_r exp(hat(along)), (n,)
    duration: slew: how long that takes
    file:    file: a CSV beside the vehicle file
    """

    kind: str = "rest"
    g_r: Numbers = ()
    nu_r: Numbers = ()
    along: Numbers = ()
    duration: Fraction = Fraction(0)
    file: Path | None = None


@dataclass(frozen=True)
class Experiment:
    """A closed loop as written; (n,) in the coordinates of the algebra, SI units.

    duration, rate:      s; of the controller in Hz, None for a continuous one
    step:                longest step of the integration; None for one that fits the loop
    turn, nu:            first error, g(0) = g_r(0) exp(hat(turn)), and first body velocity
    momentum, external:  internal momentum of wheels at the start; known force
    disturbance, wave:   constant force that the controller is not told; amplitude of a periodic
                         one at `hertz`
    noise_g, noise_nu:   standard deviations of what is measured
    force_limit:         of the actuators; empty for none
    inertia_error:       relative, of the plant against what the controller has
    """

    course: Course = Course()
    duration: Fraction = Fraction(30)
    rate: Fraction | None = None
    step: Fraction | None = None
    turn: Numbers = ()
    nu: Numbers = ()
    momentum: Numbers = ()
    external: Numbers = ()
    disturbance: Numbers = ()
    wave: Numbers = ()
    hertz: Fraction = Fraction(0)
    noise_g: Fraction = Fraction(0)
    noise_nu: Fraction = Fraction(0)
    force_limit: Numbers = ()
    inertia_error: Fraction = Fraction(0)


def experiment(top: Table, n: int) -> Experiment:
    """The [reference] and [simulate] tables of a vehicle of dimension n. Raises InputError."""
    table = top.table("simulate")
    table.only(SIMULATE_KEYS, HOMES)
    columns = {key: _column(table, key, n) for key in COLUMNS if key in table.values}
    scalars = {key: _scalar(table, key, *bounds)
               for key, bounds in SCALARS.items() if key in table.values}  # fmt: skip
    for key in ("momentum", "external"):
        if key in columns and not top.table("options").values.get(key):
            expected, found = f"a vehicle with {key} = true below [options]", "one without"
            remedy = f"write that, so that the controller is told of it, or leave {key} out"
            raise table.fault(key, expected, found, remedy)
    limits = columns.get("force_limit", ())
    if any(one <= 0 for one in limits):
        remedy = "write what the actuators give, in either direction"
        raise table.fault("force_limit", "numbers greater than 0", _listed(limits), remedy)
    said: dict[str, Any] = {**columns, **scalars}  # each of the type of its own field
    return Experiment(course=_course(top, n), **said)


COLUMNS = ("turn", "nu", "momentum", "external", "disturbance", "wave", "force_limit")

SCALARS = {
    "duration": (Fraction(1, 1000), LONGEST, "s"),
    "rate": (Fraction(1, 1000), FASTEST, "Hz"),
    "step": (Fraction(1, 10**6), Fraction(1), "s"),
    "hertz": (Fraction(0), FASTEST, "Hz"),
    "noise_g": (Fraction(0), Fraction(1, 10), "rad or m"),
    "noise_nu": (Fraction(0), LARGEST_ENTRY, "of the velocity's units"),
    "inertia_error": (Fraction(-9, 10), Fraction(10), "relative"),
}
"""Key -> least, most, unit."""


def _course(top: Table, n: int) -> Course:
    table = top.table("reference")
    table.only(REFERENCE_KEYS, HOMES)
    kind = table.choice("kind", tuple(KINDS), _likely(table))
    _refuse_others(table, kind)
    wanted = KINDS[kind][1:]
    if kind == "file":
        name = table.word("file", 'the name of a CSV file, such as "motion.csv"')
        return Course(kind, file=Path(top.file).parent / name)
    for key in wanted:
        table.require(key, f"what a reference of kind {kind} follows", f"write {key} = ...")
    return Course(
        kind=kind,
        g_r=_list(table, "g_r"),
        nu_r=_column(table, "nu_r", n) if "nu_r" in wanted else (),
        along=_column(table, "along", n) if "along" in wanted else (),
        duration=_scalar(table, "duration", *SCALARS["duration"]) if "duration" in wanted
        else Fraction(0),
    )  # fmt: skip


def _likely(table: Table) -> str:
    """The kind that the keys speak of, where none is written."""
    own = {"nu_r": "rate", "along": "slew", "file": "file"}
    return next((kind for key, kind in own.items() if key in table.values), "rest")


def _refuse_others(table: Table, kind: str) -> None:
    """Raise InputError for a key of another kind of reference."""
    for key in table.values:
        if key not in ("kind", *KINDS[kind]):
            owners = [one for one, keys in KINDS.items() if key in keys]
            remedy = f'write kind = "{owners[0]}", or leave {key} out'
            expected = f"keys of kind {kind}: {', '.join(KINDS[kind])}"
            raise table.fault(key, expected, f"a key of kind {' or '.join(owners)}", remedy)


def _column(table: Table, key: str, n: int) -> Numbers:
    """n numbers, or one that stands for all of them."""
    given = table.values[key]
    rows = given if isinstance(given, list) else [given] * n
    expected = f"{n} numbers, or one for all, each of {MODERATE}"
    remedy = f"write {key} = {[0.0] * n}, or other numbers in SI units"
    if len(rows) != n:
        raise table.fault(key, expected, described(given), remedy)
    values = [number(one) for one in rows]
    for place, value in enumerate(values, start=1):
        if value is None or not is_moderate(value):
            where = f"{key}, entry {place}" if rows is given else key
            raise table.fault(where, expected, described(rows[place - 1]), remedy)
    return tuple(value for value in values if value is not None)


def _scalar(table: Table, key: str, least: Fraction, most: Fraction, unit: str) -> Fraction:
    value = number(table.values[key])
    expected = f"a number from {shown(least)} to {shown(most)} [{unit}]"
    if value is None or not least <= value <= most:
        found = described(table.values[key])
        raise table.fault(key, expected, found, f"write {key} as a decimal number in that range")
    return value


def _list(table: Table, key: str) -> Numbers:
    """The stored numbers of a configuration, however many; rows of a matrix count as well."""
    given = table.values.get(key, [])
    rows = given if isinstance(given, list) else [given]
    flat = [x for row in rows for x in (row if isinstance(row, list) else [row])]
    values = [number(one) for one in flat]
    for place, value in enumerate(values, start=1):
        if value is None or abs(value) > LARGEST_ENTRY:
            found = described(flat[place - 1])
            remedy = "write the stored numbers of a configuration, a matrix row by row"
            raise table.fault(f"{key}, entry {place}", "a number", found, remedy)
    return tuple(value for value in values if value is not None)


def _listed(values: Numbers) -> str:
    return ", ".join(shown(value) for value in values)
