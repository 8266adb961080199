"""Where a law jumps: found by halving along curves, with no word from the law about where.

Along g(t) = exp(t X) the largest change of nu_u over a step of t is followed into the half that
has more of it. Where a law is continuous the change goes to zero with the step.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.law.space import Space

Array = NDArray[Any]
Law = Callable[[Array], Array]  # elements (..., m, m) to nu_u (..., n)

STEPS = 240
HALVINGS = 30
SHARP = 1e-3  # what is left of a change over 1e-11 that belongs to a jump
UNBOUNDED = 1e4  # size of what has no bound, and growth of a slope, over its distance
LENGTH = 6.5  # of a curve: beyond 2 pi
SPARE = 1e-3  # a pole's distance over which its growth is told


@dataclass(frozen=True)
class Cut:
    """One crossing: the element (m, m), its angles, and what nu_u does there.

    size:      largest change of a coordinate vector, inf where there is no bound
    is_steep:  the rate of the law has no bound on the way there
    """

    g: Array
    angles: Array
    size: float
    is_steep: bool


def curves(space: Space, count: int, rng: np.random.Generator) -> Array:
    """Directions X of curves exp(t X), (count, n): unit rates in one factor, less in the others."""
    x = rng.normal(size=(count, len(space.basis)))
    if not space.turns:
        return np.asarray(x / np.linalg.norm(x, axis=1, keepdims=True))
    for row in range(count):
        for order, (place, _) in enumerate(space.turns):
            speed = 1.0 if order == row % len(space.turns) else 0.31
            x[row, place] *= speed / np.linalg.norm(x[row, place])
    return np.asarray(x)


def cuts(space: Space, law: Law, directions: Array) -> list[Cut]:
    """Every crossing of a cut on the curves."""
    t = np.linspace(0.05, LENGTH, STEPS)
    nu = law(space.exp(t[:, None, None] * directions))  # (STEPS, count, n)
    change = _size(np.diff(nu, axis=0))
    peaks = change > 3 * np.median(change, axis=0) + 1e-9
    peaks[1:] &= change[1:] >= change[:-1]
    peaks[:-1] &= change[:-1] >= change[1:]
    found = (_crossing(space, law, directions[j], t[i], t[i + 1]) for i, j in np.argwhere(peaks))
    return [one for one in found if one]


def _crossing(space: Space, law: Law, x: Array, low: float, high: float) -> Cut | None:
    """The jump between two places on one curve, None where there is none."""
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        nu = law(space.exp(np.array([low, middle, high])[:, None] * x))
        if _size(nu[1] - nu[0]) > _size(nu[2] - nu[1]):
            high = middle
        else:
            low = middle
    ends = law(space.exp(np.array([low, high])[:, None] * x))
    size = float(_size(ends[1] - ends[0]))
    if size <= SHARP:
        return None
    g = space.exp((low + high) / 2 * x)
    is_bounded = size <= UNBOUNDED  # what is not a number is not
    size = float(_size(_turning(space, ends[1] - ends[0]))) if is_bounded else np.inf
    return Cut(g, space.angles(g), size, _is_steep(space, law, x, low))


def _size(x: Array) -> Any:
    return np.linalg.norm(x, axis=-1)


def _turning(space: Space, x: Array) -> Array:
    """The angular coordinates: how far a translation jumps depends on how long it is."""
    places = [x[place] for place, _ in space.turns]
    turning = np.concatenate(places) if places else x
    return turning if _size(turning) > SHARP else x


def _is_steep(space: Space, law: Law, x: Array, t: float) -> bool:
    """Whether the slope of nu_u grows like the inverse of the distance to the cut."""
    slopes = [_slope(space, law, x, t, distance) for distance in (SPARE, SPARE / 100)]
    return slopes[1] > 10 * slopes[0]


def _slope(space: Space, law: Law, x: Array, t: float, distance: float) -> float:
    """Largest slope over the directions of the algebra, a little before the cut."""
    g = space.exp((t - distance) * x)
    sides = distance / 20 * np.eye(len(space.basis))
    ahead, behind = (law(g @ space.exp(side)) for side in (sides, -sides))
    return float(_size(ahead - behind).max() / (distance / 10))
