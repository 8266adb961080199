"""A matrix without an inverse is refused before anything is divided by its determinant."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.vehicle import Vehicle
from tests.emit.cases import NONFINITE, RANGE, divides, good, is_tracking
from tests.emit.subjects import GUARDED, group
from tests.emit.test_guard import by_numpy, called, fuzzer, library

DIVIDED = [v for v in GUARDED if v.own is not None and divides(v)]
NOISE = {"f32": 2e-6, "f64": 4e-15}
SCALARS = ("f32", "f64")

every_vehicle = pytest.mark.parametrize("vehicle", DIVIDED, ids=lambda v: v.name)
every_scalar = pytest.mark.parametrize("scalar", SCALARS)


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("singular")


def flattened(vehicle: Vehicle, part: float) -> Any:
    """An element whose block in the corner has a determinant of that part of its terms."""
    size = int(np.sqrt(group(vehicle).size))
    g = np.eye(size)
    if vehicle.group == "GL2":
        g[:] = [[1.0, 1.0], [1.0 - 2.0 * part, 1.0]]
    else:  # a factor alone, or a rotation times one: a sum of terms of one sign, however small
        g[: size - 1, : size - 1] *= part
    return g.ravel()


def test_there_are_such_groups() -> None:
    assert {v.group for v in DIVIDED} >= {"GL2", "Aff1"}


@every_scalar
@every_vehicle
def test_no_inverse_is_out_of_range(folder: Path, vehicle: Vehicle, scalar: str) -> None:
    """From a determinant of zero to one that rounding may have made, in either configuration."""
    built = library(vehicle, scalar, folder)
    row = good(vehicle)
    parts = [0.0, 1e-45, -1e-45] if vehicle.group != "GL2" else [0.0]
    parts += [] if vehicle.group != "GL2" else [0.25 * NOISE[scalar], -0.25 * NOISE[scalar]]
    for field in ["g", "g_r"] if is_tracking(vehicle) else ["g"]:
        for part in parts:
            if scalar == "f64" and 0 < abs(part) < 1e-40:
                part = np.sign(part) * 5e-324
            rows = {
                name: one[None] for name, one in {**row, field: flattened(vehicle, part)}.items()
            }
            found = called(built, rows)
            assert found["status"].tolist() == [RANGE], (field, part)
            assert not any(found[name].any() for name in ("force", "s", "nu_u", "nu_u_dot"))
            if scalar == "f64":
                told = by_numpy(vehicle, rows, folder)
                assert told.status.tolist() == [RANGE], (field, part)
                assert not np.any(told.force)


@every_scalar
def test_what_has_an_inverse_is_not_refused(folder: Path, scalar: str) -> None:
    """GL2: beyond what rounding may have made, and what is not finite is told as that."""
    vehicle = next(v for v in DIVIDED if v.group == "GL2")
    built, row = library(vehicle, scalar, folder), good(vehicle)
    for part, status in ((1e3 * NOISE[scalar], 0), (-0.5, 0), (np.nan, NONFINITE)):
        for field in ("g", "g_r"):
            near = flattened(vehicle, part)
            other = {"g": "g_r", "g_r": "g"}[field]
            rows = {**row, field: near, other: near if part < 1e-2 else row[other]}
            rows = {name: one[None] for name, one in rows.items()}
            assert called(built, rows)["status"].tolist() == [status]
            if scalar == "f64":
                assert by_numpy(vehicle, rows, folder).status.tolist() == [status]


@every_scalar
@every_vehicle
def test_no_division_by_zero_on_any_bits(folder: Path, vehicle: Vehicle, scalar: str) -> None:
    """Under the sanitizer, which ends the program at one; elements of zeros are among its rows."""
    done = subprocess.run([fuzzer(vehicle, scalar, folder)], capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()
