"""Laws of rotations: nu_u = 2 p(w) v of the unit quaternion (w, v) of the error.

On SO3, where (w, v) and (-w, -v) are one rotation, w >= 0. Along q' = q (0, nu)/2 the exact
rate is

    nu_u' = (p w - p' s^2) nu + p v x nu - p' v x (v x nu),    s^2 = 1 - w^2,

which loses nothing to cancellation: the part of nu along the axis never meets the rest.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy
from sympy import Expr, Matrix, Piecewise

from derive.control.law import KinematicLaw, Written
from derive.lie.cover import Let, Scaled
from derive.lie.group import Group
from derive.lie.kernel import SMALL, Arc, H, K

Factor = Callable[[Let, Scaled], Expr]
Clearance = Callable[[Let, Scaled], Expr]


@dataclass(frozen=True)
class Quaternion:
    """Writes a law 2 p(w) v.

    factor:    (let, (w, v)) -> p(w), half the ratio of nu_u to v
    clearance: zero where the law jumps or is not defined, None where it does neither
    """

    factor: Factor
    clearance: Clearance | None

    def __call__(self, let: Let, group: Group, g_e: Matrix) -> Written:
        """The law on a group that has a cover; ValueError on another."""
        if group.cover is None:
            raise ValueError(f"{group.name} has no unit quaternion")
        error = group.cover(let, g_e)
        clearance = self.clearance(let, error) if self.clearance else sympy.S.One
        share, p = _parted(self.factor(let, error))
        # Where p loses nothing in between, v costs three products more and rounds the better.
        raw, scale = (error.raw, error.scale) if p.has(Arc) else (error.v, sympy.S.One)
        w = error.w
        reach = let("reach", p * scale, "1", "p times the scale of the vector part")
        stretch = let("stretch", 2 * share * reach, "1", "nu_u over the vector part")
        drop = let("drop", -sympy.diff(p, w) * scale**2, "1", "-dp/dw times that scale's square")
        along = let("along", _along(w, p), "1", "rate of the law along the axis")

        def rate(let: Let, nu_e: Matrix) -> Matrix:
            part = let("part", share * nu_e, "rad/s", "nu_e times the rate of nu_u at the identity")
            of = "nu_e" if share == 1 else "part"
            turn = let("turn", raw.cross(part), "rad/s", f"vector part x {of}")
            bend = let("bend", raw.cross(turn), "rad/s", "vector part x turn")
            return along * part + reach * turn + drop * bend

        return Written(stretch * raw, rate, clearance)


def _parted(p: Expr) -> tuple[Expr, Expr]:
    """p as a number below 1, which nu_e takes on, and the rest."""
    number, rest = p.as_coeff_Mul()
    return (number, rest) if number < 1 else (sympy.S.One, p)


def _along(w: Expr, p: Expr) -> Expr:
    """p w - p' s^2 in lowest terms, by s^2 = 1 - w^2 and s^2 h = 1 - w k."""
    value = p * w - sympy.diff(p, w) * (1 - w**2)
    value = value.xreplace({H(w): (1 - w * K(w)) / (1 - w**2)})
    return sympy.factor(sympy.cancel(value))


def _at_pi(let: Let, error: Scaled) -> Expr:
    """cos of half the error angle: zero at rotations by pi."""
    return error.w


def _at_minus_i(let: Let, error: Scaled) -> Expr:
    """sin of half the error angle beyond pi: zero at -i, one on the near half."""
    return error.distance


def _at_equator(let: Let, error: Scaled) -> Expr:
    """|w|: zero where the sign of w changes."""
    return let("margin", sympy.Abs(error.w), "1", "distance from w = 0")


def _sign(let: Let, error: Scaled) -> Expr:
    value = Piecewise((sympy.S.NegativeOne, error.w < 0), (sympy.S.One, True), evaluate=False)
    return let("sign", value, "1", "sign of w, + at zero") / 2


def _gibbs(let: Let, error: Scaled) -> Expr:
    """1/w, finite where it is refused."""
    w = error.w
    inverse = let("inverse", 1 / (w + SMALL), "1", "1/w, finite", stands_for=1 / w)
    let("inverse_square", inverse**2, "1", "1/w^2", stands_for=w**-2)
    return 1 / w


def _mrp(let: Let, error: Scaled) -> Expr:
    """2/(1 + w), with 1 + w = s^2/(1 + |w|) where that loses nothing to cancellation."""
    w, v = error.w, error.v
    far = v.dot(v) / (1 + sympy.Abs(w)) + SMALL
    value = Piecewise((1 + w, w >= 0), (far, True), evaluate=False)
    let("off", value, "1", "1 + w, and never zero", stands_for=1 + w)
    return 2 / (1 + w)


def _law(
    name: str, factor: Factor, doc: str, clearance: Clearance | None, is_pole: bool = False,
    source: str = "def. (KctrLaw)",
) -> KinematicLaw:  # fmt: skip
    return KinematicLaw(name, Quaternion(factor, clearance), doc, is_pole, source)


_HALF = sympy.S.Half
_SO3, _S3 = "eq. (KinCtrlLawSO3)", "eq. (KinCtrlLawS3)"

_RECORDS = {
    "SO3": (
        _law("log", lambda let, error: K(error.w), "the rotation vector", _at_pi, source=_SO3),
        _law("lee", lambda let, error: _HALF, "sin(angle/2) axis", _at_pi),
        _law("skew", lambda let, error: error.w, "sin(angle) axis", None),
        _law("gibbs", _gibbs, "2 tan(angle/2) axis", _at_pi, True),
        _law("mrp", lambda let, error: 2 / (1 + error.w), "4 tan(angle/4) axis", _at_pi),
        _law("cayley", _gibbs, "2 tan(angle/2) axis", _at_pi, True),
    ),
    "S3": (
        _law("log", lambda let, error: K(error.w), "the rotation vector", _at_minus_i, True),
        _law(
            "half_log", lambda let, error: K(error.w) / 2, "half the rotation vector",
            _at_minus_i, True, _S3,
        ),
        _law("mrp", _mrp, "4 v/(1 + w)", _at_minus_i, True),
        _law("vec", lambda let, error: sympy.S.One, "2 v, smooth everywhere", None),
        _law("sign_vec", _sign, "sign(w) v", _at_equator),
        _law("cayley", _mrp, "4 v/(1 + w)", _at_minus_i, True),
    ),
}  # fmt: skip

LAWS: dict[str, dict[str, KinematicLaw]] = {
    group: {law.name: law for law in laws} for group, laws in _RECORDS.items()
}
"""Group name -> law name -> law."""
