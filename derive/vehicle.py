"""A vehicle file becomes a Vehicle, exactly, or one readable error.

Decides which keys a vehicle file has and which values they take. Nothing heavy is imported
before a group or a law has to be looked up.
"""

from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

from derive.control.table import CONTROLLERS
from derive.vehicle_check import (
    check_name,
    check_positive_definite,
    check_symmetric,
    check_triangle,
)
from derive.vehicle_text import InputError, Table, close, described, quoted, read, shown

__all__ = [
    "CONTROLLERS", "Facts", "InputError", "Vehicle", "check_facts", "load", "resolve",
]  # fmt: skip

SCHEMA = 1
SCALARS = ("f32", "f64")
TARGETS = ("c99", "numpy")
DEFAULT_LAW = "log"
DEFAULT_CONTROLLER = "gsmc"

TOP_KEYS = ("schema", "name", "group", "law", "controller", "inertia", "gains", "emit")
EMIT_KEYS = ("scalars", "targets")

SMALLEST = Fraction(1, 10**30)  # below it, a number that is not 0 would vanish in a float
LARGEST_GAIN = Fraction(10**6)
LARGEST_ENTRY = Fraction(10**9)
LARGEST_DIMENSION = 24  # rows of an inertia; SE(2,3) has 9

# Where a key belongs that stands in another table; TOML puts every key below [gains] into it.
_HOMES = {
    **dict.fromkeys(TOP_KEYS, "to the top of the file, above the first [table]"),
    **{gain: "below [gains]" for gains in CONTROLLERS.values() for gain in gains},
    **dict.fromkeys(EMIT_KEYS, "below [emit]"),
}

DIAGONAL = "write [[J1, 0, 0], [0, J2, 0], [0, 0, J3]] for a diagonal inertia"


@dataclass(frozen=True)
class Vehicle:
    """All that a vehicle file says; inertia (n, n) and gains are exact.

    Inertia in kg m^2, and in kg m and kg where the group translates. Gains are in the order of
    their controller in CONTROLLERS, in 1/s.
    """

    name: str
    group: str
    law: str
    controller: str
    inertia: tuple[tuple[Fraction, ...], ...]
    gains: tuple[tuple[str, Fraction], ...]
    scalars: tuple[str, ...]
    targets: tuple[str, ...]
    source: str = field(compare=False)

    @property
    def pattern(self) -> tuple[bool, ...]:
        """Where the upper triangle of the inertia, row by row, is not zero; n(n+1)/2 entries."""
        n = len(self.inertia)
        return tuple(self.inertia[i][j] != 0 for i in range(n) for j in range(i, n))


@dataclass(frozen=True)
class Facts:
    """What must be known of a group to judge an inertia: its dimension n, and if it rotates."""

    dim: int
    is_rotation: bool


def load(path: Path) -> Vehicle:
    """The vehicle a file describes; raises InputError. Says nothing on group and law: resolve."""
    top = read(path)
    top.only(TOP_KEYS, _HOMES)
    _check_schema(top)
    controller = top.choice("controller", tuple(CONTROLLERS), DEFAULT_CONTROLLER)
    gains, emit = top.table("gains"), top.table("emit")
    gains.only(CONTROLLERS[controller], _HOMES)
    emit.only(EMIT_KEYS, _HOMES)
    name = top.word("name", 'a name for the vehicle, such as "cubesat"')
    check_name(top.file, name)
    return Vehicle(
        name=name,
        group=top.word("group", 'the name of a group, such as "SO3"'),
        law=top.word("law", 'the name of a kinematic law, such as "log"', DEFAULT_LAW),
        controller=controller,
        inertia=_inertia(top),
        gains=tuple((gain, _gain(gains, gain)) for gain in CONTROLLERS[controller]),
        scalars=emit.choices("scalars", SCALARS),
        targets=emit.choices("targets", TARGETS),
        source=str(path),
    )


def check_facts(vehicle: Vehicle, facts: Facts) -> None:
    """Raise InputError unless the inertia has the group's dimension and can be a body's."""
    n = len(vehicle.inertia)
    if n != facts.dim:
        raise InputError(
            vehicle.source,
            "inertia",
            f"{_square(facts.dim)}: {vehicle.group} has dimension {facts.dim}",
            _square(n),
            "give an inertia of that size, or change the group",
        )
    if facts.is_rotation and facts.dim == 3:  # the moments of a body in space
        check_triangle(vehicle.source, vehicle.inertia)


def resolve(vehicle: Vehicle) -> Facts:
    """Look up group and law, whose modules are imported only here; raises InputError."""
    facts = look_up(vehicle.source, vehicle.group)
    check_law(vehicle.source, vehicle.group, vehicle.law)
    return facts


