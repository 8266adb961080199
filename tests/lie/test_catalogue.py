"""What the listed groups mean in space: axes, senses, units and storage."""

from math import prod
from random import Random

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.linalg import expm
from scipy.spatial.transform import Rotation
from sympy import Matrix, eye

from derive.lie.catalogue import GROUPS, left_product, named
from derive.lie.group import Group
from derive.routine.derivation import Derivation, Quantity
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


FRAMES = {"SE2": (2, 1), "SE3": (3, 1), "SE23": (3, 2)}
"""Axes and columns of the groups that translate."""


@pytest.mark.parametrize("name", FRAMES)
def test_rotation_comes_before_translation_column_by_column(name: str) -> None:
    """One second at unit speed along axis i shifts column j by one along i, and nothing else."""
    group, (axes, columns) = GROUPS[name], FRAMES[name]
    turns = group.dim - axes * columns
    assert group.units[:turns] == ("rad/s",) * turns
    for j in range(columns):
        for i in range(axes):
            x = np.zeros(group.dim, int)
            x[turns + axes * j + i] = 1
            g = expm(np.array(group.hat(Matrix(x.tolist())).tolist(), float))
            wanted = np.eye(axes + columns)
            wanted[i, axes + j] = 1
            assert_allclose(g, wanted, atol=1e-15)


@pytest.mark.parametrize("name", ["SO2", "SE2"])
def test_a_positive_rate_in_the_plane_turns_the_first_axis_to_the_second(name: str) -> None:
    x = [np.pi / 2] + [0] * (GROUPS[name].dim - 1)
    g = expm(np.array(GROUPS[name].hat(Matrix(x)).tolist(), float))
    assert_allclose(g[:2, :2], [[0, -1], [1, 0]], atol=1e-15)


def test_products_and_vector_spaces_are_found_by_name() -> None:
    both = named("SE3 x SO3")
    assert (both.name, both.dim, both.size, both.shape) == ("SE3 x SO3", 9, 25, (25,))
    assert both.units == (*GROUPS["SE3"].units, *GROUPS["SO3"].units)
    assert named("R24").dim == 24
    assert named("T3").name == named("R3").name == GROUPS["R3"].name
    for unknown in ("R0", "R25", "SO5", "SE3 x", "so3"):
        with pytest.raises(KeyError):
            named(unknown)


def test_every_factor_of_a_long_product_counts() -> None:
    many = named(" x ".join(["SO2"] * 9))
    d = Derivation("long", "", "")
    g, g_r, x = (d.take(Quantity(name, size, "1", "", place=name))
                 for name, size in (("g", 36), ("g_r", 36), ("x", 9)))  # fmt: skip
    assert len(many.error(d.let, g_r, g)) == 36
    assert len(many.pull(d.let, g)("eta", x)) == 9
    with pytest.raises(ValueError, match="27 factors: at most 26"):
        named(" x ".join(["SO2"] * 27))


def test_units_of_rates_and_integrals_are_spelled_once() -> None:
    """On SE23 a column of velocity grows with m/s^2, and its rate with m/s^3."""
    group = GROUPS["SE23"]
    assert group.unit == "rad/s, m/s^2, m/s"
    assert group.acceleration_unit == "rad/s^2, m/s^3, m/s^2"
    assert group.log_unit == "rad, m/s, m"
