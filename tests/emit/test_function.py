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
