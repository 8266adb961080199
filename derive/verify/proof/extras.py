"""Wheels and known forces: what they change in the loop, for every algebra and inertia.

A body with internal momentum h obeys (I nu + h)' = ad*_nu (I nu + h) + external, whatever drives
the wheels. The law's force is what they take up, h' = -force, so that
I nu' = ad*_nu (I nu + h) + external + force.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from derive.verify.proof.algebra import Algebra, Scalar, Setting, Vector
from derive.verify.proof.dynamics import Loop
from derive.verify.proof.statement import Fact, Statement, vanish


@dataclass(frozen=True)
class Laden:
    """A motion with a momentum of wheels and a known force besides."""

    loop: Loop
    wheels: Vector
    external: Vector

    def carried(self, a: Algebra) -> Vector:
        """I nu + h."""
        return a.flat(self.loop.nu) + self.wheels


@dataclass(frozen=True)
class Formulas:
    """force: of the law; plant: I nu' under a force."""

    force: Callable[[Algebra, Laden], Vector]
    plant: Callable[[Algebra, Laden, Vector], Vector]


def law(a: Algebra, m: Laden) -> Vector:
    """ad*_(lambda nu_u - eta) (I nu + h) + I (eta' - lambda nu_u' - k_s s) - external."""
    return _turning(a, m, m.carried(a)) + _asked(a, m) - m.external


def plant(a: Algebra, m: Laden, force: Vector) -> Vector:
    """ad*_nu (I nu + h) + external + force."""
    return a.coad(m.loop.nu, m.carried(a)) + m.external + force


def _turning(a: Algebra, m: Laden, momentum: Vector) -> Vector:
    driven: Vector = m.loop.rate_gain * m.loop.nu_u
    return a.coad(driven - m.loop.eta, momentum)


def _asked(a: Algebra, m: Laden) -> Vector:
    rates = m.loop.eta_dot - m.loop.rate_gain * m.loop.nu_u_dot
    return a.flat(rates - m.loop.reach_gain * m.loop.s)


def _is_kept(setting: Setting, claim: Formulas) -> Iterator[Fact]:
    names = "nu nu_u nu_u_dot eta eta_dot wheels external"
    a, (*vectors, rate_gain, reach_gain) = setting.with_vectors(names, "rate_gain reach_gain")
    nu, nu_u, nu_u_dot, eta, eta_dot, wheels, external = vectors
    loop = Loop(nu, nu_u, nu_u_dot, eta, eta_dot, rate_gain, reach_gain)
    m = Laden(loop, wheels, external)
    force, s = claim.force(a, m), m.loop.s
    moved = claim.plant(a, m, force)
    balance = moved - force - a.coad(m.loop.nu, m.carried(a)) - external
    yield vanish("(I nu + h)' = ad*_nu (I nu + h) + external, h' = -force", balance.entries)
    slide = m.loop.slide(a, moved - force, force)
    closed = a.coad(s, m.carried(a)) - reach_gain * a.flat(s)
    yield vanish("I s' = ad*_s (I nu + h) - k_s I s", (slide - closed).entries)
    yield vanish("W' = -2 k_s W", [slide @ s + reach_gain * a.energy(s, s)])


def _with(force: Callable[[Algebra, Laden], Vector]) -> Formulas:
    return Formulas(force, plant)


def _carrying(share: Scalar) -> Formulas:
    """A law that reckons with another share of the wheels' momentum."""
    return _with(
        lambda a, m: (
            _turning(a, m, a.flat(m.loop.nu) + share * m.wheels) + _asked(a, m) - m.external
        )
    )


def _knowing(share: Scalar) -> Formulas:
    """A law that leaves a share of the known force."""
    return _with(lambda a, m: law(a, m) + share * m.external)


STATEMENTS = (
    Statement(
        "wheels and a known force leave W' = -2 k_s W", "eq. (ELeq)", "polynomials", "algebra",
        _is_kept, _with(law),
        {
            "momentum left out": _carrying(0),
            "the sign of momentum": _carrying(-1),
            "force left out": _knowing(1),
            "force added": _knowing(2),
            "momentum left out of the plant": Formulas(
                law, lambda a, m, force: plant(a, m, force) - a.coad(m.loop.nu, m.wheels)
            ),
        },
    ),
)  # fmt: skip
"""Statements about what a vehicle may carry or know."""
