"""Kinematic laws nu_u: one record each, with where they live and where they jump.

On SO3 and S3 a law is nu_u = 2 p(w) v of the unit quaternion (w, v) of the error, with w >= 0
on SO3, where (w, v) and (-w, -v) are one rotation. Along q' = q (0, nu)/2 its exact rate is

    nu_u' = (p w - p' s^2) nu + p v x nu - p' v x (v x nu),    s^2 = 1 - w^2,

which loses nothing to cancellation: the part of nu along the axis never meets the rest.
On other groups `log` is the group's chart, its rate the chain rule over the chart's steps.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy
from sympy import Expr, Matrix, Piecewise, sqrt

from derive.lie.catalogue import GROUPS
from derive.lie.cover import Let
from derive.lie.group import Group
from derive.lie.kernel import SMALL, H, K
from derive.routine.derivation import Derivation
from derive.routine.rate import rate

Applied = tuple[Matrix, Matrix, Expr]
"""Law, exact rate, clearance: zero where the law jumps or is not defined, one where it is not."""

Factor = Callable[[Let, Expr, Matrix], Expr]
Clearance = Callable[[Let, Expr, Matrix], Expr]
ONE = sympy.S.One


@dataclass(frozen=True)
class KinematicLaw:
    """nu_u : G -> algebra, Definition 1 of the paper.

    exists:  whether the law is there on a group
    write:   (d, group, g_e, nu_e) -> steps of the law, its rate along g_e' = g_e hat(nu_e), and
             its clearance
    doc:     one sentence
    is_pole: whether law or rate have no bound near the cut: refused within a margin of it
    source:  the paper's label
    """

    name: str
    exists: Callable[[Group], bool]
    write: Callable[[Derivation, Group, Matrix, Matrix], Applied]
    doc: str
    is_pole: Callable[[Group], bool] = lambda group: False
    source: str = "def. (KctrLaw)"

    def apply(self, d: Derivation, group: Group, g_e: Matrix, nu_e: Matrix) -> Applied:
        """Steps of nu_u(g_e), (n, 1), its exact rate, and the clearance."""
        value, exact, clearance = self.write(d, group, g_e, nu_e)
        unit = group.log_unit
        nu_u = d.let("nu_u", value, unit, f"kinematic law, {self.doc}", self.source)
        nu_u_dot = d.let("nu_u_dot", exact, group.unit, "exact rate of nu_u")
        return nu_u, nu_u_dot, clearance


def _quaternion(factor: Factor, at: Clearance | None) -> Callable[..., Applied]:
    """A law 2 p(w) v, from p and from the distance of (w, v) from its cut."""

    def write(d: Derivation, group: Group, g_e: Matrix, nu_e: Matrix) -> Applied:
        assert group.cover is not None
        error = group.cover(d.let, g_e)
        w, v = error.w, error.v
        clearance = at(d.let, w, v) if at else ONE
        ratio = factor(d.let, w, v)
        p = d.let("p", ratio, "1", "half of nu_u over v")
        fall = d.let("fall", -sympy.diff(ratio, w), "1", "-dp/dw")
        along = d.let("along", _along(w, ratio), "1", "rate of the law along the axis")
        turn = d.let("turn", v.cross(nu_e), "rad/s", "v x nu_e")
        bend = d.let("bend", v.cross(turn), "rad/s", "v x (v x nu_e)")
        return 2 * p * v, along * nu_e + p * turn + fall * bend, clearance

    return write


def _along(w: Expr, p: Expr) -> Expr:
    """p w - p' s^2 in lowest terms, by s^2 = 1 - w^2 and s^2 h = 1 - w k."""
    value = p * w - sympy.diff(p, w) * (1 - w**2)
    value = value.xreplace({H(w): (1 - w * K(w)) / (1 - w**2)})
    return sympy.factor(sympy.cancel(value))


def _logarithm(d: Derivation, group: Group, g_e: Matrix, nu_e: Matrix) -> Applied:
    """The group's chart, and the chain rule over its steps."""
    assert group.chart is not None
    chart = group.chart(d.let, g_e)
    value = Matrix([d.let("log", chart.log, group.log_unit, "logarithm of the error")])
    return value, rate(d, value, chart.rates(d.let, nu_e)), chart.clearance


def _skew(d: Derivation, group: Group, g_e: Matrix, nu_e: Matrix) -> Applied:
    """vee(g - g^-1)/2 and its rate vee(g hat(nu) + hat(nu) g^-1)/2: no logarithm is needed."""
    g = group.embed(g_e)
    back, flow = group.inverse(g), group.hat(nu_e)
    return group.vee(g - back) / 2, group.vee(g * flow + flow * back) / 2, ONE


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


def _on(*names: str) -> Callable[[Group], bool]:
    return lambda group: group.name in names


def _always(group: Group) -> bool:
    return True


_SO3, _S3 = _on("SO3"), _on("S3")
_KERNEL = _quaternion(lambda let, w, v: K(w), _at_pi)
_KERNEL_S3 = _quaternion(lambda let, w, v: K(w), _at_minus_i)
_HALF_S3 = _quaternion(lambda let, w, v: K(w) / 2, _at_minus_i)
_MRP = _quaternion(lambda let, w, v: 2 / (1 + w), _at_pi)

_RECORDS = (
    KinematicLaw("log", _SO3, _KERNEL, "the rotation vector", source="eq. (KinCtrlLawSO3)"),
    KinematicLaw("lee", _SO3, _quaternion(lambda let, w, v: ONE / 2, _at_pi), "sin(angle/2) axis"),
    KinematicLaw("skew", _SO3, _quaternion(lambda let, w, v: w, None), "sin(angle) axis"),
    KinematicLaw("gibbs", _SO3, _quaternion(_gibbs, _at_pi), "2 tan(angle/2) axis", _always),
    KinematicLaw("mrp", _SO3, _MRP, "4 tan(angle/4) axis"),
    KinematicLaw("log", _S3, _KERNEL_S3, "the rotation vector", _always),
    KinematicLaw(
        "half_log", _S3, _HALF_S3, "half the rotation vector", _always, "eq. (KinCtrlLawS3)"
    ),
    KinematicLaw("mrp", _S3, _quaternion(_mrp, _at_minus_i), "4 v/(1 + w)", _always),
    KinematicLaw("vec", _S3, _quaternion(lambda let, w, v: ONE, None), "2 v, smooth everywhere"),
    KinematicLaw("sign_vec", _S3, _quaternion(_sign, _at_equator), "sign(w) v"),
    KinematicLaw(
        "log",
        lambda group: group.cover is None and group.chart is not None,
        _logarithm,
        "the logarithm",
        lambda group: group.has_pole,
    ),
    KinematicLaw("skew", lambda group: group.cover is None, _skew, "vee(g - g^-1)/2"),
)


def laws_of(group: Group) -> dict[str, KinematicLaw]:
    """Every law that exists on a group, by name."""
    return {law.name: law for law in _RECORDS if law.exists(group)}


LAWS: dict[tuple[str, str], KinematicLaw] = {
    (group.name, name): law for group in GROUPS.values() for name, law in laws_of(group).items()
}
"""Every law by (group name, law name), over the catalogue."""
