"""An inertia given as a matrix is one that a rigid body can have, unless a fluid has a part."""

from itertools import product
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from derive.vehicle import InputError, Vehicle, load
from tests.vehicle.test_body import measured, points

Array = NDArray[np.float64]

IN_FLUID = "[options]\nadded_mass = true\n"


def given(folder: Path, group: str, inertia: Array, options: str = "") -> Vehicle:
    path = folder / "body.toml"
    rows = np.array(inertia, float).tolist()
    path.write_text(
        f'name = "body"\ngroup = "{group}"\ninertia = {rows}\n{options}'
        "[gains]\nlambda = 0.5\nk_s = 1\n",
        encoding="utf-8",
    )
    return load(path)


def refusal(folder: Path, group: str, inertia: Array) -> InputError:
    """The error; the option that lifts the check is named and accepts what is symmetric."""
    with pytest.raises(InputError) as caught:
        given(folder, group, inertia)
    assert "[options] added_mass = true" in caught.value.remedy
    lifted = given(folder, group, inertia, IN_FLUID)
    assert lifted.is_in_fluid
    message = str(caught.value).splitlines()
    assert len(message) == 4
    assert all(len(line) < 300 and line.isprintable() for line in message)
    return caught.value


def body(d: int, seed: int = 0) -> Array:
    return measured(*points(seed, d))


def changed(inertia: Array, *entries: tuple[int, int, float]) -> Array:
    """With those added, at (row, column) counted from 1 and at the mirror image."""
    other = inertia.copy()
    for row, column, value in entries:
        other[row - 1, column - 1] += value
        if row != column:
            other[column - 1, row - 1] += value
    return other


def test_the_inertia_of_points_is_accepted(tmp_path: Path) -> None:
    for d, group, seed in [(2, "SE2", 1), (3, "SE3", 2), (3, "SE3", 3)]:
        assert not given(tmp_path, group, body(d, seed)).is_in_fluid


CENTRED = np.diag([4.0, 3.0, 2.0, 8.0, 8.0, 8.0])

# group, inertia, fragment of expected, of found
BAD = [
    ("SE3", changed(body(3), (5, 5, 1)), "mass", "row 5, column 5 is 17, row 4, column 4 is 16"),
    ("SE3", changed(body(3), (4, 6, 0.5)), "rows 4 to 6", "row 4, column 6 is 0.5"),
    ("SE3", changed(CENTRED, (1, 4, 0.5)), "m c^", "row 1, column 4 is 0.5"),
    (
        "SE3",
        changed(CENTRED, (1, 5, 0.5)),
        "rows 1 to 3, columns 4 to 6: skew",
        "row 1, column 5 is 0.5, row 2, column 4 is 0",
    ),
    ("SE3", changed(CENTRED, (2, 6, 1), (3, 5, 1)), "skew", "column 6 is 1, row 3, column 5 is 1"),
    ("SE3", changed(CENTRED, (1, 1, 2)), "none greater", "2, 3, 6, but 6 > 2 + 3"),
    ("SE2", changed(body(2), (2, 2, 1)), "rows 2 to 3", "row 3, column 3 is 16"),
    ("SE2", changed(body(2), (2, 3, 1)), "zeros beside it", "row 2, column 3 is 1"),
    ("SO3", np.diag([1.0, 2.0, 4.0]), "none greater", "4 > 1 + 2"),
    ("S3", np.diag([1.0, 2.0, 4.0]), "none greater", "4 > 1 + 2"),
]


@pytest.mark.parametrize(("group", "inertia", "expected", "found"), BAD)
def test_what_no_rigid_body_has_is_told(
    tmp_path: Path, group: str, inertia: Array, expected: str, found: str
) -> None:
    error = refusal(tmp_path, group, inertia)
    assert error.key == "inertia"
    assert expected in error.expected
    assert found in error.found


def test_the_triangle_is_of_the_moments_about_the_centre_of_mass(tmp_path: Path) -> None:
    """A long arm hides it: about the origin the moments are those of a body."""
    far, mass = np.array([0.0, 0.0, 10.0]), 8.0
    arm = np.array([[0, -far[2], far[1]], [far[2], 0, -far[0]], [-far[1], far[0], 0]])
    inertia = np.block([
        [np.diag([1.0, 1.0, 3.0]) - mass * arm @ arm, mass * arm],
        [mass * arm.T, mass * np.eye(3)],
    ])  # fmt: skip
    assert sorted(np.diag(inertia)[:3]) == [3, 801, 801]
    assert "3 > 1 + 1" in refusal(tmp_path, "SE3", inertia).found
    inertia[2, 2] = 1.5
    given(tmp_path, "SE3", inertia)


