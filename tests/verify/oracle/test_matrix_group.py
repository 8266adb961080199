"""Exponentials, logarithms, rates and adjoints of any group against scipy, series and brackets."""

from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm, logm
from scipy.spatial.transform import Rotation

from derive.verify.oracle import matrix_truth
from tests.verify.oracle.coordinates import (
    NAMES,
    TINY,
    TURNING,
    at_angle,
    double,
    doubles,
    draw,
    matrix,
    mp,
    norm,
    off,
    spread,
    worst,
)


@pytest.mark.parametrize("length", ["1e-6", "1", "1e6"])
@pytest.mark.parametrize("angle", ["0", "1e-300", "1e-8", "1", "3", "pi"])
@pytest.mark.parametrize("name", ["SE2", "SE3", "SE23", "SE3 x R3"])
def test_log_inverts_exp(name: str, angle: str, length: str) -> None:
    turn = mp.pi - mp.mpf("1e-12") if angle == "pi" else mp.mpf(angle)
    x = at_angle(name, turn, length)
    assert worst(name, matrix_truth.log(name, matrix_truth.exp(name, x)), x) < TINY


@pytest.mark.parametrize("name", NAMES)
def test_log_inverts_exp_on_random_coordinates(name: str) -> None:
    for x in draw(name, 2, 3):
        x = [entry / 2 for entry in x]  # angles below pi
        assert worst(name, matrix_truth.log(name, matrix_truth.exp(name, x)), x) < TINY


def test_a_quaternion_goes_on_to_two_pi() -> None:
    for turn in (mp.mpf(4), 2 * mp.pi - mp.mpf("1e-12")):
        x = at_angle("S3", turn, 0)
        g = matrix_truth.exp("S3", x)
        assert off(matrix_truth.log("S3", g), x) < TINY
        assert abs(matrix_truth.angle("S3", g) - turn) < TINY
        rate, nu = matrix_truth.rate("S3", g, x), x
        assert off(rate, nu) < TINY  # along the axis the rate is the velocity


@pytest.mark.parametrize("name", ["SO3", "SE3", "S3"])
def test_a_hair_from_the_cut_costs_no_step_per_digit(name: str) -> None:
    full = 2 * mp.pi if name == "S3" else mp.pi
    x = at_angle(name, full - mp.mpf("1e-45"), 1)
    assert worst(name, matrix_truth.log(name, matrix_truth.exp(name, x)), x) < TINY


