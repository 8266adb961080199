"""From stored numbers to the unit quaternion (w, v), without threshold and without 0/0.

Both routes end in named steps. `let` is handed in by whoever writes the derivation, so this
layer knows the formulas and not what a derivation is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import sympy
from sympy import Expr, Matrix, Piecewise, pi, sqrt

from derive.lie.kernel import CUT, FLOOR, SHORT, H, K

Let = Callable[..., Any]
"""let(name, value, unit, doc, source="", stands_for=None) -> the fresh symbol or matrix."""


NEAR_ROTATION = sympy.Integer(49)
"""Below the squared length of `power`, which is at least 64 for a rotation."""

MARKLEY = "polar factor of Markley and Bar-Itzhack"


@dataclass(frozen=True)
class Cover:
    """The unit quaternion of an error, scalar w = cos(angle/2) and vector v (3, 1)."""

    w: sympy.Symbol
    v: Matrix

    def rate(self, let: Let, nu: Matrix) -> dict[sympy.Symbol, Expr]:
        """Rates along q' = q (0, nu) / 2 with body velocity nu (3, 1) in rad/s."""
        w, v, unit = self.w, self.v, "1/s"
        w_dot = let("w_dot", -v.dot(nu) / 2, unit, "rate of w, -v.nu_e/2")
        v_dot = let("v_dot", (w * nu + v.cross(nu)) / 2, unit, "rate of v, (w nu_e + v x nu_e)/2")
        return {w: w_dot, **dict(zip(v, v_dot, strict=True))}


def choose(*cases: tuple[Matrix, Any]) -> Matrix:
    """The first matrix whose condition holds, entry by entry; the last condition is True."""
    columns = zip(*(value for value, _ in cases), strict=True)
    conditions = [condition for _, condition in cases]
    return Matrix(
        [Piecewise(*zip(column, conditions, strict=True), evaluate=False) for column in columns]
    )


def at_least(value: Expr, least: Expr | int) -> Expr:
    """max(value, least): a bound that interval arithmetic sees, and no rotation meets."""
    return Piecewise((sympy.sympify(least), value < least), (value, True), evaluate=False)


def at_most(value: Expr, most: Expr | int) -> Expr:
    """min(value, most)."""
    return Piecewise((sympy.sympify(most), value > most), (value, True), evaluate=False)


def of_rotation(let: Let, stored: Matrix, *, is_carrier: bool = False) -> Cover:
    """Unit quaternion with w >= 0 of a 3x3 matrix near SO(3), its polar factor to O(drift^2).

    B = 4 p p^T for a rotation, p = (v, w). The column of the largest diagonal entry, multiplied
    once more by B, is p up to a factor in [4, 16]: one power step damps what is not orthonormal.
    The scalar comes last, so that sums end with their largest term at small angles.
    At angle pi the column chosen makes the largest |v_i| positive, the first index wins.
    A carrier turns translations too, for which a divided h is too rough; they are the longer the
    more its polynomials are off, so that w is kept from being above 1 by an ulp or more.
    """
    B = let("B", _quadruple(stored.reshape(3, 3)), "1", "4 p p^T, p = (v, w), by rows", MARKLEY)
    B = Matrix(4, 4, lambda i, j: B[_packed(min(i, j), max(i, j))])
    columns = [B[:, j] for j in range(4)]
    x, y, z, w = (B[j, j] for j in range(4))
    column = let(
        "column",
        choose(
            (columns[3], w >= 1),
            (columns[0], sympy.And(x >= y, x >= z)),
            (columns[1], y >= z),
            (columns[2], True),
        ),
        "1",
        "a column of B that cannot vanish",
    )
    power = let("power", B * column, "1", "the column after one power step")
    norm = _length(let, power, NEAR_ROTATION)
    signed = Piecewise((-1 / norm, power[3] < 0), (1 / norm, True), evaluate=False)
    scale = let("scale", signed, "1", "to unit length, and to w >= 0: the shorter way round")
    w = (let_cosine if is_carrier else _plain)(let, power[3] * scale)
    v = let("v", power[:3, :] * scale, "1", "sin of half the error angle times its axis")
    if is_carrier:
        polynomials(let, w)
    else:
        _half(let, w)
    return Cover(w, v)


