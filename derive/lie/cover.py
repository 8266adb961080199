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

from derive.lie.kernel import SMALL, TINY, H, K

Let = Callable[..., Any]
"""let(name, value, unit, doc, source="", stands_for=None) -> the fresh symbol or matrix."""


MARKLEY = "polar factor of Markley and Bar-Itzhack"


@dataclass(frozen=True)
class Cover:
    """The unit quaternion of an error, scalar w = cos(angle/2) and vector v (3, 1).

    k, h: the kernel functions of w, as steps
    """

    w: sympy.Symbol
    v: Matrix
    k: Expr
    h: Expr

    def rate(self, let: Let, nu: Matrix) -> dict[sympy.Symbol, sympy.Expr]:
        """Rates along q' = q (0, nu) / 2 with body velocity nu (3, 1) in rad/s."""
        w, v, unit = self.w, self.v, "1/s"
        w_dot = let("w_dot", -v.dot(nu) / 2, unit, "rate of w, -v.nu_e/2")
        v_dot = let("v_dot", (w * nu + v.cross(nu)) / 2, unit, "rate of v, (w nu_e + v x nu_e)/2")
        return {w: w_dot, **dict(zip(v, v_dot, strict=True))}


    def turning(self, let: Let, nu: Matrix) -> Matrix:
        """Rate of the rotation vector 2 k v, nu + k v x nu + h v x (v x nu), (3, 1)."""
        turn = let("turn", self.v.cross(nu), "rad/s", "v x nu_e")
        bend = let("bend", self.v.cross(turn), "rad/s", "v x (v x nu_e)")
        return nu + self.k * turn + self.h * bend


def choose(*cases: tuple[Matrix, Any]) -> Matrix:
    """The first matrix whose condition holds, entry by entry; the last condition is True."""
    columns = zip(*(value for value, _ in cases), strict=True)
    conditions = [condition for _, condition in cases]
    return Matrix(
        [Piecewise(*zip(column, conditions, strict=True), evaluate=False) for column in columns]
    )


def of_rotation(
    let: Let, stored: Matrix, kernel: Callable[[Let, Expr], tuple[Expr, Expr]] | None = None
) -> Cover:
    """Unit quaternion with w >= 0 of a 3x3 matrix near SO(3), its polar factor to O(drift^2).

    B = 4 p p^T for a rotation, p = (v, w). The column of the largest diagonal entry, multiplied
    once more by B, is p up to a factor in [4, 16]: one power step damps what is not orthonormal.
    The scalar comes last, so that sums end with their largest term at small angles.
    kernel writes the kernel functions of w; left out, k by polynomial and h divided.
    At angle pi the column chosen makes the largest |v_i| positive, the first index wins.
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
    norm = let("norm", sqrt(power.dot(power) + TINY), "1", "its length")
    signed = Piecewise((-1 / norm, power[3] < 0), (1 / norm, True), evaluate=False)
    scale = let("scale", signed, "1", "to unit length, and to w >= 0: the shorter way round")
    w = let("w", power[3] * scale, "1", "cos of half the error angle")
    v = let("v", power[:3, :] * scale, "1", "sin of half the error angle times its axis")
    return Cover(w, v, *(kernel or _half)(let, w))


def of_quaternion(let: Let, stored: Matrix) -> Cover:
    """Unit quaternion of stored numbers q (4, 1), scalar first, its sign kept."""
    norm = let("norm", sqrt(stored.dot(stored) + TINY), "1", "length of the quaternion")
    scale = let("scale", 1 / norm, "1", "to unit length")
    w = let("w", stored[0] * scale, "1", "cos of half the error angle")
    v = let("v", stored[1:, :] * scale, "1", "sin of half the error angle times its axis")
    return Cover(w, v, *_full(let, w, v))


def _half(let: Let, w: Expr) -> tuple[Expr, Expr]:
    """Kernel for w in [0, 1]: k by its polynomial, h by the identity s^2 h = 1 - w k."""
    k = let("k", K(w), "1", "half angle over its sine", stands_for=K(w))
    return k, _divided(let, (1 - w) * (1 + w), w, k)


def _full(let: Let, w: Expr, v: Matrix) -> tuple[Expr, Expr]:
    """Kernel for w in (-1, 1]: below zero by k(w) = pi/s - k(-w).

    At -i there is no axis, and property (ii) of the law, nu_u(g^-1) = -nu_u(g), leaves only 0.
    """
    near = let("k_near", K(sympy.Abs(w)), "1", "half angle over its sine, for |w|")
    s = let("sine", sqrt(v.dot(v)), "1", "|v|")
    far = pi / (s + TINY) - near
    value = Piecewise((near, w >= 0), (far, s > SMALL), (sympy.S.Zero, True), evaluate=False)
    k = let("k", value, "1", "half angle over its sine, on to 2 pi", stands_for=K(w))
    return k, _divided(let, v.dot(v), w, k)


def _divided(let: Let, square: Expr, w: Expr, k: Expr) -> Expr:
    """h from s^2: where s is small the quotient is rough, and so little that none sees it."""
    quotient = (1 - w * k) / (square + TINY)
    h: Expr = let("h", quotient, "1", "-dk/dw, as (1 - w k)/s^2", stands_for=H(w))
    return h


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
