"""Logarithmic coordinates of an element, as steps: rotations, and what rotations carry.

With u half the angle of its one rotation, w = cos u and s = sin u, and k, h of the kernel, a
translation p that a rotation M carries has the logarithm

    rho = p - k Y p + h Y Y p,    Y = hat(y), y = (log M)/(2 k), whose eigenvalues are +-i s:

the series x/(1 - e^-x) at x = -log M, reduced by the minimal polynomial x (x^2 + s^2) of Y.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import sympy
from sympy import Expr, Matrix, eye, sqrt

from derive.lie.cover import (
    Cover,
    Let,
    at_least,
    choose,
    let_cosine,
    of_quaternion,
    of_rotation,
    polynomials,
)
from derive.lie.kernel import SMALL, H, K

if TYPE_CHECKING:
    from derive.lie.group import Group


NEAR_TURN = sympy.Integer(3)
"""Below the squares of |(2 cos, 2 sin)| and of what half the turn is read from, at least 4."""

Tangent = Callable[[Let], Matrix]
Tail = Callable[[Let, Matrix], Matrix]


@dataclass(frozen=True)
class Chart:
    """The logarithm of an element, and what its exact rate is made of.

    log:       coordinates x, (n, 1)
    scaled:    y = x/(2 k), (n, 1), whose ad_y turns by s; x itself where nothing turns; in the
               first basis of a group that is in another one
    w:         cosine of half the angle; None where nothing turns
    square:    s^2
    tangent:   writes vee((g - 1)(g + 1)^-1), (n, 1), if there is a short way to it
    short_tail: Y^2 nu -> (Y^4 + s^2 Y^2) nu with Y = ad_y, if there is a short way to it
    """

    log: Matrix
    scaled: Matrix
    w: Expr | None = None
    square: Expr = sympy.S.Zero
    tangent: Tangent | None = None
    short_tail: Tail | None = None

    @property
    def clearance(self) -> Expr:
        """Zero where the logarithm jumps, 1 where it never does."""
        return sympy.S.One if self.w is None else self.w


Charted = Callable[[Let, Matrix], Chart]


def of_vector(let: Let, stored: Matrix) -> Chart:
    """R^n: an element is its own logarithm."""
    return Chart(stored, stored)


def of_space(let: Let, stored: Matrix) -> Chart:
    """SO3 as a carrier: the rotation vector 2 k v."""
    return _turned(let, of_rotation(let, stored, is_carrier=True))


def of_sphere(let: Let, stored: Matrix) -> Chart:
    """S3: the rotation vector 2 k v, up to 2 pi long."""
    return _turned(let, of_quaternion(let, stored))


def of_plane(let: Let, stored: Matrix) -> Chart:
    """SO2: the angle 2 k s, from -pi to pi."""
    R = stored.reshape(2, 2)
    w, s = _half_turn(let, R[0, 0] + R[1, 1], R[1, 0] - R[0, 1])
    polynomials(let, w)
    return _turned(let, Cover(w, Matrix([s])))


def carried(base: Group, turned: Charted, columns: Sequence[str]) -> Charted:
    """Chart of the matrices [[M, p …], [0, 1]]; turned charts M, columns are the units of p."""
    size = base.basis[0].rows
    whole = size + len(columns)

    def chart(let: Let, stored: Matrix) -> Chart:
        g = stored.reshape(whole, whole)
        inner = turned(let, base.store(g[:size, :size]))
        half = let("half", 1 / (2 * K(inner.w)), "1", "1/(2 k)")
        moves = [g[:size, size + i] for i in range(len(columns))]
        logs, scaled = [inner.log], [inner.scaled]
        for p, mark, unit in zip(moves, _marks(len(columns)), columns, strict=True):
            value = _shift(let, base, inner, p, mark, unit)
            rho = let(f"rho_{mark}", value, unit, "p - k Y p + h Y Y p")
            logs.append(rho)
            scaled.append(let(f"y_{mark}", half * rho, unit, "rho/(2 k)"))
        return Chart(
            log=Matrix.vstack(*logs),
            scaled=Matrix.vstack(*scaled),
            w=inner.w,
            square=inner.square,
            tangent=_carried_tangent(base, inner.tangent, moves) if inner.tangent else None,
            short_tail=_carried_tail(base, scaled, columns),
        )

    return chart


def _shift(let: Let, base: Group, inner: Chart, p: Matrix, mark: str, unit: str) -> Matrix:
    """p - k Y p + h Y Y p; in the plane, where Y Y p = -s^2 p, that is k (w p - Y p)."""
    k, h = K(inner.w), H(inner.w)
    Y = base.hat(inner.scaled)
    is_plane = -inner.square * eye(p.rows) == Y * Y
    if is_plane:
        turned = let(f"turned_{mark}", inner.w * p - Y * p, unit, "p turned back by half the angle")
        return k * turned
    swing = let(f"swing_{mark}", Y * p, unit, "Y p")
    sway = let(f"sway_{mark}", Y * swing, unit, "Y Y p")
    return p - k * swing + h * sway


def _carried_tail(base: Group, scaled: Sequence[Matrix], units: Sequence[str]) -> Tail | None:
    """In space (Y^4 + s^2 Y^2) nu = (0, -2 (v.q) Y^2 omega …) with y = (v, q …)."""
    v, *moves = scaled
    if base.ad(v) != base.hat(v):
        return None

    def tail(let: Let, bend: Matrix) -> Matrix:
        turned = bend[: base.dim, :]
        rows = [0 * turned]
        for q, mark, unit in zip(moves, _marks(len(moves)), units, strict=True):
            along = let(f"along_{mark}", -2 * v.dot(q), unit, "-2 v.q")
            rows.append(along * turned)
        return Matrix.vstack(*rows)

    return tail


def _carried_tangent(base: Group, inner: Tangent, moves: Sequence[Matrix]) -> Tangent:
    """(M - 1)(M + 1)^-1 and, of each column, (M + 1)^-1 p = (p - hat(c) p)/2."""

    def tangent(let: Let) -> Matrix:
        c = let("tangent", inner(let), "1", "tan of half the angle times its axis")
        return Matrix.vstack(c, *((p - base.hat(c) * p) / 2 for p in moves))

    return tangent


def rebased(charted: Charted, back: Matrix) -> Charted:
    """The same chart in another basis of the algebra: coordinates x become back x."""

    def chart(let: Let, stored: Matrix) -> Chart:
        inner = charted(let, stored)
        first = let("log_old", inner.log, "1", "logarithm in the first basis")
        log = let("log", back * first, "1", "logarithm")
        return replace(inner, log=log, tangent=None)  # laws go by the first basis

    return chart


def of_unipotent(group_of: Callable[[Matrix], Matrix], vee: Callable[[Matrix], Matrix]) -> Charted:
    """Groups in which (g - 1)^m = 0: log g = (g - 1) - (g - 1)^2/2 + …, which ends."""

    def chart(let: Let, stored: Matrix) -> Chart:
        off = group_of(stored)
        off = off - eye(off.rows)
        power, total = off, off
        for order in range(2, off.rows):
            power = (power * off).expand()
            total = total - (-1) ** order * power / order
        log = let("log", vee(total), "1", "logarithm, a finite series")
        return Chart(log, log)

    return chart


def _turned(let: Let, cover: Cover) -> Chart:
    w, v = cover.w, cover.v
    phi = let("phi", 2 * K(w) * v, "rad", "rotation vector of the error")
    return Chart(phi, v, w, v.dot(v), lambda let: v / (w + SMALL))


def _marks(count: int) -> list[str]:
    """Suffix of the steps of each column: p, or p0, p1 where there are several."""
    return ["p"] if count == 1 else [f"p{i}" for i in range(count)]


def _half_turn(let: Let, c: Expr, s: Expr) -> tuple[Expr, Expr]:
    """cos >= 0 and sin of half the angle, from 2 cos and 2 sin of it, up to a common factor.

    2 n q q^T = [[n + c, s], [s, n - c]], n = |(c, s)| and q = (cos, sin) of the half: the one of
    its columns that cannot vanish. At pi the sine is 1.
    """
    c, s = let("twice", Matrix([c, s]), "1", "2 cos and 2 sin of the angle")
    square = let("norm_square", c * c + s * s, "1", "their squared length")
    bounded = let("norm_bounded", at_least(square, NEAR_TURN), "1", "the same: less is no turn")
    n = let("norm", sqrt(bounded), "1", "their length")
    column = let(
        "column",
        choose(
            (Matrix([n + c, s]), c >= 0),
            (Matrix([s, n - c]), s >= 0),
            (Matrix([-s, c - n]), sympy.true),
        ),
        "1",
        "cos >= 0 and sin of half the angle, unscaled",
    )
    square = let("column_square", column.dot(column), "1", "squared length")
    bounded = let("column_bounded", at_least(square, NEAR_TURN), "1", "the same")
    scale = let("scale", 1 / sqrt(bounded), "1", "to unit length")
    w = let_cosine(let, column[0] * scale)
    return w, let("sine", column[1] * scale, "1", "sin of half the error angle")
