"""The truth about the baselines, against the paper's matrices in plain numpy and at the edges."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from derive.verify.oracle.baseline_truth import LAWS, tracking
from derive.verify.oracle.precise import mp, quaternion

Array = NDArray[np.float64]
J = np.array([[3.6046, -0.0706, 0.1491], [-0.0706, 8.6868, 0.0449], [0.1491, 0.0449, 9.3484]])
ROWS: list[list[float]] = J.tolist()
GAINS = {
    "lsf_printed": {"k": 1.5, "kappa": 0.5},
    "lsf": {"k": 1.5, "kappa": 0.5},
    "pd_plus": {"k_R": 9.25, "k_Omega": 18.5},
}


def hat(x: Any) -> Array:
    return np.array([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]])


def vee(a: Any) -> Array:
    return np.array([a[2, 1], a[0, 2], a[1, 0]])


def plain(
    name: str, R_r: Array, R: Array, W: Array, W_r: Array, rate: Array
) -> tuple[Array, Array]:
    """(force, s), spelled as eqs. (Ctrls2), (s2), (Ctrls3), (s3) are."""
    if name == "pd_plus":
        k_R, k_Omega = GAINS[name].values()
        R_e = R_r.T @ R
        psi = 1 / (2 * np.sqrt(1 + np.trace(R_e)))
        s = W - R_e.T @ W_r + k_R / k_Omega * psi * vee(R_e - R_e.T)
        seen = R.T @ R_r @ W_r
        return -k_Omega * s + J @ R.T @ R_r @ rate + hat(seen) @ J @ seen, s
    k, kappa = GAINS[name].values()
    s = W - W_r + kappa / k * R.T @ vee(R @ R_r.T - R_r @ R.T)
    last = -hat(W) @ W_r if name == "lsf_printed" else J @ hat(W) @ W_r
    return -k * J @ s + J @ rate - hat(J @ W) @ W + last, s


@pytest.mark.parametrize("name", LAWS)
def test_it_is_what_the_paper_prints(name: str) -> None:
    rng, rotations = np.random.default_rng(2), Rotation.random(16, random_state=3).as_matrix()
    rotations = rotations.reshape(2, 8, 3, 3)
    for R_r, R in zip(*rotations, strict=True):
        W, W_r, rate = rng.normal(size=(3, 3))
        found = tracking(name, ROWS, GAINS[name], R_r.ravel(), R.ravel(), W, W_r, rate)
        force, s = plain(name, R_r, R, W, W_r, rate)
        np.testing.assert_allclose(np.array(found["force"], float), force, rtol=1e-10, atol=1e-11)
        np.testing.assert_allclose(np.array(found["s"], float), s, rtol=1e-10, atol=1e-12)
        error = Rotation.from_matrix(R_r.T @ R).as_quat(scalar_first=True)
        np.testing.assert_allclose(abs(np.array(found["q"], float)), abs(error), atol=1e-12)


@pytest.mark.parametrize("name", LAWS)
def test_wheels_and_a_known_torque(name: str) -> None:
    """The torque is left out; wheels turn with the body for LSF, with the reference for PD+."""
    rng = np.random.default_rng(4)
    R_r, R = Rotation.random(2, random_state=1).as_matrix()
    W, W_r, rate, wheels, torque = rng.normal(size=(5, 3))
    at: list[Any] = [R_r.ravel(), R.ravel(), W, W_r, rate]
    bare, whole = (
        tracking(name, ROWS, GAINS[name], *at, *extras)
        for extras in ((STILL, STILL), (wheels, torque))
    )
    seen = R.T @ R_r @ W_r
    more = hat(seen) @ wheels if name == "pd_plus" else -hat(wheels) @ W
    change = np.array(whole["force"], float) - np.array(bare["force"], float)
    np.testing.assert_allclose(change, more - torque, atol=1e-13)
    assert whole["s"] == bare["s"]


def about(axis: Array, angle: Any) -> list[Any]:
    """A rotation in 130 digits."""
    n = [mp.mpf(x) for x in axis]
    size = mp.norm(n)
    a, c, s = [x / size for x in n], mp.cos(angle), mp.sin(angle)
    skew = hat(np.array(a, object))
    return [(1 if i == j else 0) * c + (1 - c) * a[i] * a[j] + s * skew[i, j]
            for i in range(3) for j in range(3)]  # fmt: skip


ONE = (1, 0, 0, 0, 1, 0, 0, 0, 1)
STILL = (0, 0, 0)


def error(name: str, g: Any, *, flip: bool = False) -> Any:
    return tracking(name, ROWS, GAINS[name], ONE, g, STILL, STILL, STILL, flip=flip)["nu_u"]


@pytest.mark.parametrize("angle", ["0", "1e-300", "1e-8", "1", "3.14", "pi - 1e-30"])
def test_attitude_errors_are_sines(angle: str) -> None:
    turn = mp.pi - mp.mpf("1e-30") if "pi" in angle else mp.mpf(angle)
    axis = np.array([2.0, -3.0, 6.0]) / 7
    for name, size in (("lsf", 2 * mp.sin(turn)), ("pd_plus", mp.sin(turn / 2))):
        found = error(name, about(axis, turn))
        wanted = [size * mp.mpf(x) / mp.norm([mp.mpf(y) for y in axis]) for x in axis]
        off = mp.norm([a - b for a, b in zip(found, wanted, strict=True)])
        assert off <= mp.mpf("1e-90") * abs(size)


def test_at_pi_pd_plus_takes_the_side_of_the_conventions() -> None:
    half_turn = (-1, 0, 0, 0, 1, 0, 0, 0, -1)
    assert [float(x) for x in error("pd_plus", half_turn)] == [0, 1, 0]
    assert [float(x) for x in error("pd_plus", half_turn, flip=True)] == [0, -1, 0]
    assert [float(x) for x in error("lsf", half_turn)] == [0, 0, 0]
    assert quaternion(((-1, 0, 0), (0, 1, 0), (0, 0, -1)))[2] == 1


def test_another_controller_is_none_of_these() -> None:
    with pytest.raises(KeyError):
        tracking("gsmc", ROWS, {"lambda": 1, "k_s": 1}, ONE, ONE, STILL, STILL, STILL)
