"""The law for any group: against the truth for attitude, and against its own closed loop."""

import numpy as np
import pytest

from derive.verify.oracle import matrix_truth, truth
from tests.verify.oracle.coordinates import (
    TINY,
    at_angle,
    blocks,
    doubles,
    draw,
    mp,
    norm,
    off,
)

LAWS = sorted(matrix_truth.LAWS)
SAME_LAW = {("SO3", "log"): "log", ("SO3", "skew"): "skew", ("SO3", "cayley"): "gibbs",
            ("S3", "log"): "log", ("S3", "skew"): "vec", ("S3", "cayley"): "mrp"}  # fmt: skip


@pytest.mark.parametrize("angle", ["1e-300", "1e-8", "1", "3.1415926"])
@pytest.mark.parametrize(("name", "law"), SAME_LAW)
def test_attitude_is_what_quaternions_say(name: str, law: str, angle: str) -> None:
    stored = matrix_truth.store(name, matrix_truth.exp(name, at_angle(name, angle, 0)))
    nu, nu_r, nu_r_dot = draw(name, 11, 3)
    inertia = ((3.6, -0.1, 0.2), (-0.1, 8.7, 0.05), (0.2, 0.05, 9.3))
    rest = truth.IDENTITY[name]
    known = SAME_LAW[name, law]
    found = matrix_truth.tracking(name, law, inertia, 0.5, 1.25, rest, stored, nu, nu_r, nu_r_dot)
    wanted = truth.tracking(name, known, inertia, 0.5, 1.25, rest, stored, nu, nu_r, nu_r_dot)
    assert {*found} == {*wanted} - {"q"} | {"angle", "lifted"}
    for key in {*wanted} - {"q"}:
        assert off(found[key], wanted[key]) < mp.mpf("1e-35"), key
    found = matrix_truth.reaching(name, law, inertia, 0.5, 1.25, stored, nu)
    wanted = truth.reaching(name, known, inertia, 0.5, 1.25, stored, nu)
    for key in {*wanted} - {"q"}:
        assert off(found[key], wanted[key]) < mp.mpf("1e-35"), key
    assert abs(found["angle"] / mp.mpf(angle) - 1) < TINY


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("name", ["SE2", "SE3", "SE23", "SE3 x R3", "R3"])
def test_the_closed_loop_decays_as_the_paper_says(name: str, law: str) -> None:
    """I s' = ad*_s I nu - k_s I s along the plant; the proof of Theorem (TckCtrl)."""
    n = sum(blocks(name))
    half = np.random.default_rng(12).normal(size=(n, n))
    inertia = (half @ half.T + np.eye(n)).tolist()
    x_r, x, nu, nu_r, nu_r_dot = draw(name, 13, 5)
    # Doubles that are not quite on the group: the element is what counts.
    g_r, g = (doubles(matrix_truth.store(name, matrix_truth.exp(name, each))) for each in (x_r, x))
    out = matrix_truth.tracking(name, law, inertia, 0.5, 1.25, g_r, g, nu, nu_r, nu_r_dot)
    nu_dot = matrix_truth.plant(name, inertia, nu, out["force"])
    s_dot = mp.matrix(nu_dot) - mp.matrix(out["eta_dot"]) + mp.matrix(out["nu_u_dot"]) / 2
    tensor, s = mp.matrix(inertia), mp.matrix(out["s"])
    momentum, basis = tensor * mp.matrix(nu), mp.eye(n)
    sides = [matrix_truth.bracket(name, tuple(s), tuple(basis[:, k])) for k in range(n)]
    turned = mp.matrix([mp.fdot(zip(momentum, side, strict=True)) for side in sides])
    assert off(tensor * s_dot, turned - mp.mpf("1.25") * (tensor * s)) < TINY


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", ["SO3", "S3", "SE3", "SE3 x R3"])
def test_no_error_is_exactly_none(name: str, seed: int) -> None:
    """A drifted reference against itself: no rounding of 130 digits is taken for an angle."""
    g = doubles(matrix_truth.store(name, matrix_truth.exp(name, draw(name, seed)[0])))
    still, n = [0.0] * sum(blocks(name)), sum(blocks(name))
    out = matrix_truth.tracking(name, "log", np.eye(n).tolist(), 1, 1, g, g, still, still, still)
    assert out["angle"] == 0
    assert norm(out["nu_u"][:3]) == 0
    assert norm(out["force"]) < mp.mpf("1e-120")
