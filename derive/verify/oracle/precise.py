"""Numbers with 130 digits, and group elements made of stored numbers with them.

Every Python float is taken as its exact binary value. The context is this module's own, so the
caller's precision is neither used nor changed; mpf leaving here compute in it.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import mpmath

Number = Any  # an mpf: mpmath has no stubs
Vector = tuple[Number, ...]  # (3,)
Quaternion = tuple[Number, ...]  # (4,), scalar first
Matrix = tuple[Vector, ...]  # (3, 3)

DIGITS = 130
mp: Any = mpmath.mp.clone()  # a context, not the global one
mp.dps = DIGITS
# Below this two numbers are one: twice the digits are reached by a further Newton step.
SAME = mp.mpf(10) ** -70


def exactly(value: Any) -> Number:
    """The stored number itself: a rational is divided here, a float loses nothing."""
    if isinstance(value, Fraction):
        return mp.mpf(value.numerator) / value.denominator
    whole = isinstance(value, int) or hasattr(value, "_mpf_")  # an mpf of whichever context
    return mp.mpf(value if whole else float(value))


def vector(values: Sequence[Any]) -> Vector:
    """Stored numbers, as they are."""
    return tuple(map(exactly, values))


def dot(a: Sequence[Number], b: Sequence[Number]) -> Number:
    """Inner product."""
    return mp.fdot(zip(a, b, strict=True))


def cross(a: Vector, b: Vector) -> Vector:
    """a x b = a^ b, the Lie bracket of so(3)."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def blend(*terms: tuple[Any, Vector]) -> Vector:
    """Sum of factor times vector."""
    factors = [factor for factor, _ in terms]
    return tuple(dot(factors, row) for row in zip(*(v for _, v in terms), strict=True))


def norm(a: Vector) -> Number:
    """Euclidean length."""
    return mp.sqrt(dot(a, a))


def times(matrix: Matrix, x: Vector) -> Vector:
    """Matrix times vector."""
    return tuple(dot(row, x) for row in matrix)


def inverse_transposed(x: Matrix) -> Matrix:
    """X^-T, the cofactors over the determinant; raises ValueError unless det X > 0."""
    cofactors = tuple(cross(x[(i + 1) % 3], x[(i + 2) % 3]) for i in range(3))
    determinant = dot(x[0], cofactors[0])
    if not determinant > 0:
        raise ValueError(f"no rotation is nearest: the determinant is {mp.nstr(determinant, 6)}")
    return tuple(tuple(entry / determinant for entry in row) for row in cofactors)


def rotation_nearest(x: Matrix) -> Matrix:
    """Orthogonal polar factor of x, (3, 3), by Newton's X <- (X + X^-T)/2.

    Raises ValueError when x is singular, a reflection or not finite.
    """
    half = mp.mpf(0.5)
    for _ in range(200):
        y = inverse_transposed(x)
        new = tuple(blend((half, a), (half, b)) for a, b in zip(x, y, strict=True))
        moved = max(
            abs(a - b) for p, r in zip(x, new, strict=True) for a, b in zip(p, r, strict=True)
        )
        x = new
        if moved < SAME:
            return x
    raise ValueError("the polar projection does not converge")


def project(stored: Sequence[Any]) -> Matrix:
    """Rotation nearest to a stored row-major matrix, 9 numbers to (3, 3)."""
    numbers = vector(stored)
    return rotation_nearest((numbers[0:3], numbers[3:6], numbers[6:9]))


def quaternion(rotation: Matrix) -> Quaternion:
    """Unit quaternion (w, v) of a rotation, w >= 0, from its largest component.

    Where w is exactly 0 the largest |component| of v is positive and the first index wins.
    """
    (a, b, c), (d, e, f), (g, h, i) = rotation
    outer = (  # 4 q q^T
        (1 + a + e + i, h - f, c - g, d - b),
        (h - f, 1 + a - e - i, b + d, c + g),
        (c - g, b + d, 1 + e - a - i, f + h),
        (d - b, c + g, f + h, 1 + i - a - e),
    )
    diagonal = [outer[k][k] for k in range(4)]
    # Components equal but for rounding are tied, and the first index wins.
    largest = next(k for k in range(4) if diagonal[k] > max(diagonal) - SAME)
    q = tuple(x / (2 * mp.sqrt(diagonal[largest])) for x in outer[largest])
    return negative(q) if q[0] < 0 else q


def negative(q: Vector) -> Vector:
    """-q: the same rotation, another point of S3."""
    return tuple(-x for x in q)


def normalise(stored: Sequence[Any]) -> Quaternion:
    """Unit quaternion along four stored numbers, scalar first, its sign kept."""
    q = vector(stored)
    length = norm(q)
    if not 0 < length < mp.inf:
        raise ValueError("no unit quaternion is nearest")
    return tuple(x / length for x in q)


def product(p: Quaternion, q: Quaternion) -> Quaternion:
    """Hamilton product, scalar first: p (x) q = Q(p) q."""
    w = p[0] * q[0] - dot(p[1:], q[1:])
    return (w, *blend((p[0], q[1:]), (q[0], p[1:]), (1, cross(p[1:], q[1:]))))


def _error_rotation(g_r: Sequence[Any], g: Sequence[Any]) -> Quaternion:
    a, b = vector(g_r), vector(g)
    relative = tuple(tuple(dot(a[i::3], b[j::3]) for j in range(3)) for i in range(3))
    return quaternion(rotation_nearest(relative))


def _error_quaternion(g_r: Sequence[Any], g: Sequence[Any]) -> Quaternion:
    w, *v = vector(g_r)
    return normalise(product((w, *negative(tuple(v))), vector(g)))


ERRORS = {"SO3": _error_rotation, "S3": _error_quaternion}


def error(group: str, g_r: Sequence[Any], g: Sequence[Any]) -> Quaternion:
    """Unit quaternion of g_e = g_r^-1 g, the product taken before it is put on the group."""
    return ERRORS[group](g_r, g)
