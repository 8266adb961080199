"""The ladder of the package's own test: error angles from nothing to either side of the cut."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from derive.verify.oracle.matrix_factor import Factor
from derive.verify.oracle.matrix_group import dim, exp, factors, store, times
from derive.verify.oracle.own_factor import Own
from derive.verify.oracle.precise import mp
from derive.verify.plant import Plant

TINY = {"f64": "1e-160", "f32": "1e-30"}
"""An angle whose square is next to nothing, or nothing."""

CLOSE = {"f64": "1e-9", "f32": "1e-5"}
"""Distance from the cut, rad, that the product g_r^-1 g still resolves."""

SMALL = ("1e-12", "1e-8", "1e-4", "1e-2")
MIDDLE = ("0.1", "0.5", "1", "1.5", "2", "2.5", "3")
BEYOND = ("3.5", "4", "5", "6")
"""Further angles on S3, where a quaternion and its negative differ."""

FEW = (("1e-12", True), ("1e-2", True), ("0.5", True), ("2", True), ("2.5", True))
"""Angles where the truth is made of matrices and takes ten times as long."""

OWN = (("0", False), ("1e-12", False), ("1e-4", True), ("0.1", True), ("0.5", True), ("1", True))
"""Norms of hat(x) on a user's group, of whose elements only those near the identity are known."""

SLOW, FAST = 2.0**-10, 2.0**9
"""Paces, exact in every scalar, of a force that needs no limit and of one that does."""

REFERENCES = 3
"""So many moving references take turns."""

OTHERS = "0.625"
"""Angle of the factors whose turn it is not, rad."""

NOISE = mp.mpf(10) ** -100
"""Where an entry of a rotation by pi is this small, it is zero: the cut is met exactly."""


@dataclass(frozen=True)
class Rung:
    """An error: its angle [rad] is `rest`, or so much beyond the cut of the law.

    is_moving: whether the reference is neither the identity nor at rest
    at_cut:    then all factors turn by it, otherwise the one whose turn it is
    axis:      by number; any where None
    of_state:  whether g is turned so, whatever the error is then
    pace:      what velocities and loads are multiplied with
    is_half:   whether the cut is meant that is half as far: where the shorter way changes
    """

    rest: str
    is_moving: bool
    at_cut: bool = False
    axis: int | None = None
    of_state: bool = False
    pace: float = 1.0
    is_half: bool = False

    def angle(self, cut: Any) -> Any:
        """The angle to 130 digits, of a factor with its cut there."""
        return cut * self.at_cut / (1 + self.is_half) + mp.mpf(self.rest)

    @property
    def doc(self) -> str:
        """It in words."""
        what = {SLOW: "slow, ", FAST: "fast, "}.get(self.pace, "")
        what += "state" if self.of_state else "error"
        if not self.at_cut:
            return f"{what} {self.rest} rad"
        rest, cut = self.rest.lstrip("-"), "half a turn" if self.is_half else "the cut"
        side = "before" if self.rest.startswith("-") else "beyond"
        return f"{what} {rest} rad {side} {cut}" if float(rest) else f"{what} at {cut}"


def ladder(vehicle: Plant, scalar: str, *, is_pole: bool) -> Iterator[Rung]:
    """The rungs of a vehicle; a slow one and a fast one find the limits of a force."""
    yield from (Rung("1e-4", False, pace=SLOW), Rung("0.5", True, pace=FAST))
    if vehicle.own is not None:
        yield from (Rung(rest, is_moving) for rest, is_moving in OWN)
        return
    if not any(one.turns for one in factors(vehicle.space)):
        yield from (Rung("0", False), Rung("1", True))  # nothing turns, all rungs are alike
        return
    yield from (Rung("0", False), Rung(TINY[scalar], False))
    if vehicle.is_attitude:
        beyond = BEYOND if vehicle.group == "S3" else ()
        yield from (Rung(rest, True) for rest in ("0", *SMALL, *MIDDLE, *beyond))
    else:
        yield from (Rung(*one) for one in FEW)
    if is_pole and not vehicle.is_attitude:
        yield Rung(f"-{CLOSE[scalar]}", False, True)  # refused, so that it needs no truth
    if vehicle.hysteresis is not None:
        yield from _at_half(scalar)
    yield from _at_cut(vehicle, scalar)


