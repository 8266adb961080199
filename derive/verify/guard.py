"""The guard of the emitted `control`: what it lets through, what it refuses, and as what."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.emit.status import STATUSES
from derive.emit.target import SCALARS
from derive.verify.backend import Backend
from derive.verify.batch import at_rest, ladder
from derive.verify.check import Check
from derive.verify.derived import has_pole
from derive.verify.limits import EPS, LIMITS
from derive.verify.plant import Plant
from derive.verify.sample import States
from derive.verify.shape import space
from derive.verify.subject import Subject, rows

Array = NDArray[Any]
VALUE = {name: value for name, value, _ in STATUSES}
UNSURE = 1e-3
"""Relative distance from a threshold of the clearance within which either status is right."""


SLIGHT = 4e-3
"""What all numbers are stretched by: their distance from the group is then at least as much."""


def guard(subject: Subject) -> Iterator[Check]:
    """`control` on good states, on bad ones, and `check_params`."""
    for backend in subject.backends:
        yield _lets_through(subject, backend)
        yield _refuses(subject, backend)
        yield _judges_params(subject, backend)


def _lets_through(subject: Subject, backend: Backend) -> Check:
    """Equal to the bare law bit for bit, with the status that the truth's clearance asks for.

    Where the vehicle has limits, the force is the bare one within them; where it takes the shorter
    way round, the law is that of the nearer quaternion.
    """
    batch = at_rest(subject.vehicle, backend.scalar, subject.each, subject.seed)
    command = backend.run("control", batch.states)
    bare = backend.run(subject.law, _as_taken(subject.vehicle, batch.states))
    clearance = batch.truth.branches[0]["clearance"][0][:, 0]
    if subject.vehicle.hysteresis is not None:
        clearance = np.abs(batch.states.g[:, 0])
    expected, is_sure = _status(subject, clearance, backend.scalar)
    is_over, is_kept = _within(subject.vehicle, backend.scalar, bare["force"], command["force"])
    expected = np.maximum(expected, np.where(is_over, VALUE["SATURATED"], VALUE["OK"]))
    refused = (expected >= VALUE["NOT_ON_GROUP"])[:, None]
    differ = [(command[n] != np.where(refused, 0.0, bare[n])).any(-1)
              for n in bare if n != "force"]  # fmt: skip
    differ.append(np.where(refused[:, 0], (command["force"] != 0).any(-1), ~is_kept))
    bad = is_sure & (np.any(differ, axis=0) | (command["status"] != expected))
    return rows("control: the law, and its status", backend.name, bad, batch.states)


def _as_taken(vehicle: Plant, states: States) -> States:
    """States at rest at the identity, of quaternions the nearer where that is what is taken."""
    if vehicle.hysteresis is None:
        return states
    return replace(states, g=np.where(states.g[:, :1] < 0, -states.g, states.g))


def _within(vehicle: Plant, scalar: str, bare: Array, found: Array) -> tuple[Array, Array]:
    """Whether a bare force is beyond the limits, and whether what was found of it is right, (N,).

    Unchanged where it is not beyond; else within the limits, and to 4 eps the bare force shrunk
    as a whole or cut by coordinate.
    """
    if not vehicle.force_limit:
        return np.zeros(len(bare), dtype=bool), (found == bare).all(-1)
    limit = np.array([float(x) for x in vehicle.force_limit]).astype(bare.dtype).astype(float)
    wide = bare.astype(float)
    size = np.abs(wide)
    is_over = (size > limit).any(-1)
    share = np.min(limit / np.maximum(size, limit), axis=-1, keepdims=True)
    wanted = wide * share if vehicle.saturation == "direction" else np.clip(wide, -limit, limit)
    is_near = np.abs(found - wanted) <= 4 * EPS[scalar] * np.abs(wanted)
    is_right = is_near.all(-1) & (np.abs(found) <= limit).all(-1)
    return is_over, np.where(is_over, is_right, (found == bare).all(-1))


def _status(subject: Subject, clearance: Array, scalar: str) -> tuple[Array, Array]:
    """Status by clearance, and where rounding cannot move it."""
    kind = SCALARS[scalar]
    near = float(subject.vehicle.hysteresis or kind.near_cut)
    refused = float(kind.refused) if has_pole(subject.vehicle) else 0.0
    status = np.where(clearance < near, VALUE["NEAR_CUT_LOCUS"], VALUE["OK"])
    status = np.where(clearance < refused, VALUE["OUT_OF_RANGE"], status)
    off = [np.abs(clearance - at) > UNSURE * at for at in (near, refused) if at > 0]
    return status, np.all(off, axis=0)


def _refuses(subject: Subject, backend: Backend) -> Check:
    """NaN, infinity, too large, off the group, in every input in turn: a zero command."""
    good = ladder(subject.vehicle, backend.scalar, 1, subject.seed, is_moving=True)
    kind = SCALARS[backend.scalar]
    inputs = ("g", "nu", *subject.vehicle.options)
    inputs += ("g_r", "nu_r", "nu_r_dot") if subject.vehicle.has_reference else ()
    bad = np.zeros(len(good.angle), dtype=bool)
    for name in inputs:
        harms = [(_with(good, name, value), status) for value, status in (
            (np.nan, "NONFINITE_INPUT"), (-np.inf, "NONFINITE_INPUT"),
            (2 * float(kind.max_input), "OUT_OF_RANGE"))]  # fmt: skip
        if name in ("g", "g_r"):
            harms += [(off, "NOT_ON_GROUP") for off in _off_group(subject.vehicle, good, name)]
        for states, status in harms:
            command = backend.run("control", states)
            bad |= command["status"] != VALUE[status]
            bad |= np.any([(command[n] != 0).any(-1) for n in command if n != "status"], axis=0)
    return rows("control: bad input refused", backend.name, bad, good)


def _with(states: States, name: str, value: float, among: Array | None = None) -> States:
    """The same states, one number of one input replaced, another one in each row."""
    array = getattr(states, name).copy()
    places = np.arange(array.shape[1]) if among is None else among
    array[np.arange(len(array)), places[np.arange(len(array)) % len(places)]] = value
    return replace(states, **{name: array})


def _off_group(vehicle: Plant, states: States, name: str) -> Iterator[States]:
    """The same off the group: one number made 2, all a little larger; doubled on a user's group.

    On R^n there is none; nor is a double where all multiples of an element are elements.
    """
    group = space(vehicle.space)
    if vehicle.own is None:
        fixed = np.flatnonzero(np.concatenate([one.is_fixed() for one in group.shapes]))
        if len(fixed):
            yield _with(states, name, 2.0, fixed)
            if (vehicle.max_drift or 0) < SLIGHT:  # within MAX_ENTRY: the distance alone tells
                yield replace(states, **{name: (1 + SLIGHT) * getattr(states, name)})
    elif not group.shapes[0].holds_one():
        yield replace(states, **{name: 2 * getattr(states, name)})


def _judges_params(subject: Subject, backend: Backend) -> Check:
    """The vehicle's own parameters pass; each of a list of bad ones is refused."""
    kept, _ = subject.vehicle.stored(backend.scalar)
    gains = subject.vehicle.named_gains(backend.scalar)
    upper = np.array([kept[i][j] for i in range(len(kept)) for j in range(i, len(kept))])
    diagonal = np.array([i == j for i in range(len(kept)) for j in range(i, len(kept))])
    params: list[tuple[dict[str, Any], str]] = [
        ({"inertia": upper, **gains}, "OK"),
        ({"inertia": np.where(diagonal, -upper, upper)}, "BAD_PARAMS"),
        ({"inertia": np.where(diagonal, 0.0, upper)}, "BAD_PARAMS"),
        ({"inertia": upper * np.nan}, "BAD_PARAMS"),
    ]
    bad = (0.0, -1.0, np.inf)
    params += [({name: value}, "BAD_PARAMS") for name in gains for value in bad]
    params += _drifts(backend.scalar) if backend.has_drift else []
    for i in np.flatnonzero(diagonal):
        negative = np.where(np.arange(len(upper)) == i, -upper, upper)
        params.append(({"inertia": negative}, "BAD_PARAMS"))
    for i in np.flatnonzero(upper == 0):
        filled = np.where(np.arange(len(upper)) == i, upper[0] / 9, upper)
        params.append(({"inertia": filled}, "BAD_PARAMS"))
    wrong = [int(backend.check_params(given)) != VALUE[status] for given, status in params]
    limit = LIMITS["rows"]
    return Check("check_params", backend.name, float(sum(wrong)), limit, len(wrong))


def _drifts(scalar: str) -> list[tuple[dict[str, Any], str]]:
    """Distances from the group from the least to the most, and neither below nor above."""
    kind = SCALARS[scalar]
    least, most = float(kind.least_drift), float(kind.most_drift)
    good = [({"max_drift": value}, "OK") for value in (least, most)]
    bad = (np.nan, 0.0, -least, least / 2, 2 * most)
    return good + [({"max_drift": value}, "BAD_PARAMS") for value in bad]
