"""What is drawn: uniform where the group is compact, in the box elsewhere, of one seed alone."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy import stats
from scipy.linalg import expm

from derive.simulate.draw import Spread, drawn, initial_angles, seed_of
from derive.simulate.reference import Course
from derive.simulate.runs import Runs
from derive.simulate.space import Array, space_of
from tests.simulate.crafts import craft

MANY = 8000
LEAST = 1e-3 / 25  # of a p-value: some 25 are looked at, which together fail by chance in 0.1 %
ALL = ("SO2", "SO3", "S3", "SE2", "SE3", "SE23", "R3", "SE3 x SO3", "SL2")


def of(group: str, count: int = MANY, spread: Spread | None = None, root: int = 0) -> Runs:
    """Runs about rest at the identity."""
    space = space_of(craft(group))
    rest = Course("rest", tuple(space.identity[:, 0]), ((0.0,) * space.dim,)).reference()
    seeds = [seed_of(root, i) for i in range(count)]
    return drawn(craft(group), rest, spread or Spread(), seeds)


def test_a_seed_is_a_whole_number_of_63_bits_of_its_own() -> None:
    seeds = {seed_of(root, run) for root in range(3) for run in range(500)}
    assert len(seeds) == 1500
    assert 2**62 < max(seeds) < 2**63


def haar(angle: Array) -> Array:
    """Share of rotations of space by at most an angle."""
    return (angle - np.sin(angle)) / math.pi


def test_rotations_of_space_are_uniform() -> None:
    g = of("SO3").g
    cosine = (g[0] + g[4] + g[8] - 1) / 2
    assert np.mean(1 - cosine) == pytest.approx(1.5, abs=0.05)
    assert stats.kstest(np.arccos(np.clip(cosine, -1, 1)), haar).pvalue > LEAST
    for entry in g:  # of a uniform rotation every entry is uniform on [-1, 1]
        assert stats.kstest(entry, stats.uniform(-1, 2).cdf).pvalue > LEAST


def test_unit_quaternions_are_uniform_on_the_whole_sphere() -> None:
    g = of("S3").g
    density = stats.semicircular()  # of any coordinate
    assert all(stats.kstest(entry, density.cdf).pvalue > LEAST for entry in g)
    assert np.min(g[0]) < -0.95


@pytest.mark.parametrize(("group", "place"), [("SO2", (0, 2)), ("SE2", (0, 3))])
def test_rotations_of_the_plane_are_uniform(group: str, place: tuple[int, int]) -> None:
    g = of(group).g
    angle = np.arctan2(g[place[1]], g[place[0]])
    assert stats.kstest(angle, stats.uniform(-math.pi, 2 * math.pi).cdf).pvalue > LEAST
    assert np.max(np.abs(angle)) > math.pi - 0.01


@pytest.mark.parametrize(("group", "places"), [("SE2", (2, 5)), ("SE3", (3, 7, 11)),
                                               ("R3", (0, 1, 2))])  # fmt: skip
def test_translations_lie_in_the_box(group: str, places: tuple[int, ...]) -> None:
    g = of(group, spread=Spread(box=2.5)).g
    for place in places:
        assert stats.kstest(g[place], stats.uniform(-2.5, 5).cdf).pvalue > LEAST


def test_every_factor_of_a_product_turns_on_its_own() -> None:
    g = of("SE3 x SO3").g
    for first, (i, j, k) in ((0, (0, 5, 10)), (16, (0, 4, 8))):
        cosine = (g[first + i] + g[first + j] + g[first + k] - 1) / 2
        assert stats.kstest(np.arccos(np.clip(cosine, -1, 1)), haar).pvalue > LEAST
    assert abs(np.corrcoef(g[0], g[16])[0, 1]) < 0.06


def test_an_own_group_starts_in_the_box_of_its_algebra() -> None:
    basis = np.array([[[0, 1], [0, 0]], [[0, 0], [1, 0]], [[1, 0], [0, -1]]], dtype=float)
    g = of("SL2", 50, Spread(box=0.7)).g.T.reshape(-1, 2, 2)
    scale = np.array([[np.sum(e * f) for f in basis] for e in basis])
    for one in g:
        x = np.linalg.solve(scale, [np.sum(e * _log(one)) for e in basis])
        assert np.all(np.abs(x) <= 0.7)
        np.testing.assert_allclose(expm(np.tensordot(x, basis, 1)), one, atol=1e-12)


def _log(g: Array) -> Array:
    """Of a matrix near 1, by Mercator's series of its repeated roots."""
    half = g
    for _ in range(8):
        half = _root(half)
    step, power, total = half - np.eye(2), np.eye(2), np.zeros((2, 2))
    for order in range(1, 12):
        power = power @ step
        total += (-1) ** (order + 1) / order * power
    return 2.0**8 * total


def _root(g: Array) -> Array:
    """Of a matrix (2, 2) of determinant 1."""
    return np.asarray((g + np.eye(2)) / math.sqrt(np.trace(g) + 2))