def _at_half(scalar: str) -> Iterator[Rung]:
    """Either side of half a turn, where q and -q are as far."""
    for rest in ("1e-2", "1e-3", CLOSE[scalar]):
        yield from (Rung(one, True, True, is_half=True) for one in (f"-{rest}", rest))
    yield from (Rung("0", False, True, axis, is_half=True) for axis in range(3))


def _at_cut(vehicle: Plant, scalar: str) -> Iterator[Rung]:
    """Either side of the cut; last of all the middle of the ladder, which bad rows start from."""
    near: tuple[str, ...] = ("-1e-3", "1e-3")
    if vehicle.is_attitude:
        near = ("-1e-2", *near, "1e-2", f"-{CLOSE[scalar]}", CLOSE[scalar])
        yield from (Rung("0", False, True, axis) for axis in range(3))
        yield Rung("0", True, True, 0, of_state=True)
    yield from (Rung(rest, True, True) for rest in near)
    yield from (Rung(("-1e-3", "1e-3")[axis % 2], False, True, axis) for axis in range(3))
    yield Rung("1", True)


def draw(place: int) -> Iterator[float]:
    """Numbers in sixteenths from -2 to 2, of no pattern that a formula could share; no zero."""
    state = 12345 + 7919 * place
    while True:
        state = (state * 1103515245 + 12345) % 2**31
        if sixteenth := state // 2**16 % 65 - 32:
            yield sixteenth / 16


def element(vehicle: Plant, rung: Rung, place: int, is_moving: bool) -> tuple[Any, Any]:
    """g and g_r as they are stored, to 130 digits: g_r^-1 g is an error by the rung's angle."""
    group = vehicle.space
    error, reference = _error(vehicle, rung, place), _reference(vehicle, place, is_moving)
    g = error if rung.of_state else times(reference, error)
    least = NOISE if rung.at_cut else mp.zero
    found = ((x if abs(x) > least else mp.zero for x in store(group, a)) for a in (g, reference))
    return tuple(next(found)), tuple(next(found))


@cache
def _error(vehicle: Plant, rung: Rung, place: int) -> Any:
    """The same for both scalars: an exponential takes longer than the truth about it."""
    return exp(vehicle.space, _coordinates(vehicle, draw(1000 + place), rung, place))


def _reference(vehicle: Plant, place: int, is_moving: bool) -> Any:
    """One of REFERENCES, or the identity."""
    return _turned(vehicle, place % REFERENCES if is_moving else None)


@cache
def _turned(vehicle: Plant, which: int | None) -> Any:
    if which is None:
        return exp(vehicle.space, (0,) * dim(vehicle.space))
    rung = Rung("0.75", is_moving=True)
    return exp(vehicle.space, _coordinates(vehicle, draw(2000 + which), rung))


def _coordinates(
    vehicle: Plant, numbers: Iterator[float], rung: Rung, place: int | None = None
) -> list[Any]:
    """Of an element: the factors take the angle in turn, the others turn by less."""
    parts = factors(vehicle.space)
    turning = [i for i, one in enumerate(parts) if one.turns or isinstance(one, Own)]
    mine = turning[(place or 0) % len(turning)] if turning else -1
    found: list[Any] = []
    for i, one in enumerate(parts):
        is_mine = i == mine or rung.at_cut or place is None
        angle = rung.angle(_cut(one, vehicle.law)) if is_mine else mp.mpf(OTHERS)
        about = _axis(one, numbers, rung.axis)
        found += [angle * x / _length(one, about) for x in about]
        found += [next(numbers) for _ in range(one.dim - len(about))]
    return found


def _cut(one: Factor | Own, law: str) -> Any:
    """Angle at which a law jumps: on S3 that of -i, but for a law that folds its sheets."""
    return +mp.pi * (one.sheets if law != "sign_vec" else 1)


def _axis(one: Factor | Own, numbers: Iterator[float], axis: int | None) -> list[float]:
    """What a factor turns about, of any length."""
    count = one.dim if isinstance(one, Own) else len(one.turns)
    if axis is None:
        return [next(numbers) for _ in range(count)]
    return [float(axis % count == i) for i in range(count)]


def _length(one: Factor | Own, x: Sequence[float]) -> Any:
    """The angle that x turns by; on a user's group the norm of hat(x)."""
    if not isinstance(one, Own):
        return mp.sqrt(mp.fsum(mp.mpf(y) ** 2 for y in x))
    hat = one.hat([mp.mpf(y) for y in x])
    return mp.sqrt(mp.fsum(entry**2 for row in hat for entry in row))
