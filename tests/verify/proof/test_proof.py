"""The paper's statements are proved, their mutants rejected, its mistakes shown."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy
from scipy.linalg import expm

from derive import cli
from derive.lie.catalogue import GROUPS
from derive.verify.proof import mistake_loop
from derive.verify.proof import run as proof
from derive.verify.proof.report import ENOUGH, ProofReport, Row
from derive.verify.proof.run import STATEMENTS, Subject, concrete, generic, prove
from derive.verify.proof.statement import Statement, vanish
from tests.command import refused

DOCS = Path(__file__).parents[3] / "docs" / "paper.md"
INERTIA = np.array([[3.6046, -0.0706, 0.1491], [-0.0706, 8.6868, 0.0449], [0.1491, 0.0449, 9.3484]])
BODY = tuple(tuple(Fraction(str(entry)) for entry in row) for row in INERTIA)

every_statement = pytest.mark.parametrize("statement", STATEMENTS, ids=lambda one: one.name)
paper = [statement for statement in STATEMENTS if statement.kind == "paper"]
quick = [statement for statement in STATEMENTS if statement.name.startswith("Lemma 1")]


@cache
def subjects(kind: str) -> list[Subject]:
    """Generic ones, and SE2 for what is proved of one group at a time."""
    if kind in (every := generic()):
        return every[kind]
    return concrete(GROUPS["SE2"], None, options=("external", "momentum"))[0][kind]


@every_statement
def test_a_statement_is_proved_and_its_mutants_rejected_for_any_group(statement: Statement) -> None:
    assert len(statement.mutants) >= ENOUGH
    for name, subject, _ in subjects(statement.kind):
        facts, survivors = statement.judge(subject)
        assert facts
        assert [fact.what for fact in facts if not fact.holds] == [], name
        assert survivors == (), name


@every_statement
def test_a_mutant_in_the_place_of_a_statement_is_a_failure(statement: Statement) -> None:
    subject = subjects(statement.kind)[0].value
    for what, claim in statement.mutants.items():
        facts, _ = replace(statement, claim=claim).judge(subject)
        assert not all(fact.holds for fact in facts), what


@pytest.mark.parametrize("group", ["SO3", "S3"])
def test_every_statement_holds_for_the_papers_body(group: str) -> None:
    own, skipped = concrete(GROUPS[group], BODY, law="log")
    assert skipped == ()
    for statement in STATEMENTS:
        for subject in own.get(statement.kind, []):
            facts, _ = statement.judge(subject.value)
            assert [fact.what for fact in facts if not fact.holds] == [], statement.name


def test_without_a_vehicle_every_logarithm_of_the_catalogue_is_proved() -> None:
    report = prove(None, statements=[one for one in STATEMENTS if one.kind == "logarithm"])
    assert [row.of for row in report.rows] == list(GROUPS)
    assert report.ok


def test_a_group_with_a_wrong_Ad_is_found_out() -> None:
    wrong = replace(GROUPS["SO3"], short_Ad=lambda rotation: rotation.T)
    report = prove(wrong, statements=[one for one in STATEMENTS if one.kind == "motion"])
    assert [row.of for row in report.rows if row.broken] == ["SO3"]
    assert not report.ok


def test_a_group_with_a_wrong_inverse_is_not_decided() -> None:
    wrong = replace(GROUPS["SO3"], inverse=lambda rotation: rotation)
    own, skipped = concrete(wrong, None)
    assert sorted(own) == ["algebra", "inverse"]
    assert "SO3" in skipped[0]


@pytest.mark.parametrize(
    ("damage", "told"),
    [
        (lambda one: replace(one, claim=one.mutants["without nu_u(g2)"]), "FAILED: "),
        (lambda one: replace(one, mutants={**one.mutants, "none": one.claim}), "not rejected: "),
        (lambda one: replace(one, mutants={}), "fewer than 2 mutants"),
    ],
)
def test_a_report_is_not_ok(damage: Callable[[Statement], Statement], told: str) -> None:
    assert prove(None, statements=quick).ok
    report = prove(None, statements=[damage(one) for one in quick])
    assert not report.ok
    assert told in report.table()
    assert json.loads(report.as_json())["ok"] is False


def test_no_rows_are_no_proof() -> None:
    assert not ProofReport("nothing", ()).ok


def test_a_mutant_rejected_on_one_subject_may_be_true_on_another() -> None:
    def row(of: str, *survivors: str) -> Row:
        return Row("x", "y", of, "z", 0.0, (), 2, survivors)

    assert ProofReport("v", (row("n = 3"), row("R3", "the sign of ad*"))).ok
    assert not ProofReport("v", (row("n = 3", "a"), row("R3", "a"))).ok


@pytest.mark.parametrize("value", [0.0, sympy.Float(0), mpmath.mpf(0), sympy.Symbol("x") * 0.5])
def test_an_inexact_number_proves_nothing(value: object) -> None:
    with pytest.raises(TypeError, match="not exact"):
        vanish("x", [value])


def test_exact_zeros_vanish_and_others_do_not() -> None:
    x = sympy.Symbol("x")
    assert vanish("", [0, Fraction(0), (x + 1) ** 2 - x**2 - 2 * x - 1]).holds
    assert not vanish("", [0, Fraction(1, 10**30)]).holds


def found(statement: Statement) -> str:
    """What a counterexample shows, in words."""
    return "\n".join(fact.shown for fact in statement.judge(None)[0] if fact.shown)


@pytest.mark.parametrize("statement", paper, ids=lambda one: one.name)
def test_a_mistake_is_written_up_with_what_is_computed(statement: Statement) -> None:
    assert found(statement)
    for line in found(statement).splitlines():
        assert f"\n{line}\n" in DOCS.read_text(encoding="utf-8")


def hat(x: object) -> np.ndarray:
    a, b, c = np.asarray(x)
    return np.array([[0, -c, b], [c, 0, -a], [-b, a, 0]])


@pytest.mark.parametrize("speed", [0.1, 20.0])
def test_the_slowest_mode_of_F_2_is_that_of_differences_in_numpy(speed: float) -> None:
    omega_r = np.array([0, speed, 0])

    def rates(state: np.ndarray) -> np.ndarray:
        y, d = state[:3], state[3:]
        R, omega = expm(hat(y)), omega_r + d  # R_r = 1 at this instant
        off = R.T @ np.array([(R - R.T)[2, 1], (R - R.T)[0, 2], (R - R.T)[1, 0]])
        feedforward = -np.cross(INERTIA @ omega, omega) - np.cross(omega, omega_r)
        torque = feedforward - INERTIA @ (d + 0.5 * off)
        spin = np.cross(INERTIA @ omega, omega) + torque
        return np.concatenate([d - np.cross(omega_r, y), np.linalg.solve(INERTIA, spin)])

    columns = [(rates(h) - rates(-h)) / 2e-5 for h in 1e-5 * np.eye(6)]
    slowest = max(np.linalg.eigvals(np.array(columns).T).real)
    shown = mistake_loop._slowest(mistake_loop.printed, sympy.Rational(str(speed)))
    assert slowest == pytest.approx(float(shown), rel=1e-6)


def test_W_rises_by_what_numpy_says() -> None:
    (text,) = (found(one) for one in paper if "angle pi" in one.name and "W" in one.name)
    assert "axis (3/5, 4/5, 0), Omega_e = (2, -1, -2)" in text
    axis, rate = np.array([0.6, 0.8, 0]), np.array([2.0, -1, -2])
    assert axis @ rate > 0
    behind, before = (rate + side * 0.5 * np.pi * axis for side in (-1, 1))
    rise = (behind @ INERTIA @ behind - before @ INERTIA @ before) / 2
    assert float(text.split("rises by ")[1].split()[0]) == pytest.approx(rise, rel=1e-3)


def test_prove_gives_table_report_and_exit_code(
    body: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(proof, "STATEMENTS", quick)
    place = body.parent / "proof.json"
    assert cli.run(["prove"]) == 0
    assert "any group: statements of the paper" in capsys.readouterr().out
    assert cli.run(["prove", str(body), "--json", str(place)]) == 0
    assert "SO3: statements of the paper" in capsys.readouterr().out
    assert [row["of"] for row in json.loads(place.read_text())["rows"]] == ["any group", "SO3"]
    assert cli.run(["prove", "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["ok"] is True
    broken = [replace(one, claim=one.mutants["without nu_u(g2)"]) for one in quick]
    monkeypatch.setattr(proof, "STATEMENTS", broken)
    assert cli.run(["prove", str(body)]) == 1
    assert "FAILED: " in capsys.readouterr().out


def test_prove_refuses_a_bad_vehicle(body: Path) -> None:
    assert "no such file" in refused(body.parent, "prove", "absent.toml")
    body.write_text(body.read_text().replace('group = "SO3"', 'group = "SO4"'))
    assert "group" in refused(body.parent, "prove", body.name)
