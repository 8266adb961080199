"""The inertia of a rigid body: made from mass, centre of mass and moments, and recognised.

Kinetic energy with the centre of mass at c in body axes: 1/2 w'J w + 1/2 m |v + w x c|^2, with
rotation before translation and J about the centre of mass.
"""

import re
from dataclasses import dataclass
from fractions import Fraction
from itertools import accumulate, pairwise

from derive.vehicle.check import Matrix, check_triangle
from derive.vehicle.key import BODY_KEYS
from derive.vehicle.text import InputError, shown

IN_FLUID = (
    "describe the body by mass, center and moments below [body] in place of the inertia; for one "
    "that carries fluid with it write [options] added_mass = true"
)


@dataclass(frozen=True)
class Kind:
    """How a body moves: coordinates of rotation, then of translation; whether it is one body."""

    turns: int
    moves: int
    is_body: bool = True

    @property
    def dim(self) -> int:
        """Rows of its inertia."""
        return self.turns + self.moves

    @property
    def has_arm(self) -> bool:
        """Whether its centre of mass can be elsewhere than at the origin."""
        return self.turns > 0 and self.moves > 0

    @property
    def keys(self) -> tuple[str, ...]:
        """What its [body] consists of."""
        there = {"mass": self.moves > 0, "center": self.has_arm, "moments": self.turns > 0}
        return tuple(key for key in BODY_KEYS if there.get(key, True))


KINDS = {
    "SO2": Kind(1, 0),
    "SO3": Kind(3, 0),
    "S3": Kind(3, 0),
    "SE2": Kind(1, 2),
    "SE3": Kind(3, 3),
    "SE23": Kind(3, 6, is_body=False),
}
"""What moves on a group, by its name; on R^n a point. No other group has a [body]."""


def kinds(group: str) -> list[Kind]:
    """What moves on each factor of a group; nothing where one of them is not known here."""
    found = [_kind(factor) for factor in group.split(" x ")]
    known = [kind for kind in found if kind]
    return known if len(known) == len(found) else []


def _kind(factor: str) -> Kind | None:
    if re.fullmatch(r"R[1-9]\d?", factor, re.ASCII):
        return Kind(0, int(factor[1:]))
    return KINDS.get(factor)


def lever(arm: tuple[Fraction, ...], turns: int) -> Matrix:
    """L, (moves, turns): v + L w is the velocity at the tip of the arm, from v and w at its foot.

    In space L w = w x c, so L = -c^; in the plane L = (-c_y, c_x).
    """
    zero = Fraction()
    if (turns, len(arm)) == (3, 3):
        x, y, z = arm
        return ((zero, z, -y), (-z, zero, x), (y, -x, zero))
    if (turns, len(arm)) == (1, 2):
        return ((-arm[1],), (arm[0],))
    return ((zero,) * turns,) * len(arm)


def rigid(mass: Fraction, moments: Matrix, arm: Matrix) -> Matrix:
    """[[J + m L'L, m L'], [m L, m 1]], (n, n), of moments J (turns, turns) and lever L."""
    turns, n = len(moments), len(moments) + len(arm)

    def entry(i: int, j: int) -> Fraction:
        if i > j:
            return entry(j, i)
        if j < turns:
            return moments[i][j] + mass * sum((row[i] * row[j] for row in arm), Fraction())
        if i < turns:
            return mass * arm[j - turns][i]
        return mass if i == j else Fraction()

    return tuple(tuple(entry(i, j) for j in range(n)) for i in range(n))


def check_rigid(file: str, group: str, inertia: Matrix) -> None:
    """Raise InputError for an inertia, positive definite, that no rigid body on the group has.

    Factor by factor where none is coupled to another; coupled ones are told nothing, and neither
    is an inertia that does not fit the group, which `check_facts` tells.
    """
    factors, moving = group.split(" x "), kinds(group)
    ends = list(accumulate((kind.dim for kind in moving), initial=0))
    if ends[-1] != len(inertia) or _is_coupled(inertia, ends):
        return
    for factor, kind, (start, end) in zip(factors, moving, pairwise(ends), strict=True):
        if kind.is_body:
            is_part = len(factors) > 1
            where = f"inertia, rows {start + 1} to {end} ({factor})" if is_part else "inertia"
            block = tuple(row[start:end] for row in inertia[start:end])
            _check_block(file, where, kind.turns, start, block)


def _is_coupled(inertia: Matrix, ends: list[int]) -> bool:
    """Whether an entry outside the blocks that end there is not zero."""
    return any(
        any(row[:start]) or any(row[end:])
        for start, end in pairwise(ends)
        for row in inertia[start:end]
    )


def _check_block(file: str, where: str, turns: int, start: int, block: Matrix) -> None:
    """Raise InputError unless a block is m 1, m c^ and a J that obeys the triangle inequality."""
    moves = len(block) - turns
    if turns and moves:
        _check_mass(file, where, turns, start, block)
        if turns == moves:
            _check_coupling(file, where, start, block)
    if turns == 3:
        # It is positive definite, as Schur's complement of m 1 in a positive definite block.
        check_triangle(file, _about_centre(block, turns), where)


def _check_mass(file: str, where: str, turns: int, start: int, block: Matrix) -> None:
    """Raise InputError unless the block of translation is m times the identity."""
    mass, n = block[turns][turns], len(block)
    first, last = start + turns + 1, start + n
    for i in range(turns, n):
        for j in range(i, n):
            if block[i][j] != (mass if i == j else 0):
                raise InputError(
                    file,
                    where,
                    f"the mass of a rigid body in rows {first} to {last}, columns {first} to "
                    f"{last}: one number on the diagonal, zeros beside it",
                    f"row {start + i + 1}, column {start + j + 1} is {shown(block[i][j])}, "
                    f"row {first}, column {first} is {shown(mass)}",
                    IN_FLUID,
                )


def _check_coupling(file: str, where: str, start: int, block: Matrix) -> None:
    """Raise InputError unless rotation is coupled to translation by m c^, which is skew."""
    for i in range(3):
        for j in range(i, 3):
            upper, lower = block[i][3 + j], block[j][3 + i]
            if upper != -lower:
                mirror = f", row {start + j + 1}, column {start + i + 4} is {shown(lower)}"
                raise InputError(
                    file,
                    where,
                    f"m c^ of a rigid body in rows {start + 1} to {start + 3}, columns {start + 4} "
                    f"to {start + 6}: skew, so zeros on its diagonal and opposite signs across it",
                    f"row {start + i + 1}, column {start + j + 4} is {shown(upper)}"
                    f"{mirror if i != j else ''}",
                    IN_FLUID,
                )


def _about_centre(block: Matrix, turns: int) -> Matrix:
    """J = A - B B'/m about the centre of mass, of a block [[A, B], [B', m 1]]."""
    if turns == len(block):
        return block
    mass, rows = block[-1][-1], block[:turns]
    return tuple(
        tuple(row[j] - _dot(row[turns:], other[turns:]) / mass for j, other in enumerate(rows))
        for row in rows
    )


def _dot(a: tuple[Fraction, ...], b: tuple[Fraction, ...]) -> Fraction:
    return sum(map(Fraction.__mul__, a, b), Fraction())
