"""The groups that come with the product: one record each, nothing else to write."""

from __future__ import annotations

import re
from functools import cache

from sympy import ImmutableMatrix, Matrix, eye

from derive.lie import chart, cover
from derive.lie.affine import semidirect
from derive.lie.cover import Let
from derive.lie.family import product, vector_space
from derive.lie.group import Group, Pull


def _turn(size: int, i: int, j: int) -> ImmutableMatrix:
    """Generator of the rotation in the (i, j) plane, from axis i towards axis j."""
    return ImmutableMatrix(size, size, lambda r, c: ((r, c) == (j, i)) - ((r, c) == (i, j)))


def left_product(q: Matrix) -> Matrix:
    """Quaternion q (4, 1) as the matrix (4, 4) of the product p -> q p; Hamilton's convention."""
    w, x, y, z = q
    return Matrix([[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]])


def _rotation_of(g: Matrix) -> Matrix:
    """Rotation matrix (3, 3) of a unit quaternion given as its left product (4, 4)."""
    w, x, y, z = g[:, 0]
    return Matrix(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _pull_of_quaternion(let: Let, q: Matrix) -> Pull:
    """R^T of a unit quaternion's rotation R, its products shared."""
    w, v = q[0], q[1:, :]
    x, y, z = v
    x2, y2, z2 = let("double", 2 * v, "1", "twice the vector part")
    rows = Matrix(
        [
            1 - (y2 * y + z2 * z), x2 * y + z2 * w, x2 * z - y2 * w,
            x2 * y - z2 * w, 1 - (x2 * x + z2 * z), y2 * z + x2 * w,
            x2 * z + y2 * w, y2 * z - x2 * w, 1 - (x2 * x + y2 * y),
        ]
    )  # fmt: skip
    R_T = let("to_body", rows, "1", "Ad of g_e^-1: reference to body frame").reshape(3, 3)
    return lambda _, x: R_T * x


def _orthonormal(stored: Matrix) -> Matrix:
    """Numbers that vanish on rotations alone.

    All columns but the last are units at right angles, and the last is the one that they leave:
    that settles the sign of det R, too.
    """
    if len(stored) == 4:
        a, c, b, d = stored
        return Matrix([a * a + b * b - 1, c + b, d - a])
    R = stored.reshape(3, 3)
    a, b, c = (R[:, i] for i in range(3))
    return Matrix([a.dot(a) - 1, a.dot(b), b.dot(b) - 1, *(c - a.cross(b))])


SO3 = Group(
    name="SO3",
    basis=(_turn(3, 1, 2), _turn(3, 2, 0), _turn(3, 0, 1)),
    units=("rad/s",) * 3,
    identity=tuple(eye(3)),
    embed=lambda stored: stored.reshape(3, 3),
    store=lambda rotation: Matrix(9, 1, list(rotation)),
    inverse=lambda rotation: rotation.T,
    residual=_orthonormal,
    storage="rotation matrix, row by row",
    shape=(3, 3),
    cover=cover.of_rotation,
    chart=chart.of_space,
    is_rotation=True,
    attitude=lambda q: Matrix(9, 1, list(_rotation_of(left_product(q)))),
    short_Ad=lambda rotation: rotation,
)

S3 = Group(
    name="S3",
    basis=tuple(ImmutableMatrix(left_product(eye(4)[:, i]) / 2) for i in (1, 2, 3)),
    units=("rad/s",) * 3,
    identity=(1, 0, 0, 0),
    embed=left_product,
    store=lambda quaternion: quaternion[:, 0],
    inverse=lambda quaternion: quaternion.T,
    residual=lambda stored: Matrix([stored.dot(stored) - 1]),
    storage="unit quaternion, Hamilton, scalar first",
    shape=(4,),
    cover=cover.of_quaternion,
    chart=chart.of_sphere,
    is_rotation=True,
    attitude=lambda q: q,
    short_Ad=_rotation_of,
    short_pull=_pull_of_quaternion,
)

SO2 = Group(
    name="SO2",
    basis=(_turn(2, 0, 1),),
    units=("rad/s",),
    identity=tuple(eye(2)),
    embed=lambda stored: stored.reshape(2, 2),
    store=lambda rotation: Matrix(4, 1, list(rotation)),
    inverse=lambda rotation: rotation.T,
    residual=_orthonormal,
    storage="rotation matrix, row by row",
    shape=(2, 2),
    chart=chart.of_plane,
    short_Ad=lambda rotation: eye(1),
    short_pull=lambda let, g: lambda name, x: x,
)

SE2 = semidirect(SO2, "SE2", ("m/s",), chart.of_plane)
SE3 = semidirect(SO3, "SE3", ("m/s",), chart.of_space)
SE23 = semidirect(SO3, "SE23", ("m/s^2", "m/s"), chart.of_space)
"""Extended poses: the columns are velocity and position."""

LARGEST = 24
"""Largest dimension of a group, of R^n and of a product."""

GROUPS: dict[str, Group] = {
    group.name: group for group in (SO2, SO3, S3, SE2, SE3, SE23, vector_space(3))
}
"""Groups by the name a vehicle file uses; besides, R1 to R24 and products: `SO3 x R3`."""


@cache
def named(name: str) -> Group:
    """A group of the catalogue, R^n, or a product of them; KeyError for an unknown factor."""
    factors = [_one(factor.strip()) for factor in name.split(" x ")]
    return factors[0] if len(factors) == 1 else product(*factors)


def _one(name: str) -> Group:
    vectors = re.fullmatch(r"[RT]([1-9]\d?)", name)
    if vectors and int(vectors[1]) <= LARGEST:
        return vector_space(int(vectors[1]))
    return GROUPS[name]
