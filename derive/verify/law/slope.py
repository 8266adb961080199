"""Morse functions from matrices, and how fast they fall under a law: by differences alone.

Each V is written once more, from the paper's formula and the matrix, so that neither the closed
form of V nor that of its rate has a part in the judgement.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.lie.group import Group
from derive.verify.law.space import Space

Array = NDArray[Any]
Values = Callable[[Array], Array]  # of elements (..., m, m), (...)

STEP = 2e-3  # on the scale of 1/(1 + |nu_u|): differences of 6th order end at 1e-12
WEIGHTS = ((1, 45.0), (2, -9.0), (3, 1.0))  # over 60 steps


def _trace(g: Array, size: int) -> Array:
    return np.asarray(np.trace(g[..., :size, :size], axis1=-2, axis2=-1))


def _fold(size: int) -> Values:
    """2 - sqrt(1 + tr R) in space, 2 - sqrt(2 + tr R) in the plane."""
    return lambda g: 2 - np.sqrt(np.maximum(_trace(g, size) + (1 if size == 3 else 2), 0))


def _carried(size: int) -> Values:
    """V_1 of the rotation block, and half the square of the columns beside it."""
    return lambda g: _fold(size)(g) + (g[..., :size, size:] ** 2).sum((-1, -2)) / 2


_PAPER: dict[tuple[str, str], Values] = {
    ("SO2", "V_1"): _fold(2),
    ("SO3", "V_1"): _fold(3),
    ("SO2", "Psi"): lambda g: (2 - _trace(g, 2)) / 2,
    ("SO3", "Psi"): lambda g: (3 - _trace(g, 3)) / 2,
    ("S3", "V_2"): lambda g: np.sqrt(np.maximum(1 - g[..., 0, 0], 0)),
    ("S3", "1 - q0"): lambda g: 1 - g[..., 0, 0],
    ("SE2", "V_1 + |p|^2/2"): _carried(2),
    ("SE3", "V_1 + |p|^2/2"): _carried(3),
    ("SE23", "V_1 + |p|^2/2"): _carried(3),
}


def values(space: Space, name: str) -> Values:
    """V of that name on a group; KeyError where it is not known."""
    group = space.group
    if name == "|log|^2/2":
        return lambda g: (space.log(g) ** 2).sum(-1) / 2
    if name == "|g - 1|^2/2":
        return lambda g: ((g - space.one) ** 2).sum((-1, -2)) / 2
    if group.factors:
        return _added(group, name)
    return _PAPER[group.name, name]


def _added(group: Group, name: str) -> Values:
    """The sum over the factors of a product; each has a block of the matrix."""
    parts = _named_parts(group, name)

    def total(g: Array) -> Array:
        first, found = 0, np.zeros(g.shape[:-2])
        for one, part in parts:
            size = one.basis[0].rows
            block = g[..., first : first + size, first : first + size]
            found, first = found + values(Space(one), part)(block), first + size
        return found

    return total


def _named_parts(group: Group, name: str) -> list[tuple[Group, str]]:
    """Each factor with its own function: names are joined by ` + `, and may have one inside."""
    rest, parts = name, []
    for one in group.factors:
        inside = " + " in rest and (one.name, " + ".join(rest.split(" + ")[:2])) in _PAPER
        words = rest.split(" + ")
        cut = 2 if inside else 1
        parts.append((one, " + ".join(words[:cut])))
        rest = " + ".join(words[cut:])
    return parts


def fall(space: Space, value: Values, g: Array, nu: Array) -> Array:
    """-V' along g' = -g hat(nu), nu held: central differences of sixth order, (...)."""
    step = STEP / (1 + np.abs(nu).max(-1, keepdims=True))
    total = np.zeros(g.shape[:-2])
    for count, weight in WEIGHTS:
        ahead, behind = (value(g @ space.exp(-sign * count * step * nu)) for sign in (1, -1))
        total = total + weight * (ahead - behind)
    return np.asarray(-total / (60 * step[..., 0]))