@pytest.mark.parametrize("group", ALL)
def test_runs_start_on_the_group(group: str) -> None:
    space = space_of(craft(group))
    assert space.drift(of(group, 40).g).max() < 1e-12


@pytest.mark.parametrize("group", ALL)
def test_a_run_is_the_same_in_any_company(group: str) -> None:
    n = space_of(craft(group)).dim
    spread = Spread(inertia=0.3, disturbance=(0.1,) * n, wave=(0.2,) * n)
    whole, few = of(group, 9, spread), of(group, 2, spread)
    names = ("g", "nu", "inertia", "disturbance", "sine", "cosine")
    for name in names:
        assert getattr(whole, name)[:, :2].tobytes() == getattr(few, name).tobytes()


def test_the_plants_inertia_stays_positive_definite_and_keeps_its_zeros() -> None:
    whole = np.array(craft("SE3").inertia)
    upper = of("SE3", 300, Spread(inertia=0.95)).inertia
    assert np.array_equal(upper != 0, np.repeat(whole[:, None] != 0, 300, 1))
    rows, columns = np.triu_indices(6)
    full = np.zeros((300, 6, 6))
    full[:, rows, columns] = full[:, columns, rows] = upper.T
    assert np.linalg.eigvalsh(full).min() > 0
    roots = np.sqrt(np.diagonal(full, axis1=1, axis2=2))
    alike = full / roots[:, :, None] / roots[:, None, :]  # as for correlations: D cancels
    assert np.ptp(alike, axis=0).max() < 1e-14
    assert np.abs(np.triu(alike[0], 1)).max() > 0.01
    kept = np.diagonal(full, axis1=1, axis2=2) / whole[[0, 6, 11, 15, 18, 20]]
    assert 0.05 < kept.min() < 0.1
    assert 1.9 < kept.max() < 1.95


def test_a_velocity_is_the_references_in_the_body_frame_and_an_error() -> None:
    space, speed = space_of(craft("SO3")), Spread(speed=0.0)
    nu_r = np.array([0.3, -0.2, 0.5])
    steady = Course("steady", tuple(space.identity[:, 0]), (tuple(nu_r),)).reference()
    runs = drawn(craft("SO3"), steady, speed, [5, 6])
    for i in range(2):
        R = runs.g[:, i].reshape(3, 3)
        np.testing.assert_allclose(runs.nu[:, i], R.T @ nu_r, atol=1e-14)


def test_an_error_is_counted_from_the_reference() -> None:
    space = space_of(craft("SO3"))
    start = expm(np.array([[0, -0.4, 0.2], [0.4, 0, -0.9], [-0.2, 0.9, 0]]))
    away = Course("rest", tuple(start.ravel()), ((0.0,) * 3,)).reference()
    runs = drawn(craft("SO3"), away, Spread(), [5])
    plain = drawn(craft("SO3"), Course("rest", tuple(space.identity[:, 0]), ((0.0,) * 3,))
                  .reference(), Spread(), [5])  # fmt: skip
    expected = start @ plain.g[:, 0].reshape(3, 3)
    np.testing.assert_allclose(runs.g[:, 0].reshape(3, 3), expected, atol=1e-14)


def test_forces_are_drawn_per_coordinate_and_known_ones_are_given() -> None:
    spread = Spread(disturbance=(0.1, 0.0, 3.0), wave=(0.0, 2.0, 0.0), momentum=(1.0, 2.0, 3.0),
                    external=(4.0, 5.0, 6.0))  # fmt: skip
    runs = of("SO3", 200, spread)
    widest = [np.abs(one).max(1) for one in (runs.disturbance, runs.sine, runs.cosine)]
    np.testing.assert_allclose(widest, [(0.1, 0, 3), (0, 2, 0), (0, 2, 0)], rtol=0.05)
    assert not any(np.signbit(one[one == 0]).any() for one in (runs.disturbance, runs.sine))
    assert runs.momentum.tolist() == [[1.0], [2.0], [3.0]]
    assert runs.external.tolist() == [[4.0], [5.0], [6.0]]


def _of_matrix(g: Array) -> Array:
    return np.asarray(np.arccos(np.clip((g[0] + g[4] + g[8] - 1) / 2, -1, 1)))


def _of_quaternion(g: Array) -> Array:
    return np.asarray(2 * np.arctan2(np.linalg.norm(g[1:], axis=0), g[0]))


@pytest.mark.parametrize(("group", "angle"), [("SO3", _of_matrix), ("S3", _of_quaternion)])
def test_the_initial_angle_is_that_of_the_error(
    group: str, angle: Callable[[Array], Array]
) -> None:
    runs = of(group, 200)
    found = initial_angles(craft(group), runs.seeds)
    np.testing.assert_allclose(found, angle(runs.g), atol=1e-6)


def test_nothing_turns_on_vectors() -> None:
    assert np.isnan(initial_angles(craft("R3"), [1, 2])).all()
