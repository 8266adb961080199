"""Rates by the chain rule against complex steps of the same formula."""

import cmath
from random import Random
from typing import Any

import pytest
import sympy
from sympy import Expr, Matrix, Piecewise, Symbol

from derive.lie.kernel import K
from derive.routine.derivation import Derivation, Quantity
from derive.routine.rate import rate

STEP = 1e-30


def begun() -> tuple[Derivation, Any, Any]:
    d = Derivation("sample", "", "")
    x, c = (d.take(Quantity(name, 3, "1", "", place=name)) for name in "xc")
    return d, x, c


def value_of(d: Derivation, wanted: Expr, values: dict[Symbol, complex]) -> complex:
    """The terms one by one, in Python's complex numbers, choices by real parts."""
    known = dict(values)
    for symbol, term in d.terms():
        known[symbol] = _complex(term, known)
    return _complex(wanted, known)


def _complex(term: Expr, known: dict[Symbol, complex]) -> complex:
    real = {symbol: value.real for symbol, value in known.items()}
    for choice in term.atoms(Piecewise):
        case = next(case for case, when in choice.args if when.subs(real) == sympy.true)
        term = term.xreplace({choice: case})
    names = sorted(term.free_symbols, key=str)
    return complex(sympy.lambdify(names, term, "cmath")(*(known[name] for name in names)))


def assert_rate(d: Derivation, entry: Expr, x: Any, c: Any, seed: int) -> None:
    """d/dt entry is what a complex step along x' = (fixed numbers) finds."""
    rng = Random(seed)
    at = {symbol: complex(rng.uniform(0.5, 1.5)) for symbol in (*x, *c)}
    speed = {symbol: rng.uniform(-2, 2) for symbol in x}
    ahead = {symbol: value + 1j * STEP * speed.get(symbol, 0) for symbol, value in at.items()}
    wanted = value_of(d, entry, ahead).imag / STEP
    rates = {symbol: Symbol(f"speed_{symbol}", real=True) for symbol in x}
    (found,) = rate(d, Matrix([entry]), rates)
    known = {**at, **{rates[symbol]: complex(speed[symbol]) for symbol in x}}
    assert value_of(d, found, known) == pytest.approx(wanted, rel=1e-13, abs=1e-13)


def formula(rng: Random, leaves: list[Any], depth: int) -> Expr:
    """A random expression that is defined for positive leaves."""
    if depth == 0:
        return rng.choice(leaves)
    left, right = (formula(rng, leaves, depth - 1) for _ in range(2))
    return rng.choice((left + right, left * right, left - right, left / (1 + right**2),
                       sympy.sqrt(1 + left**2)))  # fmt: skip


@pytest.mark.parametrize("seed", range(12))
def test_it_is_the_derivative_of_any_formula_over_any_steps(seed: int) -> None:
    rng = Random(seed)
    d, x, c = begun()
    leaves = [*x, *c]
    for index in range(4):
        value = Matrix([formula(rng, leaves, 2) for _ in range(2)])
        leaves += list(d.let(f"y{index}", value, "1", ""))
    assert_rate(d, formula(rng, leaves, 3), x, c, seed)


@pytest.mark.parametrize("seed", range(4))
def test_each_branch_of_a_choice_keeps_its_own_rate(seed: int) -> None:
    d, x, c = begun()
    cases = ((x[0] ** 2, c[0] < 1), (x[1] * x[2], c[1] < 1), (-x[2], True))
    chosen = d.let("chosen", Piecewise(*cases, evaluate=False), "1", "")
    assert_rate(d, chosen * x[1], x, c, seed)


@pytest.mark.parametrize("below", [True, False])
def test_a_locally_constant_choice_has_no_rate_of_its_own(below: bool) -> None:
    d, x, _ = begun()
    case = Piecewise((sympy.S.NegativeOne, x[0] < 0), (sympy.S.One, True), evaluate=False)
    sign = d.let("sign", case, "1", "")
    (found,) = rate(d, Matrix([sign * x[1]]), {x[0]: sympy.S(5), x[1]: sympy.S(3)})
    value = dict(d.terms())[sign].subs(x[0], -1 if below else 1)
    assert found.subs(sign, value) == (-3 if below else 3)


def test_steps_between_get_a_step_of_their_own_with_name_and_unit() -> None:
    d, x, _ = begun()
    y = d.let("y", x[0] ** 2, "rad", "")
    z = d.let("z", Matrix([y * x[1], x[2]]), "1", "")
    (found,) = rate(d, Matrix([z[0]]), {x[0]: sympy.S(1)})
    assert str(found) == "z_dot_0"
    assert [step.quantity.name for step in d.steps] == ["y", "z", "y_dot", "z_dot"]
    assert d.step("y_dot").quantity.unit == "rad/s"
    assert d.step("z_dot").quantity.unit == "1/s"
    assert d.step("y_dot").formula == (2 * x[0],)


def test_inputs_without_a_known_rate_are_constants_and_cost_nothing() -> None:
    d, x, c = begun()
    y = d.let("y", c[0] * c[1], "1", "does not move")
    found = rate(d, Matrix([y**2 * x[0], c[2], sympy.pi]), {x[0]: sympy.S(2)})
    assert list(found) == [2 * y**2, 0, 0]
    assert [step.quantity.name for step in d.steps] == ["y"]


def test_a_known_rate_of_a_step_is_taken_as_given() -> None:
    d, x, _ = begun()
    y = d.let("y", x[0] ** 2, "1", "")
    speed = Symbol("speed")
    assert list(rate(d, Matrix([y**2]), {y: speed})) == [2 * y * speed]


def test_a_kernel_is_differentiated_by_its_rule_not_as_it_is_computed() -> None:
    """k stands for K(w): its own step may be a polynomial or a quotient, its rate is -h w'."""
    d, x, _ = begun()
    w = x[0]
    k = d.let("k", w * 7, "1", "a crude stand-in", stands_for=K(w))
    total = d.let("total", K(w) * x[1], "1", "")
    (found,) = rate(d, Matrix([total]), {w: sympy.S(1)})
    assert dict(d.terms())[total] == k * x[1]
    assert d.step(str(found)).formula == (sympy.diff(K(w), w) * x[1],)


def test_complex_steps_see_a_wrong_rate() -> None:
    """The oracle itself: it tells 3 x^2 from 3 x^2 (1 + 1e-11)."""
    d, x, c = begun()
    values: dict[Symbol, complex] = {x[0]: 1.1 + 1j * STEP, **dict.fromkeys(c, 1 + 0j)}
    slope = value_of(d, x[0] ** 3, values).imag / STEP
    assert slope == pytest.approx(3 * 1.1**2, rel=1e-14)
    assert slope != pytest.approx(3 * 1.1**2 * (1 + 1e-11), rel=1e-12)
    assert cmath.isfinite(slope)
