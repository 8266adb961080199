"""`control` refuses what it must, says why, and then commands nothing; in C and numpy alike."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sympy import Matrix

from derive.emit.literal import python_name
from derive.emit.status import FIRST_BAD, STATUSES
from derive.native.compile import Compiler
from derive.native.load import Library, load_module
from derive.vehicle import Vehicle
from tests.emit import elements, subjects
from tests.emit.cases import (
    NONFINITE,
    OFF,
    OK,
    RANGE,
    SATURATED,
    Case,
    Row,
    cases,
    command,
    good,
    is_tracking,
)
from tests.emit.elements import AXES, Array, element
from tests.emit.subjects import FILES, GUARDED, STEERED, group

SCALARS = ("f32", "f64")
BAD = 19
TYPE = {"f32": ("float", "uint32_t"), "f64": ("double", "uint64_t")}

every_vehicle = pytest.mark.parametrize("vehicle", GUARDED, ids=lambda v: v.name)
every_scalar = pytest.mark.parametrize("scalar", SCALARS)


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("guarded")


@cache
def library(vehicle: Vehicle, scalar: str, folder: Path) -> Library:
    return subjects.library(vehicle, scalar, folder)


def module(vehicle: Vehicle, folder: Path) -> Any:
    return load_module(subjects.place(vehicle, folder) / f"numpy/{vehicle.name}.py")


def stacked(rows: list[Row]) -> Row:
    return {field: np.array([row[field] for row in rows]) for field in rows[0]}


def by_numpy(vehicle: Vehicle, rows: Row, folder: Path, **given: Any) -> Any:
    shape = group(vehicle).shape
    shaped = {
        name: value.reshape(-1, *shape) if name in ("g", "g_r") else value
        for name, value in rows.items()
    }
    return module(vehicle, folder).control(**shaped, **given)


def called(built: Library, rows: Row, routine: str = "control", **given: Any) -> dict[str, Array]:
    """The compiled `control`, or another law."""
    state: dict[str, Any] = {
        name: rows[name] for name in ("g", "nu", "momentum", "external") if name in rows
    }
    if "g_r" not in rows:
        return built.call(routine, state=state, **given)
    reference = {"g": rows["g_r"], "nu": rows["nu_r"], "nu_dot": rows["nu_r_dot"]}
    if routine == "reaching":
        return built.call(routine, state=state, **given)
    return built.call(routine, state=state, reference=reference, **given)


def agree(vehicle: Vehicle, rows: Row, folder: Path) -> None:
    """C in double and numpy: the same status for every row, the same bits of every command."""
    in_c = called(library(vehicle, "f64", folder), rows)
    in_numpy = by_numpy(vehicle, rows, folder)
    np.testing.assert_array_equal(in_numpy.status, in_c["status"])
    for field in command(vehicle):
        np.testing.assert_array_equal(getattr(in_numpy, field), in_c[field], field)


def asked_of(vehicle: Vehicle, built: Library) -> list[Case]:
    return [*cases(vehicle, built.constants, float(built.defaults.get("max_drift", 0.0)))]


def is_beyond(vehicle: Vehicle, built: Library, rows: Row) -> Array:
    """Whether the bare law asks for more than the vehicle's limits, if it has any, (N,)."""
    if "force_limit" not in built.defaults:
        return np.zeros(len(rows["nu"]), dtype=bool)
    law = "tracking" if is_tracking(vehicle) else "reaching"
    force = called(built, rows, law)["force"]
    return np.asarray((np.abs(force) > built.defaults["force_limit"]).any(-1))


@every_scalar
@every_vehicle
def test_every_case_gets_its_status(folder: Path, vehicle: Vehicle, scalar: str) -> None:
    built = library(vehicle, scalar, folder)
    asked = asked_of(vehicle, built)
    rows = stacked([case.row for case in asked])
    got, beyond = called(built, rows), is_beyond(vehicle, built, rows)
    wrong = [
        f"{case.name}: {status}, expected {wanted}"
        for case, status, is_over in zip(asked, got["status"], beyond, strict=True)
        if status != (wanted := SATURATED if case.status == OK and is_over else case.status)
    ]
    assert wrong == []
    refused = got["status"] >= FIRST_BAD
    for field in command(vehicle):
        assert np.isfinite(got[field]).all()
        assert not got[field][refused].any()
    assert got["force"][~refused].any(-1).all()


@every_vehicle
def test_numpy_agrees_with_c_on_every_case(folder: Path, vehicle: Vehicle) -> None:
    built = library(vehicle, "f64", folder)
    agree(vehicle, stacked([case.row for case in asked_of(vehicle, built)]), folder)


