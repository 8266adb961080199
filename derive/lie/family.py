"""Families of groups: additive ones, direct products, and the same group in another basis."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from string import ascii_lowercase

import sympy
from sympy import ImmutableMatrix, Matrix, eye, zeros

from derive.lie import chart
from derive.lie.affine import semidirect, unit_matrix
from derive.lie.cover import Let
from derive.lie.group import Group, Pull, cut, marked

__all__ = ["MARKS", "product", "rebased", "semidirect", "vector_space"]

MARKS = ascii_lowercase
"""Suffix of the steps of each factor of a product: as many as a product may have factors."""


def vector_space(n: int) -> Group:
    """R^n: n stored numbers, addition; as matrices, the translations of n-space."""

    def embed(stored: Matrix) -> Matrix:
        return Matrix.vstack(Matrix.hstack(eye(n), stored), eye(n + 1)[n, :])

    return Group(
        name=f"R{n}",
        basis=tuple(ImmutableMatrix(unit_matrix(n + 1, i, n)) for i in range(n)),
        units=("m/s",) * n,
        identity=(0,) * n,
        embed=embed,
        store=lambda g: g[:n, n],
        inverse=lambda g: embed(-g[:n, n]),
        residual=lambda stored: Matrix([]),
        storage=f"{n} numbers" if n > 1 else "one number",
        shape=(n,),
        chart=chart.of_vector,
        short_Ad=lambda g: eye(n),
        short_error=lambda let, g_r, g: g - g_r,
        short_pull=lambda let, g: lambda name, x: x,
    )


def product(*factors: Group) -> Group:
    """Direct product: stored numbers and coordinates concatenated, nothing mixed.

    Raises ValueError for more factors than MARKS.
    """
    if len(factors) > len(MARKS):
        raise ValueError(f"a product of {len(factors)} factors: at most {len(MARKS)} are expected")
    whole = _Factors(factors)
    return Group(
        name=" x ".join(one.name for one in factors),
        basis=tuple(whole.basis()),
        units=tuple(unit for one in factors for unit in one.units),
        identity=tuple(x for one in factors for x in one.identity),
        embed=whole.embed,
        store=whole.store,
        inverse=whole.inverse,
        residual=whole.residual,
        storage="; then ".join(one.storage for one in factors),
        shape=(sum(one.size for one in factors),),
        factors=factors,
        short_Ad=whole.Ad,
        short_error=whole.error,
        short_pull=whole.pull,
    )


@dataclass(frozen=True)
class _Factors:
    """Groups side by side: elements in blocks, stored numbers and coordinates in rows."""

    each: tuple[Group, ...]

    def basis(self) -> Iterator[ImmutableMatrix]:
        """Each E of each factor in its block, zeros in the others, (m, m)."""
        empty = [zeros(m) for m in self._orders]
        for i, one in enumerate(self.each):
            for e in one.basis:
                yield ImmutableMatrix(sympy.diag(*empty[:i], e, *empty[i + 1 :]))

    def embed(self, stored: Matrix) -> Matrix:
        """Stored numbers (k, 1) to element (m, m)."""
        return sympy.diag(*(one.embed(piece) for one, piece in self._pieces(stored)))

    def store(self, g: Matrix) -> Matrix:
        """Element (m, m) to stored numbers (k, 1)."""
        return Matrix.vstack(*(one.store(block) for one, block in self._blocks(g)))

    def inverse(self, g: Matrix) -> Matrix:
        """g^-1, (m, m)."""
        return sympy.diag(*(one.inverse(block) for one, block in self._blocks(g)))

    def residual(self, stored: Matrix) -> Matrix:
        """What vanishes where every factor is on its group."""
        return Matrix([x for one, piece in self._pieces(stored) for x in one.residual(piece)])

    def Ad(self, g: Matrix) -> Matrix:
        """Ad_g of an element, (n, n)."""
        return sympy.diag(*(one.Ad(block) for one, block in self._blocks(g)))

    def error(self, let: Let, g_r: Matrix, g: Matrix) -> Matrix:
        """Stored numbers of g_r^-1 g, (k, 1), from stored numbers."""
        rows = zip(MARKS, self._pieces(g_r), self._pieces(g), strict=False)
        return Matrix.vstack(
            *(one.error(marked(let, mark), a, b) for mark, (one, a), (_, b) in rows)
        )

    def pull(self, let: Let, g: Matrix) -> Pull:
        """Ad of g^-1, for stored g, as a function of velocities."""
        rows = zip(MARKS, self._pieces(g), strict=False)
        pulls = [one.pull(marked(let, mark), piece) for mark, (one, piece) in rows]

        def pulled(name: str, x: Matrix) -> Matrix:
            pieces = zip(pulls, cut(x, [one.dim for one in self.each]), strict=True)
            return Matrix.vstack(*(one(name, piece) for one, piece in pieces))

        return pulled

    @property
    def _orders(self) -> list[int]:
        """m of each factor."""
        return [one.basis[0].rows for one in self.each]

    def _blocks(self, g: Matrix) -> Iterator[tuple[Group, Matrix]]:
        """Each factor with its block of the element g."""
        start = 0
        for one, m in zip(self.each, self._orders, strict=True):
            yield one, g[start : start + m, start : start + m]
            start += m

    def _pieces(self, stored: Matrix) -> Iterator[tuple[Group, Matrix]]:
        """Each factor with its stored numbers."""
        return zip(self.each, cut(stored, [one.size for one in self.each]), strict=True)


def rebased(group: Group, name: str, basis: Matrix, units: tuple[str, ...]) -> Group:
    """The same elements, stored alike, in another basis of the algebra.

    basis: (n, n), exact: column j holds the new E_j in the old coordinates. Raises ValueError
    where it is singular. What moves a velocity is computed in the old basis, which may keep apart
    what the new one mixes: a turn of 1e-3 is lost beside a translation of 1e6.
    """
    if basis.det() == 0:
        raise ValueError(f"{name}: the new basis matrices are linearly dependent")
    made = [group.hat(basis[:, j]) for j in range(group.dim)]
    back, unit = basis.inv(), group.unit

    def pull(let: Let, g: Matrix) -> Pull:
        first = group.pull(let, g)

        def pulled(name: str, x: Matrix) -> Matrix:
            old = let(f"{name}_old", basis * x, unit, "before, in the first basis")
            new = let(f"{name}_new", first(name, old), unit, "after, in the first basis")
            return back * new

        return pulled

    return replace(
        group,
        name=name,
        basis=tuple(ImmutableMatrix(e) for e in made),
        units=units,
        cover=None,
        chart=chart.rebased(group.chart, back) if group.chart else None,
        factors=(),
        first=(group, ImmutableMatrix(basis)),
        short_Ad=None,
        short_pull=pull,
        is_rotation=False,
    )
