"""The truth about the paper's controller, and no closed form of any rate.

Inputs are stored numbers, outputs tuples of mpf. Rates are central differences along the flow;
nothing is differentiated by hand and nothing of `derive` outside this folder is imported, so
that no mistake can stand on both sides of a comparison.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from derive.verify.oracle.precise import (
    Matrix,
    Number,
    Quaternion,
    Vector,
    blend,
    cross,
    error,
    exactly,
    inverse_transposed,
    mp,
    negative,
    norm,
    normalise,
    product,
    project,
    quaternion,
    times,
    vector,
)

__all__ = [
    "LAWS", "error", "eta", "eta_rate", "law", "mp", "normalise", "plant", "project",
    "quaternion", "rate", "reaching", "tracking",
]  # fmt: skip

# A step h costs h^2 in truncation and 1e-130 / h in rounding: here 1e-84 and 1e-88.
STEP = mp.mpf(10) ** -42
STILL = (0, 0, 0)
IDENTITY = {"SO3": (1, 0, 0, 0, 1, 0, 0, 0, 1), "S3": (1, 0, 0, 0)}


def _along_axis(length: Callable[[Number], Number], q: Quaternion) -> Vector:
    """length(u) n, with u in [0, pi] half the rotation angle and n the axis; n = e1 at -i."""
    w, v = q[0], q[1:]
    s = norm(v)
    if s == 0:
        return v if w > 0 else (length(+mp.pi), mp.zero, mp.zero)
    factor = length(mp.atan2(s, w)) / s
    return tuple(factor * x for x in v)


_LENGTHS: dict[tuple[str, str], Callable[[Number], Number]] = {
    ("SO3", "log"): lambda u: 2 * u,
    ("SO3", "lee"): lambda u: mp.sin(u),
    ("SO3", "skew"): lambda u: mp.sin(2 * u),
    ("SO3", "gibbs"): lambda u: 2 * mp.tan(u),
    ("SO3", "mrp"): lambda u: 4 * mp.tan(u / 2),
    ("SO3", "cayley"): lambda u: 2 * mp.tan(u),
    ("S3", "log"): lambda u: 2 * u,
    ("S3", "half_log"): lambda u: u,
    ("S3", "mrp"): lambda u: 4 * mp.tan(u / 2),
    ("S3", "cayley"): lambda u: 4 * mp.tan(u / 2),
    ("S3", "vec"): lambda u: 2 * mp.sin(u),
    ("S3", "sign_vec"): lambda u: mp.sin(u),
}
FOLDED = {("S3", "sign_vec")}  # sign(w) vec(q): of q and -q the one with w >= 0 counts

LAWS: dict[tuple[str, str], Callable[[Quaternion], Vector]] = {
    key: partial(_along_axis, length) for key, length in _LENGTHS.items()
}
"""(group, law) -> nu_u of a unit quaternion: analytic, every choice of sign made before."""


def branch(group: str, name: str, q: Quaternion) -> Quaternion:
    """The quaternion whose neighbourhood the law is analytic on: q, or -q for a folded law."""
    return negative(q) if (group, name) in FOLDED and q[0] < 0 else q


def law(group: str, name: str, q: Quaternion) -> Vector:
    """nu_u(g_e), (3,); eqs. (KinCtrlLawSO3), (KinCtrlLawS3) and their kin."""
    return LAWS[group, name](branch(group, name, q))


def rate(group: str, name: str, q: Quaternion, nu: Sequence[Any]) -> Vector:
    """d/dt nu_u along q(t) = q exp(t nu/2) at t = 0, (3,), by a central difference.

    The step is an angle, whatever the length of nu; near -i it shrinks with the distance, so
    that the truncation stays near 1e-84. At -i itself no rate exists: ZeroDivisionError.
    """
    velocity, base = vector(nu), branch(group, name, q)
    speed = norm(velocity)
    if speed == 0:
        return velocity
    step = STEP * (norm(base[1:]) if base[0] < 0 else 1)
    turn = tuple(mp.sin(step / 2) / speed * x for x in velocity)
    ahead, behind = (
        LAWS[group, name](product(base, (mp.cos(step / 2), *side)))
        for side in (turn, negative(turn))
    )
    return blend((speed / (2 * step), ahead), (-speed / (2 * step), behind))


def flow(q: Quaternion, nu: Vector, time: Number) -> Quaternion:
    """q exp(time nu/2), unit: where g' = g nu (eq. Kin) leads when nu stays."""
    speed = norm(nu)
    if speed == 0:
        return q
    u = speed * time / 2
    return product(q, (mp.cos(u), *blend((mp.sin(u) / speed, nu))))


def eta(q: Quaternion, nu_r: Sequence[Any]) -> Vector:
    """Reference velocity in the body frame, Ad(g_e^-1) nu_r = R(q)^T nu_r, (3,), rad/s."""
    w, v, x = q[0], q[1:], vector(nu_r)
    across = cross(v, x)
    return blend((1, x), (-2 * w, across), (2, cross(v, across)))  # Rodrigues, transposed


