"""Costs against counts by hand, in the spelling of the printer."""

import pytest
import sympy
from sympy import Abs, Expr, Matrix, Piecewise, Rational, sqrt

from derive.lie.kernel import H, K
from derive.routine.cost import Cost, cost
from derive.routine.derivation import Derivation

a, b, c, e = sympy.symbols("a b c e", real=True)

BY_HAND = [
    (a + b, 1),
    (a - b, 1),
    (a + b - c + 2, 3),
    (-a, 1),
    (-a - b, 2),  # -(a + b)
    (a * b + c, 2),
    (a * b - c * e, 3),
    (a / 2, 1),
    (2 * a / 3, 2),  # 2*a/3
    (Rational(2, 3) * (a + b), 2),  # 0.66…*(a + b)
    (a**2, 1),
    (a**3, 2),
    (1 / a, 1),
    (1 / a**2, 2),
    (a * b / (c * e), 3),
    (-a / b, 2),
    (sqrt(a), 1),
    (1 / sqrt(a), 2),
    (sqrt(a**2 + b**2), 4),
    (2 * a + 2 * b, 2),  # 2*(a + b)
    (sympy.pi / (a + b), 2),
    ((a + b) * (a - b), 3),
    (Abs(a - b), 1),
    (a * (1 - b) ** 2, 3),
]


def of(*steps: Expr | Matrix) -> Cost:
    d = Derivation("sample", "", "")
    for index, value in enumerate(steps):
        d.let(f"y{index}", value, "1", "")
    return cost(d)


@pytest.mark.parametrize(("value", "operations"), BY_HAND, ids=[str(v) for v, _ in BY_HAND])
def test_operations_are_those_counted_by_hand(value: Expr, operations: int) -> None:
    assert of(value) == Cost(operations, 1, 0)


def test_steps_add_up() -> None:
    assert of(a * b, a + b, sqrt(a)) == Cost(3, 3, 0)


def test_a_term_that_stands_twice_in_one_step_counts_once() -> None:
    twice = Matrix([(a + b) * c, (a + b) * e])
    assert of(twice) == Cost(3, 2, 0)
    assert of(*twice) == Cost(4, 2, 0)


def test_kernels_are_counted_apart() -> None:
    assert of(K(a) * b + H(a)) == Cost(2, 1, 2)
    assert of(K(1 - a)) == Cost(1, 1, 1)


def test_the_dearest_case_of_a_choice_counts_and_no_comparison() -> None:
    choice = Piecewise((a, a < 0), (a * b + c, a * b < 1), (-a, True), evaluate=False)
    assert of(choice).operations == 2


def test_names_and_numbers_cost_nothing() -> None:
    assert of(Matrix([a, 0, Rational(1, 3)])) == Cost(0, 0, 0)


def test_stack_is_one_slot_per_temporary() -> None:
    assert Cost(9, 5, 0).stack_bytes(4) == 20
