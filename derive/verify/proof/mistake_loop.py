"""The paper's mistakes in its closed loops, each by a counterexample: F_2, error dynamics, W.

The claim is what the paper prints. Its facts are that the counterexample meets the assumptions
and breaks the conclusion; the mutants are the corrected formulas, which it must not break.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import product

import mpmath
import sympy
from sympy import Matrix, Rational, eye, zeros

from derive.verify.proof.statement import Fact, Statement, vanish

J = Matrix(
    [
        [Rational("3.6046"), Rational("-0.0706"), Rational("0.1491")],
        [Rational("-0.0706"), Rational("8.6868"), Rational("0.0449")],
        [Rational("0.1491"), Rational("0.0449"), Rational("9.3484")],
    ]
)
"""The inertia of the paper's simulations, kg m^2."""

K, KAPPA, LAMBDA = sympy.S.One, sympy.S.Half, sympy.S.Half
"""The gains of the paper's simulations."""

Feedforward = Callable[[Matrix, Matrix, Matrix], Matrix]


def printed(omega: Matrix, omega_r: Matrix, rate: Matrix) -> Matrix:
    """F_2 as printed: J Omega_r' - (J Omega)^ Omega - Omega^ Omega_r; eq. (Ctrls2)."""
    return J * rate - (J * omega).cross(omega) - omega.cross(omega_r)


def corrected(omega: Matrix, omega_r: Matrix, rate: Matrix) -> Matrix:
    """With J and the other sign: J Omega_r' - (J Omega)^ Omega + J (Omega^ Omega_r)."""
    return J * rate - (J * omega).cross(omega) + J * omega.cross(omega_r)


def _is_not_linear(_: object, force: Feedforward) -> Iterator[Fact]:
    """The rate of R (Omega - Omega_r), in body axes, should be -k s_2 = -k (error + ...)."""
    omega, omega_r = Matrix([1, 2, 3]) / 10, Matrix([0, 1, 0]) / 10
    s = omega - omega_r  # s_2 where R = R_r
    applied = force(omega, omega_r, zeros(3, 1)) - K * J * s
    acceleration = J.inv() * ((J * omega).cross(omega) + applied)
    off = acceleration - omega.cross(omega_r) + K * s
    size = mpmath.nstr(mpmath.sqrt(_number(off.dot(off))), 3)
    yield Fact(
        "the error dynamics is not delta' = -k s_2", any(off),
        f"at R = R_r, Omega = (1, 2, 3)/10, Omega_r = (0, 1, 0)/10 it is off by {size} rad/s^2",
    )  # fmt: skip
    slow, fast = (_slowest(force, Rational(speed)) for speed in ("0.1", "20"))
    yield Fact(
        "its slowest mode fades as the reference turns faster", fast > slow / 10,
        f"slowest mode {mpmath.nstr(slow, 3)} 1/s at |Omega_r| = 0.1 rad/s, "
        f"{mpmath.nstr(fast, 3)} 1/s at 20",
    )  # fmt: skip


def _slowest(force: Feedforward, speed: sympy.Expr) -> mpmath.mpf:
    """Largest real part of the modes about R = R_r, with Omega_r = speed e_2; 1/s.

    R R_r^T = exp(hat(R_r y)), d = Omega - Omega_r: y' = d - Omega_r x y, s_2 = d + 2 kappa/k y.
    """
    omega_r = Matrix([0, speed, 0])
    d = Matrix(sympy.symbols("d:3"))
    omega = omega_r + d
    turning = (J * omega).cross(omega) + force(omega, omega_r, zeros(3, 1))
    slope = (J.inv() * turning).jacobian(d).subs(dict.fromkeys(d, 0))
    spin = Matrix.hstack(*(omega_r.cross(eye(3)[:, i]) for i in range(3)))
    whole = Matrix.vstack(
        Matrix.hstack(-spin, eye(3)),
        Matrix.hstack(-2 * KAPPA * eye(3), slope - K * eye(3)),
    )
    with mpmath.workdps(30):
        numbers = [_number(c) for c in whole.charpoly().all_coeffs()]
        roots = mpmath.polyroots(numbers, maxsteps=200, extraprec=200)
        return max(root.real for root in roots)


def _number(value: sympy.Expr) -> mpmath.mpf:
    return mpmath.mpf(int(value.p)) / int(value.q)


Error = Callable[[Matrix, Matrix, Matrix], Matrix]


