"""What the commands make of the controllers that the paper compares with."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive import bundle, pipeline
from derive.explanation import explain
from derive.native.load import load_module
from derive.vehicle import InputError, load
from derive.verify.proof.report import ProofReport, Row

ROOT = Path(__file__).parents[1]
NAMES = ("lsf_printed", "lsf", "pd_plus")
BODIES = {name: load(ROOT / "vehicles" / f"paper_so3_{name}.toml") for name in NAMES}
each_baseline = pytest.mark.parametrize("name", NAMES)


@each_baseline
def test_the_vehicles_are_the_papers_body_with_its_gains(name: str) -> None:
    paper, one = load(ROOT / "vehicles" / "paper_so3.toml"), BODIES[name]
    same = ("group", "inertia", "scalars", "targets", "options")
    assert all(getattr(one, field) == getattr(paper, field) for field in same)
    gains = {gain: float(value) for gain, value in one.gains}
    assert gains == (
        {"k_R": 9.25, "k_Omega": 18.5} if name == "pd_plus" else {"k": 1, "kappa": 0.5}
    )
    first, second = gains.values()
    assert (first / second if name == "pd_plus" else second / first) == 0.5  # gamma_i of the paper


@each_baseline
def test_a_command_has_no_rate(name: str) -> None:
    module = load_module(
        ROOT / "generated" / BODIES[name].name / "numpy" / f"{BODIES[name].name}.py"
    )
    assert module.Command._fields == ("force", "s", "nu_u", "status")
    assert "Force, sliding variable and attitude error, (..., 3) each" in module.Command.__doc__
    assert not hasattr(module, "reaching")
    header = ROOT / f"generated/{BODIES[name].name}/c/include/{BODIES[name].name}_f64.h"
    assert "nu_u_dot" not in header.read_text()
    command = module.control(np.eye(3), np.ones(3), np.eye(3), np.ones(3), np.zeros(3))
    assert [x.shape for x in command] == [(3,), (3,), (3,), ()]
    np.testing.assert_array_equal(command.s, 0)


def test_pd_plus_is_flagged_at_the_cut_and_lsf_is_smooth_there() -> None:
    half_turn, still = np.diag([-1.0, 1.0, -1.0]), np.zeros(3)
    for name, status in (("lsf_printed", 0), ("lsf", 0), ("pd_plus", 2)):
        place = ROOT / "generated" / BODIES[name].name / "numpy" / f"{BODIES[name].name}.py"
        command = load_module(place).control(half_turn, still, np.eye(3), still, still)
        assert command.status == status
        assert command.nu_u.tolist() == ([0, 1, 0] if status else [0, 0, 0])


@each_baseline
def test_the_bundle_needs_a_sliding_rate(name: str) -> None:
    with pytest.raises(InputError) as caught:
        bundle.of(BODIES[name])
    assert (caught.value.key, caught.value.found) == ("controller", f"the string '{name}'")
    assert caught.value.expected.startswith("one of gsmc, reaching")


@each_baseline
def test_prove_judges_group_and_inertia_and_says_whose_the_theorems_are(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: dict[str, Any] = {}

    def proved(group: Any, inertia: Any, progress: Any, **more: Any) -> ProofReport:
        asked.update(more, group=group.name, inertia=inertia)
        row = Row("a", "b", "c", "d", 0.0, (), 2, ())
        return ProofReport(group.name, (row,), ("one thing",))

    monkeypatch.setattr("derive.verify.proof.run.prove", proved)
    report = pipeline.prove(BODIES[name], lambda _: None)
    assert report.ok
    assert report.skipped[0] == "one thing"
    assert f"the loop of {name}: the theorems are of gsmc" in report.table()
    assert asked == {"group": "SO3", "inertia": BODIES[name].inertia}  # no law of the vehicle's


@pytest.mark.parametrize(
    ("name", "equation", "steps", "whole"),
    [
        ("lsf_printed", "Ctrls2", "crossing", "- ad*(nu) I nu - ad(nu) nu_r"),
        ("lsf", "Ctrls2", "crossing", "- ad*(nu) I nu + I ad(nu) nu_r"),
        ("pd_plus", "s3", "s", "force = -k_Omega s + I Ad(g_e^-1) nu_r_dot - ad*(eta) I eta"),
    ],
)
def test_explain_says_the_formula_as_the_paper_does(
    name: str, equation: str, steps: str, whole: str
) -> None:
    text = explain(BODIES[name], None, "text", routine="tracking", equation=equation)
    assert f". {steps}\n" in text
    assert whole in " ".join(text.split())


@pytest.mark.parametrize(("form", "letters"), [("latex", r"\kappa"), ("html", "Ω")])
def test_gains_are_greek_letters(form: str, letters: str) -> None:
    name = "lsf" if form == "latex" else "pd_plus"
    assert letters in explain(BODIES[name], None, form, routine="tracking")
