"""The truth against scipy, exponentials and Jacobians it does not use, and at the edges."""

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from derive.verify.oracle import truth

mp = truth.mp
INERTIA = tuple(
    tuple(Fraction(x) for x in row.split())
    for row in ("3.6046 -0.0706 0.1491", "-0.0706 8.6868 0.0449", "0.1491 0.0449 9.3484")
)
IDENTITY = truth.IDENTITY
PAIRS = sorted(truth.LAWS)
AXIS = tuple(mp.mpf(x) / 7 for x in (2, -3, 6))  # a unit vector
# Away from the ladder's ends, and up to them: the half angle on S3 goes on to pi.
ANGLES = ("0", "1e-300", "1e-160", "1e-8", "0.1", "1", "3", "3.1415926535")


def unit(angle: Any, axis: tuple[Any, ...] = AXIS) -> tuple[Any, ...]:
    half = mp.mpf(angle) / 2
    return (mp.cos(half), *(mp.sin(half) * x for x in axis))


def hat(x: Any) -> Any:
    return mp.matrix([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]])


def column(x: Any) -> Any:
    return mp.matrix(list(x))


def distance(a: Any, b: Any) -> Any:
    """|a - b| / |b|, or |a| where b is 0."""
    b = tuple(b)
    size = mp.sqrt(sum(x * x for x in b))
    return mp.sqrt(sum((x - y) ** 2 for x, y in zip(a, b, strict=True))) / (size or 1)


def random_vectors(seed: int, count: int) -> list[tuple[float, ...]]:
    rows = np.random.default_rng(seed).normal(size=(count, 3))
    return [tuple(map(float, row)) for row in rows]