@every_vehicle
def test_numpy_agrees_with_c_on_noise(folder: Path, vehicle: Vehicle) -> None:
    random = np.random.default_rng(7)
    known, count = group(vehicle), 400
    rows = []
    for i in range(count):
        row = good(vehicle, seed=i, angle=random.uniform(0, 2 * np.pi))
        field = list(row)[i % len(row)]
        if i % 4:
            other = element(known, random.normal(size=3), random.uniform(0, np.pi), i)
            row = {**row, "g_r": other} if is_tracking(vehicle) else {**row, "g": other}
        if i % 2:
            flipped = row[field].copy()
            flipped.view(np.uint64)[0] ^= np.uint64(1) << np.uint64(random.integers(64))
            row = {**row, field: flipped}
        if i % 16 == 8:
            shape = row[field].shape
            noise = random.integers(0, 2**64, shape, np.uint64, endpoint=False)
            row = {**row, field: noise.view(np.float64)}
        rows.append(row)
    agree(vehicle, stacked(rows), folder)


def spoilt(defaults: dict[str, Array]) -> Iterator[tuple[str, float, Array]]:
    """Each field of the parameters made what check_params refuses: name, value, numbers."""
    values = np.nan, np.inf, -np.inf, -1.0, 0.0, float(np.finfo(defaults["inertia"].dtype).max)
    for name, value in defaults.items():
        for bad in values:
            yield name, bad, np.full_like(value, bad)


def wanted_of(vehicle: Vehicle, name: str, value: float) -> tuple[int, ...]:
    """What a good state may get with that parameter; which of them depends on the numbers."""
    if name == "max_drift":  # a distance of zero, or one that is beyond, is no element
        return (OFF,) if np.isnan(value) else (OFF, OK, SATURATED)
    if name == "force_limit":
        held = (SATURATED,) if value == 0 else (NONFINITE,)  # to nothing; to less it cannot be
        return (OK,) if value > 0 else held
    return (NONFINITE, *((OK, SATURATED) if np.isfinite(value) else ()))


@every_scalar
@every_vehicle
def test_unchecked_parameters_give_a_finite_force(
    folder: Path, vehicle: Vehicle, scalar: str
) -> None:
    built, row = library(vehicle, scalar, folder), good(vehicle)
    made, wide = module(vehicle, folder), {name: value[None] for name, value in row.items()}
    for name, value, numbers in spoilt(built.defaults):
        got = called(built, row, params={name: numbers})
        told = f"{name} = {value}"
        assert got["status"] in wanted_of(vehicle, name, value), told
        assert all(np.isfinite(got[field]).all() for field in command(vehicle)), told
        if got["status"] >= FIRST_BAD:
            assert not any(got[field].any() for field in command(vehicle)), told
        else:
            limit = {**built.defaults, name: numbers}.get("force_limit", np.inf)
            assert (np.abs(got["force"]) <= limit).all(), told
        assert built.call("check_params", params={name: numbers})["status"] == BAD, told
        if scalar == "f64":
            params = made.DEFAULTS._replace(**{python_name(name): numbers})
            found = by_numpy(vehicle, wide, folder, params=params)
            assert found.status.tolist() == [got["status"]], told
            for field in command(vehicle):
                np.testing.assert_array_equal(getattr(found, field)[0], got[field], told)
            assert made.check_params(params) == BAD, told


POLES = [
    v
    for v in GUARDED
    if v.hysteresis is None and (found := elements.cut(group(v), v.law)) and found[1]
]


@every_scalar
@pytest.mark.parametrize("vehicle", POLES, ids=lambda v: v.name)
def test_the_larger_status_wins_at_a_pole(folder: Path, vehicle: Vehicle, scalar: str) -> None:
    """At the pole alone 17; with a parameter that is not a number 18, the larger of the two.

    But where max_drift is none, no number is known to be near the group: 16, before all else.
    """
    built = library(vehicle, scalar, folder)
    for stored in elements.at_cut(group(vehicle), vehicle.law):
        at = {**good(vehicle), "g": stored}
        wide = {name: value[None] for name, value in at.items()}
        assert called(built, at)["status"] == RANGE
        assert by_numpy(vehicle, wide, folder).status.tolist() == [RANGE]
        for name, value in built.defaults.items():
            numbers = np.full_like(value, np.nan)
            wanted = OFF if name == "max_drift" else NONFINITE
            assert called(built, at, params={name: numbers})["status"] == wanted
            own = module(vehicle, folder).DEFAULTS
            params = own._replace(**{python_name(name): numbers.astype(float)})
            assert by_numpy(vehicle, wide, folder, params=params).status.tolist() == [wanted]


