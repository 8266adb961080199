"""The groups that judge the closed loop: their matrix functions, and that they are groups."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm, logm

from bench.algebra import algebra, exp, log

NAMES = (
    *("SO2", "SO3", "S3", "SE2", "SE3", "SE23", "R3", "Heisenberg", "SL2"),
    *("SO3 x R3", "SE3 x SO3", "S3 x R1"),
)
every_group = pytest.mark.parametrize("name", NAMES)


def draw(name: str, seed: int) -> np.ndarray:
    return np.random.default_rng(seed).uniform(-0.8, 0.8, (5, algebra(name).dim))


@every_group
def test_exp_and_log_are_those_of_scipy(name: str) -> None:
    a = algebra(name).hat(draw(name, 1))
    g = exp(a)
    np.testing.assert_allclose(g, [expm(x) for x in a], rtol=0, atol=1e-14)
    np.testing.assert_allclose(log(g), [np.real(logm(x)) for x in g], rtol=0, atol=1e-13)


@every_group
def test_elements_are_kept_whole_and_lie_on_the_group(name: str) -> None:
    space = algebra(name)
    g = exp(space.hat(draw(name, 2)))
    np.testing.assert_allclose(space.embed(space.store(g)), g, rtol=0, atol=1e-14)
    assert space.off(g).max() < 1e-14
    bent = g + 1e-3 * np.random.default_rng(3).normal(size=g.shape)
    assert space.off(bent).min() > 1e-5 or set(name.split(" x ")) == {"R3"}


@every_group
def test_the_flow_is_that_of_the_exponential(name: str) -> None:
    space, step = algebra(name), 1e-4
    g, nu = exp(space.hat(draw(name, 4))), draw(name, 5)
    ahead, behind = (space.store(g @ exp(space.hat(t * nu))) for t in (step, -step))
    found = space.flow(space.store(g), nu)
    np.testing.assert_allclose(found, (ahead - behind) / (2 * step), rtol=0, atol=1e-7)


@every_group
def test_coad_is_paired_with_the_bracket(name: str) -> None:
    space = algebra(name)
    x, a, y = (draw(name, seed) for seed in (6, 7, 8))
    X, Y = space.hat(x), space.hat(y)
    bracket = space.vee(X @ Y - Y @ X)
    np.testing.assert_allclose(space.hat(bracket), X @ Y - Y @ X, rtol=0, atol=1e-14)
    found = (space.coad(x, a) * y).sum(-1)
    np.testing.assert_allclose(found, (a * bracket).sum(-1), rtol=0, atol=1e-14)
