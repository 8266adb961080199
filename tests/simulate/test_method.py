"""Both Runge-Kutta methods: their order on a nonlinear equation, their nodes, polynomials."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest

from derive.simulate.method import BUTCHER, KUTTA, Method, State, step
from derive.simulate.space import Array

each_method = pytest.mark.parametrize("method", [KUTTA, BUTCHER], ids=["Kutta", "Butcher"])


def rates(t: float, state: State) -> State:
    """x' = x cos t + y, y' = -x y: no part is a function of the time alone."""
    x, y = state
    return x * math.cos(t) + y, -x * y


def flown(method: Method, steps: int) -> Array:
    """(x, y) after 2 s from (0.6, 0.9)."""
    state: State = (np.array([0.6]), np.array([0.9]))
    for place in range(steps):
        state = step(method, rates, place * 2 / steps, 2 / steps, state)
    return np.concatenate(state)


@each_method
def test_halving_the_steps_gains_the_order(method: Method) -> None:
    truth = flown(BUTCHER, 1600)
    errors = [float(np.abs(flown(method, steps) - truth).max()) for steps in (20, 40, 80)]
    found = [math.log2(a / b) for a, b in pairwise(errors)]
    assert found == pytest.approx([method.order] * 2, abs=0.35)


def test_both_come_to_the_same() -> None:
    np.testing.assert_allclose(flown(KUTTA, 6400), flown(BUTCHER, 400), atol=1e-13)


NODES = {"Kutta": (0.0, 0.5, 0.5, 1.0), "Butcher": (0.0, 1 / 3, 2 / 3, 1 / 3, 0.5, 0.5, 1.0)}


@each_method
def test_stages_are_asked_for_at_the_nodes(method: Method) -> None:
    asked: list[float] = []

    def clock(t: float, state: State) -> State:
        asked.append(t)
        return (np.ones(1),)

    (after,) = step(method, clock, 10.0, 0.25, (np.zeros(1),))
    wanted = NODES[method.name.split("'")[0]]
    np.testing.assert_allclose(asked, [10 + node * 0.25 for node in wanted], rtol=1e-15)
    assert after[0] == pytest.approx(0.25, rel=1e-15)


@each_method
@pytest.mark.parametrize("power", range(7))
def test_a_polynomial_of_the_time_is_integrated_exactly(method: Method, power: int) -> None:
    def rate(t: float, state: State) -> State:
        return (np.array([t**power]),)

    (found,) = step(method, rate, 0.0, 1.0, (np.zeros(1),))
    off = abs(found[0] * (power + 1) - 1)
    assert (off < 4e-16) == (power < method.order)


@each_method
def test_the_weights_are_those_of_the_book(method: Method) -> None:
    """Sums of order up to 3 that hold whatever the equation is, of the rounded entries."""
    weights = [Fraction(w) for w in method.weights]
    nodes = [sum(map(Fraction, row), Fraction(0)) for row in method.rows]
    second = [sum((Fraction(a) * c for a, c in zip(row, nodes, strict=False)), Fraction(0))
              for row in method.rows]  # fmt: skip
    sums = (
        sum(weights),
        sum(w * c for w, c in zip(weights, nodes, strict=True)),
        sum(w * c * c for w, c in zip(weights, nodes, strict=True)),
        sum(w * d for w, d in zip(weights, second, strict=True)),
    )
    np.testing.assert_allclose([float(one) for one in sums], [1, 1 / 2, 1 / 3, 1 / 6], rtol=1e-15)
