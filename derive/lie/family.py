"""Families of groups: additive ones, direct products, and the same group in another basis."""

from __future__ import annotations

from dataclasses import replace
from string import ascii_lowercase
from typing import Any

import sympy
from sympy import ImmutableMatrix, Matrix, eye, zeros

from derive.lie import chart
from derive.lie.affine import semidirect, unit_matrix
from derive.lie.cover import Let
from derive.lie.group import Group, Pull, marked

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
    sizes = [one.basis[0].rows for one in factors]
    starts = [sum(sizes[:i]) for i in range(len(sizes))]

    def blocks(method: str, g: Matrix) -> list[Any]:
        """A method of each factor on its block of the matrix g."""
        rows = zip(factors, starts, sizes, strict=True)
        return [getattr(one, method)(g[a : a + m, a : a + m]) for one, a, m in rows]

    def stored(method: str, numbers: Matrix) -> list[Any]:
        """A method of each factor on its stored numbers."""
        rows = zip(factors, whole.split_element(numbers), strict=True)
        return [getattr(one, method)(piece) for one, piece in rows]

    def error(let: Let, g_r: Matrix, g: Matrix) -> Matrix:
        pieces = whole.split_element(g_r), whole.split_element(g)
        rows = zip(factors, MARKS, *pieces, strict=False)
        return Matrix.vstack(*(one.error(marked(let, mark), a, b) for one, mark, a, b in rows))

    def pull(let: Let, g: Matrix) -> Pull:
        rows = zip(factors, MARKS, whole.split_element(g), strict=False)
        pulls = [one.pull(marked(let, mark), piece) for one, mark, piece in rows]
        return lambda name, x: Matrix.vstack(
            *(one(name, piece) for one, piece in zip(pulls, whole.split_velocity(x), strict=True))
        )

    def placed(i: int, e: Matrix) -> ImmutableMatrix:
        return ImmutableMatrix(
            sympy.diag(*(e if i == j else zeros(m) for j, m in enumerate(sizes)))
        )

    whole = Group(
        name=" x ".join(one.name for one in factors),
        basis=tuple(placed(i, e) for i, one in enumerate(factors) for e in one.basis),
        units=tuple(unit for one in factors for unit in one.units),
        identity=tuple(x for one in factors for x in one.identity),
        embed=lambda numbers: sympy.diag(*stored("embed", numbers)),
        store=lambda g: Matrix.vstack(*blocks("store", g)),
        inverse=lambda g: sympy.diag(*blocks("inverse", g)),
        residual=lambda numbers: Matrix([x for part in stored("residual", numbers) for x in part]),
        storage="; then ".join(one.storage for one in factors),
        shape=(sum(one.size for one in factors),),
        factors=factors,
        short_Ad=lambda g: sympy.diag(*blocks("Ad", g)),
        short_error=error,
        short_pull=pull,
    )
    return whole


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
