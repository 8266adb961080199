"""`check_params` accepts the vehicle's own parameters and none that break the law."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.control.table import CONTROLLERS
from derive.emit.literal import python_name
from derive.native.load import Library, load_module
from derive.vehicle import Vehicle
from tests.emit import subjects
from tests.emit.subjects import ALIKE, FILES, SPARSE, Array

BAD = 19
LIMIT, RATE, MOST_DRIFT = 1e9, 1e4, 0.1
LEAST, LEAST_DRIFT = 1e-9, {"f32": 2e-6, "f64": 1e-14}
FORMS = [*ALIKE, *(v for v in SPARSE if v.law == "log")]
NAN, INF = float("nan"), float("inf")

Changed = tuple[str, dict[str, Any]]


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("params")


def largest(vehicle: Vehicle, name: str) -> float:
    """What a number of the parameters may be at most."""
    units = {gain.name: gain.unit for gain in CONTROLLERS[vehicle.controller].gains}
    return MOST_DRIFT if name == "max_drift" else RATE if units.get(name) == "1/s" else LIMIT


def least(scalar: str, name: str) -> float:
    """And at least; a distance what rounding alone may lead to."""
    return LEAST_DRIFT[scalar] if name == "max_drift" else LEAST


def upper(matrix: Array) -> Array:
    return np.asarray(matrix[np.triu_indices(len(matrix))])


def changed(values: Array, index: int | tuple[int, ...], value: float) -> Array:
    copy = values.copy()
    copy[index] = value
    return copy


def refused(vehicle: Vehicle, defaults: dict[str, Array], scalar: str) -> Iterator[Changed]:
    inertia = defaults["inertia"].astype(float)
    for index, present in enumerate(vehicle.pattern):
        for value in (NAN, INF, -INF, 2 * LIMIT, -2 * LIMIT):
            yield f"inertia[{index}] = {value}", {"inertia": changed(inertia, index, value)}
        if not present:
            for value in (1e-40, -1e-3):
                name = f"inertia[{index}] = {value} where the pattern has a zero"
                yield name, {"inertia": changed(inertia, index, value)}
    for name in defaults.keys() - {"inertia"}:
        bad = [0.0, -0.0, -1.0, -LIMIT, NAN, INF, -INF, 1.001 * largest(vehicle, name), 2 * LIMIT]
        bad += [0.999 * least(scalar, name)]
        kept = defaults[name].astype(float)
        for value, place in product(bad, np.ndindex(kept.shape)):
            yield f"{name}{list(place)} = {value}", {name: changed(kept, place, value)}
    yield from indefinite(vehicle, inertia)


def indefinite(vehicle: Vehicle, inertia: Array) -> Iterator[Changed]:
    """Symmetric, of the pattern, but with an eigenvalue that is zero or negative."""
    n = len(vehicle.inertia)
    rows, columns = np.triu_indices(n)
    diagonal = np.flatnonzero(rows == columns).tolist()
    yield "all zero", {"inertia": 0 * inertia}
    yield "negative definite", {"inertia": -inertia}
    for index in diagonal:
        for value in (0.0, -1.0):
            yield f"diagonal {index} = {value}", {"inertia": changed(inertia, index, value)}
    for index, present in enumerate(vehicle.pattern):
        if present and index not in diagonal:
            ends = inertia[diagonal[rows[index]]] * inertia[diagonal[columns[index]]]
            yield f"coupling {index}", {"inertia": changed(inertia, index, 1.1 * np.sqrt(ends))}
    if all(vehicle.pattern) and n > 1:
        yield "of rank one", {"inertia": upper(np.ones((n, n)))}
        factor = np.tril(np.ones((n, n)))
        last = np.diag([*np.ones(n - 1), 0.0])
        yield "its last pivot zero", {"inertia": upper(factor @ last @ factor.T)}


@pytest.mark.parametrize("scalar", ["f32", "f64"])
@pytest.mark.parametrize("vehicle", FORMS, ids=lambda v: v.name)
def test_bad_parameters_are_refused(folder: Path, vehicle: Vehicle, scalar: str) -> None:
    built = subjects.library(vehicle, scalar, folder)
    accepted = [
        name
        for name, params in refused(vehicle, built.defaults, scalar)
        if built.check_params(params=params) != BAD
    ]
    assert accepted == []


@pytest.mark.parametrize("scalar", ["f32", "f64"])
@pytest.mark.parametrize("vehicle", FORMS, ids=lambda v: v.name)
def test_good_parameters_are_accepted(folder: Path, vehicle: Vehicle, scalar: str) -> None:
    built: Library = subjects.library(vehicle, scalar, folder)
    n, pattern = len(vehicle.inertia), np.array(vehicle.pattern)
    assert built.check_params() == 0
    told = {"MAX_PARAM": LIMIT, "MIN_GAIN": LEAST, "MAX_RATE": RATE, "MOST_DRIFT": MOST_DRIFT}
    told["LEAST_DRIFT"] = LEAST_DRIFT[scalar]
    assert built.constants.items() >= {"MAX_PARAM": LIMIT, "MIN_GAIN": LEAST}.items()
    assert all(value == told.get(name, value) for name, value in built.constants.items())
    for name in ("LEAST_DRIFT", "MOST_DRIFT"):
        assert (name in built.constants) == ("max_drift" in built.defaults)
    rates = [name for name, _ in vehicle.gains if largest(vehicle, name) == RATE]
    assert ("MAX_RATE" in built.constants) == bool(rates)
    random = np.random.default_rng(5)
    for scale in (1e-9, 1.0, 1e8):
        factor = np.tril(random.uniform(0.1, 0.2, (n, n)), -1) + np.eye(n)
        matrix = upper(factor @ factor.T) * pattern * scale
        full = np.zeros((n, n))
        full[np.triu_indices(n)] = matrix
        assert np.linalg.eigvalsh(full, "U").min() > 0
        lowest = ends(vehicle, built.defaults, lambda _, name: least(scalar, name))
        for others in (built.defaults, ends(vehicle, built.defaults, largest), lowest):
            assert built.check_params(params={**others, "inertia": matrix}) == 0


def ends(
    vehicle: Vehicle, defaults: dict[str, Array], end: Callable[[Vehicle, str], float]
) -> dict[str, Array]:
    """Every parameter but the inertia at an end of its range."""
    names = defaults.keys() - {"inertia"}
    return {name: np.full(defaults[name].shape, end(vehicle, name)) for name in names}


def in_numpy(made: Any, params: dict[str, Any]) -> Any:
    """Params of the emitted module, those that are not given as in the vehicle file."""
    return made.DEFAULTS._replace(**{python_name(name): one for name, one in params.items()})


def drawn(vehicle: Vehicle, defaults: dict[str, Array], count: int) -> dict[str, Array]:
    """Random parameters about the defaults: good ones, indefinite ones, a few bits flipped."""
    random = np.random.default_rng(11)
    noise = random.normal(size=(count, len(vehicle.pattern))) * random.uniform(0, 1, (count, 1))
    inertia = defaults["inertia"] * (1 + noise)
    inertia += np.where(random.uniform(size=(count, 1)) < 0.2, random.normal(size=noise.shape), 0)
    params = {"inertia": inertia * 10.0 ** random.integers(-8, 9, (count, 1))}
    for name in defaults.keys() - {"inertia"}:
        shape = count, *defaults[name].shape
        params[name] = random.normal(2, 1, shape) * 10.0 ** random.integers(-10, 3, shape)
        params[name] = np.where(random.uniform(size=shape) < 0.5, defaults[name], params[name])
    for values in params.values():
        flat = values.view(np.uint64).reshape(-1)
        places = random.integers(0, flat.size, count // 10)
        flat[places] ^= np.uint64(1) << random.integers(0, 64, len(places), np.uint64)
    return params


@pytest.mark.parametrize("vehicle", FORMS, ids=lambda v: v.name)
def test_numpy_and_c_judge_parameters_alike(folder: Path, vehicle: Vehicle) -> None:
    built = subjects.library(vehicle, "f64", folder)
    made = load_module(folder / vehicle.name / f"numpy/{vehicle.name}.py")
    assert made.check_params().shape == ()
    assert made.check_params() == made.OK
    for name, params in refused(vehicle, built.defaults, "f64"):
        assert made.check_params(in_numpy(made, params)) == BAD, name
    many = drawn(vehicle, built.defaults, 4000)
    got = made.check_params(in_numpy(made, many))
    rows = [{name: one[i] for name, one in many.items()} for i in range(4000)]
    assert got.tolist() == [int(built.check_params(params=row)) for row in rows]
    assert {0, BAD} == set(got.tolist())


@pytest.mark.parametrize("vehicle", FORMS, ids=lambda v: v.name)
def test_numpy_parameters_have_the_shape_they_say(folder: Path, vehicle: Vehicle) -> None:
    made = load_module(subjects.place(vehicle, folder) / f"numpy/{vehicle.name}.py")
    n, size = len(vehicle.inertia), len(vehicle.pattern)
    gain = python_name(vehicle.gains[0][0])
    nu = np.ones(n)
    for wrong in (np.ones((n, size + 1)), np.ones((7, size + 3)), np.ones(size - 1), 1.0):
        params = made.DEFAULTS._replace(inertia=wrong)
        told = rf"inertia: expected an array \(\.\.\., {size}\), found"
        with pytest.raises(ValueError, match=told):
            made.check_params(params)
        with pytest.raises(ValueError, match=told):
            made.plant(*[nu] * (2 + len(vehicle.options)), params)
    spread = made.DEFAULTS._replace(**{gain: [[1.0], [-1.0]]}, inertia=[made.DEFAULTS.inertia] * 3)
    assert made.check_params(spread).tolist() == [[0] * 3, [BAD] * 3]
    empty = made.DEFAULTS._replace(inertia=np.ones((0, size)))
    assert made.check_params(empty).shape == (0,)
    for odd in (1j, "1", None, np.ma.masked):
        with pytest.raises(TypeError, match=rf"{gain}: expected real numbers, found an? "):
            made.check_params(made.DEFAULTS._replace(**{gain: odd}))


def test_the_defaults_are_the_numbers_of_the_file(folder: Path) -> None:
    for vehicle in FILES:
        wanted = upper(np.array([[float(x) for x in row] for row in vehicle.inertia]))
        for scalar, kind in (("f32", np.float32), ("f64", np.float64)):
            defaults = subjects.library(vehicle, scalar, folder).defaults
            assert defaults["inertia"].tolist() == wanted.astype(kind).tolist()
            for name, value in vehicle.gains:
                assert defaults[name] == kind(float(value))
            limits, usual = vehicle.limits, {"f32": 1e-4, "f64": 1e-6}[scalar]
            assert ("force_limit" in defaults) == bool(limits.force)
            assert defaults.get("force_limit", np.empty(0)).tolist() == [
                kind(float(x)) for x in limits.force
            ]
            if "max_drift" in defaults:
                drift = usual if limits.drift is None else float(limits.drift)
                assert defaults["max_drift"] == kind(drift)
    assert any(vehicle.limits.force for vehicle in FILES)