def gyration(x: Matrix) -> Matrix:
    """I^sharp ad*_x I x."""
    return J.inv() * (J * x).cross(x)


def error_rate(nu: Matrix, eta: Matrix, eta_dot: Matrix) -> Matrix:
    """nu_e' at f_u = 0: nu' - eta' with Euler-Poincare for nu; what (ELerrDyn) rests on."""
    return gyration(nu) - eta_dot


def _is_not_error_dynamics(_: object, claim: Error) -> Iterator[Fact]:
    """At g_e = e with a reference that turns steadily: eta = nu_r, eta' = -ad(nu_e) eta."""
    nu, rest = Matrix([1, 2, 3]) / 10, zeros(3, 1)
    eta = Matrix([0, 1, 0]) / 10
    eta_dot = -(nu - eta).cross(eta)
    at_rest = error_rate(nu, rest, rest) - claim(nu, rest, rest)
    yield vanish("they agree while the reference rests", at_rest)
    off = error_rate(nu, eta, eta_dot) - claim(nu, eta, eta_dot)
    found = ", ".join(mpmath.nstr(_number(value), 3) for value in off)
    yield Fact(
        "they differ when it moves", any(off),
        f"at g_e = e, nu = (1, 2, 3)/10, nu_r = (0, 1, 0)/10, nu_r' = f_u = 0 "
        f"nu_e' is off by ({found}) rad/s^2",
    )  # fmt: skip


@dataclass(frozen=True)
class Crossing:
    """A loop whose error passes a rotation by pi: inertia, and |nu_u| on either side of it."""

    inertia: Matrix
    length: sympy.Expr


def _jumps_up(_: object, claim: Crossing) -> Iterator[Fact]:
    """The law turns from length a to -length a; W = I(s, s)/2 before and behind."""
    what = "W rises where the error crosses angle pi outward"
    for axis, rate in _crossings():
        behind, before = (rate + side * LAMBDA * claim.length * axis for side in (-1, 1))
        jump = ((claim.inertia * behind).dot(behind) - (claim.inertia * before).dot(before)) / 2
        if (rise := jump.expand()) > 0:
            yield Fact(
                what, True,
                f"axis {_row(axis)}, Omega_e = {_row(rate)} rad/s: outward at {axis.dot(rate)} "
                f"rad/s, and W rises by {rise.evalf(4)} J",
            )  # fmt: skip
            return
    yield Fact(what, False)


def _crossings() -> Iterator[tuple[Matrix, Matrix]]:
    """Unit axes and error velocities along them, rational, the same at every run."""
    axes = [Matrix(row) / 5 for row in ((3, 4, 0), (0, 3, 4), (4, 0, 3))]
    for axis, rate in product(axes, product(range(-2, 3), repeat=3)):
        if axis.dot(Matrix(rate)) > 0:
            yield axis, Matrix(rate)


def _row(x: Matrix) -> str:
    return "(" + ", ".join(str(Fraction(int(value.p), int(value.q))) for value in x) + ")"


_EXACT = "counterexample, exact"

STATEMENTS = (
    Statement(
        "F_2 as printed does not linearise", "eq. (Ctrls2)", _EXACT, "paper", _is_not_linear,
        printed,
        {
            "F_2 with J and the other sign": corrected,
            "the same with Omega - Omega_r for Omega": lambda omega, omega_r, rate: (
                J * (rate + (omega - omega_r).cross(omega_r)) - (J * omega).cross(omega)
            ),
        },
    ),
    Statement(
        "nabla_nu_e nu_e = f_u is not the error dynamics", "eq. (ELintrinsic-Nu-e)", _EXACT,
        "paper", _is_not_error_dynamics, lambda nu, eta, eta_dot: gyration(nu - eta),
        {
            "eq. (ELerrDyn)": error_rate,
            "the same in nu_e and eta": lambda nu, eta, eta_dot: (
                gyration((nu - eta) + eta) - eta_dot
            ),
        },
    ),
    Statement(
        "on SO3, W can rise at angle pi: not globally exponential", "thm. (Ctrl2)", _EXACT,
        "paper", _jumps_up, Crossing(J, sympy.pi),
        {
            "an isotropic inertia": Crossing(eye(3), sympy.pi),
            "a law that is continuous there": Crossing(J, sympy.S.Zero),
        },
    ),
)  # fmt: skip
"""Counterexamples to what the paper says of its loops."""
