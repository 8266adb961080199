"""Morse functions: values from matrices, rates by differences, and what makes them Morse."""

from typing import Any

import numpy as np
import pytest

from derive.bundle import Height
from derive.control.morse import heights_of
from derive.lie.catalogue import GROUPS, named
from derive.verify.law import slope
from derive.verify.law.cloud import cloud
from derive.verify.law.space import Space
from tests.own import HEISENBERG, SL2

EVERY = [*GROUPS.values(), named("SO3 x R3"), named("S3 x SE2"), SL2, HEISENBERG]
PAIRS = [(group, name) for group in EVERY for name in heights_of(group)]
each = pytest.mark.parametrize(
    ("group", "name"), PAIRS, ids=[f"{group.name}-{name}" for group, name in PAIRS]
)


def height(group: Any, name: str) -> Height:
    return Height(group, heights_of(group)[name])


def shaped(space: Space, g: Any) -> Any:
    return space.store(g).reshape(*g.shape[:-2], *space.group.shape)


@each
def test_the_value_is_that_of_the_matrix(group: Any, name: str) -> None:
    space = Space(group)
    g, _ = cloud(space, 200, np.random.default_rng(1))
    found, wanted = height(group, name).value(shaped(space, g)), slope.values(space, name)(g)
    np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1e-12)


@each
def test_the_rate_and_the_gradient_are_the_slope(group: Any, name: str) -> None:
    space, rng = Space(group), np.random.default_rng(2)
    g, _ = cloud(space, 200, rng)
    nu = rng.normal(size=(200, group.dim)) * 0.1
    one, stored = height(group, name), shaped(space, g)
    wanted = -slope.fall(space, slope.values(space, name), g, -nu)
    rate = one.rate(stored, nu)
    scale = 1 + np.abs(wanted).max()
    np.testing.assert_allclose(rate, wanted, rtol=0, atol=1e-8 * scale)
    along = (one.gradient(stored) * nu).sum(-1)
    np.testing.assert_allclose(along, rate, rtol=1e-10, atol=1e-12 * scale)


@each
def test_it_is_zero_at_the_identity_and_positive_elsewhere(group: Any, name: str) -> None:
    space, one = Space(group), height(group, name)
    e = shaped(space, space.one)
    assert one.value(e) == 0
    np.testing.assert_array_equal(one.gradient(e), 0)
    g, _ = cloud(space, 200, np.random.default_rng(3))
    assert (one.value(shaped(space, g)) > 0).all()


@pytest.mark.parametrize("angle", [1e-150, 1e-12, 1e-8, 1e-3])
@pytest.mark.parametrize(
    ("group", "name", "power", "factor"),
    [
        ("SO3", "V_1", 2, 1 / 4),
        ("SO3", "Psi", 2, 1 / 2),
        ("SO3", "|log|^2/2", 2, 1 / 2),
        ("S3", "V_2", 1, 1 / 8**0.5),
        ("S3", "1 - q0", 2, 1 / 8),
    ],
)
def test_nothing_is_lost_near_the_identity(
    angle: float, group: str, name: str, power: int, factor: float
) -> None:
    """V ~ factor angle^power, where 1 - cos(angle/2) itself rounds to 0."""
    space = Space(GROUPS[group])
    g = space.exp(np.array([0.0, angle, 0.0]))
    found = height(GROUPS[group], name).value(shaped(space, g))
    np.testing.assert_allclose(found, factor * angle**power, rtol=1e-6 + angle)


def test_v_1_has_the_papers_gradient() -> None:
    """psi (R - R^T)^vee with psi = 1/(2 sqrt(1 + tr R)), below eq. (ErrKynSO3)."""
    space = Space(GROUPS["SO3"])
    R, _ = cloud(space, 50, np.random.default_rng(4))
    psi = 1 / (2 * np.sqrt(1 + np.trace(R, axis1=1, axis2=2)))
    odd = R - np.swapaxes(R, 1, 2)
    wanted = psi[:, None] * np.stack([odd[:, 2, 1], odd[:, 0, 2], odd[:, 1, 0]], -1)
    np.testing.assert_allclose(height(GROUPS["SO3"], "V_1").gradient(R), wanted, atol=1e-12)


def test_v_2_has_the_papers_gradient() -> None:
    """v/(4 sqrt(1 - q0)), above eq. (KinCtrlLawS3)."""
    space = Space(GROUPS["S3"])
    q = space.store(cloud(space, 50, np.random.default_rng(5))[0])
    wanted = q[:, 1:] / (4 * np.sqrt(1 - q[:, :1]))
    np.testing.assert_allclose(height(GROUPS["S3"], "V_2").gradient(q), wanted, atol=1e-12)


@pytest.mark.parametrize(
    ("group", "name", "x", "has_kink"),
    [
        ("SO3", "V_1", np.pi, True),
        ("SO3", "Psi", np.pi, False),
        ("S3", "V_2", 0.0, True),
        ("S3", "1 - q0", 0.0, False),
        ("S3", "1 - q0", 2 * np.pi, False),
    ],
)
def test_smooth_is_said_where_it_is(group: str, name: str, x: float, has_kink: bool) -> None:
    space, one = Space(GROUPS[group]), height(GROUPS[group], name)
    angles = x + np.array([-1e-4, 0, 1e-4])
    left, middle, right = one.value(shaped(space, space.exp(angles[:, None] * np.eye(3)[0])))
    slopes = (middle - left) / 1e-4, (right - middle) / 1e-4
    assert (abs(slopes[1] - slopes[0]) > 0.1) == has_kink
    assert (one.morse.smooth == "everywhere") == (not has_kink)
