"""Where on a group something happens, and numbers, in words for a table."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.law.exact import Point
from derive.verify.law.space import Space, turning

Array = NDArray[Any]

NEAR = 1e-3  # rad: angles that are told as multiples of pi
SINGULAR = 1e-6
DUST = 1e-12  # told as 0
TURNS = {("S3", 1): "q0 = 0", ("S3", 2): "-i"}
"""(factor, angle over pi) -> the place; elsewhere rotations by pi."""


def named(space: Space, g: Array, angles: Array) -> str:
    """The place of an element: which factor turns by a multiple of pi, or what is singular."""
    found = []
    factors = [one for one in space.group.factors or (space.group,) if turning(one)]
    for order, (one, angle) in enumerate(zip(factors, angles, strict=True)):
        count = round(float(angle) / np.pi)
        if count and abs(angle - count * np.pi) < NEAR:
            place = TURNS.get((one.name, count), "rotations by pi")
            found.append(f"{place} of factor {order + 1}" if len(factors) > 1 else place)
    if found:
        return " and ".join(found)
    if abs(np.linalg.det(g + space.one)) < SINGULAR:
        return "elements with det(g + 1) = 0"
    return f"angle {angles[0]:.3g}" if len(angles) else f"g = {numbers(space.store(g))}"


def where(space: Space, point: Point) -> str:
    """The place of an exact element; `general position` for no particular one."""
    if not point.where:
        return "general position"
    g = np.array(point.g, dtype=float)
    return named(space, g, space.angles(g))


def numbers(values: Iterable[Any]) -> str:
    """A row of numbers: exact ones as they are, others to four digits."""
    return f"({', '.join(_number(value) for value in values)})"


def _number(value: Any) -> str:
    if getattr(value, "is_Rational", False):
        return str(value)
    size = float(value)
    return f"{size if abs(size) > DUST else 0.0:.4g}"
