"""The shorter way round on S3, with hysteresis: along walks through half a turn, noise and all.

What side is right is said here by a rule of its own, one number at a time.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.native.load import load_module
from derive.vehicle import Vehicle
from tests.emit import subjects
from tests.emit.cases import NEAR, NONFINITE, OFF
from tests.emit.subjects import FILES, Array

FILE = next(vehicle for vehicle in FILES if vehicle.name == "microsat")
FREE = replace(
    FILE,
    name="microsat_free",
    law="vec",
    hysteresis=Fraction(1, 4),
    limits=replace(FILE.limits, force=(), saturation=""),
)
"""Another law, another hysteresis, and a force that nothing limits."""

VEHICLES = (FILE, FREE)
BACKENDS = ("numpy", "f64", "f32")
STEPS, WALKS = 240, 32
FIELDS = ("force", "s", "nu_u", "nu_u_dot")
GARBAGE = (math.nan, math.inf, -math.inf, 7.0, -7.0, 1e-30, -1e-30, 0.0, -0.0)
UNSURE = 1e-6
"""Of a scalar part, which float rounds."""

Command = dict[str, Array]

every_vehicle = pytest.mark.parametrize("vehicle", VEHICLES, ids=lambda v: v.name)
every_backend = pytest.mark.parametrize("backend", BACKENDS)


@dataclass(frozen=True)
class Code:
    """The emitted routines of one backend, on rows: control with a side, and the bare law."""

    control: Callable[[Command, Array], Command]
    tracking: Callable[[Command], Command]


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("side")


@cache
def code(vehicle: Vehicle, backend: str, folder: Path) -> Code:
    if backend == "numpy":
        made = load_module(subjects.place(vehicle, folder) / f"numpy/{vehicle.name}.py")
        return Code(
            lambda rows, side: made.control(**rows, side=side)._asdict(),
            lambda rows: made.tracking(**rows)._asdict(),
        )
    built = subjects.library(vehicle, backend, folder)

    def control(rows: Command, side: Array) -> Command:
        found = built.call("control", **structs(rows), side={"sign": side})
        return {**found, "side": found.pop("sign")}

    return Code(control, lambda rows: built.call("tracking", **structs(rows)))


def structs(rows: Command) -> dict[str, Any]:
    reference = {"g": rows["g_r"], "nu": rows["nu_r"], "nu_dot": rows["nu_r_dot"]}
    return {"state": {"g": rows["g"], "nu": rows["nu"]}, "reference": reference}


def product(p: Array, q: Array) -> Array:
    """Hamilton's, scalar first."""
    w = p[..., :1] * q[..., :1] - (p[..., 1:] * q[..., 1:]).sum(-1, keepdims=True)
    v = p[..., :1] * q[..., 1:] + q[..., :1] * p[..., 1:] + np.cross(p[..., 1:], q[..., 1:])
    return np.concatenate([w, v], -1)


@cache
def walks() -> dict[str, Array]:
    """Errors, (STEPS, WALKS, ...), that swing through half a turn and back, each with its noise."""
    random = np.random.default_rng(12)
    t = np.linspace(0, 1, STEPS)[:, None]
    swing = random.uniform(0.1, 1.5, WALKS) * np.sin(
        2 * np.pi * random.uniform(0.5, 1.5, WALKS) * (t + random.uniform(0, 1, WALKS))
    )
    noise = random.uniform(0, 0.08, WALKS) * random.normal(size=(STEPS, WALKS))
    half = (np.pi + swing + noise)[..., None] / 2
    axis = random.normal(size=(WALKS, 3))
    axis = axis / np.linalg.norm(axis, axis=-1, keepdims=True)
    g_r = random.normal(size=(WALKS, 4))
    g_r = g_r / np.linalg.norm(g_r, axis=-1, keepdims=True) + np.zeros((STEPS, 1, 1))
    error = np.concatenate([np.cos(half), np.sin(half) * axis], -1)
    rates = {name: 0.1 * random.normal(size=error[..., 1:].shape) for name in ("nu", "nu_r")}
    rates["nu_r_dot"] = 0.1 * rates["nu"][::-1]
    kept = {"g": product(g_r, error), "g_r": g_r, **rates}
    return {name: x.astype(np.float32).astype(float) for name, x in kept.items()}


