"""Closed loops that take the shorter way round on S3: each loop keeps its own side."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from derive import flight
from derive.simulate.craft import Craft
from derive.simulate.flight import Flight, recorded
from derive.simulate.loop import Loop
from derive.simulate.reference import rest
from derive.simulate.runs import Runs, Setting
from derive.vehicle import load
from tests.command import ROOT

ANGLES = np.radians([150.0, 175.0, 185.0, 200.0, 350.0])
"""Of the first errors; three of them are shorter the other way round."""

SECONDS = 240.0


@cache
def craft() -> Craft:
    return flight.craft(load(ROOT / "vehicles" / "microsat.toml"), None)


@cache
def flown(backend: str, rate: float | None = 10.0, noise: float = 0.0) -> list[Flight]:
    half, axis = ANGLES / 2, np.array([[2.0], [-1.0], [2.0]]) / 3
    n, still = len(ANGLES), np.zeros((3, 1))
    g = np.concatenate([np.cos(half)[None], np.sin(half) * axis])
    inertia = np.array(craft().inertia)[:, None]
    runs = Runs(g, still, still, inertia, *(still,) * 4, tuple(range(n)))
    identity = np.array([[1.0], [0.0], [0.0], [0.0]])
    setting = Setting(SECONDS if noise == 0 else 20.0, rate, longest=0.5, noise_g=noise)
    return recorded(Loop(craft(), backend, rest(identity, 3), setting, runs).moments())


@pytest.mark.parametrize("rate", [10.0, None], ids=["sampled", "continuous"])
def test_none_is_driven_the_long_way(rate: float | None) -> None:
    for angle, one in zip(ANGLES, flown("numpy", rate), strict=True):
        way = min(angle, 2 * np.pi - angle)
        turned = np.sum(np.linalg.norm(one.nu, axis=-1)[1:] * np.diff(one.t))
        assert turned == pytest.approx(way, abs=0.02)
        assert one.g[-1, 0] == pytest.approx(1.0 if angle < np.pi else -1.0, abs=1e-6)
        assert one.g_e[-1, 0] == pytest.approx(1.0, abs=1e-6)
        assert one.height[0] == pytest.approx(1 - np.cos(way / 2))
        assert (one.status < 16).all()


def test_noise_at_half_a_turn_makes_no_chatter() -> None:
    """The measured error of 175 and 185 degrees jumps about both, and each keeps to its way."""
    for one in flown("numpy", noise=0.05)[1:3]:
        sides = np.sign(one.g_e[:, 0] * one.g[:, 0])
        assert len(set(sides)) == 1
        measured = one.nu_u @ one.nu_u[0]
        assert (measured > 0).all()


@pytest.mark.parametrize("backend", ["f64", "f32"])
def test_c_flies_as_numpy_does(backend: str) -> None:
    for one, other in zip(flown("numpy"), flown(backend), strict=True):
        assert np.abs(one.g - other.g).max() <= {"f64": 0.0, "f32": 1e-4}[backend]
