"""Where laws jump: the rotation of each factor, its distance from the cut, the side across it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from derive.verify.limits import LIMITS
from derive.verify.oracle import truth
from derive.verify.oracle.factor_law import lifted, turning
from derive.verify.oracle.matrix_function import combine, identity, solve
from derive.verify.oracle.matrix_group import coordinates, element, factors
from derive.verify.plant import Plant

mp = truth.mp

SMOOTH = ("skew", "vec")
"""Laws that jump nowhere."""


@dataclass(frozen=True)
class Turn:
    """The error of one factor, to 130 digits.

    name: of the factor; matrix: the element, where the truth has one; q: unit quaternion of its
    rotation, None where nothing turns
    """

    name: str
    matrix: Any
    q: Any

    @property
    def sine(self) -> float:
        """Sine of half the angle, 0 where nothing turns."""
        return float(truth.mp.norm(self.q[1:])) if self.q else 0.0


def turns(vehicle: Plant, found: dict[str, Any]) -> tuple[Turn, ...]:
    """The errors that a truth was told of."""
    if "lifted" not in found:
        return (Turn(vehicle.group, None, found["q"]),)
    pairs = zip(vehicle.factors, found["lifted"], strict=True)
    return tuple(Turn(name, at.matrix, at.q) for name, at in pairs)


def at_cut(error: tuple[Turn, ...], eps: float) -> tuple[int, ...]:
    """Factors whose rotation is by pi, but for rounding."""
    near = LIMITS["either side"].figure * eps
    pairs = enumerate(error)
    return tuple(i for i, at in pairs if at.q and at.name != "S3" and abs(at.q[0]) < near)


def clearance(vehicle: Plant, error: tuple[Turn, ...]) -> Any:
    """Distance from where the law jumps, by its definition in the table of laws."""
    return min(_clearance(at, vehicle.law, vehicle.own is not None) for at in error)


def _clearance(at: Turn, law: str, is_own: bool) -> Any:
    if is_own and law == "cayley":
        m = len(at.matrix)
        _, det = solve(combine((1, at.matrix), (1, identity(m))), identity(m))
        return abs(det) / 2**m
    if law in SMOOTH or at.q is None:
        return mp.one
    w = at.q[0]
    if at.name != "S3" or law == "sign_vec":
        return abs(w)
    return mp.norm(at.q[1:]) if w < 0 else mp.one


def rotations(
    vehicle: Plant, g: list[float], nu: list[float], flips: tuple[int, ...]
) -> dict[str, Any]:
    """Law and rate in the coordinates of rotations, 0 in the others: (n,) each, and the turns.

    flips: factors that are taken across the cut
    """
    parts = factors(vehicle.space)
    velocities = [piece for _, piece in coordinates(vehicle.space, nu)]
    found: dict[str, Any] = {"nu_u": (), "nu_u_dot": (), "turns": ()}
    rows = zip(parts, vehicle.factors, element(vehicle.space, g), velocities, strict=True)
    for place, (one, name, a, x) in enumerate(rows):
        at = lifted(one, a, flip=place in flips)
        value, speed = turning(at, vehicle.law, x)
        found["nu_u"] += (*value, *(mp.zero,) * (one.dim - len(value)))
        found["nu_u_dot"] += (*speed, *(mp.zero,) * (one.dim - len(speed)))
        found["turns"] += (Turn(name, a, at.q),)
    return found
