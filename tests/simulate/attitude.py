"""The closed loop of the paper once more, by hand: 3 by 3 matrices and scipy, nothing of ours."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

Array = NDArray[np.float64]

J = np.array([[3.6046, -0.0706, 0.1491], [-0.0706, 8.6868, 0.0449], [0.1491, 0.0449, 9.3484]])
Omega_r = np.array([0.0, 0.1, 0.0])
Omega_0 = np.array([1.0, 2.0, 3.0]) / (2 * np.sqrt(14.0))


def hat(x: Array) -> Array:
    return np.array([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]], dtype=np.float64)


def odd(R: Array) -> Array:
    """(R - R^T)^vee."""
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])


def euler_312(phi: float, theta: float, psi: float) -> Array:
    """Shuster's R_312, entry by entry from his table of attitude matrices."""
    cp, sp, ct, st, cs, ss = (f(x) for x in (phi, theta, psi) for f in (np.cos, np.sin))
    return np.array([
        [cs * cp - ss * st * sp, cs * sp + ss * st * cp, -ss * ct],
        [-ct * sp, ct * cp, st],
        [ss * cp + cs * st * sp, ss * sp - cs * st * cp, cs * ct],
    ])  # fmt: skip


R_r0 = euler_312(np.pi / 4, -np.pi, np.pi / 4)


def reference(t: float) -> Array:
    """R_r(t): a turn by 0.1 t about the second body axis."""
    angle = 0.1 * t
    W = hat(np.array([0.0, 1.0, 0.0]))
    return np.asarray(R_r0 @ (np.eye(3) + np.sin(angle) * W + (1 - np.cos(angle)) * W @ W))


def logarithm(R: Array) -> Array:
    v = odd(R) / 2
    sine = float(np.linalg.norm(v))
    angle = np.arctan2(sine, (np.trace(R) - 1) / 2)
    return v if sine < 1e-12 else np.asarray(angle / sine * v)


def log_rate(x: Array, w: Array) -> Array:
    """x' of exp(x^) that turns with the body rate w."""
    angle = float(np.linalg.norm(x))
    if angle < 1e-2:
        c = 1 / 12 + angle**2 / 720 + angle**4 / 30240
    else:
        c = 1 / angle**2 - (1 + np.cos(angle)) / (2 * angle * np.sin(angle))
    return np.asarray(w + np.cross(x, w) / 2 + c * np.cross(x, np.cross(x, w)))


def gsmc(R: Array, Omega: Array, R_r: Array) -> Array:
    """Eq. (Ctrls1), k_s = 1, lambda = 0.5."""
    R_e = R_r.T @ R
    sigma = R_e.T @ Omega_r
    Omega_e = Omega - sigma
    u = logarithm(R_e)
    s = Omega_e + 0.5 * u
    wanted = -0.5 * log_rate(u, Omega_e) - np.cross(Omega_e, sigma)
    return np.asarray(-J @ s + J @ wanted + np.cross(J @ Omega, 0.5 * u - sigma))


def s_2(R: Array, Omega: Array, R_r: Array) -> Array:
    return np.asarray(Omega - Omega_r + 0.5 * R.T @ odd(R @ R_r.T))


def lsf_printed(R: Array, Omega: Array, R_r: Array) -> Array:
    """Eq. (Ctrls2), k = 1, kappa = 0.5."""
    turning = -np.cross(J @ Omega, Omega) - np.cross(Omega, Omega_r)
    return np.asarray(-J @ s_2(R, Omega, R_r) + turning)


def lsf(R: Array, Omega: Array, R_r: Array) -> Array:
    """With the F_2 that leaves s_2' = -k s_2."""
    turning = -np.cross(J @ Omega, Omega) + J @ np.cross(Omega, Omega_r)
    return np.asarray(-J @ s_2(R, Omega, R_r) + turning)


def pd_plus(R: Array, Omega: Array, R_r: Array) -> Array:
    """Eq. (Ctrls3), k_Omega = 18.5, k_R = 9.25."""
    R_e = R_r.T @ R
    sigma = R_e.T @ Omega_r
    e_R = odd(R_e) / (2 * np.sqrt(1 + np.trace(R_e)))
    return np.asarray(-18.5 * (Omega - sigma) - 9.25 * e_R + np.cross(sigma, J @ sigma))


Law = Callable[[Array, Array, Array], Array]
LAWS: dict[str, Law] = {
    "gsmc": gsmc, "lsf_printed": lsf_printed, "lsf": lsf, "pd_plus": pd_plus,
}  # fmt: skip


def flown(law: Law, turns: float, instants: Sequence[float]) -> tuple[Array, Array, Array]:
    """R (T, 3, 3), Omega (T, 3), energy (T,) at those instants from R_312(0, turns pi, 0)."""

    def rates(t: float, y: Any) -> Array:
        R, Omega = y[:9].reshape(3, 3), y[9:12]
        torque = law(R, Omega, reference(t))
        gain = np.linalg.solve(J, np.cross(J @ Omega, Omega) + torque)
        return np.concatenate([(R @ hat(Omega)).ravel(), gain, [torque @ torque]])

    start = np.concatenate([(R_r0 @ euler_312(0.0, turns * np.pi, 0.0)).ravel(), Omega_0, [0.0]])
    found = solve_ivp(rates, (0.0, instants[-1]), start, method="DOP853", rtol=1e-12, atol=1e-14,
                      t_eval=list(instants))  # fmt: skip
    return found.y[:9].T.reshape(-1, 3, 3), found.y[9:12].T, np.sqrt(found.y[12])
