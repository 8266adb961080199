"""How long a step may be: by how fast the loop answers, how fast it turns and is shaken."""

from __future__ import annotations

import math

import numpy as np

from derive.simulate.craft import Craft
from derive.simulate.pilot import pilot
from derive.simulate.reference import Reference
from derive.simulate.space import Array, space_of

SLOW, SAMPLED = 0.025, 0.01  # s, the longest step of a continuous and of a sampled loop
PART = 0.1  # of the fastest time constant: a step of order 6 then errs by 1e-11
PHASE = (0.02, 0.1)  # rad in a step of order 4 and of order 6: both then err by about 1e-10
SHARE = 100  # steps in the time in which a reference changes
LOOKS = 200  # at a reference, over the duration
NUDGE = 1e-3  # of the velocity, in its units


def longest(craft: Craft, rate: float | None, swift: float = 0.0, brief: float = math.inf) -> float:
    """The longest step, s, for a controller of that rate in Hz, None for a continuous one.

    swift: how fast anything turns besides, rad/s; brief: of the reference, s. With the force held
    the plant alone is integrated, whose motion does not depend on gains.
    """
    answer = SAMPLED if rate is not None else min(SLOW, PART / fastest(craft))
    answer = min(answer, brief / SHARE)
    return min(answer, PHASE[rate is None] / swift) if swift else answer


def swiftness(craft: Craft, reference: Reference, nu: Array, hertz: float, seconds: float) -> float:
    """Largest angular rate that is known beforehand, rad/s: of the start, the reference, a wave.

    nu: first velocity (n, 1); hertz: of a periodic disturbance, 0 for none
    """
    turns = space_of(craft).turns
    spans = (seconds, min(seconds, reference.brief))
    seen = [reference.at(span * i / LOOKS)[0] for span in spans for i in range(LOOKS + 1)]
    speeds = [float(np.linalg.norm(one[turns])) for one in (nu, *seen)]
    return max(*speeds, 2 * math.pi * hertz)


def fastest(craft: Craft) -> float:
    """Largest change of the acceleration by a change of the velocity, 1/s, at e and at rest."""
    space = space_of(craft)
    n = space.dim
    still, nudged = np.zeros((n, n)), NUDGE * np.eye(n)
    e = np.repeat(space.identity, n, 1)
    given = {"g": e, "nu": nudged, "momentum": still, "external": still}
    if craft.has_reference:
        given |= {"g_r": e, "nu_r": still, "nu_r_dot": still}
    known = ("g", "nu", "g_r", "nu_r", "nu_r_dot", *craft.options)
    force = pilot(craft, "numpy", n).run({k: v for k, v in given.items() if k in known}).force
    extras = {"momentum": still, "external": still}
    inertia = np.array(craft.inertia)[:, None]
    moved = space.acceleration(inertia, nudged, force, **extras)
    return max(1.0, float(np.abs(moved).sum(0).max()) / NUDGE)
