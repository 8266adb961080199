"""The motion a vehicle file asks for, as the simulator takes it, and what is wrong with it."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from pathlib import Path

import numpy as np

from derive.simulate.craft import Craft
from derive.simulate.method import BUTCHER, State, step
from derive.simulate.reference import Course, cubic
from derive.simulate.space import Array, Space, space_of
from derive.vehicle import InputError, Vehicle
from derive.vehicle.motion import Motion, read_motion

OFF_GROUP = 1e-6  # largest residual of a given configuration, as in the emitted guard
UNEVEN = 0.1  # of the change of velocity in a row, against the largest that rates lead to
UNLIKE = 1e-3  # of a configuration against the one its velocities lead to, from row to row


def course(vehicle: Vehicle, craft: Craft) -> Course:
    """The course of the vehicle's [reference]. Raises InputError."""
    written, space = vehicle.experiment.course, space_of(craft)
    if not craft.has_reference and written.kind != "rest":
        expected = f"rest: {craft.controller} follows no reference"
        found = f"kind = {written.kind}"
        remedy = 'leave it out, or write controller = "gsmc"'
        raise InputError(vehicle.source, "reference", expected, found, remedy)
    if written.file is not None:
        return _of_file(written.file, space, float(vehicle.experiment.duration))
    start = _start(vehicle, craft, space)
    if written.kind == "rate":
        return Course("steady", start, (_floats(written.nu_r),))
    if written.kind == "slew":
        return Course("slew", start, (_floats(written.along), (float(written.duration),)))
    return Course("rest", start, ((0.0,) * space.dim,))


def _floats(values: Iterable[Fraction]) -> tuple[float, ...]:
    return tuple(map(float, values))


def _start(vehicle: Vehicle, craft: Craft, space: Space) -> tuple[float, ...]:
    """g_r(0), put onto the group where decimals have left it a little off."""
    given = _floats(vehicle.experiment.course.g_r)
    if not given:
        return tuple(space.identity[:, 0])
    remedy = "write its stored numbers, a matrix row by row, a quaternion scalar first"
    if len(given) != space.size:
        expected = f"{space.size} numbers: {space.group.storage}"
        raise InputError(vehicle.source, "reference.g_r", expected, f"{len(given)}", remedy)
    if not craft.has_reference and given != tuple(space.identity[:, 0]):
        expected = f"the identity: {craft.controller} goes there"
        remedy = 'leave it out, or write controller = "gsmc"'
        raise InputError(vehicle.source, "reference.g_r", expected, "another configuration", remedy)
    residual = float(space.drift(np.array(given)[:, None])[0])
    if not residual <= OFF_GROUP:
        expected = f"a configuration of {space.group.name}, to {OFF_GROUP:g}"
        found = f"numbers that are {residual:.2g} off the group"
        raise InputError(vehicle.source, "reference.g_r", expected, found, remedy)
    return given


def _of_file(path: Path, space: Space, duration: float) -> Course:
    """A motion whose every configuration is on the group and follows from its velocities."""
    motion = read_motion(path, space.size, space.dim)
    g = np.array(motion.g).T
    expected = f"a configuration of {space.group.name}"
    remedy = "normalise it; a quaternion has length 1"
    _refuse(path, motion, space.drift(g), OFF_GROUP, expected, "off the group by", remedy)
    expected = "the configuration that nu_r leads to from the row above"
    remedy = "mend g or nu_r, or give more rows; velocities are in the body frame"
    unlike = np.concatenate([[0.0], _unlike(space, g, motion)])
    _refuse(path, motion, unlike, UNLIKE, expected, "apart from it by", remedy)
    expected = "the change of nu_r from the row above, as its rates have it"
    remedy = "mend nu_r or nu_r_dot, or leave the columns of nu_r_dot out"
    _refuse(path, motion, _uneven(motion), UNEVEN, expected, "apart from it by a share of", remedy)
    _check_span(path, motion, duration)
    rows = zip(motion.t, motion.nu_r, motion.nu_r_dot, strict=True)
    return Course("table", motion.g[0], tuple((t, *nu, *dot) for t, nu, dot in rows))


def _check_span(path: Path, motion: Motion, duration: float) -> None:
    """Raise InputError unless the rows reach from 0 to the end of the flight."""
    if motion.t[0] != 0:
        remedy = "count the time from the start of the flight"
        raise InputError(str(path), f"line {motion.lines[0]}", "t = 0 in the first row",
                         f"t = {motion.t[0]!r}", remedy)  # fmt: skip
    if motion.t[-1] < duration * (1 - 1e-9):
        remedy = f"give more rows, or fly --duration {motion.t[-1]:g}"
        raise InputError(str(path), f"line {motion.lines[-1]}",
                         f"rows up to the end of the flight, {duration:g} s",
                         f"the last at {motion.t[-1]:g} s", remedy)  # fmt: skip


def _refuse(
    path: Path, motion: Motion, off: Array, limit: float, expected: str, found: str, remedy: str
) -> None:
    """Raise InputError for the first row that is off by more than the limit."""
    for line, one in zip(motion.lines, off, strict=True):
        if not one <= limit:
            raise InputError(
                str(path), f"line {line}", f"{expected}, to {limit:g}", f"{found} {one:.2g}", remedy
            )


def _unlike(space: Space, g: Array, motion: Motion) -> Array:
    """Distance of each configuration from where the row above leads, all intervals at once."""
    t, nu, dot = np.array(motion.t), np.array(motion.nu_r).T, np.array(motion.nu_r_dot).T
    long = np.diff(t)
    ends = (nu[:, :-1], long * dot[:, :-1], nu[:, 1:], long * dot[:, 1:])

    def rates(at: float, state: State) -> State:
        velocity = sum(w * end for w, end in zip(cubic(at)[0], ends, strict=True))
        return (long * space.chart_rate(state[0], np.asarray(velocity)),)

    reached, parts = g[:, :-1], 4
    for part in range(parts):
        start = (np.zeros((space.dim, len(long))),)
        (x,) = step(BUTCHER, rates, part / parts, 1 / parts, start)
        reached = space.advance(reached, x)
    apart = np.abs(reached - g[:, 1:]).max(0)
    return np.asarray(apart / np.maximum(1.0, np.abs(g[:, 1:]).max(0)))


def _uneven(motion: Motion) -> Array:
    """Change of nu_r between rows less the mean of its rates, over the largest change, (rows,)."""
    t, nu, dot = np.array(motion.t), np.array(motion.nu_r), np.array(motion.nu_r_dot)
    led = np.diff(t)[:, None] * (dot[:-1] + dot[1:]) / 2
    off = np.abs(np.diff(nu, axis=0) - led).max(1)
    largest = max(float(np.abs(led).max()), float(np.abs(np.diff(nu, axis=0)).max()), 1e-9)
    return np.concatenate([[0.0], off / largest])
