"""Dense samples of a group: elements of all rotation angles, by the exponential of its basis."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.law.space import Space

Array = NDArray[Any]

MARGIN = 0.02  # rad: how near to a cut, or to the end, V is differentiated
SMALLEST = 0.02  # rad, or length of coordinates
LONGEST = 4.0  # of coordinates on groups that do not turn
SHIFTS = (0.1, 1.0, 8.0)  # sizes of translations


def cloud(
    space: Space, count: int, rng: np.random.Generator, only: float | None = None
) -> tuple[Array, Array]:
    """Elements (count, m, m) with angles from nearly 0 to nearly the largest, and the angles.

    only: the one angle that all have. Where several factors turn, the first has the angle that
    is told; where none does, it is the length of the coordinates.
    """
    x = rng.normal(size=(count, len(space.basis))) * rng.choice(SHIFTS, (count, 1))
    reach = space.reach - MARGIN if space.turns else LONGEST
    angle = np.linspace(only or SMALLEST, only or reach, count)
    if not space.turns:
        return space.exp(x * (angle / np.linalg.norm(x, axis=1))[:, None]), angle
    for order, (place, _) in enumerate(space.turns):
        wanted = angle if not order else rng.uniform(SMALLEST, np.pi - MARGIN, count)
        x[:, place] *= (wanted / np.linalg.norm(x[:, place], axis=1))[:, None]
    return space.exp(x), angle


def span(function: Callable[[Array], Array], end: float) -> tuple[float, float]:
    """Infimum and supremum of a stated y between 0 and the largest angle."""
    y = function(np.linspace(1e-7, end - 1e-7, 20_001))
    return float(y.min()), float(y.max())
