"""Every statement on every group: proved, and its mutants rejected but for those that are true."""

from __future__ import annotations

from dataclasses import fields, replace

import pytest
from sympy import Matrix

from derive.control.kinematic import LAWS, laws_of
from derive.control.law import Written
from derive.lie.catalogue import GROUPS
from derive.lie.cover import Let
from derive.lie.group import Group
from derive.verify.proof import emitted, loop
from derive.verify.proof.emitted import Lawful
from derive.verify.proof.loop import Steered
from derive.verify.proof.run import STATEMENTS, concrete, prove
from tests.verify.groups import COMMUTING, EVERY

OPTIONS = ("external", "momentum")

TRUE_WHERE_ALL_COMMUTES = {
    "the sign of ad*", "ad*_y I x", "I ad_x y", "without the bracket", "not symmetrised",
    "ad*_nu I x for ad*_x I nu", "momentum left out", "the sign of momentum",
    "momentum left out of the plant", "without ad(nu_e) eta", "the sign of ad",
    "ad(nu_e) nu_r, not carried", "ad* for ad", "nu as a spatial velocity",
    "1 + z/2 for z/(1 - e^-z)", "nu itself", "f(-z)", "twice phi^2",
    "force_L(g, nu) as it is",
}  # fmt: skip
"""Mutants that only differ by a bracket, on a group whose elements commute."""

TRUE = {
    "Heisenberg": {
        "1 + z/2 for z/(1 - e^-z)",  # ad^2 = 0
        "twice phi^2",  # nothing turns
        "ad(nu_e) nu_r, not carried",  # brackets are in the centre, which nothing carries
    },
    "SO3": {"ad* for ad"},  # ad_x is antisymmetric, and so is ad*_x
    "S3": {"ad* for ad"},
    "S3 x R2": {"ad* for ad"},
}
"""Further mutants that are true, and why."""


def true_on(group: Group) -> set[str]:
    commutes = not any(map(any, group.structure))
    return TRUE.get(group.name, set()) | (TRUE_WHERE_ALL_COMMUTES if commutes else set())


@pytest.mark.parametrize("name", EVERY)
def test_every_statement_holds_and_its_mutants_do_not(name: str) -> None:
    own, skipped = concrete(EVERY[name], None, options=OPTIONS)
    assert {"algebra", "tangent", "motion", "law", "vehicle", "external"} <= own.keys()
    assert ("closure" in own) == ("momentum" in own) == (name not in COMMUTING)
    assert bool(skipped) == (name in COMMUTING)
    assert ("logarithm" in own) == ("log" in laws_of(EVERY[name]))
    for statement in STATEMENTS:
        for subject in own.get(statement.kind, []):
            facts, survivors = statement.judge(subject.value)
            assert [fact.what for fact in facts if not fact.holds] == [], statement.name
            of = subject.value if statement.kind == "spectrum" else EVERY[name]
            assert set(survivors) <= true_on(of), statement.name


@pytest.mark.parametrize(("group", "law"), [*LAWS, ("SL2", "skew"), ("SL2", "cayley")])
def test_the_rate_of_every_law_is_its_differential(group: str, law: str) -> None:
    one = Lawful(EVERY[group], laws_of(EVERY[group])[law])
    (statement,) = (one for one in emitted.STATEMENTS if one.kind == "law")
    facts, survivors = statement.judge(one)
    assert len(facts) == emitted.COUNT
    assert all(fact.holds for fact in facts)
    assert survivors == () or group in COMMUTING


@pytest.mark.parametrize(
    ("group", "law"), [("SO3", "gibbs"), ("S3", "half_log"), ("SE2", "cayley")]
)
def test_the_loop_of_other_laws_closes(group: str, law: str) -> None:
    vehicle = Steered(GROUPS[group], laws_of(GROUPS[group])[law], None, OPTIONS)
    for statement in loop.STATEMENTS:
        facts, survivors = statement.judge(vehicle)
        assert len(facts) == 4
        assert all(fact.holds for fact in facts)
        assert survivors == ()


def test_without_the_option_nothing_is_said_of_wheels() -> None:
    own, _ = concrete(GROUPS["SO3"], None, options=("external",))
    assert "external" in own
    assert "momentum" not in own


LOGS = [name for name, group in EVERY.items() if "log" in laws_of(group)]


@pytest.mark.parametrize("name", LOGS)
def test_a_wrong_logarithm_in_the_code_is_found_out(name: str) -> None:
    (statement,) = (one for one in emitted.STATEMENTS if one.kind == "logarithm")
    law = laws_of(EVERY[name])["log"]

    def write(let: Let, group: Group, g_e: Matrix) -> Written:
        found = law.write(let, group, g_e)
        last = Matrix([0] * (group.dim - 1) + [1])
        return replace(found, rate=lambda let, nu: found.rate(let, nu) + nu[-1] / 10**9 * last)

    facts, _ = statement.judge(Lawful(EVERY[name], replace(law, write=write)))
    assert [fact.holds for fact in facts] == [True, False] * emitted.COUNT


class Backwards(Group):
    """A group whose bracket has the wrong sign."""

    def ad(self, x: Matrix) -> Matrix:
        return -super().ad(x)


def test_a_group_with_a_wrong_bracket_is_found_out() -> None:
    right = GROUPS["SE2"]
    wrong = Backwards(**{field.name: getattr(right, field.name) for field in fields(right)})
    about = [one for one in STATEMENTS if one.kind in ("motion", "law", "vehicle")]
    report = prove(wrong, statements=about)
    assert [row.of for row in report.rows if row.broken] == ["SE2", "SE2, log", "SE2, log"]
    assert not report.ok


@pytest.mark.parametrize("name", ["R3", "SO2", "Heisenberg", "SL2", "SE2"])
def test_a_false_version_that_is_true_on_a_group_is_rejected_on_another(name: str) -> None:
    about = [one for one in STATEMENTS if one.kind in ("logarithm", "spectrum", "law", "motion")]
    report = prove(EVERY[name], statements=about)
    assert report.missed == ()
    assert report.ok
    of = {row.of for row in report.rows}
    assert ("SE2, log" in of, "SE2" in of) == (True, "log" in laws_of(EVERY[name]))
