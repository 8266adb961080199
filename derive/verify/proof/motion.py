"""The reference velocity in the body frame, eta = Ad(g_e^-1) nu_r, and its exact rate.

The truth is found by moving the group element itself, to first order in a time eps: in the free
algebra over g, hat(nu_r) and hat(nu_e), which is any matrix group, and at exact elements of one
group through its own Ad, where e_1 ... e_n in the place of nu_e are all that linearity leaves.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from functools import cached_property
from typing import Any, Protocol

import sympy
from sympy import Matrix, Symbol

from derive.lie.group import Group
from derive.verify.proof.dual import Walk, exact, shown
from derive.verify.proof.model import element, numbers
from derive.verify.proof.statement import Fact, Statement, vanish

EPS = Symbol("eps")


class Motion(Protocol):
    """A group element g_e that moves with nu_e, and a reference velocity that changes."""

    name: str

    def motions(self) -> Iterator[tuple[Any, Any, Any, Any]]:
        """nu_r, nu_r', nu_e, and eta' by first principles."""

    def carried(self, x: Any) -> Any:
        """Ad(g_e^-1) x."""

    def bracket(self, x: Any, y: Any) -> Any:
        """[x, y]."""


class FreeMotion:
    """Letters that commute with nothing."""

    name = "any group"

    def __init__(self) -> None:
        self.g = Symbol("g", commutative=False)

    def motions(self) -> Iterator[tuple[Any, Any, Any, Any]]:
        """One, with symbols for all."""
        x, x_dot, y = (Symbol(name, commutative=False) for name in ("x", "x_dot", "y"))
        ahead, back = self.g * (1 + EPS * y), (1 - EPS * y) * self.g**-1
        eta = back * (x + EPS * x_dot) * ahead
        yield x, x_dot, y, sympy.expand(eta).coeff(EPS, 1)

    def carried(self, x: Any) -> Any:
        """g^-1 x g."""
        return self.g**-1 * x * self.g

    def bracket(self, x: Any, y: Any) -> Any:
        """x y - y x."""
        return x * y - y * x


class GroupMotion:
    """One exact element, exact velocities of the reference, and every basis vector as nu_e."""

    def __init__(self, group: Group, seed: int = 1) -> None:
        rng = random.Random(seed)
        self.group, self.name, self.g = group, group.name, element(group, rng)
        self.reference = tuple(numbers(group.dim, rng) for _ in range(2))

    @cached_property
    def moves(self) -> list[Matrix]:
        """Rate of Ad(g^-1), (n, n), along each basis vector, through the group's own formulas."""
        g = Matrix(sympy.symbols(f"g:{self.group.size}"))
        entries = self.group.Ad(self.group.inverse(self.group.embed(g)))
        stored = self.group.store(self.g)
        nothing = self.group.store(0 * self.g)
        found = []
        for generator in self.group.basis:
            rates = self.group.store(self.g * generator) - nothing
            pairs = zip(map(exact, stored), map(exact, rates), strict=True)
            walk = Walk(dict(zip(g, pairs, strict=True)), {}, None)
            found.append(entries.applyfunc(lambda one, walk=walk: shown(walk(one)[1])))
        return found

    def motions(self) -> Iterator[tuple[Any, Any, Any, Any]]:
        """One per basis vector."""
        nu_r, nu_r_dot = self.reference
        for i, moves in enumerate(self.moves):
            unit = sympy.eye(self.group.dim)[:, i]
            yield nu_r, nu_r_dot, unit, moves * nu_r + self.carried(nu_r_dot)

    def carried(self, x: Any) -> Any:
        """By the group's own Ad."""
        return self._back * x

    @cached_property
    def _back(self) -> Matrix:
        return self.group.Ad(self.group.inverse(self.g))

    def bracket(self, x: Any, y: Any) -> Any:
        """By the structure constants."""
        return self.group.bracket(x, y)


Rate = Callable[[Motion, Any, Any, Any], Any]


def eta_rate(m: Motion, nu_r: Any, nu_r_dot: Any, nu_e: Any) -> Any:
    """Ad(g_e^-1) nu_r' - ad(nu_e) eta."""
    return m.carried(nu_r_dot) - m.bracket(nu_e, m.carried(nu_r))


def _is_rate(m: Motion, claim: Rate) -> Iterator[Fact]:
    for nu_r, nu_r_dot, nu_e, truth in m.motions():
        off = truth - claim(m, nu_r, nu_r_dot, nu_e)
        entries = off if isinstance(off, sympy.MatrixBase) else [off]
        yield vanish("eta' along g_e' = g_e hat(nu_e)", entries)


STATEMENTS = (
    Statement(
        "d/dt eta = Ad(g_e^-1) nu_r' - ad(nu_e) eta", "eq. (velErr)", "first order in time",
        "motion", _is_rate, eta_rate,
        {
            "without ad(nu_e) eta": lambda m, x, x_dot, y: m.carried(x_dot),
            "the sign of ad": lambda m, x, x_dot, y: eta_rate(m, x, x_dot, -y),
            "ad(nu_e) nu_r, not carried": lambda m, x, x_dot, y: (
                m.carried(x_dot) - m.bracket(y, x)
            ),
        },
    ),
)  # fmt: skip
"""Statements about motions on a group."""