def of_quaternion(let: Let, stored: Matrix) -> Cover:
    """Unit quaternion of stored numbers q (4, 1), scalar first, its sign kept."""
    norm = _length(let, stored, SHORT)
    scale = let("scale", 1 / norm, "1", "to unit length")
    w = _plain(let, stored[0] * scale)
    v = let("v", stored[1:, :] * scale, "1", "sin of half the error angle times its axis")
    _full(let, w, v)
    return Cover(w, v)


def let_cosine(let: Let, value: Expr) -> Expr:
    """Step of w, at most 1: beyond, polynomials grow fast."""
    cosine = let("cosine", value, "1", "cos of half the error angle, rounded")
    found: Expr = let("w", at_most(cosine, 1), "1", "cos of half the error angle")
    return found


def _plain(let: Let, value: Expr) -> Expr:
    found: Expr = let("w", value, "1", "cos of half the error angle")
    return found


def _length(let: Let, row: Matrix, least: Expr) -> Expr:
    """Step of |row|, whose square is known to be above `least`."""
    square = let("norm_square", row.dot(row), "1", "squared length")
    bounded = let("norm_bounded", at_least(square, least), "1", "the same: less is no element")
    found: Expr = let("norm", sqrt(bounded), "1", "length")
    return found


def polynomials(let: Let, w: Expr) -> None:
    """Kernel for w in [0, 1]: k and h by their polynomials."""
    let("k", K(w), "1", "half angle over its sine", stands_for=K(w))
    let("h", H(w), "1", "-dk/dw", stands_for=H(w))


def _half(let: Let, w: Expr) -> None:
    """Kernel for w in [0, 1]: k by its polynomial, h by the identity s^2 h = 1 - w k."""
    k = let("k", K(w), "1", "half angle over its sine", stands_for=K(w))
    square = let("sine_square", (1 - w) * (1 + w), "1", "1 - w^2, below zero by an ulp at most")
    _divided(let, sympy.Abs(square) + FLOOR, w, k)


def _full(let: Let, w: Expr, v: Matrix) -> None:
    """Kernel for w in (-1, 1]: below zero by k(w) = pi/s - k(-w).

    At -i there is no axis, and property (ii) of the law, nu_u(g^-1) = -nu_u(g), leaves only 0,
    which 2 k v is where k is finite.
    """
    near = let("k_near", K(sympy.Abs(w)), "1", "half angle over its sine, for |w|")
    square = let("sine_square", v.dot(v), "1", "v.v")
    bounded = let("sine_bounded", at_least(square, CUT**2), "1", "the same, away from -i and i")
    s = let("sine", sqrt(bounded), "1", "|v|", stands_for=sqrt(v.dot(v)))
    value = Piecewise((near, w >= 0), (pi / s - near, True), evaluate=False)
    k = let("k", value, "1", "half angle over its sine, on to 2 pi", stands_for=K(w))
    _divided(let, bounded, w, k)


def _divided(let: Let, square: Expr, w: Expr, k: Expr) -> None:
    """h from s^2: where s is small the quotient is rough, and so little that none sees it."""
    quotient = (1 - w * k) / square
    let("h", quotient, "1", "-dk/dw, as (1 - w k)/s^2", stands_for=H(w))


def _quadruple(R: Matrix) -> Matrix:
    """Upper triangle, by rows, of 4 p p^T from a rotation R (3, 3), p = (v, w)."""
    x, y, z = R[0, 0], R[1, 1], R[2, 2]
    return Matrix(
        [
            1 + (x - y - z), R[0, 1] + R[1, 0], R[0, 2] + R[2, 0], R[2, 1] - R[1, 2],
            1 + (y - x - z), R[1, 2] + R[2, 1], R[0, 2] - R[2, 0],
            1 + (z - x - y), R[1, 0] - R[0, 1],
            1 + (x + y + z),
        ]
    )  # fmt: skip


def _packed(i: int, j: int) -> int:
    return i * (9 - i) // 2 + j - i if i else j
