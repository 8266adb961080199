"""Kinematic laws nu_u: one record each, with the group they live on and where they jump.

Every law here is nu_u = 2 p(w) v of the unit quaternion (w, v) of the error, with w >= 0 on
SO3, where (w, v) and (-w, -v) are one rotation. Along q' = q (0, nu)/2 its exact rate is

    nu_u' = (p w - p' s^2) nu + p v x nu - p' v x (v x nu),    s^2 = 1 - w^2,

which loses nothing to cancellation: the part of nu along the axis never meets the rest.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy
from sympy import Expr, Matrix, Piecewise, sqrt

from derive.lie.cover import Let
from derive.lie.group import Group
from derive.lie.kernel import SMALL, H, K
from derive.routine.derivation import Derivation

Factor = Callable[[Let, Expr, Matrix], Expr]
Clearance = Callable[[Let, Expr, Matrix], Expr]


@dataclass(frozen=True)
class KinematicLaw:
    """nu_u : G -> algebra, Definition 1 of the paper.

    groups:    where the law exists
    factor:    (let, w, v) -> p(w), half the ratio of nu_u to v
    doc:       one sentence
    clearance: zero where the law jumps or is not defined, None where it does neither
    is_pole:   the law or its rate has no bound near its cut: refused within a margin of it
    source:    the paper's label
    """

    name: str
    groups: tuple[str, ...]
    factor: Factor
    doc: str
    clearance: Clearance | None
    is_pole: bool = False
    source: str = "def. (KctrLaw)"

    def apply(
        self, d: Derivation, group: Group, g_e: Matrix, nu_e: Matrix
    ) -> tuple[Matrix, Matrix, Expr]:
        """Steps of nu_u(g_e), its exact rate along g_e' = g_e hat(nu_e), and the clearance."""
        error = group.cover(d.let, g_e)
        w, v = error.w, error.v
        clearance = self.clearance(d.let, w, v) if self.clearance else sympy.S.One
        factor = self.factor(d.let, w, v)
        p = d.let("p", factor, "1", "half of nu_u over v")
        fall = d.let("fall", -sympy.diff(factor, w), "1", "-dp/dw")
        along = d.let("along", _along(w, factor), "1", "rate of the law along the axis")
        nu_u = d.let("nu_u", 2 * p * v, "rad", f"kinematic law, {self.doc}", self.source)
        turn = d.let("turn", v.cross(nu_e), "rad/s", "v x nu_e")
        bend = d.let("bend", v.cross(turn), "rad/s", "v x (v x nu_e)")
        exact = along * nu_e + p * turn + fall * bend
        nu_u_dot = d.let("nu_u_dot", exact, "rad/s", "exact rate of nu_u")
        return nu_u, nu_u_dot, clearance


def _along(w: Expr, p: Expr) -> Expr:
    """p w - p' s^2 in lowest terms, by s^2 = 1 - w^2 and s^2 h = 1 - w k."""
    value = p * w - sympy.diff(p, w) * (1 - w**2)
    value = value.xreplace({H(w): (1 - w * K(w)) / (1 - w**2)})
    return sympy.factor(sympy.cancel(value))


def _at_pi(let: Let, w: Expr, v: Matrix) -> Expr:
    """cos of half the error angle: zero at rotations by pi."""
    return w


def _at_minus_i(let: Let, w: Expr, v: Matrix) -> Expr:
    """sin of half the error angle beyond pi: zero at -i, one on the near half."""
    value = Piecewise((sqrt(v.dot(v)), w < 0), (sympy.S.One, True), evaluate=False)
    return let("distance", value, "1", "distance from -i")


def _at_equator(let: Let, w: Expr, v: Matrix) -> Expr:
    """|w|: zero where the sign of w changes."""
    return let("distance", sympy.Abs(w), "1", "distance from w = 0")


def _sign(let: Let, w: Expr, v: Matrix) -> Expr:
    value = Piecewise((sympy.S.NegativeOne, w < 0), (sympy.S.One, True), evaluate=False)
    return let("sign", value, "1", "sign of w, + at zero") / 2


def _gibbs(let: Let, w: Expr, v: Matrix) -> Expr:
    """1/w, finite where it is refused."""
    inverse = let("inverse", 1 / (w + SMALL), "1", "1/w, finite", stands_for=1 / w)
    let("square", inverse**2, "1", "1/w^2", stands_for=w**-2)
    return 1 / w


def _mrp(let: Let, w: Expr, v: Matrix) -> Expr:
    """2/(1 + w), with 1 + w = s^2/(1 + |w|) where that loses nothing to cancellation."""
    far = v.dot(v) / (1 + sympy.Abs(w)) + SMALL
    value = Piecewise((1 + w, w >= 0), (far, True), evaluate=False)
    let("off", value, "1", "1 + w, and never zero", stands_for=1 + w)
    return 2 / (1 + w)


_HALF = sympy.S.Half
_SO3, _S3 = ("SO3",), ("S3",)

_RECORDS = (
    KinematicLaw(
        "log",
        _SO3,
        lambda let, w, v: K(w),
        "the rotation vector",
        _at_pi,
        source="eq. (KinCtrlLawSO3)",
    ),
    KinematicLaw("lee", _SO3, lambda let, w, v: _HALF, "sin(angle/2) axis", _at_pi),
    KinematicLaw("skew", _SO3, lambda let, w, v: w, "sin(angle) axis", None),
    KinematicLaw("gibbs", _SO3, _gibbs, "2 tan(angle/2) axis", _at_pi, True),
    KinematicLaw("mrp", _SO3, lambda let, w, v: 2 / (1 + w), "4 tan(angle/4) axis", _at_pi),
    KinematicLaw("log", _S3, lambda let, w, v: K(w), "the rotation vector", _at_minus_i, True),
    KinematicLaw(
        "half_log",
        _S3,
        lambda let, w, v: K(w) / 2,
        "half the rotation vector",
        _at_minus_i,
        True,
        source="eq. (KinCtrlLawS3)",
    ),
    KinematicLaw("mrp", _S3, _mrp, "4 v/(1 + w)", _at_minus_i, True),
    KinematicLaw("vec", _S3, lambda let, w, v: sympy.S.One, "2 v, smooth everywhere", None),
    KinematicLaw("sign_vec", _S3, _sign, "sign(w) v", _at_equator),
)

LAWS: dict[tuple[str, str], KinematicLaw] = {
    (group, law.name): law for law in _RECORDS for group in law.groups
}
"""Every law by (group name, law name)."""
