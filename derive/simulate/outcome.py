"""What came of each run, read while it flies: no trajectory is kept."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from derive.simulate.loop import Moment, square
from derive.simulate.space import Array, Space

OUTCOMES = (
    *("settled", "settling_time", "energy", "peak_force", "crossings"),
    *("final_height", "final_rate", "worst_status", "drift"),
)
"""Columns of a result, in their order; docs/sweep.md says what each is."""

STEEPEST = 4.0
"""Of nu_u over nu_e, away from the cut.

The norm of d log is (a/2)/sin(a/2) at angle a: pi/2 where SO(3) is cut at a = pi, and 4 at
a = 1.79 pi on the sphere of quaternions, which is cut at 2 pi. A crossing turns nu_u over, a
jump of twice the angle of the cut, 2 pi and 4 pi; of half of that for half the logarithm.
"""

JUMP = 1.0
"""rad, that may be noise."""


class Watch:
    """The figures of N loops, kept up to date; settle bounds both the height and |nu_e|."""

    def __init__(self, space: Space, settle: float, period: float, loops: int) -> None:
        self._space, self._settle, self._period = space, settle, period
        self._turns = space.turns
        self._seen, self._last = 0, np.full(loops, -1)
        self._peak = np.zeros(loops)
        self._worst = np.zeros(loops, dtype=np.int64)
        self._crossings = np.zeros(loops, dtype=np.int64)
        self._before: tuple[Array, Array] | None = None
        self._rate, self._first = np.zeros(loops), (np.zeros(loops), np.zeros(loops))

    def see(self, moment: Moment) -> None:
        """The next instant."""
        rate = norm(moment.nu_e)
        calm = (moment.height <= self._settle) & (rate <= self._settle)
        self._last[~calm] = self._seen  # so is a NaN
        np.maximum(self._peak, norm(moment.force), out=self._peak)
        np.maximum(self._worst, moment.command.status, out=self._worst)
        if self._turns:
            self._count(moment.command.nu_u[self._turns], rate)
        if not self._seen:
            self._first = (moment.height, rate)
        self._seen, self._moment, self._rate = self._seen + 1, moment, rate

    def start(self) -> tuple[Array, Array]:
        """Height and |nu_e| at the first instant, (N,) each."""
        return self._first

    def outcomes(self) -> dict[str, Array]:
        """Columns (N,) by the names of OUTCOMES."""
        body = self._moment.body
        settled = self._last < self._seen - 1
        found = (
            settled,
            np.where(settled, (self._last + 1) * self._period, np.nan),
            np.sqrt(body.effort),
            self._peak,
            self._crossings,
            self._moment.height,
            self._rate,
            self._worst,
            self._space.drift(body.g),
        )
        return dict(zip(OUTCOMES, found, strict=True))

    def _count(self, nu_u: Array, rate: Array) -> None:
        if self._before is not None:
            before, rate_before = self._before
            self._crossings += crosses(before, nu_u, np.maximum(rate_before, rate), self._period)
        self._before = nu_u, rate


def crosses(before: Array, after: Array, rate: Array, period: float) -> NDArray[np.bool_]:
    """Where nu_u (turns, N) jumps within a period as no motion at |nu_e| = rate (N,) moves it."""
    return np.asarray(norm(after - before) > JUMP + STEEPEST * period * rate)


def norm(x: Array) -> Array:
    """Of each column, (N,)."""
    return np.asarray(np.sqrt(square(x)))
