"""The truth about the paper's controller on any group, and no closed form of log or any rate.

Inputs are stored numbers, outputs tuples of mpf. The force is the paper's, with the inverse
inertia; logarithms are those of matrices, rates central differences along the flow.
"""

from collections.abc import Sequence
from typing import Any

from derive.verify.matrix_function import Matrix, Vector, inverse, numbers, times, transpose
from derive.verify.matrix_group import (
    LAWS,
    Ad,
    ad,
    angle,
    basis,
    bracket,
    element,
    error,
    exp,
    law,
    log,
    pull,
    pull_rate,
    rate,
    store,
    whole,
)
from derive.verify.precise import exactly, mp

__all__ = [
    "LAWS", "Ad", "ad", "angle", "basis", "bracket", "element", "error", "exp", "law", "log", "mp",
    "plant", "pull", "pull_rate", "rate", "reaching", "store", "tracking", "whole",
]  # fmt: skip

Outputs = dict[str, Any]  # tuples (n,) of mpf, and the angle, an mpf


def _sum(*terms: tuple[Any, Vector]) -> Vector:
    factors = [mp.mpf(factor) for factor, _ in terms]
    return times(tuple(zip(*(x for _, x in terms), strict=True)), factors)


class _System:
    """A group and an inertia (n, n): flat, sharp and ad* of the paper."""

    def __init__(self, name: str, inertia: Sequence[Sequence[Any]]) -> None:
        self.name = name
        self.inertia: Matrix = tuple(map(numbers, inertia))
        self._sharp = inverse(self.inertia)

    def flat(self, x: Vector) -> Vector:
        """I^flat x."""
        return times(self.inertia, x)

    def sharp(self, a: Vector) -> Vector:
        """I^sharp a, with the inverse inertia."""
        return times(self._sharp, a)

    def carried(self, x: Vector, nu: Vector) -> Vector:
        """I^sharp ad*_x I^flat nu, where <ad*_x a; y> = <a; [x, y]>."""
        return self.sharp(times(transpose(ad(self.name, x)), self.flat(nu)))


def plant(
    name: str, inertia: Sequence[Sequence[Any]], nu: Sequence[Any], force: Sequence[Any]
) -> Vector:
    """nu_dot = I^sharp (ad*_nu I^flat nu + force), (n,); eq. (EulerP)."""
    system, velocity = _System(name, inertia), numbers(nu)
    return _sum((1, system.carried(velocity, velocity)), (1, system.sharp(numbers(force))))


def tracking(
    name: str,
    law_name: str,
    inertia: Sequence[Sequence[Any]],
    rate_gain: Any,
    reach_gain: Any,
    g_r: Sequence[Any],
    g: Sequence[Any],
    nu: Sequence[Any],
    nu_r: Sequence[Any],
    nu_r_dot: Sequence[Any],
) -> Outputs:
    """The tracking law exactly as printed, with the inverse inertia; eq. (TckCtrl).

    inertia (n, n), rate_gain (lambda) and reach_gain (k_s) in 1/s, g and g_r as stored. Returns
    (n,) each: eta, nu_e, eta_dot, nu_u, nu_u_dot, s, f_u and force; and the angle of g_e, rad.
    """
    system, slope, velocity = _System(name, inertia), exactly(rate_gain), numbers(nu)
    g_e = error(name, element(name, g_r), element(name, g))
    out: Outputs = {"angle": angle(name, g_e), "eta": pull(name, g_e, nu_r)}
    out["nu_e"] = _sum((1, velocity), (-1, out["eta"]))
    out["eta_dot"] = pull_rate(name, g_e, out["nu_e"], nu_r, nu_r_dot)
    out["nu_u"] = law(name, law_name, g_e)
    out["nu_u_dot"] = rate(name, g_e, out["nu_e"], law_name)
    out["s"] = _sum((1, out["nu_e"]), (slope, out["nu_u"]))
    turning = _sum((slope, out["nu_u"]), (-1, out["eta"]))
    wanted = ((-slope, out["nu_u_dot"]), (1, out["eta_dot"]), (-exactly(reach_gain), out["s"]))
    out["f_u"] = _sum((1, system.carried(turning, velocity)), *wanted)
    return {**out, "force": system.flat(out["f_u"])}


def reaching(
    name: str,
    law_name: str,
    inertia: Sequence[Sequence[Any]],
    rate_gain: Any,
    reach_gain: Any,
    g: Sequence[Any],
    nu: Sequence[Any],
) -> Outputs:
    """The reaching law exactly as printed; eq. (Ctrl2). Units and keys as in tracking."""
    system, slope, velocity = _System(name, inertia), exactly(rate_gain), numbers(nu)
    at = element(name, g)
    out: Outputs = {"angle": angle(name, at), "nu_u": law(name, law_name, at)}
    out["nu_u_dot"] = rate(name, at, velocity, law_name)
    out["s"] = _sum((1, velocity), (slope, out["nu_u"]))
    carried = system.carried(_sum((slope, out["nu_u"])), velocity)
    wanted = ((-slope, out["nu_u_dot"]), (-exactly(reach_gain), out["s"]))
    out["f_u"] = _sum((1, carried), *wanted)
    return {**out, "force": system.flat(out["f_u"])}
