"""The plant in C flies as the plant in numpy does: the same bits, for every kind of group."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from derive.simulate.chunk import Plan
from derive.simulate.draw import drawn, seed_of
from derive.simulate.flight import Flight, recorded
from derive.simulate.held import Held
from derive.simulate.loop import Loop
from derive.simulate.reference import Course
from derive.simulate.space import space_of
from tests.simulate.crafts import craft, plan

LOOPS = 5


def flights(made: Plan, is_fast: bool) -> list[Flight]:
    reference = made.course.reference()
    seeds = [seed_of(1, i) for i in range(LOOPS)]
    runs = drawn(
        made.craft, reference, replace(made.spread, wave=(0.1,) * space_of(made.craft).dim), seeds
    )
    setting = replace(made.settings[0], hertz=0.7)
    backend = "f64" if is_fast else "numpy"
    return recorded(Loop(made.craft, backend, reference, setting, runs).moments())


@pytest.mark.parametrize("group", ["SO3", "S3", "SE2", "SE3", "SL2", "SE3 x SO3", "R3"])
def test_c_flies_as_numpy_does(group: str) -> None:
    space = space_of(craft(group))
    moving = Course("slew", tuple(space.identity[:, 0]), ((0.4,) * space.dim, (0.5,)))
    made = replace(plan(group, duration=0.6), course=moving)
    for fast, plain in zip(flights(made, True), flights(made, False), strict=True):
        for name in ("g", "nu", "g_r", "g_e", "nu_e", "height", "energy"):
            np.testing.assert_array_equal(getattr(fast, name), getattr(plain, name), name)


def test_wheels_keep_their_momentum() -> None:
    made = plan("SO3", duration=0.3)
    wheels = replace(made, craft=replace(craft("SO3"), options=("momentum",)))
    assert "momentum" in space_of(wheels.craft).options
    runs = drawn(wheels.craft, made.course.reference(), made.spread, [1, 2])
    force = np.array([[0.3, 0.1], [0.2, -0.4], [-0.5, 0.6]])
    held, effort = Held(wheels.craft, runs), np.zeros(2)
    start = np.array([[0.2, 0.4], [-0.1, 0.3], [0.5, 0.0]])
    turns = [(0.0, 1.0)] * 4
    g, nu, momentum, effort = held.step(0.01, turns, (runs.g, runs.nu, start, effort), force)
    np.testing.assert_allclose(momentum, start - 0.01 * force, rtol=1e-14)
    np.testing.assert_allclose(effort, 0.01 * (force**2).sum(0), rtol=1e-14)
    # Undisturbed, the whole momentum in space, R (I nu + h), turns with nobody.
    calm = replace(runs, disturbance=np.zeros((3, 1)))
    free = Held(wheels.craft, calm)
    g, nu, momentum, _ = free.step(0.01, turns, (runs.g, runs.nu, start, np.zeros(2)), force)
    for i in range(2):
        inertia = np.zeros((3, 3))
        inertia[np.triu_indices(3)] = runs.inertia[:, i]
        inertia = inertia + np.triu(inertia, 1).T
        before = runs.g[:, i].reshape(3, 3) @ (inertia @ runs.nu[:, i] + start[:, i])
        after = g[:, i].reshape(3, 3) @ (inertia @ nu[:, i] + momentum[:, i])
        np.testing.assert_allclose(after, before, atol=1e-9)
