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

from derive.verify import casadi_twin
from derive.verify.reference import Plant
from derive.verify.sample import States, cross_matrix, hamilton

Array = NDArray[Any]
Law = Callable[[States], Mapping[str, Array]]

STEP = 1e-2
WEIGHTS = {1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
"""Central difference of 6th order: sum of weight (f(+i h) - f(-i h)) / h."""

IMAGINARY = 1e-30


def differences(law: Law, states: States, nu_e: Array) -> dict[str, Array]:
    """d/dt of every output by a 6th-order central difference, (N, n).

    The step is 1e-2 divided by the speed, so that it is an arc of 1e-2 rad.
    """
    step = STEP / np.maximum(0.3, np.linalg.norm(nu_e, axis=1, keepdims=True))
    total: dict[str, Array] = {}
    for i, weight in WEIGHTS.items():
        ahead, behind = (law(moved(states, nu_e, side * i * step)) for side in (1, -1))
        for name, value in ahead.items():
            change = weight * (value - behind[name]) / step
            total[name] = total.get(name, 0.0) + change
    return total


def complex_step(law: Law, states: States, nu_e: Array) -> dict[str, Array]:
    """d/dt of every output as the imaginary part after an imaginary step of 1e-30, (N, n)."""
    small = 1j * IMAGINARY
    if states.g.shape[1] == 4:
        spin = np.hstack([np.zeros_like(nu_e[:, :1]), nu_e])
        g = states.g + small * hamilton(states.g, spin) / 2
    else:
        rotation = states.g.reshape(-1, 3, 3)
        g = states.g + small * (rotation @ cross_matrix(nu_e)).reshape(-1, 9)
    there = replace(states, g=g, nu_r=states.nu_r + small * states.nu_r_dot)
    return {name: value.imag / IMAGINARY for name, value in law(there).items()}


def moved(states: States, nu_e: Array, time: Array) -> States:
    """The states after flowing for a time (N, 1) in s at constant nu_e and nu_r_dot."""
    speed = np.linalg.norm(nu_e, axis=1, keepdims=True)
    angle, axis = speed * time, nu_e / speed
    if states.g.shape[1] == 4:
        g = hamilton(states.g, np.hstack([np.cos(angle / 2), np.sin(angle / 2) * axis]))
    else:
        hat = cross_matrix(axis)
        turn = np.sin(angle)[..., None] * hat + 2 * np.sin(angle / 2)[..., None] ** 2 * hat @ hat
        g = (states.g.reshape(-1, 3, 3) @ (np.eye(3) + turn)).reshape(-1, 9)
    return replace(states, g=g, nu_r=states.nu_r + time * states.nu_r_dot)


def twin(vehicle: Plant, states: States) -> dict[str, Array]:
    """nu_u, nu_u_dot, eta_dot and force of the printed formulas, differentiated by CasADi."""
    given = {name: getattr(states, name) for name in ("nu", "nu_r", "nu_r_dot")}
    inertia, rate_gain, reach_gain = vehicle.stored("f64")
    given |= {"g": states.g, "g_r": states.g_r}
    given |= {"inertia": np.array(inertia), "lambda": rate_gain, "k_s": reach_gain}
    return casadi_twin.evaluate(casadi_twin.twin(vehicle.group, vehicle.law), given)


def whole_force(
    vehicle: Plant, nu: Array, eta: Array, nu_u: Array, eta_dot: Array, nu_u_dot: Array
) -> Array:
    """J f_u as eq. (TckCtrlSO3) prints it, from rates found elsewhere, (N, 3) in N m."""
    rows, rate_gain, reach_gain = vehicle.stored("f64")
    inertia = np.array(rows)
    turning = rate_gain * nu_u - eta
    s = nu - eta + rate_gain * nu_u
    wanted = eta_dot - rate_gain * nu_u_dot - reach_gain * s
    return np.asarray(np.cross(nu @ inertia, turning) + wanted @ inertia)


def body_reference(states: States) -> Array:
    """eta = R_e^T nu_r, (N, 3), rad/s."""
    if states.g.shape[1] == 4:
        flip = np.array([1.0, -1.0, -1.0, -1.0])
        error = hamilton(states.g_r * flip, states.g)
        spin = np.hstack([np.zeros_like(states.nu_r[:, :1]), states.nu_r])
        return np.asarray(hamilton(hamilton(error * flip, spin), error)[:, 1:])
    rotation, reference = (x.reshape(-1, 3, 3) for x in (states.g, states.g_r))
    return np.asarray(np.einsum("nji,njk,nk->ni", rotation, reference, states.nu_r))


def term_scales(vehicle: Plant, states: States) -> dict[str, Array]:
    """Length of the terms of a rate or of the force, where they can cancel, (N,).

    nu_e = nu - eta rounds at eps (|nu| + |eta|) / 2, eta_dot has |nu_r_dot| + |nu_e| |eta|, and
    the force |I| (|eta_dot| + (lambda + k_s) |nu_e|).
    """
    eta = body_reference(states)
    vectors = (states.nu, eta, states.nu - eta, states.nu_r_dot)
    nu, turning, speed, growth = (np.linalg.norm(x, axis=-1) for x in vectors)
    scale = growth + speed * turning
    rows, rate_gain, reach_gain = vehicle.stored("f64")
    force = np.linalg.norm(rows, 2) * (scale + (rate_gain + reach_gain) * speed)
    return {"nu_u_dot": (nu + turning) / 2, "eta_dot": scale, "force": force}


def relative(found: Array, expected: Array, scale: Array | float = 0.0) -> Array:
    """|found - expected| over |expected|, or over a scale where that is larger, (N,)."""
    off = np.linalg.norm(found - expected, axis=-1)
    return np.asarray(off / np.maximum(np.linalg.norm(expected, axis=-1), scale))
