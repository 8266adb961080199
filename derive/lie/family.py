"""Families of groups: additive ones, rotations with translations, direct products."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy
from sympy import ImmutableMatrix, Matrix, eye, zeros

from derive.lie import chart
from derive.lie.cover import Let
from derive.lie.group import Group, Pull


def vector_space(n: int) -> Group:
    """R^n: n stored numbers, addition; as matrices, the translations of n-space."""

    def embed(stored: Matrix) -> Matrix:
        return Matrix.vstack(Matrix.hstack(eye(n), stored), eye(n + 1)[n, :])

    return Group(
        name=f"R{n}",
        basis=tuple(ImmutableMatrix(_unit(n + 1, i, n)) for i in range(n)),
        units=("m/s",) * n,
        identity=(0,) * n,
        embed=embed,
        store=lambda g: g[:n, n],
        inverse=lambda g: embed(-g[:n, n]),
        residual=lambda stored: Matrix([]),
        storage=f"{n} numbers",
        shape=(n,),
        chart=chart.of_vector,
        short_Ad=lambda g: eye(n),
        short_error=lambda let, g_r, g: g - g_r,
        short_puller=lambda let, g: lambda name, x: x,
    )


def with_translations(rotations: Group, name: str, count: int, log: Callable[..., Any]) -> Group:
    """Rotations (d, d) with `count` columns that they turn: SE2, SE3, SE23."""
    d = rotations.basis[0].rows
    size = d + count

    def split(stored: Matrix) -> tuple[Matrix, list[Matrix]]:
        g = stored.reshape(size, size)
        return g[:d, :d], [g[:d, d + i] for i in range(count)]

    def joined(rotation: Matrix, columns: list[Matrix]) -> Matrix:
        top = Matrix.hstack(rotation, *columns)
        return Matrix.vstack(top, Matrix.hstack(zeros(count, d), eye(count)))

    def inverse(g: Matrix) -> Matrix:
        back = g[:d, :d].T
        return joined(back, [-back * g[:d, d + i] for i in range(count)])

    def error(let: Let, g_r: Matrix, g: Matrix) -> Matrix:
        (R_r, p_r), (R, p) = split(g_r), split(g)
        gaps = [let(f"gap_{i}", a - b, "m", "p - p_r") for i, (a, b) in enumerate(zip(p, p_r, strict=True))]
        return Matrix(list(joined(R_r.T * R, [R_r.T * gap for gap in gaps])))

    def puller(let: Let, g: Matrix) -> Pull:
        """Turned back, with the lever arm of each translation: R^T omega, R^T (v - p x omega)."""
        R, columns = split(g)

        def pull(name: str, x: Matrix) -> Matrix:
            turn = x[: rotations.dim, :]
            parts = [R.T * turn] if d == 3 else [turn]
            for i, p in enumerate(columns):
                moved = x[rotations.dim + d * i : rotations.dim + d * (i + 1), :]
                lever = p.cross(turn) if d == 3 else Matrix([p[1], -p[0]]) * turn[0]
                arm = let(f"{name}_arm_{i}", moved - lever, "m/s", "velocity at the tip of p")
                parts.append(R.T * arm)
            return Matrix([entry for part in parts for entry in part])

        return pull

    def residual(stored: Matrix) -> Matrix:
        g = stored.reshape(size, size)
        last = g[d:, :] - Matrix.hstack(zeros(count, d), eye(count))
        return Matrix([*rotations.residual(Matrix(list(g[:d, :d]))), *last])

    turns = [sympy.diag(e, zeros(count, count)) for e in rotations.basis]
    shifts = [_unit(size, i, d + column) for column in range(count) for i in range(d)]
    return Group(
        name=name,
        basis=tuple(ImmutableMatrix(e) for e in (*turns, *shifts)),
        units=(*rotations.units, *("m/s",) * (d * count)),
        identity=tuple(eye(size)),
        embed=lambda stored: stored.reshape(size, size),
        store=lambda g: Matrix(size * size, 1, list(g)),
        inverse=inverse,
        residual=residual,
        storage=f"matrix ({size}, {size}), row by row",
        shape=(size, size),
        chart=lambda let, stored: log(let, stored.reshape(size, size)),
        short_error=error,
        short_puller=puller,
    )


def product(a: Group, b: Group) -> Group:
    """Direct product: stored numbers and coordinates concatenated, nothing mixed."""
    k, m, n = len(a.identity), a.basis[0].rows, a.dim

    def embed(stored: Matrix) -> Matrix:
        return sympy.diag(a.embed(stored[:k, :]), b.embed(stored[k:, :]))

    def blocks(g: Matrix) -> tuple[Matrix, Matrix]:
        return g[:m, :m], g[m:, m:]

    def both(g: Matrix, left: Callable[..., Any], right: Callable[..., Any]) -> tuple[Any, Any]:
        first, second = blocks(g)
        return left(first), right(second)

    def error(let: Let, g_r: Matrix, g: Matrix) -> Matrix:
        one = a.error(chart.marked(let, "a"), g_r[:k, :], g[:k, :])
        return Matrix([*one, *b.error(chart.marked(let, "b"), g_r[k:, :], g[k:, :])])

    def puller(let: Let, g: Matrix) -> Pull:
        one = a.puller(chart.marked(let, "a"), g[:k, :])
        other = b.puller(chart.marked(let, "b"), g[k:, :])
        return lambda name, x: Matrix([*one(name, x[:n, :]), *other(name, x[n:, :])])

    zero_a, zero_b = zeros(m, m), zeros(b.basis[0].rows, b.basis[0].rows)
    left = [sympy.diag(e, zero_b) for e in a.basis]
    right = [sympy.diag(zero_a, e) for e in b.basis]
    log = chart.of_product(a.chart, b.chart, k, n) if a.chart and b.chart else None
    return Group(
        name=f"{a.name} x {b.name}",
        basis=tuple(ImmutableMatrix(e) for e in (*left, *right)),
        units=(*a.units, *b.units),
        identity=(*a.identity, *b.identity),
        embed=embed,
        store=lambda g: Matrix([*a.store(blocks(g)[0]), *b.store(blocks(g)[1])]),
        inverse=lambda g: sympy.diag(*both(g, a.inverse, b.inverse)),
        residual=lambda s: Matrix([*a.residual(s[:k, :]), *b.residual(s[k:, :])]),
        storage=f"{a.storage}; then {b.storage}",
        shape=(k + len(b.identity),),
        chart=log,
        has_pole=a.has_pole or b.has_pole,
        short_Ad=lambda g: sympy.diag(*both(g, a.Ad, b.Ad)),
        short_error=error,
        short_puller=puller,
    )


def _unit(size: int, row: int, column: int) -> Matrix:
    """A single one at (row, column)."""
    return Matrix(size, size, lambda i, j: int((i, j) == (row, column)))
