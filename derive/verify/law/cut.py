"""Where a law jumps: found by halving along curves, with no word from the law about where.

Along g(t) = g_0 exp(t X) the largest change of nu_u over a step of t is followed into the half
that has more of it. Where a law is continuous the change goes to zero with the step. g_0 is the
identity where a group turns, and elsewhere, as exp need not reach every element, also others.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.law.space import Space

Array = NDArray[Any]
Law = Callable[[Array], Array]  # elements (..., m, m) to nu_u (..., n)

STEPS = 240
HALVINGS = 30
SHARP = 1e-3  # what is left over 1e-11 of a change, beside 1 + |nu_u|, that belongs to a jump
UNBOUNDED = 1e4  # size of what has no bound, and growth of a slope, over its distance
LENGTH = 6.5  # of a curve: beyond 2 pi
AWAY = 3.0  # length of the coordinates of each factor of g_0
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


@dataclass(frozen=True)
class Curve:
    """g_0 exp(t X): the element (m, m) it starts from, and its direction (n,)."""

    space: Space
    start: Array
    x: Array

    def at(self, t: Array | float) -> Array:
        """The element at each t, (..., m, m)."""
        return np.asarray(self.start @ self.space.exp(np.asarray(t)[..., None] * self.x))


def curves(space: Space, count: int, rng: np.random.Generator) -> list[Curve]:
    """`count` curves from the identity and, where nothing turns, twice as many from elsewhere."""
    found = [Curve(space, space.one, x) for x in _directions(space, count, rng)]
    if not space.turns:
        for x in _directions(space, 2 * count, rng):
            a, b = space.exp(AWAY * _directions(space, 2, rng))
            found.append(Curve(space, a @ b, x))
    return found


def _directions(space: Space, count: int, rng: np.random.Generator) -> Array:
    """Directions (count, n): unit rates in one factor that turns, less in the others."""
    x = rng.normal(size=(count, len(space.basis)))
    if not space.turns:
        return np.asarray(x / np.linalg.norm(x, axis=1, keepdims=True))
    for row in range(count):
        for order, (place, _) in enumerate(space.turns):
            speed = 1.0 if order == row % len(space.turns) else 0.31
            x[row, place] *= speed / np.linalg.norm(x[row, place])
    return np.asarray(x)


def cuts(law: Law, along: Sequence[Curve]) -> list[Cut]:
    """Every crossing of a cut on the curves."""
    t = np.linspace(0.05, LENGTH, STEPS)
    nu = np.stack([law(curve.at(t)) for curve in along], axis=1)  # (STEPS, count, n)
    change = _size(np.diff(nu, axis=0))
    peaks = change > 3 * np.median(change, axis=0) + 1e-9
    peaks[1:] &= change[1:] >= change[:-1]
    peaks[:-1] &= change[:-1] >= change[1:]
    found = (_crossing(law, along[j], t[i], t[i + 1]) for i, j in np.argwhere(peaks))
    return [one for one in found if one]


def _crossing(law: Law, curve: Curve, low: float, high: float) -> Cut | None:
    """The jump between two places on one curve, None where there is none."""
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        nu = law(curve.at(np.array([low, middle, high])))
        if _size(nu[1] - nu[0]) > _size(nu[2] - nu[1]):
            high = middle
        else:
            low = middle
    ends = law(curve.at(np.array([low, high])))
    size = float(_size(ends[1] - ends[0]))
    if size <= SHARP * (1 + _size(ends).min()):
        return None
    g, space = curve.at((low + high) / 2), curve.space
    is_bounded = size <= UNBOUNDED  # what is not a number is not
    size = float(_size(_turning(space, ends[1] - ends[0]))) if is_bounded else np.inf
    return Cut(g, space.angles(g), size, _is_steep(law, curve, low))


def _size(x: Array) -> Any:
    return np.linalg.norm(x, axis=-1)


def _turning(space: Space, x: Array) -> Array:
    """The angular coordinates: how far a translation jumps depends on how long it is."""
    places = [x[place] for place, _ in space.turns]
    turning = np.concatenate(places) if places else x
    return turning if _size(turning) > SHARP else x


def _is_steep(law: Law, curve: Curve, t: float) -> bool:
    """Whether the slope of nu_u grows like the inverse of the distance to the cut."""
    slopes = [_slope(law, curve, t, distance) for distance in (SPARE, SPARE / 100)]
    return slopes[1] > 10 * slopes[0]


def _slope(law: Law, curve: Curve, t: float, distance: float) -> float:
    """Largest slope over the directions of the algebra, a little before the cut."""
    g, space = curve.at(t - distance), curve.space
    sides = distance / 20 * np.eye(len(space.basis))
    ahead, behind = (law(g @ space.exp(side)) for side in (sides, -sides))
    return float(_size(ahead - behind).max() / (distance / 10))