def eta_rate(q: Quaternion, nu_e: Vector, nu_r: Sequence[Any], nu_r_dot: Sequence[Any]) -> Vector:
    """d/dt eta while g_e flows with nu_e and nu_r grows with nu_r_dot, (3,), rad/s^2."""
    start, growth = vector(nu_r), vector(nu_r_dot)
    size = norm(start)
    # The step is small on the scale of what moves, which may be tiny or huge.
    scale = norm(nu_e) + (norm(growth) / size if size else 0)
    step = STEP / (scale or 1)
    ahead, behind = (
        eta(flow(q, nu_e, side), blend((1, start), (side, growth))) for side in (step, -step)
    )
    return blend((1 / (2 * step), ahead), (-1 / (2 * step), behind))


def _inertia(rows: Sequence[Sequence[Any]]) -> Matrix:
    return tuple(map(vector, rows))


def _sharp(inertia: Matrix, force: Vector) -> Vector:
    """I^sharp: the inertia is symmetric, so J^-T is J^-1."""
    return times(inverse_transposed(inertia), force)


def plant(
    inertia: Sequence[Sequence[Any]],
    nu: Sequence[Any],
    force: Sequence[Any],
    momentum: Sequence[Any] = STILL,
    external: Sequence[Any] = STILL,
) -> Vector:
    """nu_dot, (3,), rad/s^2, of the rigid body under a torque in N m; eq. (DynSO3).

    momentum: of wheels inside, N m s; external: a further torque, N m
    """
    matrix, velocity = _inertia(inertia), vector(nu)
    gyroscopic = cross(_whole_momentum(matrix, velocity, momentum), velocity)
    moved = (gyroscopic, vector(force), vector(external))
    return blend(*((1, _sharp(matrix, torque)) for torque in moved))


def _whole_momentum(inertia: Matrix, nu: Vector, momentum: Sequence[Any]) -> Vector:
    return blend((1, times(inertia, nu)), (1, vector(momentum)))


def tracking(
    group: str,
    name: str,
    inertia: Sequence[Sequence[Any]],
    rate_gain: Any,
    reach_gain: Any,
    g_r: Sequence[Any],
    g: Sequence[Any],
    nu: Sequence[Any],
    nu_r: Sequence[Any],
    nu_r_dot: Sequence[Any],
    momentum: Sequence[Any] = STILL,
    external: Sequence[Any] = STILL,
    *,
    flip: bool = False,
) -> dict[str, Vector]:
    """The tracking law exactly as printed, with the inverse inertia; eqs. (TckCtrl), (TckCtrlSO3).

    inertia 3 x 3 in kg m^2, rate_gain (lambda) and reach_gain (k_s) in 1/s, g and g_r as stored,
    velocities in rad/s. Returns q (4,), and (3,) each: eta, nu_e, eta_dot, nu_u, nu_u_dot, s,
    f_u (rad/s^2) and force (N m). momentum: of wheels inside, N m s; external: a known torque,
    N m, which the force leaves out. `flip` takes -q instead of q: on SO3 the other branch at the
    cut locus; on S3, where -q is another element, ValueError.
    """
    if flip and group != "SO3":
        raise ValueError(f"only SO3 has a second branch, not {group}")
    q = error(group, g_r, g)
    q = negative(q) if flip else q
    matrix, velocity, slope = _inertia(inertia), vector(nu), exactly(rate_gain)
    out = {"q": q, "eta": eta(q, nu_r)}
    out["nu_e"] = blend((1, velocity), (-1, out["eta"]))
    out["eta_dot"] = eta_rate(q, out["nu_e"], nu_r, nu_r_dot)
    out["nu_u"] = law(group, name, q)
    out["nu_u_dot"] = rate(group, name, q, out["nu_e"])
    out["s"] = blend((1, out["nu_e"]), (slope, out["nu_u"]))
    turning = blend((slope, out["nu_u"]), (-1, out["eta"]))
    carried = _sharp(matrix, cross(_whole_momentum(matrix, velocity, momentum), turning))
    wanted = ((-slope, out["nu_u_dot"]), (1, out["eta_dot"]), (-exactly(reach_gain), out["s"]))
    out["f_u"] = blend((1, carried), *wanted)
    out["force"] = blend((1, times(matrix, out["f_u"])), (-1, vector(external)))
    return out


def reaching(
    group: str,
    name: str,
    inertia: Sequence[Sequence[Any]],
    rate_gain: Any,
    reach_gain: Any,
    g: Sequence[Any],
    nu: Sequence[Any],
    momentum: Sequence[Any] = STILL,
    external: Sequence[Any] = STILL,
    *,
    flip: bool = False,
) -> dict[str, Vector]:
    """The reaching law exactly as printed; eq. (Ctrl2). Units, keys and errors as in tracking."""
    if flip and group != "SO3":
        raise ValueError(f"only SO3 has a second branch, not {group}")
    q = error(group, IDENTITY[group], g)
    q = negative(q) if flip else q
    matrix, velocity, slope = _inertia(inertia), vector(nu), exactly(rate_gain)
    out = {"q": q, "nu_u": law(group, name, q), "nu_u_dot": rate(group, name, q, velocity)}
    out["s"] = blend((1, velocity), (slope, out["nu_u"]))
    whole = _whole_momentum(matrix, velocity, momentum)
    carried = _sharp(matrix, cross(whole, blend((slope, out["nu_u"]))))
    out["f_u"] = blend((1, carried), (-slope, out["nu_u_dot"]), (-exactly(reach_gain), out["s"]))
    out["force"] = blend((1, times(matrix, out["f_u"])), (-1, vector(external)))
    return out
