"""The suite on the controllers the paper compares with: green when right, red when not."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

import pytest

from derive import pipeline
from derive.control import port
from derive.control.table import CONTROLLERS
from derive.vehicle import Vehicle, load
from derive.verify.closed import lsf_residual
from derive.verify.limits import LIMITS
from derive.verify.mutation import outcomes
from derive.verify.run import run
from derive.verify.suite import PLAN
from tests.verify.subjects import ROOT, plant, vehicle
from tests.verify.test_suite import EXTRAS, failures, verified

NAMES = ("lsf_printed", "lsf", "pd_plus")
BODIES = {name: load(ROOT / "vehicles" / f"paper_so3_{name}.toml") for name in NAMES}
each_baseline = pytest.mark.parametrize("name", NAMES)


def with_options(name: str, *options: str) -> Vehicle:
    return vehicle("SO3", CONTROLLERS[name].law or "", name, options)


def test_every_baseline_of_the_table_is_here() -> None:
    assert tuple(name for name, one in CONTROLLERS.items() if one.is_baseline) == NAMES
    assert all(BODIES[name].controller == name for name in NAMES)


@each_baseline
@pytest.mark.parametrize("options", [EXTRAS, EXTRAS[:1], EXTRAS[1:]], ids="-".join)
def test_what_a_vehicle_knows_besides_is_judged(name: str, options: tuple[str, ...]) -> None:
    assert failures(verified(with_options(name, *options), each=4)) == []


@each_baseline
@pytest.mark.parametrize("size", ["1e-6", "1e9"])
@pytest.mark.parametrize("gains", [("1e-3", "1e4"), ("1e4", "1e-3")], ids="-".join)
def test_no_size_and_no_gain_raises_a_false_alarm(
    name: str, size: str, gains: tuple[str, str]
) -> None:
    one = Fraction(size)
    inertia = tuple(tuple(one * (i == j) for j in range(3)) for i in range(3))
    given = tuple(zip(CONTROLLERS[name].names, map(Fraction, gains), strict=True))
    assert failures(verified(replace(BODIES[name], inertia=inertia, gains=given), each=3)) == []


@each_baseline
@pytest.mark.parametrize("seed", range(1, 4))
def test_no_seed_raises_a_false_alarm(name: str, seed: int) -> None:
    assert failures(verified(BODIES[name], each=3, seed=seed)) == []


@each_baseline
def test_no_check_speaks_of_a_rate_and_every_output_is_judged(name: str) -> None:
    report = verified(BODIES[name], each=1)
    names = {check.name for check in report.checks}
    assert report.skipped == ()
    assert not any("nu_u_dot" in one or "eta" in one for one in names)
    assert {"nu_u: truth", "force: truth", "s: truth", "nu_dot: truth", "check_params"} <= names
    assert "tracking: bits, C and numpy" in names
    assert any("loop" in one for one in names) == (name == "lsf")
    assert {c.subject for c in report.checks} >= {"numpy f64", "C f64", "C f32"}


def test_the_table_of_checks_says_whose_they_are() -> None:
    assert all(set(of) <= set(CONTROLLERS) and of for _, _, of in PLAN)
    whole = {what: of for what, _, of in PLAN}
    assert whole["differences along the flow"] == ("gsmc", "reaching")
    assert whole["the loop that closes, in 50 digits"] == ("lsf",)
    assert sum(set(of) == set(CONTROLLERS) for of in whole.values()) == 7


@each_baseline
def test_no_mutant_that_moves_an_output_is_missed(name: str) -> None:
    """Of the law; the other routines are those of gsmc."""
    of = with_options(name, *EXTRAS) if name == "lsf" else BODIES[name]
    each = 480 if name == "pd_plus" else 24  # a choice of columns needs many axes
    routine, outcome = next(iter(outcomes(plant(of), each=each)))
    assert routine == "tracking"
    assert outcome is not None
    assert outcome.missed == ()
    assert outcome.tried > 700
    assert outcome.bound < LIMITS["mutant"].figure


def test_the_loop_of_the_printed_lsf_is_not_closed() -> None:
    printed, corrected = (plant(BODIES[name]) for name in ("lsf_printed", "lsf"))
    assert lsf_residual(corrected, 5, 1) < LIMITS["symbolic"].figure
    assert lsf_residual(printed, 5, 1) > 1e-3


def test_one_lsf_is_not_taken_for_the_other() -> None:
    """What is emitted for the one fails as the other."""
    names = ("lsf_printed", "lsf")
    for name, other in (names, names[::-1]):
        texts = pipeline.texts(replace(BODIES[name], targets=("numpy",)))
        wrong = replace(plant(BODIES[name]), controller=other)
        report = run(BODIES[name].name, texts, wrong, each=2)
        assert any("force: truth" in line for line in failures(report))


@each_baseline
def test_exchanged_gains_turn_the_suite_red(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    right = port.take_gains
    monkeypatch.setattr("derive.control.baseline.take_gains", lambda *given: right(*given)[::-1])
    assert failures(verified(BODIES[name], each=2)) != []


LINE = re.compile(r"^    ((?:nu_u|raw|crossing|wanted|force|s|given|ratio)(?:_\d)?) = (.*)$", re.M)


@each_baseline
def test_a_turned_sign_is_seen(name: str) -> None:
    """The numpy module alone, the first line of each step turned round."""
    texts = pipeline.texts(replace(BODIES[name], targets=("numpy",)))
    path = f"numpy/{BODIES[name].name}.py"
    law = texts[path][texts[path].index("def _law(") : texts[path].index("def _plant(")]
    found = {hit[1].rpartition("_")[0] or hit[1]: hit for hit in LINE.finditer(law)}
    lines = [hit for hit in found.values() if hit[2].count("(") == hit[2].count(")")]
    assert len(lines) >= 3
    for hit in lines:
        harmed = texts[path].replace(law, law.replace(hit[0], f"    {hit[1]} = -({hit[2]})"))
        assert failures(run(BODIES[name].name, {path: harmed}, plant(BODIES[name]), each=2)), hit[0]
