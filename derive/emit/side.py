"""The steps by which a package tests that its `control` keeps to the way round that it took."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

from derive.emit.literal import exact, nearest

AXIS = (Fraction(2, 7), Fraction(-3, 7), Fraction(6, 7))
"""Of length one, with no zero whose sign could be lost."""

INSIDE, OUTSIDE = Fraction(3, 4), Fraction(5, 4)
"""Of the hysteresis: a scalar part within it, and one beyond."""

KEPT = ((OUTSIDE, 1), (INSIDE, 1), (-INSIDE, 1), (INSIDE, 1), (-INSIDE, 1), (-OUTSIDE, -1),
        (-INSIDE, -1), (INSIDE, -1), (-INSIDE, -1), (OUTSIDE, 1))  # fmt: skip
"""Parts of the hysteresis one after the other, and the side that each leaves."""

GIVEN = (("0", INSIDE, 1), ("0", -INSIDE, -1), ("NOT_A_NUMBER", INSIDE, 1),
         ("NOT_A_NUMBER", -INSIDE, -1), ("7", -INSIDE, 1), ("7", -OUTSIDE, -1),
         ("INFINITE", -INSIDE, 1), ("-INFINITE", INSIDE, -1), ("-7", OUTSIDE, 1),
         ("0", Fraction(0), 1))  # fmt: skip
"""What a side holds before a step, whatever that is."""


def steps(hysteresis: Fraction, scalar: str) -> list[list[str]]:
    """Rows as C initialises them: before, scalar, vector, after, is_kept, is_near."""
    rows = [("1" if place else "0", "0", part, after) for place, (part, after) in enumerate(KEPT)]
    rows += [("0", *one) for one in GIVEN]
    return [list(_row(*row, hysteresis, scalar)) for row in rows]


def _row(
    is_kept: str, before: str, part: Fraction, after: int, hysteresis: Fraction, scalar: str
) -> Iterator[str]:
    w = part * hysteresis
    yield before if "N" in before else exact(float(before), scalar)
    yield exact(float(nearest(w, scalar)), scalar)
    yield exact(float(nearest(Fraction(math.sqrt(1 - w * w)), scalar)), scalar)
    yield exact(float(after), scalar)
    yield is_kept
    yield str(int(after * w < hysteresis))


def axis(scalar: str) -> list[str]:
    """The axis as C initialises it."""
    return [exact(float(nearest(x, scalar)), scalar) for x in AXIS]
