"""The emitted numpy against the textbook law written with einsum, in one and the same run."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from bench.figure import Figure
from bench.subject import ELEMENT, Array, place, vehicle
from derive.native.load import load_module

ROWS = 20_000


def plain(inertia: Array, rate_gain: float, reach_gain: float, x: dict[str, Array]) -> Array:
    """The tracking force on SO(3) as one would write it down: arccos of the trace, einsum."""
    g_e = np.einsum("...ji,...jk->...ik", x["g_r"], x["g"])
    eta = np.einsum("...ji,...j->...i", g_e, x["nu_r"])
    nu_e = x["nu"] - eta
    eta_dot = np.einsum("...ji,...j->...i", g_e, x["nu_r_dot"]) - np.cross(nu_e, eta)
    angle = np.arccos((np.trace(g_e, axis1=-2, axis2=-1) - 1) / 2)[..., None]
    skew = (g_e - np.swapaxes(g_e, -1, -2)) / 2
    nu_u = np.stack([skew[..., 2, 1], skew[..., 0, 2], skew[..., 1, 0]], -1) * angle / np.sin(angle)
    turn = np.cross(nu_u, nu_e)
    bend = (1 - angle / 2 / np.tan(angle / 2)) / angle**2
    nu_u_dot = nu_e + turn / 2 + bend * np.cross(nu_u, turn)
    s = nu_e + rate_gain * nu_u
    wanted = eta_dot - rate_gain * nu_u_dot - reach_gain * s
    momentum = np.einsum("ij,...j->...i", inertia, x["nu"])
    turning = rate_gain * nu_u - eta
    force = np.cross(momentum, turning) + np.einsum("ij,...j->...i", inertia, wanted)
    return np.asarray(force)


def rows() -> dict[str, Array]:
    """A batch of states away from the angles that the textbook law cannot take."""
    random = np.random.default_rng(1)
    element = ELEMENT["SO3"]

    def elements(largest: float) -> Array:
        angles = random.uniform(0.1, largest, ROWS)
        return np.array([element(random.normal(size=3), angle) for angle in angles])

    batch = {name: random.normal(size=(ROWS, 3)) for name in ("nu", "nu_r", "nu_r_dot")}
    g_r = elements(3.0)
    return {**batch, "g_r": g_r, "g": g_r @ elements(2.8)}


def best(call: Callable[[], Any], repeats: int = 7) -> float:
    """Shortest time of a call, s."""
    times = []
    for _ in range(repeats):
        start = perf_counter()
        call()
        times.append(perf_counter() - start)
    return min(times)


def measure(folder: Path) -> list[Figure]:
    """Rows per second of both and their ratio; AssertionError when they do not agree."""
    subject = vehicle("paper_so3")
    made = load_module(place(subject.name, folder) / f"numpy/{subject.name}.py")
    inertia = np.array([[float(entry) for entry in row] for row in subject.inertia])
    gains = {name: float(value) for name, value in subject.gains}
    batch = rows()

    def textbook() -> Array:
        return plain(inertia, gains["lambda"], gains["k_s"], batch)

    np.testing.assert_allclose(made.tracking(**batch).force, textbook(), rtol=1e-8, atol=1e-8)
    ours, guarded = best(lambda: made.tracking(**batch)), best(lambda: made.control(**batch))
    theirs = best(textbook)
    return [
        Figure("numpy tracking", ROWS / ours, "rows/s"),
        Figure("numpy control", ROWS / guarded, "rows/s"),
        Figure("plain einsum", ROWS / theirs, "rows/s"),
        Figure("numpy tracking over plain einsum", theirs / ours, "times"),
    ]