def at(step: int) -> Command:
    return {name: x[step] for name, x in walks().items()}


def scalar_part(rows: Command) -> Array:
    """Of g_r^-1 g: the inner product of the two."""
    return np.asarray((rows["g"] * rows["g_r"]).sum(-1))


def chosen(kept: float, w: float, hysteresis: float) -> int:
    """The rule: what was chosen, or else what is nearer; over to the other beyond the margin."""
    sign = int(math.copysign(1, kept)) if kept > 0 or kept < 0 else 1
    if not (kept > 0 or kept < 0) and w < 0:
        sign = -1
    return -sign if sign * w < -hysteresis else sign


@cache
def walked(vehicle: Vehicle, backend: str, folder: Path) -> tuple[list[Command], Array, Array]:
    """Commands step by step, the scalar parts and the sides, (STEPS, WALKS), from none chosen."""
    run, side, commands = code(vehicle, backend, folder).control, np.zeros(WALKS), []
    for step in range(STEPS):
        commands.append(run(at(step), side))
        side = commands[-1]["side"]
    sides = np.array([one["side"] for one in commands], float)
    return commands, np.array([scalar_part(at(step)) for step in range(STEPS)]), sides


@every_backend
@every_vehicle
def test_the_side_is_kept_until_the_other_is_shorter_by_the_margin(
    folder: Path, vehicle: Vehicle, backend: str
) -> None:
    margin = float(vehicle.hysteresis or 0)
    _, w, sides = walked(vehicle, backend, folder)
    before, flips = np.zeros(WALKS), 0
    for step in range(STEPS):
        for walk in range(WALKS):
            wanted = chosen(before[walk], w[step, walk], margin)
            if min(abs(abs(w[step, walk]) - edge) for edge in (0.0, margin)) > UNSURE:
                assert sides[step, walk] == wanted
            flips += step > 0 and sides[step, walk] != before[walk]
        before = sides[step]
    assert flips > WALKS / 2


@every_backend
@every_vehicle
def test_noise_makes_no_chatter(folder: Path, vehicle: Vehicle, backend: str) -> None:
    """From flip to flip the error crosses the whole band; a choice by sign flips far oftener."""
    margin = float(vehicle.hysteresis or 0)
    _, w, sides = walked(vehicle, backend, folder)
    found = 0
    for walk in range(WALKS):
        flips = np.flatnonzero(np.diff(sides[:, walk])) + 1
        between = np.abs(np.diff(w[flips, walk]))
        assert (between > 2 * margin - UNSURE).all()
        found += len(flips)
    nearest = np.count_nonzero(np.diff(np.sign(w), axis=0))
    assert 0 < 2 * found < nearest


@every_backend
@every_vehicle
def test_what_is_driven_exceeds_half_a_turn_by_no_more_than_the_margin(
    folder: Path, vehicle: Vehicle, backend: str
) -> None:
    margin = float(vehicle.hysteresis or 0)
    commands, w, sides = walked(vehicle, backend, folder)
    angle = 2 * np.arccos(np.clip(sides * w, -1, 1))
    most = np.pi + 2 * np.arcsin(margin)
    assert np.pi + np.arcsin(margin) < angle.max() <= most + 4 * UNSURE
    other = 2 * np.pi - angle
    turned = np.diff(sides, axis=0) != 0
    assert (angle[1:][turned] < other[1:][turned]).all()
    status = np.array([one["status"] for one in commands])
    is_sure = np.abs(sides * w - margin) > UNSURE
    np.testing.assert_array_equal((status == NEAR)[is_sure], (sides * w < margin)[is_sure])
    assert (status < OFF).all()


