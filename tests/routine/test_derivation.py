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


# A derivation in two parts.


def whole() -> Derivation:
    """b = a x_0, mid = (b + x_1, 2, b x_2), out = (mid_0 mid_2 + y, mid_1), with a spare step."""
    d, a, x = begun()
    y = d.take(quantity("y"))
    b = d.let("b", a * x[0], "m", "before", "eq. (B)")
    mid = d.let("mid", Matrix([b + x[1], 2, b * x[2]]), "rad", "between", "eq. (Mid)")
    d.let("spare", mid[0] * 3, "1", "needed by none")
    last = d.let("last", mid[0] * mid[2] + y, "1", "after")
    d.give(quantity("out", 2), Matrix([last, mid[1]]))
    return d


def test_two_parts_give_what_the_whole_gives() -> None:
    d = whole()
    head, tail = d.parted("mid")
    names = [symbol for q in d.inputs for symbol in q.symbols()]
    values = dict(zip(names, map(Rational, ("2/3", "5", "-7", "11", "1/13")), strict=True))
    ((quantity_, entries),) = head.outputs
    passed = dict(zip(quantity_.symbols(), head.evaluate(values, 60)["mid"], strict=True))
    assert len(entries) == 3
    assert set(passed) == {Symbol(f"mid_{i}", real=True) for i in range(3)}
    given = {name: value for name, value in values.items() if str(name) == "y"}
    for found, known in zip(
        tail.evaluate(given | passed, 60)["out"], d.evaluate(values, 60)["out"], strict=True
    ):
        assert abs(found - known) < Rational(1, 10**55)
        assert found != 0


def test_each_part_takes_what_it_needs_and_says_what_the_whole_says() -> None:
    d = whole()
    head, tail = d.parted("mid")
    assert [q.name for q in head.inputs] == ["a", "x"]
    assert [q.name for q in tail.inputs] == ["y", "mid"]
    passed = tail.inputs[-1]
    assert (passed, passed.place) == (head.outputs[0][0], "mid")
    assert (passed.unit, passed.doc, passed.source) == ("rad", "between", "eq. (Mid)")
    assert [s.quantity.name for s in head.steps] == ["b", "mid"]
    assert [s.quantity.name for s in tail.steps] == ["spare", "last"]
    assert tail.outputs == d.outputs
    for part in (head, tail):
        assert (part.name, part.doc, part.source) == (d.name, d.doc, d.source)
    assert len(d.inputs) == 3
    assert len(d.steps) == 4


def test_a_head_computes_only_what_it_passes_on() -> None:
    d, a, x = begun()
    y = d.let("y", a * x, "1", "needed in part")
    d.let("mid", Matrix([y[1] + 1]), "1", "between")
    d.give(quantity("out"), d.let("last", y[0] + a, "1", ""))
    head, tail = d.parted("mid")
    assert [str(symbol) for symbol, _ in head.terms()] == ["y_1", "mid_0"]
    assert [q.name for q in tail.inputs] == ["a", "mid"]
    with pytest.raises(KeyError, match="lost"):
        head.step("lost")


def test_what_is_an_earlier_name_cannot_be_passed_on() -> None:
    d, a, x = begun()
    mid = d.let("mid", Matrix([x[0] + 1, a]), "1", "an input by another name")
    d.give(quantity("out", 2), mid)
    with pytest.raises(ValueError, match=r"sample: mid is made of \(mid_0, a\)"):
        d.parted("mid")


def test_a_name_that_no_step_has_parts_nothing() -> None:
    with pytest.raises(ValueError, match="'other' is not in list"):
        whole().parted("other")


def test_needing_leaves_out_inputs_that_nobody_mentions() -> None:
    d, a, x = begun()
    d.give(quantity("out"), d.let("y", x[1] + 1, "1", ""))
    assert [q.name for q in d.needing().inputs] == ["x"]
    kept = d.needing(d.inputs[0])
    assert [q.name for q in kept.inputs] == ["a", "x"]
    assert (kept.steps, kept.outputs) == (d.steps, d.outputs)
    assert [q.name for q in d.inputs] == ["a", "x"]
    d.give(quantity("other"), a)
    assert [q.name for q in d.needing().inputs] == ["a", "x"]


def test_what_is_kept_stays_whole_with_all_that_it_is_made_of() -> None:
    d, a, x = begun()
    root = d.let("root", sympy.sqrt(a), "1", "needed by what is kept alone")
    kept = d.let("kept", Matrix([root + x[0], x[1] * 2, 3]), "1", "read in part")
    d.let("lost", x[2] + 1, "1", "needed by none")
    d.give(quantity("out"), d.let("y", kept[1] + 1, "1", ""))
    assert [str(s) for s, _ in d.pruned().terms()] == ["kept_1", "y"]
    short = d.pruned(keep="kept")
    assert [str(s) for s, _ in short.terms()] == ["root", "kept_0", "kept_1", "y"]
    assert short.step("kept") == d.step("kept")
    assert d.pruned(keep="nobody").steps == d.pruned().steps
