"""The paper's mistakes on where its laws live: cut loci, excluded points, smoothness.

As in mistake_loop: the claim is what the paper prints, the mutants are what is right.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import mpmath
import sympy
from mpmath import mp
from sympy import Matrix, Rational, eye

from derive.verify.proof.statement import Fact, Statement, vanish

DIGITS = 60
NEAR = mpmath.mpf(10) ** -30
"""How near to the place in question; what is shown has half as many digits."""


@dataclass(frozen=True)
class Region:
    """U_q = {q : V_2(q) < bound} without one point, named by its q0."""

    bound_squared: sympy.Expr
    excluded: int


def _excludes_nothing(_: object, claim: Region) -> Iterator[Fact]:
    """V_2(q)^2 = 1 - q0, largest at -i, where q^-1 = q and so nu_u = 0 by property (ii)."""
    antipode = Matrix([-1, 0, 0, 0])
    inverse = Matrix([antipode[0], *-antipode[1:, :]])
    yield vanish("-i is its own inverse, so an odd law is zero there", inverse - antipode)
    square = 1 - antipode[0]
    largest, bound = sympy.sqrt(square), sympy.sqrt(claim.bound_squared)
    yield Fact(
        "V_2(-i) is below the bound", bool(square < claim.bound_squared),
        f"V_2 <= V_2(-i) = {largest} < {bound}: no q is excluded, not even the equilibrium -i",
    )  # fmt: skip
    yield Fact("-i is not the point left out", claim.excluded != antipode[0])


Angle = Callable[[Matrix], sympy.Expr]


def arccosine(R: Matrix) -> sympy.Expr:
    """arccos((tr R - 1)/2), as printed below eq. (KinCtrlLawSO3)."""
    return sympy.acos((R.trace() - 1) / 2)


def _has_no_sign(_: object, angle: Angle) -> Iterator[Fact]:
    """Rotations by -pi/2 and by pi/2 about e_3 are two, and both angles lie in (-pi, pi)."""
    ahead = Matrix([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    yield Fact("the two rotations differ", ahead != ahead.T)
    angles = angle(ahead), angle(ahead.T)
    yield Fact(
        "phi does not tell them apart", angles[0] == angles[1],
        f"phi = {angles[0]} for the rotations by pi/2 and by -pi/2 about e_3",
    )  # fmt: skip


Quaternion = tuple[mpmath.mpf, mpmath.mpf]
"""w and the first component of v; the axis is e_1 throughout."""

Law = Callable[[mpmath.mpf, mpmath.mpf], mpmath.mpf]


def log_so3(w: mpmath.mpf, v: mpmath.mpf) -> mpmath.mpf:
    """phi of the rotation, from whichever of q and -q has w >= 0; eq. (KinCtrlLawSO3)."""
    return 2 * mp.atan2(v, w) if w >= 0 else 2 * mp.atan2(-v, -w)


def log_s3(w: mpmath.mpf, v: mpmath.mpf) -> mpmath.mpf:
    """arccos(w) v/|v|, half the angle up to pi; eq. (KinCtrlLawS3)."""
    return mp.atan2(v, w)


@dataclass(frozen=True)
class Laws:
    """nu_u along rotations about one axis."""

    so3: Law
    s3: Law


def _is_not_smooth(_: object, claim: Laws) -> Iterator[Fact]:
    """Star on g1 = exp(1 e_1) and g2 so that g1 g2 is just before and just behind the place."""
    with mp.workdps(DIGITS):
        for where, law, angle in (
            ("angle pi on SO3", claim.so3, +mp.pi),
            ("-i on S3", claim.s3, 2 * mp.pi),
        ):
            before, behind = (_star(law, angle + side * NEAR) for side in (-1, 1))
            jump = abs(behind - before)
            yield Fact(
                f"star jumps at {where}", jump > 1,
                f"at {where} star jumps by {mp.nstr(jump / mp.pi, 20)} pi lambda",
            )  # fmt: skip


def _star(law: Law, angle: mpmath.mpf) -> mpmath.mpf:
    """Velocity part of (g1, 0) star (g2, 0) over lambda, g1 g2 the rotation by that angle."""
    parts = (mpmath.mpf(1), angle - 1, angle)
    one, two, both = (law(mp.cos(part / 2), mp.sin(part / 2)) for part in parts)
    return one + two - both


Family = Callable[[sympy.Symbol], Matrix]


def _cross(n: Matrix) -> Matrix:
    return Matrix.hstack(*(n.cross(eye(3)[:, i]) for i in range(3)))


def _axis(t: sympy.Expr) -> Matrix:
    """A unit vector that turns with t: a rational curve."""
    return Matrix([1 - t**2, 2 * t, 0]) / (1 + t**2)


def _is_not_isolated(_: object, family: Family) -> Iterator[Fact]:
    """Rotations by pi about a whole curve of axes."""
    t = sympy.Symbol("t")
    R = family(t)
    square = (R * R - eye(3)).applyfunc(sympy.cancel)
    yield vanish("R(t)^-1 = R(t), so an odd law is zero there", square)
    gram = (R.T * R - eye(3)).applyfunc(sympy.cancel)
    yield vanish("R(t) is orthogonal", gram)
    moves = R.diff(t).applyfunc(sympy.cancel)
    yield Fact("R(t) is none of the others, and not e", any(moves) and R.subs(t, 0) != eye(3))
    shown = ", ".join(str(value) for value in family(Rational(1, 2))[:, 0])
    found = f"nu_u = 0 on R(t) = 2 n n^T - 1 for every t; R(1/2) e_1 = ({shown})"
    yield Fact("R(t) is a rotation", sympy.cancel(R.det()) == 1, found)


Height = Callable[[mpmath.mpf], mpmath.mpf]
"""A function of the angle of rotation about e_1."""


@dataclass(frozen=True)
class Heights:
    """The functions V_1 on SO3 and V_2 on S3 along one axis, in terms of the angle."""

    on_so3: Height
    on_s3: Height


MORSE = Heights(
    on_so3=lambda phi: 2 - mp.sqrt(2 + 2 * mp.cos(phi)),
    on_s3=lambda phi: mp.sqrt(1 - mp.cos(phi / 2)),
)


def _has_kinks(_: object, claim: Heights) -> Iterator[Fact]:
    """Slopes to the left and to the right of the place."""
    with mp.workdps(2 * DIGITS):
        for name, where, height, angle in (
            ("V_1", "angle pi", claim.on_so3, +mp.pi),
            ("V_2", "the identity", claim.on_s3, mp.zero),
        ):
            middle = height(angle)
            left, right = (
                (height(angle + side * NEAR) - middle) / (side * NEAR) for side in (-1, 1)
            )
            yield Fact(
                f"{name} has a kink at {where}", abs(right - left) > mpmath.mpf(1) / 10,
                f"{name} at {where} has slopes {mp.nstr(left, 6)} and {mp.nstr(right, 6)}",
            )  # fmt: skip


_EXACT, _DIGITS = "counterexample, exact", "counterexample, 60 digits"

STATEMENTS = (
    Statement(
        "V_2 < 2 - eps excludes nothing; S3 without i is not enough", "eq. (KinCtrlLawS3)", _EXACT,
        "paper", _excludes_nothing, Region(sympy.S(4), excluded=1),
        {
            "V_2 < sqrt 2": Region(sympy.S(2), excluded=1),
            "S3 without -i": Region(sympy.S(4), excluded=-1),
        },
    ),
    Statement(
        "arccos gives no angle in (-pi, 0)", "eq. (KinCtrlLawSO3)", _EXACT, "paper", _has_no_sign,
        arccosine,
        {
            "the signed angle about e_3": lambda R: sympy.atan2(R[1, 0], R[0, 0]),
            "arccos with the sign of R - R^T": lambda R: sympy.sign(R[1, 0]) * arccosine(R),
        },
    ),
    Statement(
        "with log, star is not smooth: it jumps by 2 pi lambda", "lem. 1 (LieGroup)", _DIGITS,
        "paper", _is_not_smooth, Laws(log_so3, log_s3),
        {
            "sin(phi) on SO3": Laws(lambda w, v: 2 * w * v, log_s3),
            "2 vec(q) on S3": Laws(log_so3, lambda w, v: 2 * v),
        },
    ),
    Statement(
        "the other equilibria are not isolated on SO3", "def. (KctrLaw)", _EXACT, "paper",
        _is_not_isolated, lambda t: 2 * _axis(t) * _axis(t).T - eye(3),
        {
            "rotations by pi/2": lambda t: eye(3) + _cross(_axis(t)) + _cross(_axis(t)) ** 2,
            "one axis": lambda t: 2 * _axis(sympy.S.Zero) * _axis(sympy.S.Zero).T - eye(3),
        },
    ),
    Statement(
        "V_1 and V_2 are not smooth, hence not Morse", "def. (KctrLaw)", _DIGITS, "paper",
        _has_kinks, MORSE,
        {
            "(1 - cos phi) on SO3": Heights(lambda phi: 1 - mp.cos(phi), MORSE.on_s3),
            "1 - q0 on S3": Heights(MORSE.on_so3, lambda phi: 1 - mp.cos(phi / 2)),
        },
    ),
)  # fmt: skip
"""Counterexamples to what the paper says of its spaces and laws."""
