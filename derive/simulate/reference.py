"""Motions to follow: a first configuration and a velocity with its exact rate, over time.

The configuration itself is integrated with the plant, by the same steps, so that g_r' = g_r
hat(nu_r) holds whatever the group is.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from derive.simulate.space import Array

EDGE = 1e-12  # of a table's length: how far beyond its ends rounding may move a time


@dataclass(frozen=True)
class Reference:
    """g_r(0), (k, 1), and t -> nu_r and nu_r', (n, 1) each, velocities in its own body frame.

    is_at_rest: it never leaves the identity, where one without a reference goes
    brief:      seconds in which it has changed; infinite where it never does
    """

    start: Array
    at: Callable[[float], tuple[Array, Array]]
    is_at_rest: bool = False
    brief: float = math.inf


@dataclass(frozen=True)
class Course:
    """A reference as plain numbers, which travel to another process; equal ones fly alike.

    kind:  of KINDS, where what its rows hold is said
    start: stored numbers of g_r(0), (k,)
    rows:  the numbers of the kind
    """

    kind: str
    start: tuple[float, ...]
    rows: tuple[tuple[float, ...], ...]

    def reference(self) -> Reference:
        """The motion; raises KeyError for an unknown kind."""
        start = np.array(self.start, dtype=np.float64)[:, None]
        return KINDS[self.kind](start, [np.array(row, dtype=np.float64) for row in self.rows])


def rest(start: Array, dim: int) -> Reference:
    """At the identity `start`, without moving."""
    still = np.zeros((dim, 1))
    return Reference(start, lambda t: (still, still), is_at_rest=True)


def steady(start: Array, nu_r: Array) -> Reference:
    """A constant body velocity nu_r (n, 1)."""
    still = np.zeros_like(nu_r)
    return Reference(start, lambda t: (nu_r, still))


def slew(start: Array, along: Array, seconds: float) -> Reference:
    """From rest to rest along exp(hat(along)), (n, 1), at a speed of 2772 p^5 (1 - p)^5/seconds.

    p = t/seconds. Velocity and five rates of it are zero at the ends, so that a step of order 6
    which ends a little after the slew loses nothing.
    """

    def at(t: float) -> tuple[Array, Array]:
        p = min(max(t / seconds, 0.0), 1.0)
        bump = (p * (1 - p)) ** 4
        speed = 2772 * bump * p * (1 - p) / seconds
        gain = 13860 * bump * (1 - 2 * p) / (seconds * seconds)
        return along * speed, along * gain

    return Reference(start, at, brief=seconds)


def tabled(start: Array, times: Array, nu_r: Array, nu_r_dot: Array) -> Reference:
    """Through velocities and their rates at given times, (rows,) and (rows, n), by cubics.

    The cubic of each interval takes both at its ends, so nu_r_dot is the exact rate of nu_r.
    Before the first and after the last row the velocity of that row is kept; at these rows the
    rate is still that of the cubic, which a step that starts or ends there needs.
    """
    knots = [float(t) for t in times]
    slack = EDGE * (knots[-1] - knots[0])

    def at(t: float) -> tuple[Array, Array]:
        if t < knots[0] - slack or t > knots[-1] + slack:
            return _held(nu_r[0 if t < knots[0] else -1])
        i = min(max(bisect_right(knots, t) - 1, 0), len(knots) - 2)
        long = knots[i + 1] - knots[i]
        p = (t - knots[i]) / long
        value, rate = cubic(p)
        ends = np.stack([nu_r[i], long * nu_r_dot[i], nu_r[i + 1], long * nu_r_dot[i + 1]])
        velocity = sum(w * end for w, end in zip(value, ends, strict=True))
        gain = sum(w * end for w, end in zip(rate, ends, strict=True))
        return np.asarray(velocity)[:, None], np.asarray(gain)[:, None] / long

    return Reference(start, at)


def _held(velocity: Array) -> tuple[Array, Array]:
    return velocity[:, None], np.zeros((len(velocity), 1))


def cubic(p: float) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Hermite's four cubics at p in [0, 1], and their rates by p."""
    q = 1 - p
    value = ((1 + 2 * p) * q * q, p * q * q, p * p * (3 - 2 * p), -p * p * q)
    rate = (-6 * p * q, (1 - 3 * p) * q, 6 * p * q, p * (3 * p - 2))
    return value, rate


def _tabled(start: Array, rows: list[Array]) -> Reference:
    table = np.stack(rows)
    half = (table.shape[1] + 1) // 2
    return tabled(start, table[:, 0], table[:, 1:half], table[:, half:])


KINDS: dict[str, Callable[[Array, list[Array]], Reference]] = {
    "rest": lambda start, rows: rest(start, len(rows[0])),
    "steady": lambda start, rows: steady(start, rows[0][:, None]),
    "slew": lambda start, rows: slew(start, rows[0][:, None], float(rows[1][0])),
    "table": _tabled,
}
"""Rows of a course. rest: n zeros; steady: nu_r; slew: `along`, then (seconds,); table: one row
(t, nu_r, nu_r_dot) per time."""
