"""Whose derivations are explained in tests: every vehicle file, every law of rotations, the
logarithm of every other group, and groups of one's own and products with all options."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from derive.vehicle.file import Vehicle
from derive.vehicle.group import OwnGroup, group_of
from derive.vehicle.limits import Limits
from tests.emit.subjects import FILES, LAWFUL, OPTED, STEERED

OPTIONS = ("external", "momentum")


def _matrix(size: int, *ones: tuple[int, int]) -> tuple[tuple[Fraction, ...], ...]:
    return tuple(tuple(Fraction((i, j) in ones) for j in range(size)) for i in range(size))


HEISENBERG = OwnGroup(
    "Heisenberg",
    (_matrix(3, (0, 1)), _matrix(3, (1, 2)), _matrix(3, (0, 2))),
    ("m/s", "1/s", "m/s"),
)
STRETCH = OwnGroup("Aff1", (_matrix(2, (0, 0)), _matrix(2, (0, 1))), ("1/s", "m/s"))


def made(name: str, group: str, own: OwnGroup | None, law: str) -> Vehicle:
    """With momentum and a known force, and an inertia without a zero."""
    bare = replace(
        FILES[0], name=name, group=group, own=own, law=law, options=OPTIONS, limits=Limits()
    )
    n = group_of(bare).dim
    inertia = tuple(
        tuple(Fraction(9 + i) if i == j else Fraction(1 + i + j, 10) for j in range(n))
        for i in range(n)
    )
    return replace(bare, inertia=inertia, controller="gsmc", gains=_GAINS)


_GAINS = (("lambda", Fraction(1, 2)), ("k_s", Fraction(3, 4)))

OPTIONAL = (
    made("heisenberg", "Heisenberg", HEISENBERG, "log"),
    made("affine", "Aff1", STRETCH, "skew"),
    made("product", "S3 x SE2 x R2", None, "log"),
    made("extended", "SE23", None, "log"),
)
_ROTATIONS = ("SO3", "S3")

SUBJECTS = (
    *FILES,
    *(
        one
        for one in LAWFUL
        if one.group in _ROTATIONS or (one.law == "log" and one.group != "SE23")
    ),
    *(one for one in STEERED if one.group in _ROTATIONS),
    *(one for one in OPTED if one.group in _ROTATIONS),
    *OPTIONAL,
)

"""Whose formulas are read back and evaluated."""

DOCUMENTED = (*FILES, *(one for one in LAWFUL if one.group in ("SO2", "R3", "S3")), *OPTIONAL)
"""Whose documents are read whole."""
