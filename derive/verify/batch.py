"""The states, their truth and their limits, made once for the suite and for the mutants alike."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify import reference, sample
from derive.verify.limits import EPS, LIMITS
from derive.verify.plant import Plant
from derive.verify.reference import Truth
from derive.verify.sample import States
from derive.verify.shape import space

Array = NDArray[Any]

BETWEEN = 8
"""States at random angles, for each one on a rung of the ladder."""


@dataclass(frozen=True)
class Batch:
    """States, the truth about the outputs there, and the largest error each may have.

    limits: output -> relative error, (N,); an output that is not named is not judged
    """

    states: States
    truth: Truth
    limits: Mapping[str, Array]

    @property
    def beyond(self) -> Array:
        """Rows beyond a rotation by pi, (N,)."""
        return self.states.angle > np.pi


CARRYING = ("SE2", "SE3", "SE23")
"""Groups in which rotations carry translations."""

FEW, FEWER = 4, 8
"""A truth made of matrices takes up to ten times as long as one of quaternions: by so many fewer
states, where rotations carry nothing and where they do."""


_OWN = {"log": "own", "rate": "own", "force_f64": "own_force", "plant_f64": "own_force"}


def limit_of(vehicle: Plant, what: str) -> str:
    """Name of the limit of "log", "rate", "force_f64" or "plant_f64" on a vehicle's group."""
    if vehicle.own is not None:
        return _OWN.get(what, what)
    if not any(name in CARRYING for name in vehicle.factors) or what not in ("log", "rate"):
        return what
    return "skew_carried" if vehicle.law == "skew" else f"{what}_carried"


def rotation_limit(vehicle: Plant, what: str) -> str:
    """The same of rotations alone; what skew reads is the matrix as it is stored."""
    found = limit_of(vehicle, what)
    return found if found == "skew_carried" else what


def samples(vehicle: Plant, each: int) -> int:
    """States on every rung, of `each` that were asked for; all lengths are among them."""
    if vehicle.is_attitude:
        return each
    carries = any(name in CARRYING for name in vehicle.factors)
    return max(1, each // (FEWER if carries else FEW))


def ladder(vehicle: Plant, scalar: str, each: int, seed: int, *, is_moving: bool) -> States:
    """`each` states on every rung, and BETWEEN times as many at random angles."""
    rungs = sample.angles(vehicle)
    rng = np.random.default_rng([seed, is_moving])
    between = rng.uniform(0, rungs[-1], BETWEEN * each)
    angle = np.concatenate([sample.spread(rungs, each), between])
    return sample.states(vehicle, angle, scalar, rng, is_moving=is_moving)


@cache
def at_rest(vehicle: Plant, scalar: str, each: int, seed: int) -> Batch:
    """The identity as reference, where law and rate have no error of the product g_r^-1 g."""
    states = ladder(vehicle, scalar, samples(vehicle, each), seed, is_moving=False)
    truth = reference.at_rest(vehicle, states, scalar)
    beyond = states.angle > np.pi
    far, eps = LIMITS["beyond_pi"].figure, EPS[scalar]
    log, rate = (
        np.where(beyond, far, LIMITS[limit_of(vehicle, name)].figure) * eps
        for name in ("log", "rate")
    )
    whole = _everywhere(vehicle, truth, scalar)
    clearance = np.full(len(beyond), LIMITS["mutant"].figure * eps)
    limits = {"nu_u": log, "nu_u_dot": rate, "clearance": clearance, "force": whole, "s": whole}
    return Batch(states, truth, limits)


def _rotation(vehicle: Plant, what: str) -> float:
    return LIMITS[rotation_limit(vehicle, what)].figure


@cache
def turned(vehicle: Plant, scalar: str, each: int, seed: int) -> Batch | None:
    """Rotations alone, whose truth takes little: all states that were asked for, at rest.

    None where nothing turns, or where `at_rest` has as many.
    """
    if vehicle.is_attitude or not any(one.turns for one in space(vehicle.space).shapes):
        return None
    states = ladder(vehicle, scalar, each, seed + 1, is_moving=False)
    truth = reference.turned(vehicle, states, scalar)
    beyond, eps = states.angle > np.pi, EPS[scalar]
    limits = {
        name: np.where(beyond, LIMITS["beyond_pi"].figure, _rotation(vehicle, what)) * eps
        for name, what in (("nu_u", "log"), ("nu_u_dot", "rate"))
    }
    return Batch(states, truth, limits)


@cache
def on_the_move(vehicle: Plant, scalar: str, each: int, seed: int) -> Batch:
    """Moving references, for the whole force and s."""
    states = ladder(vehicle, scalar, samples(vehicle, each), seed, is_moving=True)
    run = reference.tracking if vehicle.has_reference else reference.reaching
    truth = run(vehicle, states, scalar)
    whole = _everywhere(vehicle, truth, scalar) / truth.conditioning
    return Batch(states, truth, {"force": whole, "s": whole})


@cache
def at_ties(vehicle: Plant, scalar: str, seed: int) -> Batch | None:
    """Exact rotations by pi, where one side is right; None where there is no such choice."""
    turning = [name for name in vehicle.factors if name != "S3" and not name.startswith("R")]
    if vehicle.own or not turning or sample.reach(turning[0], vehicle.law) < np.pi:
        return None
    states = sample.ties(vehicle, scalar, np.random.default_rng(seed))
    truth = reference.at_rest(vehicle, states, scalar).first()
    limit = LIMITS[limit_of(vehicle, "log")].figure * EPS[scalar]
    return Batch(states, truth, {"nu_u": np.full(len(states.angle), limit)})


@cache
def under_force(vehicle: Plant, scalar: str, each: int, seed: int) -> tuple[Batch, Array]:
    """The plant, and the forces (N, n) applied to it: as large as the inertia makes them."""
    states = ladder(vehicle, scalar, each, seed, is_moving=True)
    size = np.linalg.norm(vehicle.stored("f64")[0], 2)
    force = (states.nu_r * size).astype(states.nu_r.dtype)
    truth = reference.plant(vehicle, states, force, scalar)
    limit = np.full(len(force), LIMITS[limit_of(vehicle, f"plant_{scalar}")].figure)
    return Batch(states, truth, {"nu_dot": limit}), force


def _everywhere(vehicle: Plant, truth: Truth, scalar: str) -> Array:
    """The limit of force and s; none where a law on S3 changes its sign, and two are right."""
    clearance = truth.branches[0]["clearance"][0][:, 0]
    limit = np.full(len(clearance), LIMITS[limit_of(vehicle, f"force_{scalar}")].figure)
    jumps = "S3" in vehicle.factors and vehicle.law == "sign_vec"
    return np.where(jumps & (clearance < LIMITS["either side"].figure * EPS[scalar]), np.inf, limit)
