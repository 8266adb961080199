"""Derivatives of the emitted numpy code: differences along the flow, complex step, CasADi.

None of them knows a closed form of a rate. Each one moves the state along
g(t) = g exp(t nu_e), nu_r(t) = nu_r + t nu_r_dot, so that g_e' = g_e hat(nu_e).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.natural import Natural, blocks_of, lengths
from derive.verify.oracle import casadi_group, casadi_twin
from derive.verify.plant import Plant
from derive.verify.sample import States
from derive.verify.shape import space

Array = NDArray[Any]
Law = Callable[[States], Mapping[str, Array]]

STEP = 1e-2
WEIGHTS = {1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
"""Central difference of 6th order: sum of weight (f(+i h) - f(-i h)) / h."""

IMAGINARY = 1e-30


def differences(vehicle: Plant, law: Law, states: States, nu_e: Array) -> dict[str, Array]:
    """d/dt of every output by a 6th-order central difference, (N, n).

    The step is 1e-2 divided by the speed, so that it is an arc of 1e-2 rad.
    """
    step = STEP / np.maximum(0.3, _speed(vehicle, nu_e))
    total: dict[str, Array] = {}
    for i, weight in WEIGHTS.items():
        ahead, behind = (law(moved(vehicle, states, nu_e, side * i * step)) for side in (1, -1))
        for name, value in ahead.items():
            change = weight * (value - behind[name]) / step
            total[name] = total.get(name, 0.0) + change
    return total


def _speed(vehicle: Plant, nu_e: Array) -> Array:
    """|nu_e|, (N, 1); in whatever basis a user's group has, as fast as ad can turn: 2 |hat|."""
    length = np.linalg.norm(nu_e, axis=1, keepdims=True)
    if vehicle.own is None:
        return np.asarray(length)
    (hat,) = space(vehicle.space).hat(nu_e)
    return np.asarray(np.maximum(length, 2 * np.linalg.norm(hat, 2, axis=(1, 2))[:, None]))


def complex_step(vehicle: Plant, law: Law, states: States, nu_e: Array) -> dict[str, Array]:
    """d/dt of every output as the imaginary part after an imaginary step of 1e-30, (N, n)."""
    small = 1j * IMAGINARY
    g = states.g + small * space(vehicle.space).tangent(states.g, nu_e)
    there = replace(states, g=g, nu_r=states.nu_r + small * states.nu_r_dot)
    return {name: value.imag / IMAGINARY for name, value in law(there).items()}


def moved(vehicle: Plant, states: States, nu_e: Array, time: Array) -> States:
    """The states after flowing for a time (N, 1) in s at constant nu_e and nu_r_dot."""
    g = space(vehicle.space).flowed(states.g, time * nu_e)
    return replace(states, g=g, nu_r=states.nu_r + time * states.nu_r_dot)


def twin(vehicle: Plant, states: States) -> dict[str, Array]:
    """nu_u, nu_u_dot, eta_dot and force of the printed formulas, differentiated by CasADi."""
    names = ("nu", "nu_r", "nu_r_dot", "momentum", "external")
    given: dict[str, Any] = {name: getattr(states, name) for name in names}
    inertia, _ = vehicle.stored("f64")
    given |= {"inertia": np.array(inertia), **vehicle.named_gains("f64")}
    if vehicle.is_attitude:
        given |= {"g": states.g, "g_r": states.g_r}
        return casadi_twin.evaluate(casadi_twin.twin(vehicle.group, vehicle.law), given)
    group = space(vehicle.space)
    for name in ("g", "g_r"):
        for place, a in enumerate(group.matrices(getattr(states, name))):
            given[f"{name}_{place}"] = a
    return casadi_twin.evaluate(casadi_group.twin(vehicle.space, vehicle.law), given)


def whole_force(
    vehicle: Plant, states: States, eta: Array, nu_u: Array, eta_dot: Array, nu_u_dot: Array
) -> Array:
    """I f_u as eq. (TckCtrl) prints it, from rates found elsewhere, (N, n)."""
    rows, (rate_gain, reach_gain) = vehicle.stored("f64")
    inertia, nu = np.array(rows), states.nu
    turning = rate_gain * nu_u - eta
    s = nu - eta + rate_gain * nu_u
    wanted = eta_dot - rate_gain * nu_u_dot - reach_gain * s
    carried = space(vehicle.space).coad(turning, nu @ inertia + states.momentum)
    return np.asarray(carried + wanted @ inertia - states.external)


def body_reference(vehicle: Plant, states: States) -> Array:
    """eta = Ad(g_e^-1) nu_r, (N, n)."""
    group = space(vehicle.space)
    return group.pull(group.error(states.g_r, states.g), states.nu_r)


def term_scales(vehicle: Plant, states: States) -> dict[str, Array]:
    """Length of the terms of a rate or of the force, where they can cancel, (N, blocks).

    nu_e = nu - eta rounds at eps (|nu| + |eta|) / 2, eta_dot has |nu_r_dot| + |nu_e| |eta|, and
    the force |I| (|eta_dot| + (lambda + k_s) |nu_e|).
    """
    return _natural(vehicle, states, {}).terms()


def step_scales(vehicle: Plant, states: States, nu_u: Array) -> dict[str, Array]:
    """The same for differences, whose step is chosen for the velocity as a whole."""
    return _natural(vehicle, states, {"nu_u": nu_u}).stepped()


def _natural(vehicle: Plant, states: States, outputs: dict[str, Array]) -> Natural:
    still = np.zeros((len(states.angle), len(space(vehicle.space).shapes)))
    nu_e = states.nu - body_reference(vehicle, states)
    return Natural(vehicle, states, still, {"nu_e": nu_e, **outputs})


def relative(vehicle: Plant, found: Array, expected: Array, scale: Array | float = 0.0) -> Array:
    """|found - expected| over |expected|, or over a scale where that is larger, (N,)."""
    blocks = blocks_of(vehicle)
    off, size = (lengths(blocks, x) for x in (found - expected, expected))
    size = np.maximum(size, scale)
    return np.asarray((off / np.where(size > 0, size, 1.0)).max(-1))
