"""From stored numbers to the unit quaternion (w, v), without threshold and without 0/0.

Both routes end in named steps. `let` is handed in by whoever writes the derivation, so this
layer knows the formulas and not what a derivation is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import sympy
from sympy import Expr, Matrix, Piecewise, pi, sqrt

from derive.lie.kernel import CUT, FLOOR, LEAST, H, K

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


@dataclass(frozen=True)
class Scaled(Cover):
    """The same, and its vector part before it is brought to unit length.

    raw:      v/scale, (3, 1): a law made of raw and scale needs no v
    scale:    1 over the length of the quaternion that raw belongs to
    distance: where w and -w are two elements |v| for w < 0, else 1
    """

    raw: Matrix
    scale: Expr
    distance: Expr = sympy.S.One


def choose(*cases: tuple[Matrix, Any]) -> Matrix:
    """The first matrix whose condition holds, entry by entry; the last condition is True."""
    columns = zip(*(value for value, _ in cases), strict=True)
    conditions = [condition for _, condition in cases]
    return Matrix(
        [Piecewise(*zip(column, conditions, strict=True), evaluate=False) for column in columns]
    )


def at_least(value: Expr, least: Expr | int) -> Expr:
    """max(value, least): a bound that interval arithmetic sees, and no rotation meets."""
    return Piecewise((sympy.sympify(least), value <= least), (value, True), evaluate=False)


def at_most(value: Expr, most: Expr | int) -> Expr:
    """min(value, most)."""
    return Piecewise((sympy.sympify(most), value >= most), (value, True), evaluate=False)


def let_cosine(let: Let, value: Expr) -> Expr:
    """Step of w, at most 1: beyond, polynomials grow fast."""
    cosine = let("cosine", value, "1", "cos of half the error angle, rounded")
    found: Expr = let("w", at_most(cosine, 1), "1", "cos of half the error angle")
    return found


def of_rotation(let: Let, stored: Matrix, *, is_carrier: bool = False) -> Scaled:
    """Unit quaternion with w >= 0 of a 3x3 matrix near SO(3), its polar factor to O(drift^2).

    B = 4 p p^T for a rotation, p = (v, w). The column of the largest diagonal entry, multiplied
    once more by B, is p up to a factor in [4, 16]: one power step damps what is not orthonormal.
    The scalar comes last, so that sums end with their largest term at small angles.
    At angle pi the column chosen makes the largest |v_i| positive, the first index wins.
    A carrier turns translations too, for which a divided h is too rough; they are the longer the
    more its polynomials are off, so that w is kept from being above 1 by an ulp or more.
    """
    entries = _quadruple(let, stored.reshape(3, 3))
    B = let("B", entries, "1", "4 p p^T, p = (v, w), by rows", MARKLEY)
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
    square = _square(let, power[:3, :])
    norm = _length(let, square + power[3] ** 2, NEAR_ROTATION)
    inverse = let("inverse_norm", 1 / norm, "1", "to unit length")
    signed = Piecewise((-inverse, power[3] < 0), (inverse, True), evaluate=False)
    scale = let("scale", signed, "1", "to unit length, and to w >= 0: the shorter way round")
    error = _scaled(let, power[3], power[:3, :], scale, let_cosine if is_carrier else _cosine)
    if is_carrier:
        polynomials(let, error.w)
    else:
        k = let("k", K(error.w), "1", "half angle over its sine", stands_for=K(error.w))
        _divided(let, square + FLOOR, error, k)
    return error


def of_quaternion(let: Let, stored: Matrix) -> Scaled:
    """Unit quaternion of stored numbers q (4, 1), scalar first, its sign kept.

    Its kernel goes on below w = 0 by k(w) = pi/s - k(-w), up to -i, where there is no axis, and
    property (ii) of the law, nu_u(g^-1) = -nu_u(g), leaves only 0.
    """
    square = _square(let, stored[1:, :])
    norm = _length(let, square + stored[0] ** 2, LEAST)
    scale = let("scale", 1 / norm, "1", "to unit length")
    error = _scaled(let, stored[0], stored[1:, :], scale, _cosine)
    w = error.w
    near = let("k_near", K(sympy.Abs(w)), "1", "half angle over its sine, for |w|")
    cases = (square + FLOOR, w >= 0), (square, square > CUT**2), (CUT**2, True)
    divisor = let("divisor", Piecewise(*cases, evaluate=False), "1", "the same, never zero")
    far = Piecewise((sympy.S.One, w >= 0), (sqrt(divisor) * scale, True), evaluate=False)
    distance = let("distance", far, "1", "distance from -i: |v| beyond pi, and 1 before")
    value = Piecewise((near, w >= 0), (pi / distance - near, True), evaluate=False)
    k = let("k", value, "1", "half angle over its sine, on to 2 pi", stands_for=K(w))
    _divided(let, divisor, error, k)
    return replace(error, distance=distance)


def _square(let: Let, raw: Matrix) -> Expr:
    found: Expr = let("square", raw.dot(raw), "1", "square of its vector part")
    return found


def _length(let: Let, square: Expr, least: Expr) -> Expr:
    """Step of a length whose square is known to be above `least`."""
    square = let("norm_square", square, "1", "its squared length")
    bounded = let("norm_bounded", at_least(square, least), "1", "the same: less is no element")
    found: Expr = let("norm", sqrt(bounded), "1", "its length")
    return found


def _cosine(let: Let, value: Expr) -> Expr:
    found: Expr = let("w", value, "1", "cos of half the error angle")
    return found


def _scaled(
    let: Let, scalar: Expr, raw: Matrix, scale: Expr, cosine: Callable[[Let, Expr], Expr]
) -> Scaled:
    w = cosine(let, scalar * scale)
    v = let("v", raw * scale, "1", "sin of half the error angle times its axis")
    return Scaled(w, v, raw, scale)


def polynomials(let: Let, w: Expr) -> None:
    """Kernel for w in [0, 1]: k and h by their polynomials."""
    let("k", K(w), "1", "half angle over its sine", stands_for=K(w))
    let("h", H(w), "1", "-dk/dw", stands_for=H(w))


def _divided(let: Let, square: Expr, error: Scaled, k: Expr) -> None:
    """h scale^2 from s^2 = square scale^2: rough where s is small, and so little that none sees it.

    Whoever needs h alone gets it from there.
    """
    w, scale = error.w, error.scale
    doc, value = "-dk/dw times scale^2, as s^2 h = 1 - w k", (1 - w * k) / square
    h = let("h_raw", value, "1", doc, stands_for=H(w) * scale**2)
    let("h", h / scale**2, "1", "-dk/dw", stands_for=H(w))


def _quadruple(let: Let, R: Matrix) -> Matrix:
    """Upper triangle, by rows, of 4 p p^T from a rotation R (3, 3), p = (v, w)."""
    x, y, z = R[0, 0], R[1, 1], R[2, 2]
    pairs = Matrix([1 + x, 1 - x, y + z, y - z])
    more, less, both, apart = let("pairs", pairs, "1", "what B's diagonal is made of")
    return Matrix(
        [
            more - both, R[0, 1] + R[1, 0], R[0, 2] + R[2, 0], R[2, 1] - R[1, 2],
            less + apart, R[1, 2] + R[2, 1], R[0, 2] - R[2, 0],
            less - apart, R[1, 0] - R[0, 1],
            more + both,
        ]
    )  # fmt: skip


def _packed(i: int, j: int) -> int:
    return i * (9 - i) // 2 + j - i if i else j
