"""Rotations, or other matrices, that carry translations: [[M, p …], [0, 1]]."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy
from sympy import ImmutableMatrix, Matrix, eye, zeros

from derive.lie.chart import Charted, carried
from derive.lie.cover import Let
from derive.lie.group import Group, Pull, times_second


def semidirect(base: Group, name: str, units: Sequence[str], turned: Charted | None) -> Group:
    """M of base, and one column of translation for each unit of its velocity.

    turned: chart of M as a carrier, None for a group without a logarithm
    """
    affine = _Affine(base, tuple(units))
    whole = affine.size + len(units)
    return Group(
        name=name,
        basis=affine.basis,
        units=(*base.units, *(unit for unit in units for _ in range(affine.size))),
        identity=tuple(eye(whole)),
        embed=affine.embed,
        store=lambda g: Matrix(list(g)),
        inverse=affine.inverse,
        residual=affine.residual,
        storage=f"matrix of {whole} rows, row by row",
        shape=(whole, whole),
        chart=carried(base, turned, affine.lengths) if turned else None,
        short_error=affine.error,
        short_pull=affine.pull,
    )


@dataclass(frozen=True)
class _Affine:
    """The formulas of [[M, p …], [0, 1]]."""

    base: Group
    units: tuple[str, ...]

    @property
    def size(self) -> int:
        """Rows of M."""
        return int(self.base.basis[0].rows)

    @property
    def lengths(self) -> list[str]:
        """Units of the columns."""
        return [times_second(unit) for unit in self.units]

    @property
    def basis(self) -> tuple[ImmutableMatrix, ...]:
        """That of M, then one matrix for each entry, column by column."""
        count, whole = len(self.units), self.size + len(self.units)
        turns = [sympy.diag(e, zeros(count)) for e in self.base.basis]
        shifts = [unit_matrix(whole, i, j) for j in range(self.size, whole)
                  for i in range(self.size)]  # fmt: skip
        return tuple(ImmutableMatrix(e) for e in (*turns, *shifts))

    def split(self, g: Matrix) -> tuple[Matrix, list[Matrix]]:
        """M and the columns."""
        d = self.size
        return g[:d, :d], [g[:d, d + i] for i in range(len(self.units))]

    def joined(self, M: Matrix, columns: Sequence[Matrix]) -> Matrix:
        """[[M, p …], [0, 1]]."""
        below = Matrix.hstack(zeros(len(columns), self.size), eye(len(columns)))
        return Matrix.vstack(Matrix.hstack(M, *columns), below)

    def embed(self, stored: Matrix) -> Matrix:
        """Stored numbers to the matrix, whose last rows are exact."""
        whole = self.size + len(self.units)
        return self.joined(*self.split(stored.reshape(whole, whole)))

    def inverse(self, g: Matrix) -> Matrix:
        """[[M^-1, -M^-1 p …], [0, 1]]."""
        M, columns = self.split(g)
        back = self.base.inverse(M)
        return self.joined(back, [-back * p for p in columns])

    def error(self, let: Let, g_r: Matrix, g: Matrix) -> Matrix:
        """g_r^-1 g: the difference of the translations is taken before it is turned."""
        (M_r, starts), (M, ends) = self.split(self.embed(g_r)), self.split(self.embed(g))
        back = self.base.inverse(M_r)
        rows = enumerate(zip(starts, ends, self.lengths, strict=True))
        gaps = [let(f"gap_{i}", p - p_r, unit, "translation of g from g_r")
                for i, (p_r, p, unit) in rows]  # fmt: skip
        return Matrix(list(self.joined(back * M, [back * gap for gap in gaps])))

    def pull(self, let: Let, stored: Matrix) -> Pull:
        """M^-1 on the velocity of M, and M^-1 (v + hat(omega) p) on that of each column."""
        M, columns = self.split(self.embed(stored))
        back = self.base.inverse(M)
        turn_back = self.base.Ad(back)

        def pulled(name: str, x: Matrix) -> Matrix:
            turn, *moves = self.velocities(x)
            parts = [turn_back * turn]
            for i, (p, move) in enumerate(zip(columns, moves, strict=True)):
                arm = move + self.base.hat(turn) * p
                parts.append(back * let(f"{name}_arm_{i}", arm, self.units[i], "velocity at p"))
            return Matrix.vstack(*parts)

        return pulled

    def velocities(self, x: Matrix) -> Iterator[Matrix]:
        """Coordinates of M's velocity, then of each column's."""
        n, d = self.base.dim, self.size
        yield x[:n, :]
        for start in range(n, n + d * len(self.units), d):
            yield x[start : start + d, :]

    def residual(self, stored: Matrix) -> Matrix:
        """That of M, and the last rows."""
        whole = self.size + len(self.units)
        g = stored.reshape(whole, whole)
        M = self.base.store(g[: self.size, : self.size])
        return Matrix([*self.base.residual(M), *(g - eye(whole))[self.size :, :]])


def unit_matrix(size: int, row: int, column: int) -> Matrix:
    """A single one at (row, column)."""
    return Matrix(size, size, lambda i, j: int((i, j) == (row, column)))
