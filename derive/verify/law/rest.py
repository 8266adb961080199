"""Where a law vanishes off the identity: the equilibria O_u of g' = -g hat(nu_u(g)).

Newton's method from many elements, with the slope of the law by differences. At an equilibrium
the rank of that slope tells whether it stands alone, and its eigenvalues whether it repels.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.law.space import Space

Array = NDArray[Any]
Law = Callable[[Array], Array]

ITERATIONS = 40
DELTA = 1e-5  # of the differences
NONE = 1e-4  # singular values below, relative to the largest, are zero
FOUND = 1e-9  # |nu_u| at an equilibrium
APART = 1e-2  # its distance from the identity, and its clearance from a cut
LONGEST = 0.5  # step, rad


@dataclass(frozen=True)
class Rest:
    """One equilibrium: the element, its angles, the dimension of the set it lies in.

    repels: nearby states leave it, in at least one direction
    """

    g: Array
    angles: Array
    dimension: int
    repels: bool


def rests(space: Space, law: Law, clearance: Law, starts: Array) -> list[Rest]:
    """The equilibria that are reached from the elements `starts`, (N, m, m)."""
    g = starts
    for _ in range(ITERATIONS):
        nu, slope = law(g), _slopes(space, law, g)
        ok = np.isfinite(slope).all((-1, -2)) & np.isfinite(nu).all(-1)
        g, nu, slope = g[ok], nu[ok], slope[ok]
        step = -(np.linalg.pinv(slope, rcond=NONE) @ nu[..., None])[..., 0]
        length = np.linalg.norm(step, axis=-1, keepdims=True)
        g = g @ space.exp(step * np.minimum(1, LONGEST / np.maximum(length, 1e-300)))
    off = np.abs(g - space.one).max((-1, -2))
    good = (np.linalg.norm(law(g), axis=-1) < FOUND) & (off > APART) & (clearance(g) > APART)
    return [_rest(space, law, one) for one in g[good]]


def _rest(space: Space, law: Law, g: Array) -> Rest:
    slope = _slopes(space, law, g)
    parts = np.linalg.svd(slope, compute_uv=False)
    rank = int((parts > NONE * max(parts[0], NONE)).sum())
    repels = bool((np.linalg.eigvals(-slope).real > NONE).any())
    return Rest(g, space.angles(g), len(slope) - rank, repels)


def _slopes(space: Space, law: Law, g: Array) -> Array:
    """D nu_u along g exp(t X), (..., n, n): column j belongs to direction j."""
    sides = space.exp(DELTA * np.eye(len(space.basis)))
    back = space.exp(-DELTA * np.eye(len(space.basis)))
    ahead, behind = (law(g[..., None, :, :] @ side) for side in (sides, back))
    return np.asarray(np.swapaxes(ahead - behind, -1, -2) / (2 * DELTA))
