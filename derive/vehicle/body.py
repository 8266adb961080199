"""What a [body] says, or a [[body]] for each factor of a product, becomes an inertia."""

from collections.abc import Iterator
from fractions import Fraction

from derive.vehicle.check import Matrix, check_positive_definite, check_symmetric, check_triangle
from derive.vehicle.group import OwnGroup
from derive.vehicle.key import BODY_KEYS, HOMES
from derive.vehicle.number import (
    LARGEST_DIMENSION,
    LARGEST_ENTRY,
    MODERATE,
    column,
    is_moderate,
    matrix,
    positive,
)
from derive.vehicle.rigid import KINDS, Kind, kinds, lever, rigid
from derive.vehicle.text import InputError, Table, described, shown

LARGEST_ARM = Fraction(10**4)  # m

IN_SPACE = (
    "write moments = [[J1, 0, 0], [0, J2, 0], [0, 0, J3]], in kg m^2 about the centre of mass"
)
IN_PLANE = "write moments = 0.1, or what it is in kg m^2 about the centre of mass"
MASS = "write mass = 1.0, or what it is in kg"


def assembled(top: Table, group: str, own: OwnGroup | None) -> Matrix:
    """The inertia (n, n) of the body on a group; of a product, one block for each factor."""
    factors, moving = group.split(" x "), [] if own else kinds(group)
    if not moving or sum(kind.dim for kind in moving) > LARGEST_DIMENSION:
        raise _bodiless(top, group, own)
    blocks = []
    for factor, kind, table in zip(factors, moving, _tables(top, group, factors), strict=True):
        if not kind.is_body:
            raise _bodiless(top, factor, None)
        blocks.append(_of_body(table, factor, kind))
    return _diagonal(blocks)


def has_added_mass(top: Table) -> bool:
    """Whether a body, already assembled, carries fluid with it."""
    return any("added_mass" in each for each in _bodies(top) if isinstance(each, dict))


def _bodies(top: Table) -> list[object]:
    """What stands there of a [body], or of every [[body]]."""
    given = top.values.get("body", [])
    return given if isinstance(given, list) else [given]


def _bodiless(top: Table, group: str, own: OwnGroup | None) -> InputError:
    """The error for a [body] where none can be; first of all that of a group nobody knows."""
    from derive.vehicle.lookup import look_up

    look_up(top.file, group, own)
    known = ", ".join(name for name, kind in KINDS.items() if kind.is_body)
    expected = f"a group of bodies: {known}, R1, R2, ... or a product of them"
    remedy = "write inertia = [[...], ...] at the top of the file in its place"
    return top.fault("body", expected, f"a body on {group}", remedy)


def _tables(top: Table, group: str, factors: list[str]) -> Iterator[Table]:
    """The table of each factor's body, in order."""
    tables = [table for table in _bodies(top) if isinstance(table, dict)]
    is_single = len(factors) == 1
    if len(tables) != len(_bodies(top)):
        remedy = "write [body] on a line of its own, and mass, center and moments below it"
        raise top.fault("body", "a table", described(top.values["body"]), remedy)
    if len(tables) != len(factors):
        expected = f"{len(factors)} bodies, one for each factor of {group}, in order"
        remedy = "write [[body]] once for each factor, and its keys below it"
        if is_single:
            expected, remedy = f"one body, as {group} is no product", "write [body] once"
        raise top.fault("body", expected, f"{len(tables)} of them", remedy)
    for place, table in enumerate(tables, start=1):
        yield Table(top.file, "body" if is_single else f"body {place}", table)


def _of_body(table: Table, factor: str, kind: Kind) -> Matrix:
    """The inertia of one body, (n, n), with what the fluid adds."""
    _check_keys(table, factor, kind.keys)
    mass = positive(table, "mass", LARGEST_ENTRY, MASS) if kind.moves else Fraction()
    arm: tuple[Fraction, ...] = (Fraction(),) * kind.moves
    if kind.has_arm:
        arm = column(table, "center", kind.moves, LARGEST_ARM, "m")
    inertia = rigid(mass, _moments(table, kind), lever(arm, kind.turns))
    if "added_mass" in table.values:
        inertia = _sum(inertia, _added(table, kind.dim))
        check_positive_definite(table.file, inertia, f"{table.name}, with added_mass")
    _check_moderate(table, inertia)
    return inertia


def _check_keys(table: Table, factor: str, known: tuple[str, ...]) -> None:
    """Raise InputError for an unknown key, and for one that says nothing of such a body."""
    for key in table.values:
        if key in BODY_KEYS and key not in known:
            expected = f"{', '.join(known)}: all that there is of a body on {factor}"
            raise table.fault(key, expected, "a key that says nothing there", f"remove {key}")
    table.only(known, HOMES)


def _moments(table: Table, kind: Kind) -> Matrix:
    """Moments about the centre of mass, (turns, turns), those of a rigid body."""
    if kind.turns < 2:
        return ((positive(table, "moments", LARGEST_ENTRY, IN_PLANE),),) if kind.turns else ()
    moments = matrix(table, "moments", IN_SPACE, kind.turns)
    key = f"{table.name}.moments"
    check_symmetric(table.file, moments, key)
    check_positive_definite(table.file, moments, key)
    check_triangle(table.file, moments, key, "what a fluid adds belongs to added_mass")
    return moments


def _added(table: Table, n: int) -> Matrix:
    """What the fluid adds, (n, n), symmetric."""
    remedy = f"give all {n} rows of {n} numbers, rotation before translation"
    added = matrix(table, "added_mass", remedy, n)
    check_symmetric(table.file, added, f"{table.name}.added_mass")
    return added


def _sum(a: Matrix, b: Matrix) -> Matrix:
    return tuple(tuple(map(Fraction.__add__, *rows)) for rows in zip(a, b, strict=True))


def _diagonal(blocks: list[Matrix]) -> Matrix:
    """The blocks on the diagonal of one matrix, zeros elsewhere."""
    n = sum(map(len, blocks))
    rows: list[tuple[Fraction, ...]] = []
    for block in blocks:
        before = (Fraction(),) * len(rows)
        after = (Fraction(),) * (n - len(rows) - len(block))
        rows += [(*before, *row, *after) for row in block]
    return tuple(rows)


def _check_moderate(table: Table, inertia: Matrix) -> None:
    """Raise InputError for an entry that would vanish or be absurd, though what made it is not."""
    for i, row in enumerate(inertia, start=1):
        for j, entry in enumerate(row, start=1):
            if not is_moderate(entry):
                raise InputError(
                    table.file,
                    table.name,
                    f"a body whose whole inertia has entries {MODERATE}",
                    f"row {i}, column {j} of its inertia is {shown(entry, 6)}",
                    "check the units: kg, m and kg m^2",
                )
