"""Stored numbers become elements exactly, ties at pi included, and no group takes what is none."""

from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from derive.verify.oracle import truth
from derive.verify.oracle.precise import exactly

mp = truth.mp
IDENTITY = truth.IDENTITY


def test_the_callers_precision_is_left_alone() -> None:
    before = mpmath.mp.prec
    truth.law("SO3", "log", truth.error("SO3", IDENTITY["SO3"], IDENTITY["SO3"]))
    assert mpmath.mp.prec == before
    assert mp.dps >= 60
    assert mp is not mpmath.mp


def test_stored_numbers_are_taken_exactly() -> None:
    assert exactly(0.1) == Fraction(0.1).numerator / mp.mpf(Fraction(0.1).denominator)
    assert exactly(np.float32(0.1)) == exactly(float(np.float32(0.1))) != exactly(0.1)
    assert exactly(Fraction(1, 3)) * 3 == 1
    third = mp.mpf(1) / 3
    assert exactly(third) == third != exactly(float(third))
    assert exactly(5e-324) > 0


def test_a_drifted_matrix_is_put_on_the_group() -> None:
    noise = np.random.default_rng(3)
    for seed in range(5):
        stored = Rotation.random(rng=np.random.default_rng(seed)).as_matrix()
        stored = stored + noise.normal(size=(3, 3)) * 1e-2
        rotation = mp.matrix([list(row) for row in truth.project(stored.ravel().tolist())])
        assert mp.mnorm(rotation.T * rotation - mp.eye(3)) < mp.mpf("1e-120")
        u, _, v = np.linalg.svd(stored)
        np.testing.assert_allclose(np.array(rotation.tolist(), float), u @ v, atol=1e-14)


def test_what_is_nearest_to_no_rotation_is_refused() -> None:
    for stored in ((0,) * 9, (1, 0, 0, 0, 1, 0, 0, 0, -1), (float("nan"),) * 9):
        with pytest.raises(ValueError, match="no rotation"):
            truth.project(stored)
    for quaternion in ((0, 0, 0, 0), (float("nan"),) * 4):
        with pytest.raises(ValueError, match="no unit quaternion"):
            truth.normalise(quaternion)


@pytest.mark.parametrize(
    ("axis", "wanted"),
    [
        ((-1, 0, 0), (1, 0, 0)),
        ((0, -1, 0), (0, 1, 0)),
        ((0, 0, 1), (0, 0, 1)),
        ((-1, 1, 0), (1, -1, 0)),
        ((1, -1, -1), (1, -1, -1)),
        ((1, -2, -2), (-1, 2, 2)),
        ((0.1, 0.2, -0.7), (-0.1, -0.2, 0.7)),
    ],
)
def test_at_pi_the_largest_component_is_positive(axis: Any, wanted: Any) -> None:
    n = np.array(axis, float) / np.linalg.norm(axis)
    stored = 2 * np.outer(n, n) - np.eye(3)
    assert (stored == stored.T).all()  # an exact tie
    q = truth.error("SO3", IDENTITY["SO3"], stored.ravel().tolist())
    assert q[0] == 0
    np.testing.assert_allclose(np.array(q[1:], float), np.array(wanted) / np.linalg.norm(axis))
    turned = np.array(truth.law("SO3", "log", q), float)
    np.testing.assert_allclose(turned, np.pi * np.array(q[1:], float))


def test_a_tie_but_for_rounding_is_a_tie() -> None:
    tiny = mp.mpf("1e-120")
    q = truth.quaternion(((-tiny, -mp.one, mp.zero), (-mp.one, tiny, mp.zero), (0, 0, -mp.one)))
    assert q[1] > 0 > q[2]


@pytest.mark.parametrize("tilt", [1e-300, -1e-300, 1e-17])
def test_short_of_a_tie_the_scalar_decides(tilt: float) -> None:
    q = truth.error("SO3", IDENTITY["SO3"], (1, 0, 0, 0, -1, -tilt, 0, tilt, -1))
    assert q[0] > 0
    assert mp.sign(q[1]) == mp.sign(tilt)