def table_of(vehicle: Vehicle, scalar: str) -> str:
    """A C table of elements near the identity, at random, at pi and at the end of S3."""
    random = np.random.default_rng(3)
    kind: Any = {"f32": np.float32, "f64": np.float64}[scalar]
    angles = [0.0, 1e-9, 1.0, 2.0, np.pi - 1e-4, np.pi, 2 * np.pi - 1e-4, 2 * np.pi]
    axes: list[Array] = [*AXES[:3], random.normal(size=3), random.normal(size=3)]
    known = group(vehicle)
    table = [element(known, axis, angle) for axis in axes for angle in angles]
    table += [np.round(row) for row in table if np.allclose(row, np.round(row))]
    table += [np.array(known.identity, float), *elements.at_cut(known, vehicle.law)]
    rows = (", ".join(float(kind(x)).hex() for x in row) for row in table)
    real, _ = TYPE[scalar]
    lines = ",\n".join(f"    {{{row}}}" for row in rows)
    head = f"#define COUNT {len(table)}\nstatic const {real} ELEMENTS[COUNT][{len(table[0])}]"
    return f"{head} = {{\n{lines}\n}};\n"


def fuzzer(vehicle: Vehicle, scalar: str, folder: Path) -> Path:
    """The emitted source and fuzz.c, with every sanitizer there is."""
    own = folder / f"fuzz_{vehicle.name}_{scalar}"
    own.mkdir(exist_ok=True)
    (own / "elements.h").write_text(table_of(vehicle, scalar), encoding="utf-8")
    real, bits = TYPE[scalar]
    known, prefix = group(vehicle), f"{vehicle.name}_{scalar}"
    given = {"HEADER": f'"{prefix}.h"', "PREFIX": prefix, "MACRO": prefix.upper(), "REAL": real}
    given |= {"BITS": bits, "STORED": str(known.size), "DIM": str(known.dim)}
    given |= {"HAS_SIDE": str(int(vehicle.hysteresis is not None))}
    given |= {"FIELDS": str(len(command(vehicle)))}
    given |= {"HAS_REFERENCE": str(int(is_tracking(vehicle))), "ROWS": str(rows(vehicle))}
    given |= {"HAS_RESIDUAL": str(int(has_residual(vehicle)))}
    given |= {"HAS_LIMIT": str(int(bool(vehicle.limits.force)))}
    kinds = ["address", "undefined", "float-divide-by-zero"]
    flags = ["-std=c99", "-O1", "-ffp-contract=off", "-fno-sanitize-recover=all"]
    flags += [f"-fsanitize={','.join(kinds)}", f"-I{own}"]
    flags += [f"-I{subjects.header(vehicle, scalar, folder).parent}"]
    flags += [f"-D{name}={value}" for name, value in given.items()]
    sources = [Path(__file__).with_name("fuzz.c"), subjects.source(vehicle, scalar, folder)]
    return Compiler.find().run([*flags, *map(str, sources), "-lm"], own / "fuzz")


def has_residual(vehicle: Vehicle) -> bool:
    """Whether there are numbers that are no element."""
    return bool(group(vehicle).residual(Matrix(group(vehicle).identity)))


def rows(vehicle: Vehicle) -> int:
    """Fewer where each takes longer."""
    return 200_000 if group(vehicle).dim <= 3 else 40_000


FUZZED = [
    *FILES,
    *STEERED,
    *(v for v in GUARDED if (v.group, v.law) in {
        ("SO3", "gibbs"), ("SO3", "mrp"), ("S3", "log"), ("S3", "sign_vec"), ("SE2", "cayley"),
        ("GL2", "skew"), ("Aff1", "cayley"), ("Random2", "cayley"), ("Random0", "log"),
        ("S3 x SE2", "log"),
    } and v not in FILES and v not in STEERED),
]  # fmt: skip
"""Every vehicle file, every controller, and laws and groups of each kind."""


@every_scalar
@pytest.mark.parametrize("vehicle", FUZZED, ids=lambda v: v.name)
def test_no_bits_lead_astray(folder: Path, vehicle: Vehicle, scalar: str) -> None:
    done = subprocess.run(
        [fuzzer(vehicle, scalar, folder)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    lines = [line.split() for line in done.stdout.splitlines()]
    counts = {int(status): int(count) for status, count in lines}
    assert sum(counts.values()) == rows(vehicle)
    assert (
        {SATURATED if vehicle.limits.force else OK, 17, 18}
        <= set(counts)
        <= {value for _, value, _ in STATUSES}
    )
    assert (16 in counts) == has_residual(vehicle)
    assert (1 in counts) == bool(vehicle.limits.force)
    if elements.cut(group(vehicle), vehicle.law):
        assert counts[2] > 0
