"""One arithmetic in every backend, and the paper's, on every group, those made here included.

C in double and numpy give the same bits; both, and C in float, are held to 130 digits with the
inverse inertia; the rate is the complex step of the emitted law.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.native.load import Library, load_module
from derive.vehicle import Vehicle
from derive.verify.oracle import baseline_truth
from tests.control.drawn import square
from tests.emit import subjects
from tests.emit.cases import Row, command, is_baseline, is_tracking
from tests.emit.elements import AXES, element, velocity
from tests.emit.subjects import GUARDED, Array, group
from tests.oracle import truth

WITHIN = {"f64": 1e-12, "f32": 5e-4}
"""Of a command, relative to its largest part over the batch."""

every_vehicle = pytest.mark.parametrize("vehicle", GUARDED, ids=lambda v: v.name)


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("same")


@cache
def library(vehicle: Vehicle, scalar: str, folder: Path) -> Library:
    return subjects.library(vehicle, scalar, folder)


def module(vehicle: Vehicle, folder: Path) -> Any:
    return load_module(subjects.place(vehicle, folder) / f"numpy/{vehicle.name}.py")


def batch(vehicle: Vehicle, count: int) -> Row:
    """Errors of up to two radians, with a reference that is not the identity."""
    known, random = group(vehicle), np.random.default_rng(9)
    names = ["nu", *(name for name in ("momentum", "external") if name in vehicle.options)]
    rows = {"g": [element(known, AXES[i % 4], 2.0 * i / count, i) for i in range(count)]}
    if is_tracking(vehicle):
        rows["g_r"] = [element(known, AXES[(i + 1) % 4], 0.4, count + i) for i in range(count)]
        names += ["nu_r", "nu_r_dot"]
    found = {name: np.array(row) for name, row in rows.items()}
    return found | {name: random.normal(size=(count, known.dim)) for name in names}


def in_c(built: Library, vehicle: Vehicle, rows: Row) -> dict[str, Array]:
    """The bare law of the compiled C."""
    state = {name: x for name, x in rows.items() if name in ("g", "nu", "momentum", "external")}
    if not is_tracking(vehicle):
        return built.call("reaching", state=state)
    reference = {"g": rows["g_r"], "nu": rows["nu_r"], "nu_dot": rows["nu_r_dot"]}
    return built.call("tracking", state=state, reference=reference)


def in_numpy(made: Any, vehicle: Vehicle, rows: Row) -> Any:
    shape = group(vehicle).shape
    given = {name: x.reshape(-1, *shape) if name[0] == "g" else x for name, x in rows.items()}
    return (made.tracking if is_tracking(vehicle) else made.reaching)(**given)


@every_vehicle
def test_c_in_double_and_numpy_agree_bit_for_bit(folder: Path, vehicle: Vehicle) -> None:
    rows = batch(vehicle, 24)
    compiled = in_c(library(vehicle, "f64", folder), vehicle, rows)
    plain = in_numpy(module(vehicle, folder), vehicle, rows)
    for field in command(vehicle):
        np.testing.assert_array_equal(compiled[field], getattr(plain, field), err_msg=field)
        assert np.isfinite(compiled[field]).all()
    assert compiled["force"].any()


def papers(vehicle: Vehicle, params: dict[str, Any], row: dict[str, Any]) -> dict[str, Any]:
    """The command by the paper's formulas, in 130 digits."""
    if is_baseline(vehicle):
        gains = {name: value for name, value in params.items() if name != "inertia"}
        inertia = square(params["inertia"])
        return baseline_truth.tracking(vehicle.controller, inertia, gains, **row)
    known = truth(group(vehicle))
    named = {"rate_gain": params["lambda"], "reach_gain": params["k_s"]}
    given = {"inertia": params["inertia"], **named, **row}
    write = known.tracking if is_tracking(vehicle) else known.reaching
    return write(vehicle.law, given)


@every_vehicle
@pytest.mark.parametrize("scalar", WITHIN)
def test_the_command_is_the_papers(folder: Path, vehicle: Vehicle, scalar: str) -> None:
    """From what is stored in that scalar, taken exactly."""
    kind = {"f32": np.float32, "f64": np.float64}[scalar]
    rows = {name: x.astype(kind).astype(float) for name, x in batch(vehicle, 3).items()}
    built = library(vehicle, scalar, folder)
    params = {name: x.astype(float).tolist() for name, x in built.defaults.items()}
    found = in_c(built, vehicle, rows)
    for i in range(3):
        wanted = papers(vehicle, params, {name: x[i].tolist() for name, x in rows.items()})
        for field in command(vehicle):
            exact = np.array(wanted[field], float)
            size = 1 + np.abs(exact).max()
            assert np.abs(found[field][i] - exact).max() <= WITHIN[scalar] * size, (i, field)


@pytest.mark.parametrize(
    "vehicle", [v for v in GUARDED if not is_baseline(v)], ids=lambda v: v.name
)
def test_the_rate_is_the_complex_step_of_the_law(folder: Path, vehicle: Vehicle) -> None:
    """Along g' = g hat(nu), through the emitted numpy of `reaching`."""
    known, made = group(vehicle), module(vehicle, folder)
    rows = {name: x for name, x in batch(vehicle, 12).items() if name[-2:] != "_r"}
    rows.pop("nu_r_dot", None)
    pairs = zip(rows["g"], rows["nu"], strict=True)
    speed = np.array([velocity(known, g, nu) for g, nu in pairs])
    shaped = {**rows, "g": (rows["g"] + 1e-100j * speed).reshape(-1, *known.shape)}
    stepped = made.reaching(**shaped)
    still = made.reaching(**{**rows, "g": rows["g"].reshape(-1, *known.shape)})
    slope = np.imag(stepped.nu_u) / 1e-100
    size = 1 + np.abs(still.nu_u_dot).max(axis=-1, keepdims=True)
    assert (np.abs(slope - still.nu_u_dot) <= 1e-12 * size).all()
    assert still.nu_u_dot.any()
