"""Runge-Kutta methods as tables, and one step of any of them.

In the chart of the step's start (Munthe-Kaas) a method keeps its order and never leaves the group.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from derive.simulate.space import Array

State = tuple[Array, ...]


@dataclass(frozen=True)
class Method:
    """An explicit method: rows of its tableau, its weights; nodes are the sums of the rows."""

    name: str
    order: int
    rows: tuple[tuple[float, ...], ...]
    weights: tuple[float, ...]

    @cached_property
    def nodes(self) -> tuple[float, ...]:
        """Where in the step each stage lies, 0 to 1."""
        return tuple(float(sum(map(Fraction, row))) for row in self.rows)


def step(
    method: Method, rates: Callable[[float, State], State], t: float, h: float, state: State
) -> State:
    """The state after h seconds; rates(t, state) are the rates of its parts."""
    slopes: list[State] = []
    for node, row in zip(method.nodes, method.rows, strict=True):
        slopes.append(rates(t + node * h, _moved(state, h, row, slopes)))
    return _moved(state, h, method.weights, slopes)


def _moved(state: State, h: float, weights: Sequence[float], slopes: Sequence[State]) -> State:
    """Each part plus h times a combination of its slopes, summed in their order."""
    used = [(h * w, slope) for w, slope in zip(weights, slopes, strict=True) if w]
    parts = list(state)
    for w, slope in used:
        parts = [part + w * rate for part, rate in zip(parts, slope, strict=True)]
    return tuple(parts)


def _table(text: str) -> tuple[tuple[float, ...], ...]:
    return tuple(
        tuple(float(Fraction(word)) for word in line.split()) for line in text.strip().split("\n")
    )


KUTTA = Method(
    "Kutta's of order 4",
    4,
    ((), (0.5,), (0.0, 0.5), (0.0, 0.0, 1.0)),
    (1 / 6, 1 / 3, 1 / 3, 1 / 6),
)
"""For a held force: four evaluations of the plant."""

BUTCHER = Method(
    "Butcher's of order 6",
    6,
    (
        (),
        *_table("""
1/3
0 2/3
1/12 1/3 -1/12
-1/16 9/8 -3/16 -3/8
0 9/8 -3/8 -3/4 1/2
9/44 -9/11 63/44 18/11 0 -16/11
"""),
    ),
    tuple(float(Fraction(w)) for w in "11/120 0 27/40 27/40 -4/15 -4/15 11/120".split()),
)
"""For a controller without sampling: seven calls of it."""
