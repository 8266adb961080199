"""Exact numbers, columns and matrices of a vehicle file, and how large they may be."""

from fractions import Fraction

from derive.vehicle.check import Matrix
from derive.vehicle.text import Table, described, shown

SMALLEST = Fraction(1, 10**30)  # below it, a number that is not 0 would vanish in a float
LARGEST_ENTRY = Fraction(10**9)
LARGEST_DIMENSION = 24  # rows of an inertia; SE(2,3) has 9

MODERATE = f"at most {shown(LARGEST_ENTRY)} in absolute value, 0 or above 1e-30"


def number(given: object) -> Fraction | None:
    """An exact number, or nothing for whatever else stands there; a boolean is not a number."""
    if isinstance(given, bool) or not isinstance(given, int | Fraction):
        return None
    return Fraction(given)


def is_moderate(value: Fraction, most: Fraction = LARGEST_ENTRY) -> bool:
    """Whether a number is 0, or neither vanishes in a float nor is larger than `most`."""
    return not value or SMALLEST <= abs(value) <= most


def positive(
    table: Table, key: str, most: Fraction, remedy: str, least: Fraction = SMALLEST
) -> Fraction:
    """The number under a key that must be there, greater than 0 and of moderate size."""
    expected = f"a number greater than 0 (at least {shown(least)}) and at most {shown(most)}"
    given = table.require(key, expected, remedy)
    value = number(given)
    if value is None or not least <= value <= most:
        raise table.fault(key, expected, described(given), remedy)
    return value


def column(table: Table, key: str, n: int, most: Fraction, unit: str) -> tuple[Fraction, ...]:
    """The n numbers under a key, in that unit, at most `most` each; zeros when left out."""
    given = table.values.get(key, [0] * n)
    expected = f"an array of {n} numbers of at most {shown(most)} in absolute value"
    remedy = f"write {key} = {[0.0] * n}, in {unit}, or leave the key out for that"
    if not isinstance(given, list) or len(given) != n:
        raise table.fault(key, expected, described(given), remedy)
    values = [number(each) for each in given]
    for place, value in enumerate(values, start=1):
        if value is None or not is_moderate(value, most):
            where = f"{key}, entry {place}"
            raise table.fault(where, expected, described(given[place - 1]), remedy)
    return tuple(value for value in values if value is not None)


def matrix(table: Table, key: str, remedy: str, size: int | None = None) -> Matrix:
    """The square matrix under a key that must be there, of `size` rows where that is given."""
    rows = table.require(key, "an array of rows", remedy)
    if not isinstance(rows, list) or not rows or not isinstance(rows[0], list):
        raise table.fault(key, "an array of rows, each an array", described(rows), remedy)
    n = len(rows)
    if size is not None and n != size:
        raise table.fault(key, f"{size} rows of {size} numbers", f"{n} rows", remedy)
    if n > LARGEST_DIMENSION:
        most = f"at most {LARGEST_DIMENSION} rows"
        raise table.fault(key, most, f"{n} rows", "give the inertia of one vehicle")
    return tuple(
        _row(table, f"{key}, row {place}", row, place, n) for place, row in enumerate(rows, 1)
    )


def _row(table: Table, where: str, row: object, place: int, n: int) -> tuple[Fraction, ...]:
    """One row of a matrix, the place-th: n numbers of moderate size."""
    if not isinstance(row, list) or len(row) != n:
        expected = f"an array of {n} numbers, as there are {n} rows"
        raise table.fault(where, expected, described(row), f"make the matrix {square(n)}")
    entries = []
    for at, given in enumerate(row, start=1):
        value = number(given)
        if value is None or not is_moderate(value):
            remedy = "write a decimal number in kg m^2, without quotes"
            if value is not None and abs(value) < SMALLEST and at != place:
                remedy = "write 0: a coupling that small is none"
            found = described(given)
            raise table.fault(f"{where}, column {at}", f"a number of {MODERATE}", found, remedy)
        entries.append(value)
    return tuple(entries)


def square(n: int) -> str:
    """A size in words."""
    return f"{n} by {n}"