@pytest.mark.parametrize("seed", range(20))
def test_log_is_that_of_scipy(seed: int) -> None:
    stored = Rotation.random(rng=np.random.default_rng(seed))
    q = truth.error("SO3", IDENTITY["SO3"], stored.as_matrix().ravel().tolist())
    measured = np.array(truth.law("SO3", "log", q), float)
    np.testing.assert_allclose(measured, stored.as_rotvec(), rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("angle", ["1e-300", "1e-9", "0.5", "2", "3.14159265"])
def test_log_inverts_a_matrix_exponential(angle: str) -> None:
    wanted = [mp.mpf(angle) * x for x in AXIS]
    rotation = mp.expm(hat(wanted), method="taylor")
    rows = tuple(tuple(rotation[i, j] for j in range(3)) for i in range(3))
    assert distance(truth.law("SO3", "log", truth.quaternion(rows)), wanted) < mp.mpf("1e-100")


def test_an_angle_of_1e_minus_300_is_kept() -> None:
    tiny = 1e-300
    matrix = (1, -tiny, 0, tiny, 1, 0, 0, 0, 1)
    for group, stored, turn in (("SO3", matrix, tiny), ("S3", (1, 0, 0, tiny), 2 * mp.mpf(tiny))):
        q = truth.error(group, IDENTITY[group], stored)
        assert distance(truth.law(group, "log", q), (0, 0, mp.mpf(turn))) < mp.mpf("1e-100")
        nu = (0.3, -2.0, 1e-3)
        assert distance(truth.rate(group, "log", q, nu), map(mp.mpf, nu)) < mp.mpf("1e-80")


def test_a_quaternion_keeps_its_sign() -> None:
    q = truth.error("S3", (2, 0, 0, 0), (-3, 0, 0, 4))
    assert distance(q, (mp.mpf(-3) / 5, 0, 0, mp.mpf(4) / 5)) < mp.mpf("1e-125")
    assert truth.law("S3", "log", q)[2] > mp.pi
    assert distance(truth.law("S3", "half_log", q), (0, 0, mp.acos(mp.mpf(-3) / 5))) < 1e-100


@pytest.mark.parametrize(("law", "wanted"), [("log", 2), ("half_log", 1)])
def test_at_minus_i_the_axis_is_the_first(law: str, wanted: int) -> None:
    value = truth.law("S3", law, truth.error("S3", IDENTITY["S3"], (-1, 0, 0, 0)))
    assert distance(value, (wanted * mp.pi, 0, 0)) < mp.mpf("1e-100")
    with pytest.raises(ZeroDivisionError):
        truth.rate("S3", law, (mp.mpf(-1), mp.zero, mp.zero, mp.zero), (1, 0, 0))


@pytest.mark.parametrize("angle", [*ANGLES, "4", "6.2831"])
def test_algebraic_laws_need_no_angle(angle: str) -> None:
    q = unit(angle)
    w, v = q[0], q[1:]
    factors = {
        ("SO3", "lee"): 1,
        ("SO3", "skew"): 2 * w,
        ("SO3", "gibbs"): 2 / w,
        ("SO3", "mrp"): 4 / (1 + w),
        ("S3", "mrp"): 4 / (1 + w),
        ("S3", "vec"): 2,
        ("S3", "sign_vec"): mp.sign(w),
    }
    for key, factor in factors.items():
        assert distance(truth.law(*key, q), [factor * x for x in v]) < mp.mpf("1e-100"), key


@pytest.mark.parametrize("nu", [*random_vectors(1, 3), (1.0, 0.0, 0.0), (1e-200, 1e-201, 0.0)])
@pytest.mark.parametrize("angle", ["0.3", "1", "2", "3.1", "3.3", "6.28318"])
def test_log_rate_is_the_inverse_right_jacobian(angle: str, nu: tuple[float, ...]) -> None:
    phi = mp.mpf(angle)
    across, speed = hat([phi * x for x in AXIS]), column(map(mp.mpf, nu))
    slope = 1 / phi**2 - (1 + mp.cos(phi)) / (2 * phi * mp.sin(phi))
    wanted = speed + across * speed / 2 + slope * (across * (across * speed))
    for group in ("SO3", "S3"):
        assert distance(truth.rate(group, "log", unit(phi), nu), wanted) < mp.mpf("1e-60")


@pytest.mark.parametrize(("group", "law"), PAIRS)
@pytest.mark.parametrize("angle", ANGLES)
def test_rates_integrate_to_differences(group: str, law: str, angle: str) -> None:
    """Fourth order and another step: a wrong factor or an aliased step would show."""
    q, nu = unit(angle), random_vectors(5, 1)[0]
    speed = tuple(map(mp.mpf, nu))
    h = mp.mpf("1e-25")
    at = [truth.LAWS[group, law](truth.flow(q, speed, k * h)) for k in (-2, -1, 1, 2)]
    wanted = [(a - 8 * b + 8 * c - d) / (12 * h) for a, b, c, d in zip(*at, strict=True)]
    assert distance(truth.rate(group, law, q, nu), wanted) < mp.mpf("1e-45")


@pytest.mark.parametrize("gap", ["1e-3", "1e-7", "1e-12"])
def test_near_minus_i_the_rate_stays_sharp(gap: str) -> None:
    """d/dt (u/s v) = u/s v' + (u'/s - u s'/s^2) v with s' = w u', by hand here only."""
    u = mp.pi - mp.mpf(gap)
    w, s = mp.cos(u), mp.sin(u)
    v, nu = tuple(s * x for x in AXIS), tuple(map(mp.mpf, random_vectors(6, 1)[0]))
    v_dot = (w * column(nu) + hat(v) * column(nu)) / 2
    u_dot = sum(a * b for a, b in zip(v, nu, strict=True)) / (2 * s)
    wanted = u / s * v_dot + (u_dot / s - u * w * u_dot / s**2) * column(v)
    assert distance(truth.rate("S3", "half_log", (w, *v), nu), wanted) < mp.mpf("1e-50")


def test_sign_vec_keeps_its_branch_at_a_tiny_scalar() -> None:
    q = truth.normalise((-5e-324, 0.6, 0.0, 0.8))
    assert distance(truth.law("S3", "sign_vec", q), (-q[1], -q[2], -q[3])) < 1e-100
    # -v' = -(w nu + v x nu)/2 with nu = 2 e3: the branch of q, not that across w = 0.
    rate = truth.rate("S3", "sign_vec", q, (0.0, 0.0, 2.0))
    assert distance(rate, (0, q[1], 0)) < mp.mpf("1e-60")


@pytest.mark.parametrize("scale", [1e-150, 1.0, 1e6])
def test_eta_is_the_matrix_product_and_its_rate_the_bracket(scale: float) -> None:
    q = unit("2.5")
    rotation = mp.expm(hat([mp.mpf("2.5") * x for x in AXIS]), method="taylor")
    speed, nu_r, growth = (column(map(mp.mpf, x)) for x in random_vectors(2, 3))
    speed, growth = speed * scale, growth * scale
    moved = rotation.T * nu_r
    assert distance(truth.eta(q, tuple(nu_r)), moved) < mp.mpf("1e-100")
    wanted = rotation.T * growth - hat(speed) * moved
    measured = truth.eta_rate(q, tuple(speed), tuple(nu_r), tuple(growth))
    assert distance(measured, wanted) < mp.mpf("1e-60")


@pytest.mark.parametrize(("group", "law"), PAIRS)
def test_the_closed_loop_decays_as_the_paper_says(group: str, law: str) -> None:
    """J s' = (J nu) x s - k_s J s along the plant; the proof of Theorem (TckCtrl)."""
    nu, nu_r, nu_r_dot = random_vectors(8, 3)
    g_r, g = {
        "S3": ((0.5, 0.5, -0.5, 0.5), (0.8, 0.0, 0.6, 0.0)),
        "SO3": ((0, -1, 0, 1, 0, 0, 0, 0, 1), (0.28, 0, 0.96, 0, 1, 0, -0.96, 0, 0.28)),
    }[group]
    out = truth.tracking(group, law, INERTIA, 0.5, 1.25, g_r, g, nu, nu_r, nu_r_dot)
    nu_dot = truth.plant(INERTIA, nu, out["force"])
    s_dot = column(nu_dot) - column(out["eta_dot"]) + column(out["nu_u_dot"]) / 2
    inertia = mp.matrix([[mp.mpf(x.numerator) / x.denominator for x in row] for row in INERTIA])
    momentum = inertia * column(map(mp.mpf, nu))
    s = column(out["s"])
    wanted = hat(momentum) * s - mp.mpf("1.25") * (inertia * s)
    assert distance(inertia * s_dot, wanted) < mp.mpf("1e-60")


@pytest.mark.parametrize(("group", "law"), PAIRS)
def test_reaching_is_tracking_of_rest(group: str, law: str) -> None:
    stored = {"S3": (-0.6, 0.0, 0.8, 0.0), "SO3": (0, -1, 0, 1, 0, 0, 0, 0, 1)}[group]
    nu, rest = (0.3, -0.2, 0.9), (0.0, 0.0, 0.0)
    alone = truth.reaching(group, law, INERTIA, 0.5, 2, stored, nu)
    both = truth.tracking(group, law, INERTIA, 0.5, 2, IDENTITY[group], stored, nu, rest, rest)
    for name in ("s", "nu_u", "nu_u_dot", "force"):
        assert distance(alone[name], both[name]) < mp.mpf("1e-100")


def test_the_other_branch_lies_across_the_cut() -> None:
    stored = Rotation.from_rotvec([0, 0, np.pi - 1e-9]).as_matrix().ravel().tolist()
    state = (IDENTITY["SO3"], stored, (1, 0, 0), (0, 0, 0), (0, 0, 0))
    near, far = (
        truth.tracking("SO3", "log", INERTIA, 1, 1, *state, flip=flip) for flip in (False, True)
    )
    gap = [a - b for a, b in zip(near["nu_u"], far["nu_u"], strict=True)]
    assert distance(gap, (0, 0, 2 * mp.pi)) < mp.mpf("1e-7")  # of the axis, rounded with R
    assert distance(near["eta_dot"], far["eta_dot"]) == 0
    assert distance(near["nu_u_dot"], far["nu_u_dot"]) > mp.mpf("0.1")
    with pytest.raises(ValueError, match="SO3"):
        truth.reaching("S3", "log", INERTIA, 1, 1, IDENTITY["S3"], (0, 0, 0), flip=True)