@every_backend
@every_vehicle
def test_it_is_the_bare_law_of_the_side_that_is_taken(
    folder: Path, vehicle: Vehicle, backend: str
) -> None:
    commands, _, sides = walked(vehicle, backend, folder)
    bare = code(vehicle, backend, folder).tracking
    fields = FIELDS if not vehicle.limits.force else FIELDS[1:]
    for step in range(0, STEPS, 8):
        rows = at(step)
        wanted = bare({**rows, "g_r": sides[step][:, None] * rows["g_r"]})
        for field in fields:
            np.testing.assert_array_equal(commands[step][field], wanted[field], err_msg=field)
    assert (sides < 0).any()
    assert (sides > 0).any()


@every_vehicle
def test_numpy_and_c_go_the_same_way_bit_for_bit(folder: Path, vehicle: Vehicle) -> None:
    plain, compiled = (walked(vehicle, one, folder)[0] for one in ("numpy", "f64"))
    for one, other in zip(plain, compiled, strict=True):
        np.testing.assert_array_equal(one["status"], other["status"])
        for field in (*FIELDS, "side"):
            found, wanted = (np.ascontiguousarray(x[field]) for x in (one, other))
            np.testing.assert_array_equal(found.view(np.uint64), wanted.view(np.uint64), field)


@every_backend
@every_vehicle
def test_whatever_a_side_holds_it_means_one(folder: Path, vehicle: Vehicle, backend: str) -> None:
    margin, run = float(vehicle.hysteresis or 0), code(vehicle, backend, folder).control
    rows = {name: x.reshape(-1, x.shape[-1]) for name, x in walks().items()}
    w = scalar_part(rows)
    is_sure = (np.abs(w) > UNSURE) & (np.abs(np.abs(w) - margin) > UNSURE)
    for garbage in GARBAGE:
        command = run(rows, np.full(len(w), garbage))
        wanted = np.array([chosen(garbage, x, margin) for x in w])
        np.testing.assert_array_equal(command["side"][is_sure], wanted[is_sure], str(garbage))
        assert all(np.isfinite(command[field]).all() for field in FIELDS)
        assert (command["status"] < OFF).all()


@every_backend
@every_vehicle
def test_a_refused_input_leaves_the_side_alone(
    folder: Path, vehicle: Vehicle, backend: str
) -> None:
    kept, run = np.array(GARBAGE), code(vehicle, backend, folder).control
    good = {name: x[: len(kept)] for name, x in at(0).items()}
    kind = np.float32 if backend == "f32" else np.float64
    for name, value, status in (("nu", np.nan, NONFINITE), ("g", 2.0, OFF), ("g_r", 0.0, OFF)):
        command = run({**good, name: np.full_like(good[name], value)}, kept)
        assert set(command["status"]) == {status}
        assert not any(command[field].any() for field in FIELDS)
        left = np.asarray(command["side"], kind)
        np.testing.assert_array_equal(left, kept.astype(kind))
        np.testing.assert_array_equal(np.signbit(left), np.signbit(kept.astype(kind)))


def test_in_numpy_a_side_broadcasts_and_the_bare_law_has_none(folder: Path) -> None:
    made = load_module(subjects.place(FILE, folder) / f"numpy/{FILE.name}.py")
    rows = {name: x[:, None] for name, x in at(3).items()}
    sides = np.array([1.0, -1.0, 0.0])
    command = made.control(**rows, side=sides)
    assert command.side.shape == command.status.shape == (WALKS, 3)
    for place, side in enumerate(sides):
        alone = made.control(**at(3), side=side)
        np.testing.assert_array_equal(alone.force, command.force[:, place])
        np.testing.assert_array_equal(alone.side, command.side[:, place])
    assert made.tracking(**at(3)).side == 0.0
    with pytest.raises(TypeError, match="side: expected real numbers"):
        made.control(**at(3), side=1j)
