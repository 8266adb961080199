"""How long a step may be, from how fast the closed loop is at rest at its reference."""

from __future__ import annotations

import numpy as np

from derive.simulate.craft import Craft
from derive.simulate.pilot import pilot
from derive.simulate.space import space_of

SLOW, SAMPLED = 0.05, 0.01  # s, the longest step of a continuous and of a sampled loop
PART = 0.1  # of the fastest time constant: a step of order 6 then errs by 1e-11
NUDGE = 1e-3  # of the velocity, in its units


def longest(craft: Craft, rate: float | None) -> float:
    """The longest step, s, for a controller of that rate in Hz, None for a continuous one.

    With the force held the plant alone is integrated, whose motion does not depend on gains.
    """
    return SAMPLED if rate is not None else min(SLOW, PART / fastest(craft))


def fastest(craft: Craft) -> float:
    """Largest change of the acceleration by a change of the velocity, 1/s, at e and at rest."""
    space = space_of(craft)
    n = space.dim
    still, nudged = np.zeros((n, n)), NUDGE * np.eye(n)
    e = np.repeat(space.identity, n, 1)
    given = {"g": e, "nu": nudged, "momentum": still, "external": still}
    if craft.controller != "reaching":
        given |= {"g_r": e, "nu_r": still, "nu_r_dot": still}
    known = ("g", "nu", "g_r", "nu_r", "nu_r_dot", *craft.options)
    force = pilot(craft, "numpy", n).run({k: v for k, v in given.items() if k in known}).force
    extras = {"momentum": still, "external": still}
    inertia = np.array(craft.inertia)[:, None]
    moved = space.acceleration(inertia, nudged, force, **extras)
    return max(1.0, float(np.abs(moved).sum(0).max()) / NUDGE)
