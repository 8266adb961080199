"""What the listed groups mean in space: axes, senses, units and storage."""

from math import prod
from random import Random

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.linalg import expm
from scipy.spatial.transform import Rotation
from sympy import Matrix, eye

from derive.lie.catalogue import GROUPS, left_product
from derive.lie.group import Group
from tests.points import hamilton, vector

ROTATIONS = {name: group for name, group in GROUPS.items() if group.is_rotation}
each_rotation = pytest.mark.parametrize("group", ROTATIONS.values(), ids=ROTATIONS)

TURNED = {
    "SO3": lambda x: Rotation.from_rotvec(x).as_matrix().ravel(),
    "S3": lambda x: Rotation.from_rotvec(x).as_quat(scalar_first=True),
}
"""Group name -> stored numbers of the rotation by the vector x, short of pi, from scipy."""


@pytest.mark.parametrize("name", GROUPS)
def test_a_group_is_listed_by_its_name_and_fits_together(name: str) -> None:
    group = GROUPS[name]
    assert group.name == name
    assert len(group.units) == group.dim
    assert len(group.identity) == prod(group.shape)
    assert group.embed(Matrix(group.identity)).shape == group.basis[0].shape
    assert group.storage


@each_rotation
@pytest.mark.parametrize("seed", range(4))
def test_velocities_are_angular_rates_in_rad_per_second(group: Group, seed: int) -> None:
    """One second at the body rate x is the rotation by the vector x."""
    x = np.array(vector(Random(seed)), float) / 2
    flow = expm(np.array(group.hat(Matrix(x)).tolist(), float))
    stored = np.array(group.store(Matrix(flow)), float).ravel()
    assert_allclose(stored, TURNED[group.name](x), atol=1e-14)
    assert group.units == ("rad/s",) * 3


@each_rotation
def test_the_bracket_is_the_cross_product(group: Group) -> None:
    rng = Random(1)
    for _ in range(4):
        x, y = np.array(vector(rng)), np.array(vector(rng))
        found = group.bracket(Matrix(x), Matrix(y))
        assert list(found) == list(Matrix(np.cross(x, y).tolist()))


@each_rotation
def test_Ad_turns_body_vectors_into_space(group: Group) -> None:
    """A quarter turn about the third axis takes the first into the second."""
    stored = TURNED[group.name](np.array([0, 0, np.pi / 2]))
    Ad = np.array(group.Ad(group.embed(Matrix(stored))), float)
    assert_allclose(Ad, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-15)


def test_the_left_product_is_hamiltons() -> None:
    rng = Random(2)
    p, q = vector(rng, 4), vector(rng, 4)
    assert list(left_product(Matrix(p)) * Matrix(q)) == list(Matrix(list(hamilton(p, q))))
    i, j, k = (left_product(eye(4)[:, axis]) for axis in (1, 2, 3))
    assert i * j == k
