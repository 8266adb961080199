"""The paper's formulas as printed, in CasADi, differentiated by CasADi's own AD.

Nothing is regularised: arccos of the trace, the axis from R - R^T, the inverse inertia. So the
twin is an oracle between about 0.3 and 2.8 rad of error, and singular at both ends.
Inputs are taken to lie on the group; nothing is projected.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

import casadi as ca
import numpy as np
from numpy.typing import ArrayLike, NDArray

INPUTS = (
    "g", "nu", "g_r", "nu_r", "nu_r_dot", "momentum", "external", "inertia", "lambda", "k_s",
)  # fmt: skip
OUTPUTS = ("nu_u", "nu_u_dot", "eta_dot", "force")


def _product(p: ca.SX, q: ca.SX) -> ca.SX:
    """p (x) q = Q(p) q, scalar first."""
    top = ca.horzcat(p[0], -p[1:].T)
    rest = ca.horzcat(p[1:], p[0] * ca.SX.eye(3) + ca.skew(p[1:]))
    return ca.vertcat(top, rest) @ q


def _conjugate(q: ca.SX) -> ca.SX:
    return ca.vertcat(q[0], -q[1:])


def _bar(x: ca.SX) -> ca.SX:
    return ca.vertcat(0, x)


@dataclass(frozen=True)
class _Group:
    """A group as the paper writes it; `shape` is that of an element."""

    shape: tuple[int, int]
    element: Callable[[ca.SX], ca.SX]  # stored numbers to element
    error: Callable[[ca.SX, ca.SX], ca.SX]  # g_r^-1 g
    velocity: Callable[[ca.SX, ca.SX], ca.SX]  # g nu, the rate of g
    to_body: Callable[[ca.SX, ca.SX], ca.SX]  # Ad(g^-1) x


_GROUPS = {
    "SO3": _Group(
        shape=(3, 3),
        element=lambda stored: ca.reshape(stored, 3, 3).T,  # CasADi counts down columns
        error=lambda r_r, r: r_r.T @ r,
        velocity=lambda r, nu: r @ ca.skew(nu),
        to_body=lambda r, x: r.T @ x,
    ),
    "S3": _Group(
        shape=(4, 1),
        element=lambda stored: stored,
        error=lambda q_r, q: _product(_conjugate(q_r), q),
        velocity=lambda q, nu: _product(q, _bar(nu)) / 2,
        to_body=lambda q, x: _product(_product(_conjugate(q), _bar(x)), q)[1:],
    ),
}


def _angle(r: ca.SX) -> ca.SX:
    """phi(R) = arccos((tr R - 1)/2); below eq. (KinCtrlLawSO3)."""
    return ca.acos((ca.trace(r) - 1) / 2)


def _odd(r: ca.SX) -> ca.SX:
    """(R - R^T)^vee, twice sin(phi) times the axis."""
    return ca.inv_skew(r - r.T)


def _lee(r: ca.SX) -> ca.SX:
    return _odd(r) / (2 * ca.sqrt(1 + ca.trace(r)))  # psi(R) (R - R^T)^vee


def _half_log(q: ca.SX) -> ca.SX:
    return ca.acos(q[0]) / ca.norm_2(q[1:]) * q[1:]  # eq. (KinCtrlLawS3)


LAWS: dict[tuple[str, str], Callable[[ca.SX], ca.SX]] = {
    ("SO3", "log"): lambda r: _angle(r) / (2 * ca.sin(_angle(r))) * _odd(r),
    ("SO3", "lee"): _lee,
    ("SO3", "skew"): lambda r: _odd(r) / 2,
    ("SO3", "gibbs"): lambda r: 2 * ca.tan(_angle(r) / 2) / (2 * ca.sin(_angle(r))) * _odd(r),
    ("SO3", "mrp"): lambda r: 4 * ca.tan(_angle(r) / 4) / (2 * ca.sin(_angle(r))) * _odd(r),
    ("SO3", "cayley"): lambda r: 2 * ca.tan(_angle(r) / 2) / (2 * ca.sin(_angle(r))) * _odd(r),
    ("S3", "log"): lambda q: 2 * _half_log(q),
    ("S3", "half_log"): _half_log,
    ("S3", "mrp"): lambda q: 4 * q[1:] / (1 + q[0]),
    ("S3", "cayley"): lambda q: 4 * q[1:] / (1 + q[0]),
    ("S3", "vec"): lambda q: 2 * q[1:],
    ("S3", "sign_vec"): lambda q: ca.sign(q[0]) * q[1:],
}


@cache
def _rates(group: str, law: str) -> ca.Function:
    """(g_e, nu_e, nu_r, nu_r_dot) -> (nu_u, nu_u_dot, eta_dot), each rate one forward AD sweep."""
    g = _GROUPS[group]
    g_e = ca.SX.sym("g_e", *g.shape)
    nu_e, nu_r, nu_r_dot = (ca.SX.sym(name, 3) for name in ("nu_e", "nu_r", "nu_r_dot"))
    flow = ca.vec(g.velocity(g_e, nu_e))
    nu_u, eta = LAWS[group, law](g_e), g.to_body(g_e, nu_r)
    nu_u_dot = ca.jtimes(nu_u, ca.vec(g_e), flow)
    everything = ca.vertcat(ca.vec(g_e), nu_r)
    eta_dot = ca.jtimes(eta, everything, ca.vertcat(flow, nu_r_dot))
    return ca.Function("rates", [g_e, nu_e, nu_r, nu_r_dot], [nu_u, nu_u_dot, eta_dot])


@cache
def twin(group: str, law: str) -> ca.Function:
    """The tracking law of eqs. (TckCtrlSO3) and (TckCtrlS3), J^-1 included.

    Inputs, as named in INPUTS: g and g_r as stored (9 row-major or 4 scalar first), velocities
    in rad/s, momentum (of wheels) in N m s, external (a known torque) in N m, inertia (3, 3) in
    kg m^2, gains in 1/s. Outputs, as named in OUTPUTS, (3,) each:
    the force in N m. KeyError when the law does not exist on the group.
    """
    g = _GROUPS[group]
    size = g.shape[0] * g.shape[1]
    vectors = ((3, 1),) * 4
    shapes = ((size, 1), (3, 1), (size, 1), *vectors, (3, 3), (1, 1), (1, 1))
    symbols = [ca.SX.sym(name, *shape) for name, shape in zip(INPUTS, shapes, strict=True)]
    stored, nu, stored_r, nu_r, nu_r_dot, momentum, external, inertia, slope, reach = symbols
    g_e = g.error(g.element(stored_r), g.element(stored))
    eta = g.to_body(g_e, nu_r)
    nu_e = nu - eta
    nu_u, nu_u_dot, eta_dot = _rates(group, law)(g_e, nu_e, nu_r, nu_r_dot)
    s = nu_e + slope * nu_u
    turning = ca.cross(inertia @ nu + momentum, slope * nu_u - eta)
    wanted = ca.inv(inertia) @ turning - slope * nu_u_dot + eta_dot - reach * s
    outputs = [nu_u, nu_u_dot, eta_dot, inertia @ wanted - external]
    return ca.Function("twin", symbols, outputs, list(INPUTS), list(OUTPUTS))


def evaluate(
    function: ca.Function, inputs: Mapping[str, ArrayLike]
) -> dict[str, NDArray[np.float64]]:
    """A function of columns and matrices over a batch, by name: (rows, n) arrays each.

    `inputs` holds for every input either one value of its own shape or a leading axis of them;
    names are unknown or missing: KeyError.
    """
    names = function.name_in()
    if set(names) != set(inputs):
        raise KeyError(f"inputs are {sorted(inputs)}, expected {sorted(names)}")
    batches = [_batch(inputs[name], function.size_in(name)) for name in names]
    rows = max(map(len, batches))
    columns = [
        np.broadcast_to(x, (rows, *x.shape[1:])).transpose(1, 0, 2).reshape(x.shape[1], -1)
        for x in batches
    ]
    results = function.map(rows).call([ca.DM(np.ascontiguousarray(x)) for x in columns])
    return {
        name: np.array(result, dtype=np.float64).T
        for name, result in zip(function.name_out(), results, strict=True)
    }


def _batch(value: ArrayLike, shape: tuple[int, int]) -> NDArray[np.float64]:
    """(rows or 1, *shape): one matrix, or a leading axis of them."""
    return np.asarray(value, dtype=np.float64).reshape(-1, *shape)
