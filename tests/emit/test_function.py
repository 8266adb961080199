"""Derivations run as numpy: batches, choices, kernels, and what is refused."""

from typing import Any

import numpy as np
import pytest
from sympy import Abs, Piecewise

from derive.emit.function import Function, compiled
from derive.lie.kernel import K
from derive.routine.derivation import Derivation, Quantity


def made() -> Function:
    d = Derivation("toy", "a toy", "nowhere")
    x, a = d.take(Quantity("x", 2, "1", "x")), d.take(Quantity("a", 1, "1", "a", is_scalar=True))
    y = d.let("y", a * x, "1", "scaled")
    z = d.let("z", Piecewise((y[0], y[0] < 0), (K(Abs(y[1])), True)), "1", "a choice")
    d.give(Quantity("y", 2, "1", "y"), y)
    d.give(Quantity("z", 1, "1", "z", is_scalar=True), z)
    d.give(Quantity("one", 3, "1", "one"), [0, 1, x[0]])
    return compiled(d.pruned())


def test_values_over_a_batch() -> None:
    x = np.array([[[-1.0, 0.5], [1.0, 0.5], [1.0, -0.5]]])
    found = made()(x=x, a=np.array([[2.0], [1.0]]))
    assert {name: rows.shape for name, rows in found.items()} == {
        "y": (2, 3, 2), "z": (2, 3), "one": (2, 3, 3),
    }  # fmt: skip
    np.testing.assert_array_equal(found["y"][0], 2 * x[0])
    k = np.arccos(0.5) / np.sin(np.arccos(0.5))
    np.testing.assert_allclose(found["z"][1], [-1.0, k, k], rtol=1e-15)
    np.testing.assert_array_equal(found["one"][0, 0], [0, 1, -1])


def test_integers_and_lists_are_computed_in_double() -> None:
    found = made()(x=[1, 0], a=1)
    assert found["y"].dtype == np.float64
    np.testing.assert_allclose(found["z"], np.pi / 2)


def test_a_complex_step_runs_through() -> None:
    found = made()(x=np.array([-1.0, 0.5 + 1e-30j]), a=3.0)
    assert found["y"][1].imag == pytest.approx(3e-30)


def test_the_text_is_what_runs() -> None:
    text = made().text
    assert "# y: scaled [1]" in text
    assert "np.where(z_if_0, y_0, _k(" in text
    assert "nowhere" in text


@pytest.mark.parametrize(
    ("given", "fault", "told"),
    [
        ({"x": [1.0, 2.0, 3.0], "a": 1.0}, ValueError, r"x: expected an array \(\.\.\., 2\)"),
        ({"x": 1.0, "a": 1.0}, ValueError, "x: expected an array"),
        ({"x": [1.0, 2.0]}, TypeError, "expected x, a"),
        ({"x": [1.0, 2.0], "a": 1.0, "b": 1.0}, TypeError, "found x, a, b"),
        ({"x": np.zeros((2, 2)), "a": np.zeros(3)}, ValueError, "broadcast"),
    ],
)
def test_what_does_not_fit_is_refused(
    given: dict[str, Any], fault: type[Exception], told: str
) -> None:
    with pytest.raises(fault, match=told):
        made()(**given)


def drawn(columns: int) -> dict[str, Any]:
    random = np.random.default_rng(4)
    return {"x": random.normal(size=(2, columns)) / 2, "a": random.normal(size=columns)}


def test_columns_are_the_rows_bit_for_bit() -> None:
    given = drawn(50)
    y, z, one = made().columns(**given)
    rows = made()(x=given["x"].T, a=given["a"])
    assert (y.shape, z.shape, one.shape) == ((2, 50), (50,), (3, 50))
    for column, name in ((y, "y"), (z, "z"), (one, "one")):
        assert column.T.tobytes() == np.ascontiguousarray(rows[name].T).T.tobytes()
        np.testing.assert_array_equal(column.T, rows[name])


def test_a_column_is_the_same_in_whatever_company() -> None:
    """Of 1, 7 or 1000: no loop of numpy's may round it otherwise."""
    given = drawn(1000)
    whole = made().columns(**given)
    for first, last in ((0, 1), (3, 10), (993, 1000), (999, 1000)):
        few = made().columns(x=given["x"][:, first:last], a=given["a"][first:last])
        for part, all_of_them in zip(few, whole, strict=True):
            assert part.tobytes() == np.ascontiguousarray(all_of_them[..., first:last]).tobytes()


def test_columns_that_all_share_are_spread() -> None:
    given = drawn(5)
    y, z, one = made().columns(x=given["x"], a=np.array([2.0]))
    np.testing.assert_array_equal(y, 2 * given["x"])
    assert (z.shape, one.shape) == ((5,), (3, 5))
    np.testing.assert_array_equal(one[0], np.zeros(5))


def test_a_scalar_goes_in_and_comes_out_without_an_axis_of_its_own() -> None:
    _, z, _ = made().columns(x=np.array([[-1.0], [0.5]]), a=np.array([3.0]))
    assert z.shape == (1,)
    assert z[0] == -3.0
