"""The group a vehicle moves on: spelled by name, or described in a [group] table."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from derive.lie.basis import BadBasis, Basis, Matrix, check
from derive.vehicle.key import GROUP_KEYS, HOMES
from derive.vehicle.number import number
from derive.vehicle.text import Table, described, quoted

if TYPE_CHECKING:
    from derive.lie.group import Group
    from derive.vehicle.file import Vehicle

LARGEST_PART = 10**6  # numerator and denominator of an entry of a basis
LONGEST_WORD = 48  # characters of a group's name
WORD = re.compile(r"[A-Za-z][A-Za-z0-9_]*", re.ASCII)
UNIT = re.compile(r"[A-Za-z0-9(][A-Za-z0-9/^.() -]{0,23}(?<! )", re.ASCII)  # safe in a comment of C
RATIO = re.compile(r"\s*([+-]?\d{1,9})\s*/\s*(\d{1,9})\s*", re.ASCII)
VECTORS = re.compile(r"([RT])([1-9]\d?)", re.ASCII)  # R^n and T(n), one group
DEFAULT_UNIT = "1/s"

EXAMPLE = 'name = "SL2" and basis = [[[0, 1], [0, 0]], [[0, 0], [1, 0]], [[1, 0], [0, -1]]]'


@dataclass(frozen=True)
class OwnGroup:
    """A group that a vehicle file describes: n basis matrices (m, m), units of a velocity."""

    name: str
    basis: Basis
    units: tuple[str, ...]


def spelled(top: Table) -> tuple[str, OwnGroup | None]:
    """The group's name, and the group itself where the file describes it."""
    if isinstance(top.values.get("group"), dict):
        own = _own(top.table("group"))
        return own.name, own
    word = top.word("group", 'the name of a group, such as "SO3" or "SO3 x R3", or a [group] table')
    return normal(word), None


def normal(group: str) -> str:
    """A name with single spaces, and with T(n), the translations of n-space, as the R^n it is."""
    factors = " ".join(group.split()).split(" x ")
    vectors = (VECTORS.fullmatch(factor) for factor in factors)
    pairs = zip(factors, vectors, strict=True)
    return " x ".join(f"R{found[2]}" if found else factor for factor, found in pairs)


def _own(table: Table) -> OwnGroup:
    """What a [group] table describes: a name, a basis of matrices and a unit for each of them."""
    table.only(GROUP_KEYS, HOMES)
    name = table.word("name", "a name for the group")
    if not WORD.fullmatch(name) or len(name) > LONGEST_WORD:
        expected = (
            f"letters, digits and underscores, a letter first, at most {LONGEST_WORD} of them"
        )
        raise table.fault("name", expected, quoted(name), 'write name = "mine", or another word')
    basis = _basis(table)
    return OwnGroup(name, basis, _units(table, len(basis)))


def _basis(table: Table) -> Basis:
    """The matrices under basis, exact, which span an algebra."""
    expected = "an array of square matrices, each an array of rows"
    given = table.require("basis", expected, EXAMPLE)
    places = enumerate(_list(table, "basis", given, "square matrices"), start=1)
    matrices = tuple(_matrix(table, f"basis, E_{k}", matrix) for k, matrix in places)
    try:
        check(matrices)
    except BadBasis as fault:
        raise table.fault("basis", fault.expected, fault.found, fault.remedy) from None
    return matrices


def _matrix(table: Table, where: str, given: object) -> Matrix:
    """One matrix of the basis, of whatever shape."""
    places = enumerate(_list(table, where, given, "rows"), start=1)
    return tuple(_row(table, f"{where}, row {i}", row) for i, row in places)


def _row(table: Table, where: str, given: object) -> tuple[Fraction, ...]:
    places = enumerate(_list(table, where, given, "numbers"), start=1)
    return tuple(_entry(table, f"{where}, column {j}", entry) for j, entry in places)


def _list(table: Table, where: str, given: object, of: str) -> list[Any]:
    if not isinstance(given, list):
        raise table.fault(where, f"an array of {of}", described(given), EXAMPLE)
    return given


def _entry(table: Table, where: str, given: object) -> Fraction:
    """One entry of a matrix: a number or a ratio in quotes, exact and of moderate size."""
    ratio = RATIO.fullmatch(given) if isinstance(given, str) else None
    value = number(given)
    if ratio and int(ratio[2]):
        value = Fraction(int(ratio[1]), int(ratio[2]))
    if value is None or max(abs(value.numerator), value.denominator) > LARGEST_PART:
        expected = (
            'an exact number, as 2, -0.5 or "1/3", that is a ratio of whole numbers of at most '
            f"{LARGEST_PART}"
        )
        raise table.fault(where, expected, described(given), "write a simpler number there")
    return value


def _units(table: Table, n: int) -> tuple[str, ...]:
    """The unit of each coordinate of a velocity."""
    given = table.values.get("units", [DEFAULT_UNIT] * n)
    expected = f'an array of {n} units of a velocity, one for each matrix, such as "rad/s"'
    remedy = f"write units = {[DEFAULT_UNIT] * n}, or leave it out for that".replace("'", '"')
    if not isinstance(given, list) or len(given) != n:
        raise table.fault("units", expected, described(given), remedy)
    for place, unit in enumerate(given, start=1):
        if not isinstance(unit, str) or not UNIT.fullmatch(unit):
            kinds = "at most 24 letters, digits and / ^ . ( ) - or spaces"
            raise table.fault(f"units, entry {place}", kinds, described(unit), remedy)
    return tuple(given)


def law_of(top: Table, default: str) -> str:
    """The name of the law, at the top of the file or below [group]."""
    expected = f'the name of a kinematic law, such as "{default}"'
    law = top.word("law", expected, default)
    group = top.values.get("group")
    if not isinstance(group, dict) or "law" not in group:
        return law
    inner = top.table("group").word("law", expected)
    if "law" in top.values and inner != law:
        remedy = "keep one of the two"
        found = f"{quoted(inner)}, and {quoted(law)} at the top of the file"
        raise top.fault("group.law", "one law", found, remedy)
    return inner


def group_of(vehicle: Vehicle) -> Group:
    """The group of a vehicle, which resolved: its own, or the catalogue's."""
    return made(vehicle.group, vehicle.own)


def made(name: str, own: OwnGroup | None) -> Group:
    """The group itself, which imports computer algebra; KeyError for a name nobody knows."""
    if own is None:
        from derive.lie.catalogue import named

        return named(name)
    from derive.lie.own import of_basis

    return of_basis(own.name, own.basis, own.units)