def check_law(file: str, group: str, law: str) -> None:
    """Raise InputError unless the law exists on that group, which is known."""
    from derive.control.kinematic import LAWS

    there = laws_on(group)
    if law not in there:
        expected, found, remedy = _unknown("law", law, there)
        elsewhere = [other for other, name in LAWS if name == law]
        if elsewhere:
            found = f"{quoted(law)}, which exists only on {', '.join(elsewhere)}"
        raise InputError(file, "law", f"{expected} (the laws that exist on {group})", found, remedy)


def look_up(file: str, group: str) -> Facts:
    """The facts of a group or a product; raises InputError for a factor nobody knows."""
    from derive.lie.catalogue import GROUPS, named

    for factor in group.split(" x "):
        if factor.strip() not in GROUPS:
            known = (*GROUPS, "and products of them such as SO3 x R3")
            _, told, remedy = _unknown("group", factor.strip(), tuple(GROUPS))
            raise InputError(file, "group", f"one of {', '.join(known)}", told, remedy)
    found = named(group)
    return Facts(dim=found.dim, is_rotation=found.is_rotation)


def laws_on(group: str) -> tuple[str, ...]:
    """Names of the kinematic laws that exist on a group."""
    from derive.control.kinematic import laws_of
    from derive.lie.catalogue import named

    return tuple(laws_of(named(group)))


def _unknown(key: str, word: str, known: tuple[str, ...]) -> tuple[str, str, str]:
    """Expected, found and remedy for a word that is not known."""
    meant = close(word, known)
    remedy = f'write {key} = "{meant}", the nearest' if meant else f"choose a {key} of that list"
    return f"one of {', '.join(known)}", described(word), remedy


def _check_schema(top: Table) -> None:
    """Raise InputError for a schema that this version does not read; left out, it is the newest."""
    schema = top.values.get("schema", SCHEMA)
    if isinstance(schema, bool) or schema != SCHEMA:
        remedy = f"write schema = {SCHEMA}, or install the version of derive the file is for"
        raise top.fault("schema", f"the number {SCHEMA}", described(schema), remedy)


def _inertia(top: Table) -> tuple[tuple[Fraction, ...], ...]:
    """The inertia, (n, n): exact, symmetric and positive definite."""
    rows = top.require("inertia", "an array of rows", DIAGONAL)
    if not isinstance(rows, list) or not rows or not isinstance(rows[0], list):
        raise top.fault("inertia", "an array of rows, each an array", described(rows), DIAGONAL)
    n = len(rows)
    if n > LARGEST_DIMENSION:
        most = f"at most {LARGEST_DIMENSION} rows"
        raise top.fault("inertia", most, f"{n} rows", "give the inertia of one vehicle")
    inertia = tuple(_row(top, number, row, n) for number, row in enumerate(rows, start=1))
    check_symmetric(top.file, inertia)
    check_positive_definite(top.file, inertia)
    return inertia


def _row(top: Table, number: int, row: object, n: int) -> tuple[Fraction, ...]:
    """One row of the inertia: n numbers of moderate size."""
    where = f"inertia, row {number}"
    if not isinstance(row, list) or len(row) != n:
        expected = f"an array of {n} numbers, as there are {n} rows"
        raise top.fault(where, expected, described(row), f"make the matrix {_square(n)}")
    expected = f"a number of at most {shown(LARGEST_ENTRY)} in absolute value, 0 or above 1e-30"
    entries = []
    for column, given in enumerate(row, start=1):
        value = _number(given)
        if value is None or (value and not SMALLEST <= abs(value) <= LARGEST_ENTRY):
            remedy = "write a decimal number in kg m^2, without quotes"
            if value is not None and abs(value) < SMALLEST and column != number:
                remedy = "write 0: a coupling that small is none"
            raise top.fault(f"{where}, column {column}", expected, described(given), remedy)
        entries.append(value)
    return tuple(entries)


def _gain(gains: Table, name: str) -> Fraction:
    """One gain: positive, and of moderate size."""
    expected = f"a number greater than 0 (at least 1e-30) and at most {shown(LARGEST_GAIN)}"
    remedy = f"write {name} = 1.0, or another positive number without quotes, below [gains]"
    given = gains.require(name, expected, remedy)
    value = _number(given)
    if value is None or not SMALLEST <= value <= LARGEST_GAIN:
        raise gains.fault(name, expected, described(given), remedy)
    return value


def _number(given: object) -> Fraction | None:
    """An exact number, or nothing for whatever else stands there; a boolean is not a number."""
    if isinstance(given, bool) or not isinstance(given, int | Fraction):
        return None
    return Fraction(given)


def _square(n: int) -> str:
    return f"{n} by {n}"
