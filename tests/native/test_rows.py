"""Thousands of rows in C at a time answer what one call a row answers, bit for bit."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from bench.algebra import algebra, exp
from derive.native.compile import FLAGS, WARNINGS_C, Compiler, build_object
from derive.native.header import parse
from derive.native.load import Library
from derive.native.rows import Rows, build_rows, column, text
from tests.emit import subjects
from tests.emit.subjects import COMPILERS
from tests.native import toy

COUNT = 17
VEHICLES = {
    one.name: one
    for one in (*subjects.FILES, *subjects.OPTED)
    if one.name in ("paper_so3", "quadrotor", "sl2", "se3_log_gsmc_full_external_momentum")
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("rows")


def library(name: str, scalar: str, folder: Path) -> Library:
    vehicle = VEHICLES[name]
    header = subjects.header(vehicle, scalar, folder)
    source = subjects.source(vehicle, scalar, folder)
    built = build_rows(header, source, folder / f"{name}_{scalar}")
    return Library(header, built, f"{name}_{scalar}")


def fill(rows: Rows, group: str, seed: int) -> None:
    """Random numbers everywhere but in the parameters, the third row off the group.

    Even rows have a force limit that is never met, where there is one.
    """
    random, space = np.random.default_rng(seed), algebra(group)
    for struct, buffer in rows.inputs.items():
        for name in keys(buffer) if struct != "params" else ():
            buffer[name] = random.normal(size=buffer[name].shape)
            if name == "g":
                turns = random.uniform(-0.7, 0.7, (COUNT, space.dim))
                buffer[name] = space.store(exp(space.hat(turns)))
                buffer[name][3, 0] += 2.0
    if "force_limit" in keys(rows.inputs.get("params", np.empty(0))):
        rows.inputs["params"]["force_limit"][::2] = 1e8


def keys(buffer: NDArray[Any]) -> tuple[str, ...]:
    return buffer.dtype.names or ()


@pytest.mark.parametrize("scalar", ["f32", "f64"])
@pytest.mark.parametrize("routine", ["control", "tracking", "plant", "check_params"])
@pytest.mark.parametrize("name", VEHICLES)
def test_rows_are_the_calls_bit_for_bit(name: str, routine: str, scalar: str, folder: Path) -> None:
    loaded = library(name, scalar, folder)
    rows = Rows(loaded, routine, COUNT)
    fill(rows, VEHICLES[name].group, seed=3)
    given: dict[str, Any] = {
        struct: {key: buffer[key].copy() for key in keys(buffer)}
        for struct, buffer in rows.inputs.items()
    }
    plain = {one.name for one in loaded.routines[routine].parameters if one.size}
    given = {key: value[key] if key in plain else value for key, value in given.items()}
    rows.run()
    wanted = loaded.call(routine, **given)
    for buffer in rows.outputs.values():
        for key in keys(buffer):
            assert buffer[key].dtype == loaded.scalar
            assert buffer[key].tobytes() == wanted[key].tobytes()
            assert buffer[key].any()
    assert rows.results.tolist() == np.broadcast_to(wanted.get("status", 0), COUNT).tolist()
    if routine == "control":
        assert rows.results[3] == 16
        assert 0 in rows.results
        assert (1 in rows.results) == bool(VEHICLES[name].limits.force)
        assert not (rows.results[::2] == 1).any()


@pytest.mark.parametrize("scalar", ["f32", "f64"])
def test_an_array_argument_is_stepped_by_its_length(scalar: str, tmp_path: Path) -> None:
    """const double force[2] is a pointer, which moves by two numbers from row to row."""
    header, source = toy.write(tmp_path, scalar)
    loaded = Library(header, build_rows(header, source, tmp_path), f"toy_{scalar}")
    rows = Rows(loaded, "plant", 5)
    _, nu, _, force, _ = toy.rows(5)
    column(rows.inputs["state"], "nu")[...] = nu.T
    column(rows.inputs["force"], "force")[...] = force.T
    rows.run()
    wanted = (force + nu[:, ::-1] * [1.0, -1.0]) / toy.INERTIA[:2]
    found = column(rows.outputs["nu_dot"], "nu_dot")
    np.testing.assert_allclose(
        found, wanted.T, rtol=0, atol=30 * float(np.finfo(loaded.scalar).eps)
    )


def test_parameters_start_as_the_defaults_and_may_differ_by_row(tmp_path: Path) -> None:
    header, source = toy.write(tmp_path, "f64")
    loaded = Library(header, build_rows(header, source, tmp_path), "toy_f64")
    rows = Rows(loaded, "check_params", 3)
    assert rows.inputs["params"]["inertia"].tolist() == [toy.INERTIA.tolist()] * 3
    rows.inputs["params"]["k_s"][1] = -1.0
    rows.run()
    assert rows.results.tolist() == [0, 17, 0]
    rows.inputs["params"]["k_s"][1] = 1.0  # in place: nothing is copied
    rows.run()
    assert rows.results.tolist() == [0, 0, 0]


def test_a_second_run_sees_new_numbers_and_no_rows_are_no_fault(tmp_path: Path) -> None:
    header, source = toy.write(tmp_path, "f64")
    loaded = Library(header, build_rows(header, source, tmp_path), "toy_f64")
    rows = Rows(loaded, "reaching", 4)
    for value in (1.0, -2.0):
        column(rows.inputs["state"], "nu")[...] = value
        rows.run()
        np.testing.assert_array_equal(column(rows.outputs["command"], "s"), np.full((2, 4), value))
    Rows(loaded, "reaching", 0).run()
    with pytest.raises(KeyError, match="steer"):
        Rows(loaded, "steer", 1)


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("scalar", ["f32", "f64"])
def test_the_loops_compile_without_a_warning(compiler: str, scalar: str, tmp_path: Path) -> None:
    for vehicle in VEHICLES.values():
        header = subjects.header(vehicle, scalar, tmp_path)
        loops = tmp_path / f"{vehicle.name}_{scalar}_rows.c"
        routines = parse(header.read_text(encoding="utf-8")).routines.values()
        loops.write_text(text(header.name, list(routines)), encoding="utf-8")
        found = Compiler.find([compiler])
        flags = (*FLAGS, *WARNINGS_C[found.family])
        assert build_object(loops, header.parent, tmp_path, flags, found).exists()
