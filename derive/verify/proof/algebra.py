"""A Lie algebra with an inertia, over polynomials: the ground on which the dynamics is proved.

Structure constants and inertia are either symbols, antisymmetric and symmetric and nothing else
(the Jacobi identity is nowhere needed), or the exact numbers of a group and of a vehicle.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import islice, product
from typing import Any

import sympy
from sympy import QQ, ZZ, ring
from sympy.polys.matrices import DomainMatrix

from derive.lie.group import Group

Inertia = Sequence[Sequence[Fraction]]
"""Exact rows, (n, n)."""

Scalar = Any
"""A polynomial with rational coefficients."""


@dataclass(frozen=True)
class Vector:
    """Coordinates (n,) of a velocity or of a covector; `a @ x` is their pairing <a; x>."""

    entries: tuple[Scalar, ...]

    def __add__(self, other: Vector) -> Vector:
        pairs = zip(self.entries, other.entries, strict=True)
        return Vector(tuple(a + b for a, b in pairs))

    def __sub__(self, other: Vector) -> Vector:
        return self + -other

    def __neg__(self) -> Vector:
        return Vector(tuple(-a for a in self.entries))

    def __rmul__(self, factor: Scalar) -> Vector:
        return Vector(tuple(factor * a for a in self.entries))

    def __matmul__(self, other: Vector) -> Scalar:
        return sum(a * b for a, b in zip(self.entries, other.entries, strict=True) if a and b)


@dataclass(frozen=True)
class Algebra:
    """n-dimensional, [e_i, e_j] = sum_k constants[i, j][k] e_k, inertia (n, n)."""

    constants: dict[tuple[int, int], tuple[Scalar, ...]]
    inertia: tuple[Vector, ...]
    zero: Scalar

    def bracket(self, x: Vector, y: Vector) -> Vector:
        """[x, y]."""
        total = [self.zero] * len(self.inertia)
        for (i, j), row in self.constants.items():
            size = x.entries[i] * y.entries[j]
            for k, c in enumerate(row):
                if c:
                    total[k] += c * size
        return Vector(tuple(total))

    def coad(self, x: Vector, a: Vector) -> Vector:
        """ad*_x a in the paper's sign: <ad*_x a; y> = <a; [x, y]>."""
        total = [self.zero] * len(self.inertia)
        for (i, j), row in self.constants.items():
            image = sum((c * a.entries[k] for k, c in enumerate(row) if c), self.zero)
            total[j] += x.entries[i] * image
        return Vector(tuple(total))

    def flat(self, x: Vector) -> Vector:
        """I x."""
        return Vector(tuple(row @ x for row in self.inertia))

    def energy(self, x: Vector, y: Vector) -> Scalar:
        """I(x, y)."""
        return self.flat(x) @ y

    @property
    def determinant(self) -> Scalar:
        """det I."""
        return _adjugate(self.inertia)[1]

    def scaled_sharp(self, a: Vector) -> Vector:
        """det(I) I^sharp a, by the adjugate: a polynomial, and no inverse."""
        return Vector(tuple(row @ a for row in _adjugate(self.inertia)[0]))


@cache
def _adjugate(matrix: tuple[Vector, ...]) -> tuple[tuple[Vector, ...], Scalar]:
    """Rows of adj(I), adj(I) I = det(I), and det(I); without a division."""
    n = len(matrix)
    domain = matrix[0].entries[0].ring.to_domain()
    rows = [list(row.entries) for row in matrix]
    adjugate, determinant = DomainMatrix(rows, (n, n), domain).adj_det()
    return tuple(Vector(tuple(row)) for row in adjugate.to_list()), determinant


@dataclass(frozen=True)
class Setting:
    """Of what an algebra is made: symbols throughout, or what is known of a group and a body.

    structure: constants[i][j][k] as exact numbers, None for symbols
    inertia:   (n, n) exact numbers, None for symbols
    """

    dim: int
    structure: tuple[tuple[tuple[Fraction, ...], ...], ...] | None = None
    inertia: tuple[tuple[Fraction, ...], ...] | None = None

    @classmethod
    def of(cls, group: Group, inertia: Sequence[Sequence[Fraction]] | None) -> Setting:
        """The structure constants of a group, and a body's inertia where one is given."""
        n = group.dim
        structure = tuple(
            tuple(tuple(_fraction(c[k, j]) for k in range(n)) for j in range(n))
            for c in group.structure
        )
        rows = None if inertia is None else tuple(tuple(row) for row in inertia)
        return cls(n, structure, rows)

    def with_vectors(self, vectors: str, scalars: str = "") -> tuple[Algebra, list[Any]]:
        """The algebra over the ring that has these vectors and scalars, and they themselves."""
        n = self.dim
        above = [f"{i}_{j}" for i in range(n) for j in range(i + 1, n)]
        upper = [f"{i}_{j}" for i in range(n) for j in range(i, n)]
        names = [f"{name}_{i}" for name in vectors.split() for i in range(n)] + scalars.split()
        names += [f"c_{ij}_{k}" for ij in above for k in range(n)] if not self.structure else []
        names += [f"I_{ij}" for ij in upper] if not self.inertia else []
        is_symbolic = not self.structure and not self.inertia
        polynomials, *symbols = ring(names, ZZ if is_symbolic else QQ)
        generators = iter(symbols)
        given: list[Any] = [Vector(tuple(islice(generators, n))) for _ in vectors.split()]
        given += islice(generators, len(scalars.split()))
        c = self.structure or _antisymmetric(generators, n)
        inertia = self.inertia or _symmetric(generators, n)
        one = polynomials.one
        constants = {
            (i, j): tuple(one * _exact(value) for value in c[i][j])
            for i, j in product(range(n), repeat=2)
            if any(c[i][j])
        }
        rows = tuple(Vector(tuple(one * _exact(value) for value in row)) for row in inertia)
        return Algebra(constants, rows, polynomials.zero), given


def _symmetric(entries: Iterator[Scalar], n: int) -> list[list[Scalar]]:
    """The matrix whose upper triangle, by rows, is made of the next entries."""
    upper = {(i, j): next(entries) for i in range(n) for j in range(i, n)}
    return [[upper[min(i, j), max(i, j)] for j in range(n)] for i in range(n)]


def _antisymmetric(entries: Iterator[Scalar], n: int) -> list[list[list[Scalar]]]:
    """Constants [i][j][k] that change sign with i and j, made of the next entries."""
    above = {(i, j): [*islice(entries, n)] for i in range(n) for j in range(i + 1, n)}
    above |= {(j, i): [-c for c in row] for (i, j), row in above.items()}
    return [[above.get((i, j), [0] * n) for j in range(n)] for i in range(n)]


def _exact(value: Scalar) -> Scalar:
    """A fraction as the ring's own number; a polynomial stays itself."""
    return QQ(value.numerator, value.denominator) if isinstance(value, Fraction) else value


def _fraction(value: sympy.Expr) -> Fraction:
    """An exact number of the catalogue; TypeError for one that is not rational."""
    if not value.is_Rational:
        raise TypeError(f"{value} is not rational: structure constants have to be exact numbers")
    return Fraction(int(value.p), int(value.q))
