"""The least drift that may be asked for lets every good error through: rounding alone is none."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.emit import subjects
from tests.emit.cases import OFF
from tests.emit.subjects import FILES, LAWFUL, group

Wide = NDArray[np.longdouble]
COUNT, BAD = 20_000, 19
KIND: dict[str, Any] = {"f32": np.float32, "f64": np.float64}
LETTERS = {
    "S3": "q", "SO3": "R", "SE2": "P", "SE3": "T", "SE23": "E", "SE3 x SO3": "TR", "SO2": "C"
}  # fmt: skip
"""What each group's numbers are, one after the other: a letter for each factor."""

CHOSEN = tuple(
    next(one for one in (*FILES, *LAWFUL) if one.group == name and one.controller == "gsmc")
    for name in LETTERS
)


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("least_drift")


def quaternions(random: np.random.Generator) -> Wide:
    """Unit quaternions, some of them next to turns about one axis, wider than double, (N, 4)."""
    q = random.normal(size=(COUNT, 4)) * 10.0 ** random.uniform(-6, 0, size=(COUNT, 4))
    wide = q.astype(np.longdouble)
    return np.asarray(wide / np.sqrt((wide**2).sum(1))[:, None])


def rotations(q: Wide) -> Wide:
    """Their matrices, (N, 3, 3)."""
    w, x, y, z = q.T
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )
    return np.stack([np.stack(row, -1) for row in rows], -2)


def numbers(letter: str, random: np.random.Generator) -> Wide:
    """Elements of one factor, row by row, not yet rounded, (N, k)."""
    q = quaternions(random)
    if letter == "q":
        return q
    turn = rotations(q)
    if letter in "CP":
        flat = q[:, :2] / np.sqrt((q[:, :2] ** 2).sum(1))[:, None]
        c, s = flat.T
        turn = np.stack([np.stack([c, -s], -1), np.stack([s, c], -1)], -2)
    size = turn.shape[-1]
    whole = np.tile(np.eye(size + {"P": 1, "T": 1, "E": 2}.get(letter, 0)), (COUNT, 1, 1))
    wide = whole.astype(np.longdouble)
    far = random.uniform(-1, 1, wide[:, :size, size:].shape) * 10.0 ** random.uniform(-3, 6)
    wide[:, :size, :size], wide[:, :size, size:] = turn, far
    return wide.reshape(COUNT, -1)


@pytest.mark.parametrize("scalar", ["f32", "f64"])
@pytest.mark.parametrize("vehicle", CHOSEN, ids=lambda v: v.name)
def test_no_correctly_rounded_pair_is_off(folder: Path, vehicle: Any, scalar: str) -> None:
    """Nor are they so near that a fiftieth of the least would do."""
    built = subjects.library(vehicle, scalar, folder)
    random, kind = np.random.default_rng(9), KIND[scalar]
    pair = [np.hstack([numbers(one, random) for one in LETTERS[vehicle.group]]) for _ in range(2)]
    g, g_r = (one.astype(kind).astype(float) for one in pair)
    still = np.zeros((COUNT, group(vehicle).dim))
    state, reference = {"g": g, "nu": still}, {"g": g_r, "nu": still, "nu_dot": still}
    state |= dict.fromkeys(vehicle.options, still)
    for part, are_off in ((1.0, False), (0.02, True)):
        params = {"max_drift": np.array(part * built.constants["LEAST_DRIFT"])}
        found = built.call("control", state=state, reference=reference, params=params)
        assert (found["status"] == OFF).any() == are_off
        assert built.check_params(params=params) == (0 if part == 1.0 else BAD)
