"""A reference motion in a CSV file: times, configurations, velocities and their rates, row by row.

The first line names the columns: t, g_0 …, nu_r_0 …, and, where they are known, nu_r_dot_0 ….
"""

from __future__ import annotations

import csv
import math
import stat
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from statistics import median

from derive.vehicle.text import LARGEST_FILE, InputError, quoted

WIDEST_GAP = 1.5  # of the usual distance of two rows

Row = tuple[float, ...]


@dataclass(frozen=True)
class Motion:
    """Rows of a file: t (rows,), g (rows, k), nu_r and nu_r_dot (rows, n); g may be empty.

    lines: the line of the file each row stands on
    """

    t: Row
    g: tuple[Row, ...]
    nu_r: tuple[Row, ...]
    nu_r_dot: tuple[Row, ...]
    lines: tuple[int, ...]


def read_motion(path: Path, stored: int, dim: int) -> Motion:
    """The motion in a file of k = stored and n = dim columns; InputError names the line."""
    names, rows = _cells(path)
    wanted = ["t", *_named("g", stored), *_named("nu_r", dim)]
    rates = _named("nu_r_dot", dim)
    if names not in (wanted, [*wanted, *rates]):
        found = ", ".join(names)
        raise _fault(path, 1, f"the columns {', '.join(wanted)}, and {', '.join(rates)} if known",
                     quoted(found), "name the columns in that order in the first line")  # fmt: skip
    lines = tuple(line for line, _ in rows)
    numbers = [_numbers(path, line, names, cells) for line, cells in rows]
    if len(numbers) < 2:
        raise _fault(path, 1, "two rows of numbers or more", f"{len(numbers)}", "give the motion")
    t = tuple(row[0] for row in numbers)
    _check_times(path, t, lines)
    nu_r = tuple(row[1 + stored : 1 + stored + dim] for row in numbers)
    known = tuple(row[1 + stored + dim :] for row in numbers)
    dots = known if len(names) > len(wanted) else _slopes(t, nu_r)
    return Motion(t, tuple(row[1 : 1 + stored] for row in numbers), nu_r, dots, lines)


def _named(stem: str, size: int) -> list[str]:
    return [f"{stem}_{i}" for i in range(size)]


def _cells(path: Path) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """The names in the first line, and the cells of every other that is not empty."""
    expected = "a CSV file: UTF-8, columns named in its first line"
    try:
        told = path.stat()
        if not stat.S_ISREG(told.st_mode):  # a pipe could block, a device have no end
            found = "a directory" if stat.S_ISDIR(told.st_mode) else "not a regular file"
            raise InputError(str(path), "", expected, found, "name one file")
        if told.st_size > 256 * LARGEST_FILE:
            remedy = "give fewer rows: between them the velocity is a cubic"
            raise InputError(str(path), "", expected, "more than 256 MiB", remedy)
        with path.open(encoding="utf-8-sig", newline="") as file:
            lines = [(place, [cell.strip() for cell in cells])
                     for place, cells in enumerate(csv.reader(file), start=1)]  # fmt: skip
    except (OSError, UnicodeDecodeError, csv.Error) as fault:
        reason = getattr(fault, "strerror", None) or str(fault)
        remedy = "check [reference] file, which is looked for beside the vehicle file"
        raise InputError(str(path), "", expected, reason, remedy) from None
    if not lines:
        raise InputError(str(path), "", expected, "an empty file", "give the motion to follow")
    return lines[0][1], [(place, cells) for place, cells in lines[1:] if any(cells)]


def _numbers(path: Path, line: int, names: list[str], cells: list[str]) -> Row:
    if len(cells) != len(names):
        raise _fault(path, line, f"{len(names)} cells", f"{len(cells)}", "fill the row")
    return tuple(_number(path, line, *pair) for pair in zip(names, cells, strict=True))


def _number(path: Path, line: int, name: str, cell: str) -> float:
    try:
        value = float(cell)
    except ValueError:
        value = math.nan
    if not math.isfinite(value) or abs(value) > 1e9:
        found = quoted(cell) if cell else "an empty cell"
        raise _fault(path, line, f"a finite number of at most 1e9 in column {name}", found,
                     "mend that cell, or leave the row out")  # fmt: skip
    return value


def _check_times(path: Path, t: Row, lines: tuple[int, ...]) -> None:
    """Raise InputError where time does not increase, or where rows are missing."""
    apart = [later - earlier for earlier, later in pairwise(t)]
    usual = median(apart)
    for gap, line, at in zip(apart, lines[1:], t[1:], strict=True):
        if gap <= 0:
            raise _fault(path, line, "a time after that of the row above", f"t = {at!r}",
                         "sort the rows by time, each time once")  # fmt: skip
        if gap > WIDEST_GAP * usual:
            raise _fault(path, line, f"a row about {usual:.6g} s after the one above",
                         f"a gap of {gap:.6g} s", "give the rows that are missing")  # fmt: skip


def _slopes(t: Row, nu: tuple[Row, ...]) -> tuple[Row, ...]:
    """Rates by differences of the neighbours, one-sided at the ends."""
    last = len(t) - 1
    pairs = [(max(i - 1, 0), min(i + 1, last)) for i in range(len(t))]
    return tuple(
        tuple((b - a) / (t[j] - t[i]) for a, b in zip(nu[i], nu[j], strict=True)) for i, j in pairs
    )


def _fault(path: Path, line: int, expected: str, found: str, remedy: str) -> InputError:
    return InputError(str(path), f"line {line}", expected, found, remedy)