def stacked(*blocks: Array) -> Array:
    n = sum(len(block) for block in blocks)
    inertia, start = np.zeros((n, n)), 0
    for block in blocks:
        inertia[start : start + len(block), start : start + len(block)] = block
        start += len(block)
    return inertia


def test_a_product_is_judged_block_by_block(tmp_path: Path) -> None:
    good, bad = np.diag([2.0, 3.0, 4.0]), np.diag([1.0, 2.0, 4.0])
    given(tmp_path, "SO3 x SE3 x R2", stacked(good, body(3), np.array([[2.0, 1.0], [1.0, 3.0]])))
    error = refusal(tmp_path, "SE3 x SO3", stacked(body(3), bad))
    assert error.key == "inertia, rows 7 to 9 (SO3)"
    error = refusal(tmp_path, "SO3 x SE3", stacked(good, changed(body(3), (5, 5, 1))))
    assert error.key == "inertia, rows 4 to 9 (SE3)"
    assert "rows 7 to 9" in error.expected
    assert error.found == "row 8, column 8 is 17, row 7, column 7 is 16"
    error = refusal(tmp_path, "SO2 x SE3", stacked(np.eye(1), changed(CENTRED, (1, 5, 0.5))))
    assert error.found == "row 2, column 6 is 0.5, row 3, column 5 is 0"


def test_coupled_factors_are_two_halves_of_one_thing(tmp_path: Path) -> None:
    bad = stacked(np.diag([1.0, 2.0, 4.0]), np.diag([2.0, 3.0, 4.0]))
    refusal(tmp_path, "SO3 x SO3", bad)
    for row, column in [(1, 4), (3, 6)]:
        given(tmp_path, "SO3 x SO3", changed(bad, (row, column, 0.1)))


@pytest.mark.parametrize("group", ["R3", "SE23", "R2 x SO2", "SO4", "SO3 x own"])
def test_other_groups_take_every_inertia(tmp_path: Path, group: str) -> None:
    n = 9 if group == "SE23" else 3
    assert len(given(tmp_path, group, np.diag(np.arange(1.0, n + 1) ** 2)).inertia) == n


@pytest.mark.parametrize(("group", "n"), [("SE3", 5), ("SE2", 4), ("SO3 x SO3", 5)])
def test_what_does_not_fit_is_left_to_the_facts(tmp_path: Path, group: str, n: int) -> None:
    given(tmp_path, group, np.diag(np.arange(1.0, n + 1)))


def test_a_verdict_is_that_of_numpy(tmp_path: Path) -> None:
    """Random bodies with one entry moved; a body's 6x6 is that of a 4x4 mass matrix, semidefinite.

    The mass matrix [[sum m r r', m c], [m c', m]] is linear in the 6x6, and exists only where the
    pattern holds: an oracle that knows neither Schur complement nor triangle.
    """
    random = np.random.default_rng(3)
    seen = set()
    for seed, (row, column) in product(range(4), [(1, 1), (2, 2), (1, 2), (1, 4), (2, 6), (4, 4)]):
        step = float(random.integers(-40, 60))
        inertia = changed(body(3, seed), (row, column, step))
        if np.linalg.eigvalsh(inertia)[0] < 1e-6:
            continue
        x, y, z = c = np.array([inertia[2, 4], inertia[0, 5], inertia[1, 3]])
        skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        spread = np.trace(inertia[:3, :3]) / 2 * np.eye(3) - inertia[:3, :3]
        mass = np.block([[spread, c[:, None]], [c[None, :], inertia[3:4, 3:4]]])
        is_pattern = np.array_equal(skew, inertia[:3, 3:]) and np.array_equal(
            inertia[3:, 3:], inertia[3, 3] * np.eye(3)
        )
        lowest = np.linalg.eigvalsh(mass)[0]
        if is_pattern and abs(lowest) < 1e-6:
            continue
        is_body = bool(is_pattern and lowest > 0)
        try:
            given(tmp_path, "SE3", inertia)
            verdict = True
        except InputError:
            verdict = False
        assert verdict == is_body
        seen.add((is_body, bool(is_pattern)))
    assert seen == {(True, True), (False, True), (False, False)}
