"""A derivation keeps names apart, values small and order straight."""

import pytest
import sympy
from sympy import Matrix, Piecewise, Rational, Symbol

from derive.routine.derivation import Derivation, Quantity


def quantity(name: str, size: int = 1) -> Quantity:
    return Quantity(name, size, "1", f"the {name}", is_scalar=size == 1, place=f"state.{name}")


def begun() -> tuple[Derivation, Symbol, Matrix]:
    """A derivation with a scalar input a and the input x of three entries."""
    d = Derivation("sample", "a sample", "eq. (Sample)")
    return d, d.take(quantity("a")), d.take(quantity("x", 3))


def test_inputs_are_symbols_in_their_shape() -> None:
    _, a, x = begun()
    assert (str(a), [str(entry) for entry in x]) == ("a", ["x_0", "x_1", "x_2"])
    assert isinstance(a, Symbol)
    assert x.shape == (3, 1)
    assert all(symbol.is_real for symbol in (a, *x))


def test_a_step_returns_fresh_symbols_in_the_shape_of_its_value() -> None:
    d, a, x = begun()
    y, b = d.let("y", a * x, "m", "scaled", "eq. (Y)"), d.let("b", x.dot(x), "1", "square")
    assert [str(entry) for entry in y] == ["y_0", "y_1", "y_2"]
    assert y.shape == (3, 1)
    assert str(b) == "b"
    step = d.step("y")
    assert (step.quantity.unit, step.quantity.source, step.quantity.size) == ("m", "eq. (Y)", 3)
    assert step.formula == tuple(a * x)
    assert [*d.terms()] == [*zip(y, a * x, strict=True), (b, x.dot(x))]


def test_what_is_already_a_name_or_a_number_stays_itself() -> None:
    d, a, x = begun()
    y = d.let("y", Matrix([x[1], 0, Rational(2, 3), a + 1, -a]), "1", "mixed")
    assert list(y)[:3] == [x[1], 0, Rational(2, 3)]
    assert [str(entry) for entry in y[3:, :]] == ["y_3", "y_4"]
    assert len(list(d.terms())) == 2


def test_a_root_of_a_number_is_computed_like_anything_else() -> None:
    d, _, _ = begun()
    assert str(d.let("y", sympy.sqrt(2), "1", "root")) == "y"


@pytest.mark.parametrize("name", ["a", "x", "y"])
def test_a_name_is_said_once(name: str) -> None:
    d, a, _ = begun()
    d.let("y", a + 1, "1", "first")
    with pytest.raises(ValueError, match=f"sample: .*'{name}'"):
        d.let(name, a + 2, "1", "second")
    with pytest.raises(ValueError, match=f"sample: .*'{name}'"):
        d.take(quantity(name))


def test_later_steps_spell_an_expression_as_the_step_that_stands_for_it() -> None:
    d, a, x = begun()
    f = sympy.Function("f")
    before = d.let("before", f(a) + 1, "1", "not yet")
    named = d.let("named", x[0] / a, "1", "another way to f(a)", stands_for=f(a))
    after = d.let("after", 2 * f(a) + f(x[1]), "1", "from now on")
    assert dict(d.terms())[before] == f(a) + 1
    assert dict(d.terms())[after] == 2 * named + f(x[1])
    assert d.step("after").formula == (2 * f(a) + f(x[1]),)
    assert d.let("alias", f(a), "1", "nothing to compute") == named


def test_pruning_keeps_what_outputs_need_and_their_order() -> None:
    d, a, x = begun()
    y = d.let("y", a * x, "1", "needed in part")
    d.let("lost", y[0] + a, "1", "needed by none")
    z = d.let("z", y[2] ** 2, "1", "needed")
    d.give(quantity("out", 2), Matrix([z, x[1]]))
    short = d.pruned()
    assert [(str(symbol), value) for symbol, value in short.terms()] == [
        ("y_2", a * x[2]),
        ("z", y[2] ** 2),
    ]
    assert short.outputs == d.outputs
    assert short.inputs == d.inputs
    assert len(list(d.terms())) == 5
    with pytest.raises(KeyError, match="lost"):
        short.step("lost")


def test_without_an_output_its_steps_go_too() -> None:
    d, a, x = begun()
    for name, value in (("kept", a + 1), ("dropped", x[0] + 1)):
        d.give(quantity(name), d.let(f"{name}_value", value, "1", ""))
    left = d.without("dropped")
    assert [q.name for q, _ in left.outputs] == ["kept"]
    assert [str(symbol) for symbol, _ in left.terms()] == ["kept_value"]
    assert len(d.outputs) == 2


def test_used_tells_which_entries_are_mentioned() -> None:
    d, _, x = begun()
    d.give(quantity("out", 2), Matrix([d.let("y", x[0] * 2, "1", ""), x[2]]))
    assert d.used(d.inputs[1]) == (True, False, True)
    assert d.used(d.inputs[0]) == (False,)


def test_it_evaluates_to_the_digits_asked_for() -> None:
    d, a, x = begun()
    root = d.let("root", sympy.sqrt(a), "1", "")
    case = d.let("case", Piecewise((root, x[0] < 0), (-root, True), evaluate=False), "1", "")
    d.give(quantity("out", 2), Matrix([case, x[1]]))
    for sign in (1, -1):
        values = dict(zip((a, *x), map(sympy.Integer, (2, sign, 5, 0)), strict=True))
        found, plain = d.evaluate(values, 80)["out"]
        assert abs(found + sign * sympy.sqrt(2).evalf(90)) < Rational(1, 10**78)
        assert abs(plain - 5) < Rational(1, 10**78)
