"""The truth about the paper's controller on any group, and no closed form of any rate.

Inputs are stored numbers, outputs tuples of mpf. The force is the paper's, with the inverse
inertia; rates are central differences along the flow.
"""

from collections.abc import Collection, Sequence
from typing import Any

from derive.verify.oracle import factor_law
from derive.verify.oracle.factor_law import Lifted, lifted
from derive.verify.oracle.matrix_function import Matrix, Vector, inverse, numbers, times, transpose
from derive.verify.oracle.matrix_group import (
    LAWS,
    Ad,
    Element,
    Name,
    ad,
    angle,
    basis,
    bracket,
    coordinates,
    dim,
    element,
    error,
    exp,
    factors,
    law,
    log,
    pull,
    pull_rate,
    rate,
    store,
    whole,
)
from derive.verify.oracle.precise import exactly, mp

__all__ = [
    "LAWS", "Ad", "ad", "angle", "basis", "bracket", "element", "error", "exp", "factors", "law",
    "log", "mp", "plant", "pull", "pull_rate", "rate", "reaching", "store", "tracking", "whole",
]  # fmt: skip

Outputs = dict[str, Any]  # tuples (n,) of mpf, the angle, an mpf, and the lifted error


def _sum(*terms: tuple[Any, Vector]) -> Vector:
    factors = [mp.mpf(factor) for factor, _ in terms]
    return times(tuple(zip(*(x for _, x in terms), strict=True)), factors)


class _System:
    """A group, an inertia (n, n) and what else is known: flat, sharp and ad* of the paper."""

    def __init__(
        self,
        name: Name,
        inertia: Sequence[Sequence[Any]],
        momentum: Sequence[Any],
        external: Sequence[Any],
    ) -> None:
        still = (0,) * len(inertia)
        self.name = name
        self.momentum, self.external = numbers(momentum or still), numbers(external or still)
        self.inertia: Matrix = tuple(map(numbers, inertia))
        self._sharp = inverse(self.inertia)

    def flat(self, x: Vector) -> Vector:
        """I^flat x."""
        return times(self.inertia, x)

    def sharp(self, a: Vector) -> Vector:
        """I^sharp a, with the inverse inertia."""
        return times(self._sharp, a)

    def carried(self, x: Vector, nu: Vector) -> Vector:
        """I^sharp ad*_x (I^flat nu + momentum), where <ad*_x a; y> = <a; [x, y]>."""
        momentum = _sum((1, self.flat(nu)), (1, self.momentum))
        return self.sharp(times(transpose(ad(self.name, x)), momentum))


def plant(
    name: Name,
    inertia: Sequence[Sequence[Any]],
    nu: Sequence[Any],
    force: Sequence[Any],
    momentum: Sequence[Any] = (),
    external: Sequence[Any] = (),
) -> Vector:
    """nu_dot = I^sharp (ad*_nu (I^flat nu + momentum) + force + external), (n,); eq. (EulerP)."""
    system, velocity = _System(name, inertia, momentum, external), numbers(nu)
    pushed = _sum((1, numbers(force)), (1, system.external))
    return _sum((1, system.carried(velocity, velocity)), (1, system.sharp(pushed)))


def tracking(
    name: Name,
    law_name: str,
    inertia: Sequence[Sequence[Any]],
    rate_gain: Any,
    reach_gain: Any,
    g_r: Sequence[Any],
    g: Sequence[Any],
    nu: Sequence[Any],
    nu_r: Sequence[Any],
    nu_r_dot: Sequence[Any],
    momentum: Sequence[Any] = (),
    external: Sequence[Any] = (),
    *,
    flips: Collection[int] = (),
) -> Outputs:
    """The tracking law exactly as printed, with the inverse inertia; eq. (TckCtrl).

    inertia (n, n), rate_gain (lambda) and reach_gain (k_s) in 1/s, g and g_r as stored. Returns
    (n,) each: eta, nu_e, eta_dot, nu_u, nu_u_dot, s, f_u and force; the angle of g_e, rad, and
    its factors lifted. momentum: of wheels inside; external: a known force, which the force
    leaves out; flips: factors whose rotation is taken across the cut.
    """
    system, velocity = _System(name, inertia, momentum, external), numbers(nu)
    g_e = error(name, element(name, g_r), element(name, g))
    out: Outputs = {"angle": angle(name, g_e), "eta": pull(name, g_e, nu_r)}
    out["nu_e"] = _sum((1, velocity), (-1, out["eta"]))
    out["eta_dot"] = pull_rate(name, g_e, out["nu_e"], nu_r, nu_r_dot)
    out |= _law(name, law_name, g_e, out["nu_e"], flips)
    return out | _force(system, velocity, rate_gain, reach_gain, out)


def reaching(
    name: Name,
    law_name: str,
    inertia: Sequence[Sequence[Any]],
    rate_gain: Any,
    reach_gain: Any,
    g: Sequence[Any],
    nu: Sequence[Any],
    momentum: Sequence[Any] = (),
    external: Sequence[Any] = (),
    *,
    flips: Collection[int] = (),
) -> Outputs:
    """The reaching law exactly as printed; eq. (Ctrl2). Units and keys as in tracking."""
    system, velocity = _System(name, inertia, momentum, external), numbers(nu)
    at = element(name, g)
    out: Outputs = {"angle": angle(name, at)} | _law(name, law_name, at, velocity, flips)
    still = (mp.zero,) * dim(name)
    there = out | {"eta": still, "nu_e": velocity, "eta_dot": still}
    return out | _force(system, velocity, rate_gain, reach_gain, there)


def _law(name: Name, which: str, g_e: Element, nu: Vector, flips: Collection[int]) -> Outputs:
    """nu_u and its rate, factor by factor, and what they were taken at."""
    parts: list[Lifted] = [
        lifted(one, a, flip=place in flips)
        for place, (one, a) in enumerate(zip(factors(name), g_e, strict=True))
    ]
    speeds = [piece for _, piece in coordinates(name, nu)]
    rates = [factor_law.rate(at, which, x) for at, x in zip(parts, speeds, strict=True)]
    return {
        "lifted": tuple(parts),
        "nu_u": tuple(x for at in parts for x in factor_law.law(at, which)),
        "nu_u_dot": tuple(x for each in rates for x in each),
    }


def _force(system: _System, nu: Vector, rate_gain: Any, reach_gain: Any, at: Outputs) -> Outputs:
    """s, f_u and the force."""
    slope = exactly(rate_gain)
    s = _sum((1, at["nu_e"]), (slope, at["nu_u"]))
    turning = _sum((slope, at["nu_u"]), (-1, at["eta"]))
    wanted = ((-slope, at["nu_u_dot"]), (1, at["eta_dot"]), (-exactly(reach_gain), s))
    f_u = _sum((1, system.carried(turning, nu)), *wanted)
    force = _sum((1, system.flat(f_u)), (-1, system.external))
    return {"s": s, "f_u": f_u, "force": force}
