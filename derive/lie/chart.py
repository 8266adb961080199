"""Logarithmic coordinates of an error, as steps: rotations, and translations carried by them.

With (w, v) the unit quaternion of the rotation and k, h of the kernel, the logarithm of a pose
with translation p is (2 k v, p - k v x p + h v x (v x p)) in space, and in the plane, where
v = s along the one axis, (2 k s, k (w p - s J p)). Nothing cancels and nothing divides.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy
from sympy import Expr, Matrix, Piecewise, sqrt

from derive.lie.cover import Cover, Let, choose, of_quaternion, of_rotation
from derive.lie.kernel import TINY, H, K, M

Rates = Callable[[Let, Matrix], dict[sympy.Symbol, Expr]]


@dataclass(frozen=True)
class Chart:
    """log(g), (n, 1), with what its exact rate and its guard need.

    rates:     (let, nu) -> rates of the symbols that log is made of, along g' = g hat(nu)
    clearance: cosine of half the rotation angle: zero where the logarithm jumps; 1 elsewhere
    """

    log: Matrix
    rates: Rates
    clearance: Expr


def of_rotation_matrix(let: Let, stored: Matrix) -> Chart:
    """SO3: the rotation vector."""
    return _of_cover(let, of_rotation(let, stored), None)


def of_unit_quaternion(let: Let, stored: Matrix) -> Chart:
    """S3: the rotation vector up to 2 pi; its clearance is the sine beyond pi."""
    cover = of_quaternion(let, stored)
    far = sqrt(cover.v.dot(cover.v))
    value = Piecewise((far, cover.w < 0), (sympy.S.One, True), evaluate=False)
    return _of_cover(let, cover, let("minus_i", value, "1", "distance from -i"))


def of_vector(let: Let, stored: Matrix) -> Chart:
    """R^n: an element is its own logarithm."""
    return Chart(stored, lambda _, nu: dict(zip(stored, nu, strict=True)), sympy.S.One)


def of_plane(let: Let, g: Matrix) -> Chart:
    """SO2 and SE2: a rotation (2, 2), with a column of translation where g is (3, 3)."""
    w, s = _half_turn(let, g[0, 0] + g[1, 1], g[1, 0] - g[0, 1])
    k = let("k", K(w), "1", "half angle over its sine", stands_for=K(w))
    let("h", H(w), "1", "-dk/dw", stands_for=H(w))
    phi = let("phi", 2 * k * s, "rad", "error angle")
    moves = [g[:2, 2]] if g.rows == 3 else []
    turned = [let("half_way", w * p - s * _quarter(p), "m", "w p - s J p") for p in moves]

    def rates(let: Let, nu: Matrix) -> dict[sympy.Symbol, Expr]:
        w_dot = let("w_dot", -s * nu[0] / 2, "1/s", "rate of w")
        s_dot = let("sine_dot", w * nu[0] / 2, "1/s", "rate of the sine")
        known = {phi: nu[0], w: w_dot, s: s_dot}
        for i, p in enumerate(moves):
            known |= _carried(let, i, g[:2, :2], p, nu[1:, :])
        return known

    return Chart(Matrix([phi, *(k * x for part in turned for x in part)]), rates, w)


def of_space(let: Let, g: Matrix) -> Chart:
    """SE3 and SE23: a rotation (3, 3) and one or more columns of translation."""
    rotation = g[:3, :3]
    cover = of_rotation(let, Matrix(9, 1, list(rotation)), _polynomials)
    v, k, h = cover.v, cover.k, cover.h
    phi = let("phi", 2 * k * v, "rad", "rotation vector of the error")
    moves = [g[:3, i] for i in range(3, g.cols)]
    logs = [phi]
    for i, p in enumerate(moves):
        swing = let(f"swing_{i}", v.cross(p), "m", "v x p")
        sway = let(f"sway_{i}", v.cross(swing), "m", "v x (v x p)")
        logs.append(p - k * swing + h * sway)

    def rates(let: Let, nu: Matrix) -> dict[sympy.Symbol, Expr]:
        turning = cover.turning(let, nu[:3, :])
        known = cover.rate(let, nu[:3, :]) | dict(zip(phi, turning, strict=True))
        for i, p in enumerate(moves):
            known |= _carried(let, i, rotation, p, nu[3 + 3 * i : 6 + 3 * i, :])
        return known

    return Chart(Matrix([x for part in logs for x in part]), rates, cover.w)


def of_product(first: Callable[[Let, Matrix], Chart], second: Callable[[Let, Matrix], Chart],
               split: int, dim: int) -> Callable[[Let, Matrix], Chart]:  # fmt: skip
    """The chart of a direct product: stored numbers and coordinates concatenated."""

    def chart(let: Let, stored: Matrix) -> Chart:
        a = first(marked(let, "a"), stored[:split, :])
        b = second(marked(let, "b"), stored[split:, :])

        def rates(let: Let, nu: Matrix) -> dict[sympy.Symbol, Expr]:
            return {
                **a.rates(marked(let, "a"), nu[:dim, :]),
                **b.rates(marked(let, "b"), nu[dim:, :]),
            }

        return Chart(Matrix([*a.log, *b.log]), rates, _nearer(let, a.clearance, b.clearance))

    return chart


def _of_cover(let: Let, cover: Cover, clearance: Expr | None) -> Chart:
    phi = let("phi", 2 * cover.k * cover.v, "rad", "rotation vector of the error")

    def rates(let: Let, nu: Matrix) -> dict[sympy.Symbol, Expr]:
        return dict(zip(phi, cover.turning(let, nu), strict=True))

    return Chart(phi, rates, cover.w if clearance is None else clearance)


def _carried(let: Let, i: int, rotation: Matrix, p: Matrix, nu: Matrix) -> dict[Expr, Expr]:
    """Rate of a translation, p' = R nu."""
    p_dot = let(f"p_dot_{i}", rotation * nu, "m/s", "rate of the translation, R nu_e")
    return dict(zip(p, p_dot, strict=True))