@pytest.mark.parametrize("name", NAMES)
def test_exp_and_log_are_those_of_scipy(name: str) -> None:
    x = draw(name, 3)[0]
    a = double(spread(name, x).tolist())
    g = matrix_truth.exp(name, x)
    np.testing.assert_allclose(double(matrix_truth.whole(g)), expm(a), atol=1e-13)
    wanted = logm(expm(a))
    found = spread(name, matrix_truth.log(name, g)).tolist()
    np.testing.assert_allclose(double(found), wanted, atol=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_what_is_stored_is_the_element(name: str) -> None:
    g = matrix_truth.exp(name, draw(name, 4)[0])
    again = matrix_truth.element(name, matrix_truth.store(name, g))
    assert matrix_truth.store(name, g)  # never empty
    for a, b in zip(matrix_truth.whole(again), matrix_truth.whole(g), strict=True):
        assert off(a, b) < TINY


def test_storage_and_order_are_those_of_the_conventions() -> None:
    r = Rotation.from_rotvec([0.3, -0.4, 1.2])
    w = np.roll(r.as_quat(), 1)  # scalar first
    velocity, position = [1.0, 2.0, 3.0], [4.0, 5.0, 6.0]
    pose = np.eye(5)
    pose[:3, :3], pose[:3, 3], pose[:3, 4] = r.as_matrix(), velocity, position
    stored = {"SO3": r.as_matrix(), "S3": w, "SE3": np.delete(np.delete(pose, 3, 0), 3, 1),
              "SE23": pose, "R3": np.array(position)}  # fmt: skip
    for name, values in stored.items():
        kept = values.ravel().tolist()
        back = doubles(matrix_truth.store(name, matrix_truth.element(name, kept)))
        np.testing.assert_allclose(back, kept, atol=1e-15)
    for name in ("SO3", "S3", "SE3", "SE23"):
        g = matrix_truth.element(name, stored[name].ravel().tolist())
        np.testing.assert_allclose(
            doubles(matrix_truth.log(name, g))[:3], r.as_rotvec(), atol=1e-14
        )
    still = np.eye(5)
    still[:3, 3], still[:3, 4] = velocity, position
    x = matrix_truth.log("SE23", matrix_truth.element("SE23", still.ravel().tolist()))
    assert doubles(x) == [0, 0, 0, *velocity, *position]
    turned = [0.0, -1.0, 7.0, 1.0, 0.0, 8.0, 0.0, 0.0, 1.0]  # by +pi/2
    assert float(matrix_truth.log("SE2", matrix_truth.element("SE2", turned))[0]) == np.pi / 2


@pytest.mark.parametrize("name", ["SO2", "SE2", "SO3", "SE3", "SE23"])
def test_a_drifted_rotation_is_put_on_the_group(name: str) -> None:
    g = matrix_truth.exp(name, draw(name, 5)[0])
    exact = double(matrix_truth.whole(g))
    size = 2 if name.endswith("2") else 3
    noise = np.random.default_rng(6).normal(size=(size, size)) * 1e-3
    exact[:size, :size] += noise
    found = double(matrix_truth.whole(matrix_truth.element(name, exact.ravel().tolist())))
    u, _, v = np.linalg.svd(exact[:size, :size])
    np.testing.assert_allclose(found[:size, :size], u @ v, atol=1e-14)
    np.testing.assert_array_equal(found[:, size:], exact[:, size:])


@pytest.mark.parametrize("name", NAMES)
def test_bracket_and_adjoints_are_those_of_matrices(name: str) -> None:
    x, y, z = draw(name, 7, 3)
    a, b = spread(name, x), spread(name, y)
    found = matrix_truth.bracket(name, x, y)
    assert mp.mnorm(spread(name, found) - (a * b - b * a)) < TINY
    rows = matrix_truth.ad(name, x)
    assert off([mp.fdot(zip(row, map(mp.mpf, y), strict=True)) for row in rows], found) < TINY
    g = matrix_truth.exp(name, z)
    whole = matrix(matrix_truth.whole(g))
    moved = matrix(matrix_truth.Ad(name, g)) * mp.matrix(x)
    assert mp.mnorm(spread(name, moved) - whole * a * whole**-1) < TINY
    pulled = matrix_truth.pull(name, g, x)
    assert mp.mnorm(spread(name, pulled) - whole**-1 * a * whole) < TINY


@pytest.mark.parametrize("name", NAMES)
def test_rate_of_log_is_the_series_in_ad(name: str) -> None:
    """log' = ad/(1 - exp(-ad)) nu = nu + ad nu/2 + sum B_2k ad^2k nu / (2k)!."""
    x, nu = at_angle(name, 2, 30), draw(name, 8)[0]
    across, term = matrix(matrix_truth.ad(name, x)), mp.matrix(nu)
    wanted = term + across * term / 2
    for k in range(1, 60):
        term = across * (across * term)
        wanted += mp.bernoulli(2 * k) / mp.factorial(2 * k) * term
    assert worst(name, matrix_truth.rate(name, matrix_truth.exp(name, x), nu), wanted) < TINY


@pytest.mark.parametrize("angle", ["0", "1e-300", "1e-8", "3.14159265358"])
def test_rate_of_log_at_the_edges(angle: str) -> None:
    """exp(log g) = g to first order: (1 - exp(-ad))/ad log' = nu, a series that never diverges."""
    x, nu = at_angle("SE3", angle, "1e6"), draw("SE3", 9)[0]
    found = matrix_truth.rate("SE3", matrix_truth.exp("SE3", x), nu)
    across, term = matrix(matrix_truth.ad("SE3", x)), mp.matrix(found)
    back = term
    for k in range(1, 120):
        term = -across * term / (k + 1)
        back = back + term
    # Lengths of 1e6 cancel down to velocities of one.
    assert worst("SE3", back, nu) < mp.mpf("1e-34")


@pytest.mark.parametrize("scale", ["1e-100", "1e25"])
def test_a_rate_is_linear_in_the_velocity(scale: str) -> None:
    g, nu = matrix_truth.exp("SE3", at_angle("SE3", 2, 1)), draw("SE3", 15)[0]
    scaled = matrix_truth.rate("SE3", g, [mp.mpf(scale) * x for x in nu])
    wanted = [mp.mpf(scale) * x for x in matrix_truth.rate("SE3", g, nu)]
    assert worst("SE3", scaled, wanted) < TINY


@pytest.mark.parametrize("scale", ["1e-100", "1", "1e25"])
@pytest.mark.parametrize("name", NAMES)
def test_a_pull_grows_with_the_bracket(name: str, scale: str) -> None:
    x, nu, start, growth = draw(name, 10, 4)
    nu, growth = ([mp.mpf(scale) * entry for entry in each] for each in (nu, growth))
    g = matrix_truth.exp(name, x)
    pulled, grown = (matrix_truth.pull(name, g, each) for each in (start, growth))
    turning = matrix_truth.bracket(name, nu, pulled)
    wanted = [a - b for a, b in zip(grown, turning, strict=True)]
    assert off(matrix_truth.pull_rate(name, g, nu, start, growth), wanted) < TINY


@pytest.mark.parametrize("name", TURNING)
@pytest.mark.parametrize("angle", ["0", "1e-300", "1", "3.14159265358"])
def test_angle_is_that_of_the_rotation(name: str, angle: str) -> None:
    g = matrix_truth.exp(name, at_angle(name, angle, 1))
    assert abs(matrix_truth.angle(name, g) - mp.mpf(angle)) <= mp.mpf(angle) * TINY


def test_the_largest_angle_of_a_product_counts() -> None:
    g = matrix_truth.exp("SO3 x R3 x SO2", (0.1, 0, 0, 5, 5, 5, -0.7))
    assert abs(matrix_truth.angle("SO3 x R3 x SO2", g) - mp.mpf(0.7)) < TINY


@pytest.mark.parametrize(
    ("name", "stored", "message"),
    [
        ("SE4", (1,), "unknown group 'SE4'"),
        ("R0", (1,), "unknown group 'R0'"),
        ("SO3 x SX", (1,), "unknown group 'SX'"),
        ("SO3", (1, 0, 0), "9 numbers are expected, not 3"),
        ("R3", (1, 0, float("nan")), "not finite"),
        ("SO2", (1, 0, 0, -1), "no rotation is nearest"),
        ("SO3", (1, 0, 0, 0, 1, 0, 0, 0, -1), "no rotation is nearest"),
        ("SO3", (0,) * 9, "singular"),
        ("S3", (0, 0, 0, 0), "singular"),
    ],
)
def test_what_is_no_element_is_refused(name: str, stored: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        matrix_truth.element(name, stored)


AXIS = np.array([2, -3, 6]) / 7
HALF_TURN = (2 * np.outer(AXIS, AXIS) - np.eye(3)).ravel().tolist()  # a tie but for rounding
CUT = [("SO2", (-1, 0, 0, -1)), ("SO3", (-1, 0, 0, 0, -1, 0, 0, 0, 1)), ("SO3", HALF_TURN),
       ("S3", (-1, 0, 0, 0))]  # fmt: skip


@pytest.mark.parametrize(("name", "stored"), CUT)
def test_no_logarithm_is_principal_at_the_cut(name: str, stored: Any) -> None:
    with pytest.raises(ValueError, match="singular"):
        matrix_truth.log(name, matrix_truth.element(name, stored))
    assert norm(matrix_truth.law(name, "skew", matrix_truth.element(name, stored))) < 1e-120
