"""Groups in numpy against the truth with 130 digits and against scipy."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import expm

from derive.verify import shape
from derive.verify.oracle import matrix_group
from tests.verify.oracle.coordinates import NAMES, blocks
from tests.verify.oracle.test_factor_law import HEISENBERG, SL2

ALL = [*NAMES, SL2, HEISENBERG]


def rows(name: Any, seed: int, count: int) -> NDArray[Any]:
    n = matrix_group.dim(name)
    return np.random.default_rng(seed).normal(size=(count, n))


@pytest.mark.parametrize("name", ALL, ids=str)
def test_stored_numbers_flow_as_the_truth_says(name: Any) -> None:
    x, nu = rows(name, 31, 2)
    g = np.array(matrix_group.store(name, matrix_group.exp(name, x)), float)
    group = shape.space(name)
    np.testing.assert_allclose(group.kept(group.matrices(g[None]))[0], g, atol=1e-15)
    wanted = matrix_group.times(matrix_group.exp(name, x), matrix_group.exp(name, nu))
    found = group.flowed(g[None], nu[None])[0]
    np.testing.assert_allclose(found, np.array(matrix_group.store(name, wanted), float), atol=1e-13)
    h = 1e-6
    ahead, behind = (group.flowed(g[None], side * h * nu[None]) for side in (1, -1))
    slope = group.tangent(g[None], nu[None])
    np.testing.assert_allclose(slope, (ahead - behind) / (2 * h), atol=1e-8)


@pytest.mark.parametrize("name", ALL, ids=str)
def test_pulls_and_brackets_are_those_of_the_truth(name: Any) -> None:
    x, y, z = rows(name, 32, 3)
    g = matrix_group.exp(name, z)
    kept = np.array(matrix_group.store(name, g), float)[None]
    group, identity = shape.space(name), matrix_group.exp(name, [0] * len(x))
    still = np.array(matrix_group.store(name, identity), float)[None]
    pulled = group.pull(group.error(still, kept), x[None])[0]
    np.testing.assert_allclose(pulled, np.array(matrix_group.pull(name, g, x), float), atol=1e-12)
    bracket = np.einsum("ijk,j,k->i", group.structure(), x, y)
    wanted = np.array(matrix_group.bracket(name, x, y), float)
    np.testing.assert_allclose(bracket, wanted, atol=1e-13)
    assert np.isclose(group.coad(x[None], z[None])[0] @ y, z @ wanted)


@pytest.mark.parametrize("name", NAMES)
def test_blocks_are_rotations_and_translations(name: str) -> None:
    found = list(shape.space(name).blocks())
    assert [block.rows.stop - block.rows.start for block in found] == blocks(name)
    assert found[-1].rows.stop == matrix_group.dim(name)


def test_expm_is_that_of_scipy() -> None:
    a = np.random.default_rng(33).normal(size=(5, 4, 4)) * 3
    np.testing.assert_allclose(shape.expm(a), [expm(one) for one in a], rtol=1e-11)
    assert (shape.expm(np.zeros((2, 3, 3))) == np.eye(3)).all()


def test_one_number_that_leaves_the_group_is_no_translation() -> None:
    fixed = shape.space("SE3").shapes[0].is_fixed().reshape(4, 4)
    assert fixed[:3, :3].all()
    assert fixed[3].all()
    assert not fixed[:3, 3].any()
    assert not shape.space("R3").shapes[0].is_fixed().any()
    scaling = ((1, 0), (0, 1)), ((0, 1), (-1, 0))
    assert shape.space(scaling).shapes[0].holds_one()
    assert not shape.space(SL2).shapes[0].holds_one()
