"""The emitted numpy module: batches of any shape, parameters that broadcast, refused inputs."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.native.load import load_module
from derive.vehicle import Vehicle
from tests.emit import subjects
from tests.emit.cases import command, is_tracking
from tests.emit.elements import Array, element
from tests.emit.subjects import ALIKE, FILES, GUARDED, group
from tests.oracle import truth

SHAPES: tuple[tuple[int, ...], ...] = (
    (),
    (1,),
    (5,),
    (2, 3),
    (0,),
    (2, 0, 3),
    (4095,),
    (4096,),
    (4097,),
)

every_vehicle = pytest.mark.parametrize("vehicle", ALIKE, ids=lambda v: v.name)


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("numpy")


@cache
def module(vehicle: Vehicle, folder: Path) -> Any:
    return load_module(subjects.place(vehicle, folder) / f"numpy/{vehicle.name}.py")


def law(made: Any, vehicle: Vehicle) -> Any:
    """The bare law that `control` guards."""
    return made.tracking if is_tracking(vehicle) else made.reaching


def inputs(vehicle: Vehicle, shape: tuple[int, ...], seed: int = 2) -> dict[str, Array]:
    random, known = np.random.default_rng(seed), group(vehicle)
    count = int(np.prod(shape))
    few = min(count, 12)  # drawn apart, then repeated: what is batched need not differ

    def elements() -> Array:
        pairs = zip(random.normal(size=(few, 3)), random.uniform(0, 3, few), strict=True)
        table = [element(known, axis, angle, i) for i, (axis, angle) in enumerate(pairs)]
        whole = np.resize(np.array(table), (count, known.size))
        return whole.reshape(*shape, *known.shape)

    names = ["nu", *(name for name in ("momentum", "external") if name in vehicle.options)]
    given = {"g": elements()}
    if is_tracking(vehicle):
        given |= {"g_r": elements()}
        names += ["nu_r", "nu_r_dot"]
    return given | {name: random.normal(size=(*shape, known.dim)) for name in names}


def rows(given: dict[str, Array], depth: int) -> list[dict[str, Array]]:
    """Every row of a batch of that many leading axes."""
    shape = given["nu"].shape[:depth]
    return [{name: value[at] for name, value in given.items()} for at in np.ndindex(*shape)]


@every_vehicle
@pytest.mark.parametrize("shape", SHAPES, ids=str)
def test_a_batch_is_its_rows(folder: Path, vehicle: Vehicle, shape: tuple[int, ...]) -> None:
    made, given = module(vehicle, folder), inputs(vehicle, shape)
    for routine in (made.control, law(made, vehicle)):
        whole = routine(**given)
        assert whole.status.shape == shape
        assert whole.status.dtype.kind == "i"
        for field in command(vehicle):
            assert getattr(whole, field).shape == (*shape, group(vehicle).dim)
            assert getattr(whole, field).dtype == np.float64
        alone = rows(given, len(shape))
        flat = whole.force.reshape(-1, group(vehicle).dim)
        picked = sorted({*range(min(3, len(alone))), *range(len(alone))[-3:]})
        for i in picked:
            np.testing.assert_array_equal(routine(**alone[i]).force, flat[i])


@every_vehicle
def test_leading_axes_broadcast(folder: Path, vehicle: Vehicle) -> None:
    made = module(vehicle, folder)
    given = inputs(vehicle, (4, 1))
    given |= {"nu": inputs(vehicle, (3,), 5)["nu"]}
    spread = law(made, vehicle)(**given)
    assert spread.force.shape == (4, 3, group(vehicle).dim)
    for i, j in np.ndindex(4, 3):
        row = {name: value[i, 0] for name, value in given.items() if name != "nu"}
        alone = law(made, vehicle)(**row, nu=given["nu"][j])
        np.testing.assert_array_equal(spread.force[i, j], alone.force)


MARGINS = ("force_limit", "max_drift")
"""Parameters of `control` alone."""


def assert_spread(run: Any, given: dict[str, Array], params: Any, name: str, batch: Array) -> Any:
    """The batch of one parameter is its rows; what it gives."""
    spread = run(**given, params=params._replace(**{name: batch}))
    for k in range(len(batch)):
        alone = run(**given, params=params._replace(**{name: batch[k]}))
        np.testing.assert_array_equal(spread.force[k], alone.force)
        assert spread.status[k] == alone.status
    return spread


@every_vehicle
def test_every_parameter_broadcasts(folder: Path, vehicle: Vehicle) -> None:
    made, given = module(vehicle, folder), inputs(vehicle, ())
    for name, value in made.DEFAULTS._asdict().items():
        batch = np.multiply.outer([1.0, 2.0, 3.0], value)
        guarded = assert_spread(made.control, given, made.DEFAULTS, name, batch)
        assert guarded.force.shape == (3, group(vehicle).dim)
        if name not in MARGINS:
            bare = assert_spread(law(made, vehicle), given, made.DEFAULTS, name, batch)
            assert bare.force.shape == (3, group(vehicle).dim)
            assert len({tuple(force) for force in bare.force}) == 3


@every_vehicle
def test_every_margin_broadcasts(folder: Path, vehicle: Vehicle) -> None:
    """A force within each of three limits; what is off by 1e-4 within one distance of three."""
    made, given = module(vehicle, folder), inputs(vehicle, ())
    fields = made.DEFAULTS._fields
    assert ("force_limit" in fields) == bool(vehicle.limits.force)
    if "force_limit" in fields:
        size = np.abs(law(made, vehicle)(**given).force)
        batch = np.multiply.outer([0.25, 0.5, 2.0], size)
        spread = assert_spread(made.control, given, made.DEFAULTS, "force_limit", batch)
        assert spread.status.tolist() == [made.SATURATED, made.SATURATED, made.OK]
        np.testing.assert_allclose(np.abs(spread.force), np.minimum(batch, size), rtol=1e-15)
    if "max_drift" in fields:
        off = {**given, "g": given["g"] * (1 + 1e-4)}
        batch = np.array([1e-6, 1e-5, 0.05])
        spread = assert_spread(made.control, off, made.DEFAULTS, "max_drift", batch)
        assert spread.status[:2].tolist() == [made.NOT_ON_GROUP] * 2
        assert spread.status[2] < made.NOT_ON_GROUP


@every_vehicle
def test_a_wrong_shape_is_refused(folder: Path, vehicle: Vehicle) -> None:
    made, good = module(vehicle, folder), inputs(vehicle, (2,))
    for routine in (made.control, law(made, vehicle)):
        for name, value in good.items():
            wrongs = [value[..., :-1], np.concatenate([value, value], -1), np.array(1.0)]
            if len(group(vehicle).shape) == 2 and name.startswith("g"):
                wrongs += [value[..., :-1, :], value.reshape(len(value), -1)]
            for wrong in wrongs:
                with pytest.raises(ValueError, match=r"expected an array \(\.\.\., "):
                    routine(**{**good, name: wrong})
        with pytest.raises(ValueError, match="broadcast"):
            routine(**{**good, "nu": inputs(vehicle, (3,))["nu"]})


@every_vehicle
def test_control_refuses_complex_numbers(folder: Path, vehicle: Vehicle) -> None:
    made, good = module(vehicle, folder), inputs(vehicle, (2,))
    for name, value in good.items():
        with pytest.raises(TypeError, match="real numbers"):
            made.control(**{**good, name: value.astype(complex)})
    for name, value in made.DEFAULTS._asdict().items():
        params = made.DEFAULTS._replace(**{name: np.asarray(value) + 0j})
        with pytest.raises(TypeError, match="real numbers"):
            made.control(**good, params=params)


@pytest.mark.parametrize("vehicle", GUARDED, ids=lambda v: v.name)
def test_a_complex_step_runs_through_the_law(folder: Path, vehicle: Vehicle) -> None:
    made, given = module(vehicle, folder), inputs(vehicle, (6,))
    routine, step = law(made, vehicle), 1e-5
    for name in given:
        way = np.random.default_rng(1).normal(size=given[name].shape)
        stepped = routine(**{**given, name: given[name] + 1e-100j * way})
        sides = [routine(**{**given, name: given[name] + sign * step * way}) for sign in (1, -1)]
        for field in command(vehicle):
            slope = np.imag(getattr(stepped, field)) / 1e-100
            central = (getattr(sides[0], field) - getattr(sides[1], field)) / (2 * step)
            size = 1 + np.abs(central).max()
            np.testing.assert_allclose(slope, central, rtol=1e-6, atol=1e-6 * size)


@every_vehicle
def test_the_plant_takes_any_batch(folder: Path, vehicle: Vehicle) -> None:
    made = module(vehicle, folder)
    n, wheels = group(vehicle).dim, "momentum" in vehicle.options
    random = np.random.default_rng(4)
    names = ["nu", *(name for name in ("momentum", "external") if name in vehicle.options), "force"]
    upper = [vehicle.inertia[i][j] for i in range(n) for j in range(i, n)]
    for shape in SHAPES[:6]:
        given = {name: random.normal(size=(*shape, n)) for name in names}
        found = made.plant(**given)
        assert found.shape == (*shape, n)
        for at in list(np.ndindex(*shape))[:2]:
            row = {name: value[at].tolist() for name, value in given.items()}
            wanted = np.array(truth(group(vehicle)).plant(upper, **row), float)
            np.testing.assert_allclose(found[at], wanted, rtol=1e-12, atol=1e-12)
    assert wheels == ("momentum" in made.plant.__code__.co_varnames)


@every_vehicle
def test_narrow_numbers_are_computed_in_double(folder: Path, vehicle: Vehicle) -> None:
    made = module(vehicle, folder)
    identity = np.reshape(group(vehicle).identity, group(vehicle).shape)
    drawn = inputs(vehicle, (3,))
    given = {name: value.astype(np.float32) for name, value in drawn.items()}
    wide = {name: value.astype(float) for name, value in given.items()}
    bare = law(made, vehicle)
    np.testing.assert_array_equal(bare(**given).force, bare(**wide).force)
    whole: dict[str, Array] = {
        name: np.full(group(vehicle).dim, 100, np.int8) for name in given if name[0] != "g"
    }
    whole |= {
        "nu": np.full(group(vehicle).dim, -100, np.int8)
    }  # its distance from nu_r is beyond int8
    whole |= {name: identity.astype(np.int8) for name in given if name.startswith("g")}
    wide = {name: value.astype(float) for name, value in whole.items()}
    np.testing.assert_array_equal(made.control(**whole).force, made.control(**wide).force)


def test_inputs_are_left_as_they_were(folder: Path) -> None:
    for vehicle in FILES:
        given = inputs(vehicle, (5,))
        for value in given.values():
            value.setflags(write=False)
        kept = {name: value.copy() for name, value in given.items()}
        module(vehicle, folder).control(**given)
        for name, value in given.items():
            np.testing.assert_array_equal(value, kept[name])
