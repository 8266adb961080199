"""Every mutant that moves an output is caught; what is not caught is listed with its bound."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy
from sympy import Symbol

from derive.lie.kernel import coefficients
from derive.routine.derivation import Derivation, Quantity
from derive.verify.limits import LIMITS
from derive.verify.mutant import of_kernel, of_steps
from derive.verify.mutation import mutation, outcomes
from derive.verify.plant import Plant
from tests.verify.subjects import PAPER, plant, vehicle
from tests.verify.test_suite import with_law


def judged(group: str, law: str, controller: str = "gsmc") -> Plant:
    return plant(with_law(group, law, controller))


@pytest.mark.parametrize(("group", "law"), [("SO3", "log"), ("S3", "half_log")])
def test_no_mutant_that_moves_an_output_is_missed(group: str, law: str) -> None:
    each = 480 if group == "SO3" else 120  # a wrong column shows near a corner of the cube alone
    for routine, outcome in outcomes(judged(group, law), each=each):
        assert outcome is not None
        assert outcome.missed == (), routine
        assert outcome.tried > 10
        assert outcome.bound < LIMITS["mutant"].figure
        assert len(outcome.equivalent) < outcome.tried / 4 or outcome.tried < 100


@pytest.mark.parametrize(
    ("group", "law", "options"),
    [("SO2", "log", ("external", "momentum")), ("SL2", "cayley", ()), ("SE2", "log", ())],
)
def test_no_mutant_is_missed_on_other_groups(
    group: str, law: str, options: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("derive.verify.mutation.MOST", 500)
    for routine, outcome in outcomes(plant(vehicle(group, law, options=options))):
        assert outcome is None or outcome.missed == (), routine
        assert (outcome is None) == (group == "SL2" and routine == "drift")


def test_where_there_are_many_a_fixed_seed_chooses(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("derive.verify.mutation.MOST", 30)
    of = plant(vehicle("SE3", "log"))
    (_, first), *_ = outcomes(of, each=8)
    (_, again), *_ = outcomes(of, each=8)
    assert first == again
    assert first is not None
    assert first.tried == 30 < first.there
    check = next(iter(mutation(of, each=8)))
    assert f"30 of {first.there} tried" in check.worst


def test_a_blind_suite_would_be_found_out(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("derive.verify.trial.Case.rejects", lambda self, outputs: False)
    first = next(iter(mutation(judged("SO3", "log", "reaching"))))
    assert not first.is_ok
    assert first.measured > 1000


def example() -> Derivation:
    """y = a_0 b - 3 a_1, and its square root's inverse."""
    d = Derivation("example", "", "")
    a = d.take(Quantity("a", 2, "1", "", place="a"))
    b = d.take(Quantity("b", 1, "1", "", is_scalar=True, place="b"))
    y = d.let("y", a[0] * b - 3 * a[1], "1", "")
    d.give(Quantity("z", 1, "1", "", is_scalar=True, place="z"), d.let("z", y**-1, "1", ""))
    return d


def test_signs_terms_coefficients_and_pairs_are_all_changed() -> None:
    a0, a1, b, y = (Symbol(name, real=True) for name in ("a_0", "a_1", "b", "y"))
    off = 1 + sympy.Rational(1, 10**9)
    value = a0 * b - 3 * a1
    expected = {
        -value, off * value,
        -a0 * b - 3 * a1, -3 * a1, off * a0 * b - 3 * a1,
        a0 * b + 3 * a1, a0 * b, a0 * b - 3 * off * a1,
        a1 * b - 3 * a0,
    }  # fmt: skip
    assert {m.value for m in of_steps(example()) if m.symbol == y} == {*map(sympy.expand, expected)}


def test_every_coefficient_of_a_polynomial_is_changed() -> None:
    terms = coefficients(0, "f32")
    n = len(terms)
    changed = [m.polynomial for m in of_kernel(0, "f32")]
    assert len(changed) == 3 * n + n * (n - 1) // 2
    assert all(polynomial != terms for polynomial in changed)
    assert (Fraction(0), *terms[1:]) in changed


def test_the_paper_vehicle_is_the_one_judged() -> None:
    assert PAPER.name == "paper_so3"
