"""The truth about the controllers the paper compares with, as it prints them, with matrices.

Eqs. (Ctrls2), (s2) of LSF, (Ctrls3), (s3) of PD+, and the F_2 that LSF needs; 130 digits, nothing
of `derive` outside this folder. Inputs are stored numbers, outputs tuples of mpf.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from derive.verify.oracle.precise import (
    Matrix,
    Number,
    Vector,
    blend,
    cross,
    dot,
    exactly,
    mp,
    negative,
    quaternion,
    rotation_nearest,
    times,
    vector,
)

STILL = (0, 0, 0)
FLAT = mp.mpf(10) ** -55
"""1 + tr R_e below which R_e is a rotation by pi: psi (R_e - R_e^T)^vee is then 0/0."""

Outputs = dict[str, Vector]
Law = Callable[[Mapping[str, Any], Mapping[str, Number]], Outputs]


def _matrix(stored: Sequence[Any]) -> Matrix:
    numbers = vector(stored)
    return (numbers[0:3], numbers[3:6], numbers[6:9])


def _transposed(a: Matrix) -> Matrix:
    return tuple(zip(*a, strict=True))


def _product(a: Matrix, b: Matrix) -> Matrix:
    columns = _transposed(b)
    return tuple(tuple(dot(row, column) for column in columns) for row in a)


def _odd(a: Matrix) -> Vector:
    """(A - A^T)^vee."""
    return (a[2][1] - a[1][2], a[0][2] - a[2][0], a[1][0] - a[0][1])


def _lsf(at: Mapping[str, Any], gains: Mapping[str, Number]) -> Outputs:
    """s_2, its attitude error R^T (R R_r^T - R_r R^T)^vee, and tau_2 without F_2's last term."""
    back = _transposed(at["R"])
    error = times(back, _odd(_product(at["R"], _transposed(at["R_r"]))))
    s = blend((1, at["nu"]), (-1, at["nu_r"]), (gains["kappa"] / gains["k"], error))
    driven = times(at["J"], blend((-gains["k"], s), (1, at["nu_r_dot"])))
    turning = cross(blend((1, times(at["J"], at["nu"])), (1, at["momentum"])), at["nu"])
    return {"nu_u": error, "s": s, "force": blend((1, driven), (-1, turning))}


def _lsf_printed(at: Mapping[str, Any], gains: Mapping[str, Number]) -> Outputs:
    found, last = _lsf(at, gains), cross(at["nu"], at["nu_r"])
    return found | {"force": blend((1, found["force"]), (-1, last))}


def _lsf_corrected(at: Mapping[str, Any], gains: Mapping[str, Number]) -> Outputs:
    found, last = _lsf(at, gains), times(at["J"], cross(at["nu"], at["nu_r"]))
    return found | {"force": blend((1, found["force"]), (1, last))}


def _pd_plus(at: Mapping[str, Any], gains: Mapping[str, Number]) -> Outputs:
    """s_3 and tau_3; momentum, of wheels, turns with the reference as J R_e^T Omega_r does."""
    back = _transposed(at["R_e"])
    eta, given = (times(back, at[name]) for name in ("nu_r", "nu_r_dot"))
    error = _attitude(at["R_e"])
    error = negative(error) if at["flip"] else error
    s = blend((1, at["nu"]), (-1, eta), (gains["k_R"] / gains["k_Omega"], error))
    momentum = blend((1, times(at["J"], eta)), (1, at["momentum"]))
    terms = (-gains["k_Omega"], s), (1, times(at["J"], given)), (1, cross(eta, momentum))
    return {"nu_u": error, "s": s, "force": blend(*terms)}


def _attitude(error: Matrix) -> Vector:
    """psi(R_e) (R_e - R_e^T)^vee, psi = 1/(2 sqrt(1 + tr R_e)); at angle pi its limit."""
    spread = 1 + error[0][0] + error[1][1] + error[2][2]
    if spread < FLAT:
        return quaternion(error)[1:]
    return blend((1 / (2 * mp.sqrt(spread)), _odd(error)))


LAWS: dict[str, Law] = {
    "lsf_printed": _lsf_printed,
    "lsf": _lsf_corrected,
    "pd_plus": _pd_plus,
}
"""Controller -> nu_u (the attitude error), s and the torque that is not known already."""


def tracking(
    controller: str,
    inertia: Sequence[Sequence[Any]],
    gains: Mapping[str, Any],
    g_r: Sequence[Any],
    g: Sequence[Any],
    nu: Sequence[Any],
    nu_r: Sequence[Any],
    nu_r_dot: Sequence[Any],
    momentum: Sequence[Any] = STILL,
    external: Sequence[Any] = STILL,
    *,
    flip: bool = False,
) -> Outputs:
    """The controller exactly as printed; units as in truth.tracking, gains by their names.

    Returns q (4,), the unit quaternion of R_e, and (3,) each: nu_e, nu_u, s and force (N m).
    momentum: of wheels inside, N m s; external: a known torque, N m, which the force leaves out.
    flip: at a rotation by pi, the other side. KeyError for another controller.
    """
    at: dict[str, Any] = {"R": _matrix(g), "R_r": _matrix(g_r), "J": tuple(map(vector, inertia))}
    at |= {"nu": vector(nu), "nu_r": vector(nu_r), "nu_r_dot": vector(nu_r_dot)}
    at |= {"momentum": vector(momentum), "flip": flip}
    at["R_e"] = rotation_nearest(_product(_transposed(at["R_r"]), at["R"]))
    q = quaternion(at["R_e"])
    out = {"q": negative(q) if flip else q}
    out["nu_e"] = blend((1, at["nu"]), (-1, times(_transposed(at["R_e"]), at["nu_r"])))
    out |= LAWS[controller](at, {name: exactly(value) for name, value in gains.items()})
    return out | {"force": blend((1, out["force"]), (-1, vector(external)))}
