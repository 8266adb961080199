"""Compiled C answers in batches what the same formulas answer in numpy."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from derive.native.compile import build
from derive.native.load import Library, load_module
from tests.native import toy
from tests.native.toy import INERTIA, RATE_GAIN, REACH_GAIN


@pytest.fixture(scope="module", params=["f32", "f64"])
def library(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Library:
    header, source = toy.write(tmp_path_factory.mktemp("toy"), request.param)
    return Library(header, build([source], header.parent, header.parent), f"toy_{request.param}")


def close(library: Library, found: NDArray[Any], wanted: NDArray[np.float64]) -> None:
    assert found.dtype == library.scalar
    limit = 30 * float(np.finfo(library.scalar).eps)
    np.testing.assert_allclose(found, wanted, rtol=0, atol=limit)


def test_the_scalar_is_read_from_the_header(library: Library) -> None:
    assert library.scalar == {"toy_f32": np.float32, "toy_f64": np.float64}[library.prefix]


def test_defaults_constants_and_statuses_are_read(library: Library) -> None:
    close(library, library.defaults["inertia"], INERTIA)
    assert library.defaults["lambda"].shape == ()
    assert library.constants["MAX_NU"] == 1000.0
    assert library.statuses == {"OK": 0, "SATURATED": 1, "OUT_OF_RANGE": 17}


def test_tracking_answers_row_by_row(library: Library) -> None:
    g, nu, g_r, nu_r, nu_r_dot = toy.rows(11)
    answer = library.tracking(g, nu, g_r, nu_r, nu_r_dot)
    s = nu - nu_r + RATE_GAIN * g[:, :2]
    close(library, answer["s"], s)
    close(library, answer["force"], INERTIA[:2] * nu_r_dot - REACH_GAIN * s + g_r[:, 2:])
    assert set(answer) == {"force", "s"}


def test_control_adds_a_status(library: Library) -> None:
    g, nu, g_r, nu_r, nu_r_dot = toy.rows(5)
    nu[3, 0] = 2000.0
    answer = library.control(g, nu, g_r, nu_r, nu_r_dot)
    assert answer["status"].tolist() == [0, 0, 0, 17, 0]
    bare = library.tracking(g, nu, g_r, nu_r, nu_r_dot)
    np.testing.assert_array_equal(answer["s"], bare["s"])


def test_reaching_has_no_reference(library: Library) -> None:
    g, nu, *_ = toy.rows(5)
    close(library, library.reaching(g, nu)["s"], nu + RATE_GAIN * g[:, :2])


def test_plant_takes_and_gives_plain_arrays(library: Library) -> None:
    g, nu, _, force, _ = toy.rows(5)
    wanted = (force + nu[:, ::-1] * [1.0, -1.0]) / INERTIA[:2]
    close(library, library.plant(g, nu, force), wanted)


def test_params_may_differ_by_row_and_be_partial(library: Library) -> None:
    g, nu, g_r, nu_r, nu_r_dot = toy.rows(3)
    gains = np.array([0.0, 1.0, -2.0])
    answer = library.tracking(g, nu, g_r, nu_r, nu_r_dot, {"lambda": gains})
    close(library, answer["s"], nu - nu_r + gains[:, None] * g[:, :2])
    assert library.check_params({"k_s": [1.0, -1.0]}).tolist() == [0, 17]
    assert library.check_params() == 0


def test_leading_axes_broadcast(library: Library) -> None:
    g, nu, g_r, nu_r, nu_r_dot = toy.rows(6)
    grid = library.tracking(g[:, None], nu[:4], g_r[0], nu_r[0], nu_r_dot[0])["s"]
    assert grid.shape == (6, 4, 2)
    one = library.tracking(g[5], nu[2], g_r[0], nu_r[0], nu_r_dot[0])["s"]
    assert one.shape == (2,)
    np.testing.assert_array_equal(grid[5, 2], one)
    assert library.reaching(g[:0], nu[:0])["force"].shape == (0, 2)


def test_matrices_are_taken_row_by_row(library: Library) -> None:
    g, nu, *_ = toy.rows(6)
    flat, square = library.reaching(g, nu), library.reaching(g.reshape(6, 2, 2), nu)
    np.testing.assert_array_equal(flat["force"], square["force"])


def test_bits_pass_through_unchanged(library: Library) -> None:
    inputs = np.array([np.nan, -np.inf, -0.0, np.finfo(library.scalar).smallest_subnormal])
    s = library.reaching(np.zeros(4), np.stack([inputs, inputs], axis=-1))["s"][:, 0]
    np.testing.assert_array_equal(s, inputs.astype(library.scalar))


def test_wrong_arguments_are_refused(library: Library) -> None:
    g, nu, g_r, nu_r, nu_r_dot = toy.rows(2)
    with pytest.raises(ValueError, match=r"nu: shape \(2, 3\) does not end in \(2,\)"):
        library.reaching(g, np.zeros((2, 3)))
    with pytest.raises(ValueError, match="broadcast"):
        library.reaching(g, np.zeros((3, 2)))
    with pytest.raises(TypeError, match="reference"):
        library.control(g, nu)
    with pytest.raises(TypeError, match="k_t"):
        library.tracking(g, nu, g_r, nu_r, nu_r_dot, params={"k_t": 1.0})
    reference = {"g": g_r, "nu": nu_r}
    with pytest.raises(TypeError, match="nu_dot"):
        library.call("tracking", state={"g": g, "nu": nu}, reference=reference)
    with pytest.raises(KeyError, match="steer"):
        library.call("steer")


def test_a_python_file_loads_as_a_module(tmp_path: Path) -> None:
    (tmp_path / "toy.py").write_text("GAIN = 2\n", encoding="utf-8")
    assert load_module(tmp_path / "toy.py").GAIN == 2
    with pytest.raises(FileNotFoundError):
        load_module(tmp_path / "missing.py")
