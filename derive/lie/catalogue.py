"""The groups that come with the product: one record each, nothing else to write."""

from __future__ import annotations

from sympy import ImmutableMatrix, Matrix, eye

from derive.lie import cover
from derive.lie.group import Group


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


def _orthonormal(stored: Matrix) -> Matrix:
    """R^T R - I, upper triangle, and det R - 1: seven numbers that vanish on SO(3) alone."""
    R = stored.reshape(3, 3)
    gram = R.T * R - eye(3)
    return Matrix([*(gram[i, j] for i in range(3) for j in range(i, 3)), R.det() - 1])


SO3 = Group(
    name="SO3",
    basis=(_turn(3, 1, 2), _turn(3, 2, 0), _turn(3, 0, 1)),
    units=("rad/s",) * 3,
    identity=tuple(eye(3)),
    embed=lambda stored: stored.reshape(3, 3),
    store=lambda rotation: Matrix(9, 1, list(rotation)),
    inverse=lambda rotation: rotation.T,
    residual=_orthonormal,
    cover=cover.of_rotation,
    short_Ad=lambda rotation: rotation,
    storage="rotation matrix, row by row",
    shape=(3, 3),
    is_rotation=True,
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
    cover=cover.of_quaternion,
    short_Ad=_rotation_of,
    storage="unit quaternion, Hamilton, scalar first",
    shape=(4,),
    is_rotation=True,
)

GROUPS: dict[str, Group] = {group.name: group for group in (SO3, S3)}
"""Every group by the name a vehicle file uses."""
