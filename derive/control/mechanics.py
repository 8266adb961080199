"""A mechanical system on a Lie group: its group and its inertia, and what they define.

The inertia is kept symmetric, as symbols where the vehicle has a number and as zero where its
pattern has a zero: every vehicle of one pattern shares one derivation.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy
from sympy import ImmutableMatrix, Matrix, Piecewise

from derive.lie.group import Group
from derive.routine.derivation import Derivation, Quantity


@dataclass(frozen=True)
class MechanicalSystem:
    """Configuration group and inertia tensor (n, n), symmetric; eq. (ELeq)."""

    group: Group
    inertia: ImmutableMatrix

    @property
    def dim(self) -> int:
        """n, the dimension of the group."""
        return self.group.dim

    def flat(self, x: Matrix) -> Matrix:
        """I x: velocity (n, 1) to momentum (n, 1)."""
        return self.inertia * x

    def sharp(self, a: Matrix) -> Matrix:
        """I^-1 a, exactly: for proofs; routines solve with `solve` instead."""
        return self.inertia.inv() * a

    def connection(self, x: Matrix, y: Matrix) -> Matrix:
        """Restriction of the Levi-Civita connection to the algebra, (n, 1); eq. (Rest)."""
        coad, flat = self.group.coad, self.flat
        return (self.group.bracket(x, y) - self.sharp(coad(x) * flat(y) + coad(y) * flat(x))) / 2

    def pivots(self, d: Derivation, *, is_definite: bool = True) -> tuple[Matrix, Matrix]:
        """Steps of I = L D L^T: unit lower triangular L (n, n) and pivots D (n, 1).

        All pivots are positive if and only if the inertia is positive definite. Where that is
        to be found out, nothing is divided by a pivot that is not: the pivots after it are wrong.
        """
        n = self.dim
        lower, pivot = sympy.eye(n), sympy.zeros(n, 1)
        for j in range(n):
            left = sum((lower[j, k] ** 2 * pivot[k] for k in range(j)), sympy.S.Zero)
            pivot[j] = d.let(
                f"pivot_{j}", self.inertia[j, j] - left, self.group.inertia_unit, "pivot of I"
            )
            divisor = pivot[j] if is_definite else self._divisor(d, j, pivot[j])
            for i in range(j + 1, n):
                left = sum((lower[i, k] * lower[j, k] * pivot[k] for k in range(j)), sympy.S.Zero)
                value = (self.inertia[i, j] - left) / divisor
                lower[i, j] = d.let(f"lower_{i}{j}", value, "1", "I = L D L^T, entry of L")
        return lower, pivot

    def _divisor(self, d: Derivation, j: int, pivot: Any) -> Any:
        """Step of a pivot that anything may be divided by: 1 where it is not positive."""
        value = Piecewise((pivot, pivot > 0), (sympy.S.One, True), evaluate=False)
        unit, doc = self.group.inertia_unit, "the pivot, or 1 where it is not positive"
        return d.let(f"divisor_{j}", value, unit, doc)

    def solve(self, d: Derivation, a: Matrix) -> Matrix:
        """Steps of x with I x = a, (n, 1), by the pivots; no inverse is formed."""
        lower, pivot = self.pivots(d)
        n = self.dim
        x = list(a)
        for i in range(n):
            left = sum((lower[i, k] * x[k] for k in range(i)), sympy.S.Zero)
            unit, doc = self.group.force_unit, "forward substitution"
            x[i] = d.let(f"forward_{i}", x[i] - left, unit, doc)
        for i in reversed(range(n)):
            left = sum((lower[k, i] * x[k] for k in range(i + 1, n)), sympy.S.Zero)
            unit, doc = self.group.acceleration_unit, "back substitution"
            x[i] = d.let(f"back_{i}", x[i] / pivot[i] - left, unit, doc)
        return Matrix(x)


def symmetric(entries: Matrix, pattern: tuple[bool, ...]) -> ImmutableMatrix:
    """Upper triangle by rows, n(n+1)/2 entries, to the matrix (n, n), zero where pattern is."""
    n = next(n for n in range(1, len(pattern) + 1) if n * (n + 1) // 2 == len(pattern))
    place = {(i, j): k for k, (i, j) in enumerate((i, j) for i in range(n) for j in range(i, n))}

    def entry(i: int, j: int) -> Any:
        k = place[min(i, j), max(i, j)]
        return entries[k] if pattern[k] else 0

    return ImmutableMatrix(n, n, entry)


def take_system(d: Derivation, group: Group, pattern: tuple[bool, ...]) -> MechanicalSystem:
    """Declare the inertia as an input of d and make the system of it."""
    size = len(pattern)
    doc = "inertia, upper triangle, row by row"
    unit = group.inertia_unit
    inertia = d.take(Quantity("inertia", size, unit, doc, place="params.inertia"))
    return MechanicalSystem(group, symmetric(inertia, pattern))


@dataclass(frozen=True)
class Extras:
    """What a vehicle may know besides g and nu: zero where its file does not ask for it.

    momentum: internal, of wheels, (n, 1), added to I nu; external: known force, (n, 1)
    """

    momentum: Matrix
    external: Matrix


def take_extras(d: Derivation, group: Group, options: tuple[str, ...]) -> Extras:
    """Declare as inputs of d the extras asked for."""
    zero = sympy.zeros(group.dim, 1)
    units = {"momentum": group.momentum_unit, "external": group.force_unit}
    docs = {"momentum": "internal momentum, of wheels", "external": "known external force"}
    taken = {
        name: d.take(Quantity(name, group.dim, unit, docs[name], place=f"state.{name}"))
        if name in options
        else zero
        for name, unit in units.items()
    }
    return Extras(**taken)


def let_momentum(
    d: Derivation, system: MechanicalSystem, nu: Matrix, extras: Extras, name: str = "nu"
) -> Matrix:
    """Step of the whole momentum, I nu, and that of the wheels where there are any.

    name: of the velocity, where it is another
    """
    unit = system.group.momentum_unit
    if any(extras.momentum):
        value = system.flat(nu) + extras.momentum
        return d.let("whole_momentum", value, unit, f"I {name} and the internal momentum")
    return d.let("momentum", system.flat(nu), unit, f"I {name}")


def plant(group: Group, pattern: tuple[bool, ...], options: tuple[str, ...] = ()) -> Derivation:
    """Euler-Poincare: I nu' = coad(nu) I nu + force; eq. (EulerP).

    With internal momentum h, force is also what the wheels are driven with: h' = -force as far
    as it comes from them, and I nu' = coad(nu) (I nu + h) + external + force.
    """
    d = Derivation("plant", "acceleration under a force, Euler-Poincare", "eq. (EulerP)")
    n = group.dim
    system = take_system(d, group, pattern)
    nu = d.take(Quantity("nu", n, group.unit, "body velocity", place="state.nu"))
    extras = take_extras(d, group, options)
    force = d.take(Quantity("force", n, group.force_unit, "applied force", place="force"))
    momentum = let_momentum(d, system, nu, extras)
    total = group.coad(nu) * momentum + force + extras.external
    total = d.let("total", total, group.force_unit, "coad(nu) I nu + force")
    nu_dot = system.solve(d, total)
    output = Quantity("nu_dot", n, group.acceleration_unit, "body acceleration", place="nu_dot")
    d.give(output, nu_dot)
    return d.pruned()


def definiteness(group: Group, pattern: tuple[bool, ...]) -> Derivation:
    """Pivots of the inertia: all positive if and only if it is positive definite."""
    d = Derivation("definiteness", "pivots of the inertia: all positive for a valid one", "")
    system = take_system(d, group, pattern)
    _, pivot = system.pivots(d, is_definite=False)
    output = Quantity("pivot", group.dim, group.inertia_unit, "pivots of I", place="pivot")
    d.give(output, pivot)
    return d.pruned()


def residual(group: Group) -> Derivation:
    """How far stored numbers are from the group: every number vanishes on it, and only there.

    Without an output where all numbers are elements.
    """
    d = Derivation("residual", "distance of stored numbers from the group", "")
    g = d.take(Quantity("g", group.size, "1", "configuration", place="g"))
    value = group.residual(g)
    if not value:
        return d
    off = d.let("off", value, "1", "deviation from the group")
    d.give(Quantity("residual", len(value), "1", "vanishes on the group", place="residual"), off)
    return d.pruned()
