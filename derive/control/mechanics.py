"""A mechanical system on a Lie group: its group and its inertia, and what they define.

The inertia is kept symmetric, as symbols where the vehicle has a number and as zero where its
pattern has a zero: every vehicle of one pattern shares one derivation.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy
from sympy import ImmutableMatrix, Matrix

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

    @property
    def momentum_unit(self) -> str:
        """Units of I nu."""
        return ", ".join(f"{unit} s" for unit in self.group.force_unit.split(", "))

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

    def pivots(self, d: Derivation) -> tuple[Matrix, Matrix]:
        """Steps of I = L D L^T: unit lower triangular L (n, n) and pivots D (n, 1).

        All pivots are positive if and only if the inertia is positive definite.
        """
        n = self.dim
        lower, pivot = sympy.eye(n), sympy.zeros(n, 1)
        for j in range(n):
            left = sum((lower[j, k] ** 2 * pivot[k] for k in range(j)), sympy.S.Zero)
            pivot[j] = d.let(f"pivot_{j}", self.inertia[j, j] - left, "kg m^2", "pivot of I")
            for i in range(j + 1, n):
                left = sum((lower[i, k] * lower[j, k] * pivot[k] for k in range(j)), sympy.S.Zero)
                value = (self.inertia[i, j] - left) / pivot[j]
                lower[i, j] = d.let(f"lower_{i}{j}", value, "1", "I = L D L^T, entry of L")
        return lower, pivot

    def solve(self, d: Derivation, a: Matrix) -> Matrix:
        """Steps of x with I x = a, (n, 1), by the pivots; no inverse is formed."""
        lower, pivot = self.pivots(d)
        n = self.dim
        x = list(a)
        for i in range(n):
            left = sum((lower[i, k] * x[k] for k in range(i)), sympy.S.Zero)
            x[i] = d.let(f"forward_{i}", x[i] - left, self.group.force_unit, "forward substitution")
        for i in reversed(range(n)):
            left = sum((lower[k, i] * x[k] for k in range(i + 1, n)), sympy.S.Zero)
            x[i] = d.let(f"back_{i}", x[i] / pivot[i] - left, self.group.acceleration_unit, "back substitution")
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
    inertia = d.take(Quantity("inertia", size, "kg m^2", doc, place="params.inertia"))
    return MechanicalSystem(group, symmetric(inertia, pattern))


def plant(group: Group, pattern: tuple[bool, ...]) -> Derivation:
    """Euler-Poincare: I nu' = coad(nu) I nu + force; eq. (EulerP)."""
    d = Derivation("plant", "acceleration under a force, Euler-Poincare", "eq. (EulerP)")
    n = group.dim
    system = take_system(d, group, pattern)
    nu = d.take(Quantity("nu", n, group.unit, "body velocity", place="state.nu"))
    force = d.take(Quantity("force", n, group.force_unit, "applied force", place="force"))
    momentum = d.let("momentum", system.flat(nu), system.momentum_unit, "I nu")
    total = d.let("total", group.coad(nu) * momentum + force, group.force_unit, "coad(nu) I nu + force")
    nu_dot = system.solve(d, total)
    output = Quantity("nu_dot", n, group.acceleration_unit, "body acceleration", place="nu_dot")
    d.give(output, nu_dot)
    return d.pruned()


def definiteness(group: Group, pattern: tuple[bool, ...]) -> Derivation:
    """Pivots of the inertia: all positive if and only if it is positive definite."""
    d = Derivation("definiteness", "pivots of the inertia: all positive for a valid one", "")
    system = take_system(d, group, pattern)
    _, pivot = system.pivots(d)
    output = Quantity("pivot", group.dim, "kg m^2", "pivots of I", place="pivot")
    d.give(output, pivot)
    return d.pruned()


def residual(group: Group) -> Derivation:
    """How far stored numbers are from the group: every number vanishes on it, and only there."""
    d = Derivation("residual", "distance of stored numbers from the group", "")
    size = len(group.identity)
    g = d.take(Quantity("g", size, "1", "configuration", place="g"))
    value = group.residual(g)
    off = d.let("off", value, "1", "deviation from the group")
    d.give(Quantity("residual", len(value), "1", "vanishes on the group", place="residual"), off)
    return d.pruned()
