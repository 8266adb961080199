"""How a statement is judged: its verdict follows from flights, by one rule for each kind.

Where a statement speaks of an instant without saying how near is near, all thresholds of a range
are tried: one that does for all its numbers has to be found.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from derive.simulate.flight import Flight
from derive.simulate.reading import settled_between
from derive.simulate.space import Array

REPRODUCED = "reproduced"
AT_SOME = "reproduced at some thresholds"  # an order, which others reverse
AT_ONE = "reproduced at one threshold"  # numbers, all of them together
NOT_AT_ONE = "not at one threshold"
NOT = "not reproduced"
VERDICTS = (REPRODUCED, AT_SOME, AT_ONE, NOT_AT_ONE, NOT)

THREE = ("gsmc", "lsf", "pd_plus")
Flights = Mapping[str, Flight]
"""The paper's three controllers in one scenario; `lsf` is one of its two forms."""


@dataclass(frozen=True)
class Finding:
    """What was measured, in words and as numbers, and what follows.

    best, least, most: the threshold that fits best, where one is searched, and the ends of those
    that do; None for none
    residual: how far the worst number is off at the best threshold
    """

    verdict: str
    measured: str
    numbers: tuple[float, ...]
    quantity: str = ""
    best: float | None = None
    least: float | None = None
    most: float | None = None
    residual: float | None = None

    @property
    def threshold(self) -> str:
        """At which threshold, in words."""
        best = "" if self.best is None else f"{self.quantity} = {told(self.best)}"
        if self.least is None or self.most is None:
            return best
        ends = f"{told(self.least)} to {told(self.most)}"
        return f"{best} ({ends})" if best else f"{self.quantity} = {ends}"


def told(threshold: float) -> str:
    """A threshold in words."""
    return f"{threshold:.3g}" if threshold >= 0.1 else f"{threshold:.1e}"


Judge = Callable[[Flights], Finding]


@dataclass(frozen=True)
class Quantity:
    """Values whose settling is looked at, and the thresholds that are tried."""

    name: str
    values: Callable[[Flight], Array]
    thresholds: Array = field(compare=False)

    def times(self, flights: Flights) -> Array:
        """Settling times at each threshold, (3, M), in the order of THREE."""
        return np.stack([
            settled_between(flights[name].t, self.values(flights[name]), self.thresholds)
            for name in THREE
        ])  # fmt: skip


PSI = Quantity("Ψ", lambda flight: flight.height, np.geomspace(1e-2, 1e-12, 401))
RATE = Quantity("‖Ω_e‖", lambda flight: flight.rate_error(), np.geomspace(1e-1, 1e-5, 201))
BEGUN = Quantity(
    "Ψ/Ψ(0)", lambda flight: flight.height / flight.height[0], 1 - np.geomspace(1e-3, 0.3, 251)
)

Numbers = Callable[[Array], Array]
"""Settling times (3, M) -> the numbers that a statement gives, (k, M)."""


def search(
    quantity: Quantity, said: Sequence[float], within: float, of: Numbers = lambda times: times
) -> Judge:
    """The numbers of a statement, each met within some seconds, at one and the same threshold."""

    def judge(flights: Flights) -> Finding:
        found = of(quantity.times(flights))
        off = np.abs(found - np.array(said)[:, None])
        off[np.isnan(off)] = np.inf
        worst = off.max(axis=0)
        if not np.isfinite(worst).any():
            return Finding(NOT, "does not settle at any threshold", ())
        best = int(worst.argmin())
        numbers = tuple(float(x) for x in found[:, best])
        off_by = f"off by {worst[best]:.2f} s at most, {within:g} allowed"
        said_so = f"{' / '.join(f'{x:.2f}' for x in numbers)} s, {off_by}"
        ends = _ends(quantity.thresholds[worst <= within])
        return Finding(_met(off <= within), said_so, numbers, quantity.name,
                       float(quantity.thresholds[best]), *ends, float(worst[best]))  # fmt: skip

    return judge


def _met(is_near: Array) -> str:
    """The verdict on numbers that are near at some thresholds, (k, M).

    NOT_AT_ONE where each of them has a threshold, but not all the same.
    """
    together = is_near.all(axis=0)
    if together.all():
        return REPRODUCED
    if together.any():
        return AT_ONE
    return NOT_AT_ONE if is_near.any(axis=1).all() else NOT


def _ends(thresholds: Array) -> tuple[float | None, float | None]:
    if not len(thresholds):
        return None, None
    return float(thresholds.min()), float(thresholds.max())


def order(quantity: Quantity, last: Sequence[str]) -> Judge:
    """Whether those controllers settle after all others, at each threshold that all reach."""

    def judge(flights: Flights) -> Finding:
        times = quantity.times(flights)
        kept = ~np.isnan(times).any(axis=0)
        if not kept.any():
            return Finding(NOT, "does not settle at any threshold", ())
        late = [THREE.index(name) for name in last]
        early = [i for i in range(len(THREE)) if i not in late]
        ahead = (times[late].min(axis=0) - times[early].max(axis=0))[kept]
        holds = ahead > 0
        numbers = float(ahead.min()), float(ahead.max())
        late_by = f"{numbers[0]:.2f} to {numbers[1]:.2f} s later"
        verdict = REPRODUCED if holds.all() else AT_SOME if holds.any() else NOT
        ends = _ends(quantity.thresholds[kept][holds])
        return Finding(verdict, f"{late_by}; {_share(holds)}", numbers, quantity.name,
                       None, *ends)  # fmt: skip

    return judge


def _share(holds: Array) -> str:
    """At how many of the thresholds (M,) that all reach an order holds, in words."""
    found, every = int(holds.sum()), len(holds)
    return (
        f"holds at all {every} thresholds"
        if found == every
        else f"holds at {found} of {every} thresholds"
    )


def measured(of: Callable[[Flights], tuple[bool, str, tuple[float, ...]]]) -> Judge:
    """A statement without a threshold: it holds or not."""

    def judge(flights: Flights) -> Finding:
        holds, words, numbers = of(flights)
        return Finding(REPRODUCED if holds else NOT, words, numbers)

    return judge
