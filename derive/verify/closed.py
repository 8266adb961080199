"""The loop that a controller closes, as an identity at random points, in 50 digits.

The force is that of the emitted derivation; what it does to the body is computed here, by Euler's
equation, I nu' = (I nu + momentum) x nu + force + external.
"""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import mpmath
from sympy import Expr, Matrix, Rational

from derive.verify.derived import parts_of
from derive.verify.plant import Plant

DIGITS = 50


def lsf_residual(vehicle: Plant, points: int, seed: int) -> float:
    """Largest |I (nu' - nu_r' - nu x nu_r) + k I s| over |k I s|: zero for the LSF that is right.

    The rate of the error R R_r^T that LSF has is R (nu - nu_r), whose own rate is
    R (nu' - nu_r' - nu x nu_r).
    """
    rng = random.Random(seed)
    return max(float(_lsf(vehicle, rng)) for _ in range(points))


def _lsf(vehicle: Plant, rng: random.Random) -> Any:
    d = parts_of(vehicle).main
    at = {q.name: _drawn(q.name, q.size, rng) for q in d.inputs}
    inertia = Matrix(len(vehicle.inertia), len(vehicle.inertia), _entries(vehicle.inertia))
    n = range(len(vehicle.inertia))
    at["inertia"] = [inertia[i, j] for i in n for j in n if j >= i]
    given = {x: v for q in d.inputs for x, v in zip(q.symbols(), at[q.name], strict=True)}
    found = {name: Matrix(value) for name, value in d.evaluate(given, DIGITS).items()}
    nu, nu_r, nu_r_dot = (Matrix(at[name]) for name in ("nu", "nu_r", "nu_r_dot"))
    still = [Rational(0)] * 3
    momentum, external = (Matrix(at.get(name, still)) for name in ("momentum", "external"))
    pushed = (inertia * nu + momentum).cross(nu) + found["force"] + external
    asked = -Rational(at["k"][0]) * inertia * found["s"]
    off = pushed - inertia * (nu_r_dot + nu.cross(nu_r)) - asked
    with mpmath.workdps(DIGITS):
        return off.evalf(DIGITS).norm() / asked.evalf(DIGITS).norm()


def _drawn(name: str, size: int, rng: random.Random) -> list[Expr]:
    """Exact numbers for an input: a rotation, a positive gain, or a vector."""
    if name.startswith("g"):
        return list(_rotation(rng))
    return [Rational(rng.randint(1, 50), 7) * rng.choice((1, -1) if size > 1 else (1,))
            for _ in range(size)]  # fmt: skip


def _rotation(rng: random.Random) -> Matrix:
    """A rotation of ratios, by Cayley's map."""
    x = Matrix([Rational(rng.randint(-30, 30), 20) for _ in range(3)])
    hat = Matrix([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]])
    one = Matrix.eye(3)
    return (one - hat).inv() * (one + hat)


def _entries(rows: tuple[tuple[Fraction, ...], ...]) -> list[Rational]:
    return [Rational(x.numerator, x.denominator) for row in rows for x in row]