def _half_turn(let: Let, c: Expr, s: Expr) -> tuple[Expr, Expr]:
    """cos >= 0 and sin of half the angle, from 2 cos and 2 sin of it, up to a common factor.

    2 n p p^T = [[n + c, s], [s, n - c]] with n = |(c, s)|: a column that cannot vanish.
    """
    c, s = let("twice", Matrix([c, s]), "1", "2 cos and 2 sin of the angle")
    n = let("norm", sqrt(c * c + s * s + TINY), "1", "their length")
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
    scale = let("scale", 1 / sqrt(column.dot(column) + TINY), "1", "to unit length")
    w = let("w", column[0] * scale, "1", "cos of half the error angle")
    return w, let("sine", column[1] * scale, "1", "sin of half the error angle")


def _polynomials(let: Let, w: Expr) -> tuple[Expr, Expr]:
    """k, h and m by their polynomials: a divided h would lose its digits in the rate of rho."""
    k = let("k", K(w), "1", "half angle over its sine", stands_for=K(w))
    h = let("h", H(w), "1", "-dk/dw", stands_for=H(w))
    let("m", M(w), "1", "-dh/dw", stands_for=M(w))
    return k, h


def _quarter(p: Matrix) -> Matrix:
    """J p: p turned by a right angle."""
    return Matrix([-p[1], p[0]])


def marked(let: Let, letter: str) -> Let:
    """The same let, its names marked as those of one factor."""
    return lambda name, *rest, **more: let(f"{name}_{letter}", *rest, **more)


def _nearer(let: Let, a: Expr, b: Expr) -> Expr:
    """The smaller clearance of two."""
    if sympy.S.One in (a, b):
        return b if a == sympy.S.One else a
    value = Piecewise((a, a <= b), (b, True), evaluate=False)
    return let("distance", value, "1", "the smaller clearance")
