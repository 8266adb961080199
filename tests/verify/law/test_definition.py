"""The Definition of a kinematic law: the table that has to come out, and laws that break it."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy
from sympy import Matrix, diag

from derive.control.caution import CAUTIONS, cautions
from derive.control.kinematic import LAWS, laws_of
from derive.control.law import KinematicLaw, Written
from derive.control.quaternion_law import Quaternion
from derive.lie.catalogue import GROUPS, named
from derive.lie.group import Group
from derive.lie.kernel import K
from derive.verify.law import consequence, factor
from derive.verify.law.definition import judge
from derive.verify.law.report import report
from derive.verify.law.verdict import Verdict
from tests.own import GALILEAN, GL2, HEISENBERG, POSE, SL2, SO4
from tests.verdicts import catalogue, verdict

PI, NONE = "rotations by pi", ""
INF = np.inf


def cot(x: Any) -> Any:
    return np.cos(x) / np.sin(x)


PAPER: dict[tuple[str, str], tuple[str, dict[str, float], str, Callable[[Any], Any]]] = {
    ("SO3", "log"): (PI, {PI: 2 * np.pi}, NONE, lambda u: u * cot(u / 2)),
    ("SO3", "lee"): (PI, {PI: 2}, NONE, lambda u: np.cos(u / 2) ** 2),
    ("SO3", "skew"): (NONE, {}, PI, lambda u: np.sin(2 * u) * cot(u / 2) / 2),
    ("SO3", "gibbs"): (PI, {PI: INF}, NONE, lambda u: np.tan(u) * cot(u / 2)),
    ("SO3", "mrp"): (PI, {PI: 8}, NONE, lambda u: 2 + 0 * u),
    ("S3", "half_log"): ("-i", {"-i": 2 * np.pi}, NONE, lambda u: u / 4 * cot(u / 2)),
    ("S3", "vec"): (NONE, {}, "-i", lambda u: (1 + np.cos(u)) / 2),
    ("S3", "sign_vec"): (
        NONE,
        {"q0 = 0": 2},
        "-i",
        lambda u: np.sign(np.cos(u)) * (1 + np.cos(u)) / 4,
    ),
}
"""Where (ii) does not hold, jumps, where the law vanishes, y for V_1 or V_2 of half the angle."""


def test_every_law_is_judged_and_zero_at_the_identity() -> None:
    assert [(one.group, one.law) for one in catalogue().verdicts] == list(LAWS)
    assert all(one.is_zero_at_e for one in catalogue().verdicts)
    assert catalogue().ok


@pytest.mark.parametrize(("group", "law"), PAPER, ids=map("-".join, PAPER))
def test_the_table_comes_out(group: str, law: str) -> None:
    off, jumps, rest, y = PAPER[group, law]
    found = verdict(group, law)
    assert "".join((*found.odd.fails, *found.odd.undefined)) == off
    assert bool(found.odd.example) == bool(found.odd.fails)
    assert {one.place: pytest.approx(one.size, abs=1e-6) for one in found.jumps} == jumps
    assert "".join(one.place for one in found.rests) == rest
    first = found.falls[0]
    assert first.morse == {"SO3": "V_1", "S3": "V_2"}[group]
    assert first.holds == (law != "sign_vec")
    stated = factor.claimed(group, law, first.morse)
    assert stated is not None
    phi = np.linspace(0.01, (np.pi if group == "SO3" else 2 * np.pi) - 0.01, 301)
    np.testing.assert_allclose(stated.of_angle(phi), y(phi / 2), rtol=1e-9, atol=1e-12)
    assert first.misfit < 1e-6
    assert first.factor == stated.text
    assert first.samples > 300


def test_equilibria_are_isolated_or_not() -> None:
    sizes = {("SO3", "skew"): 2, ("SE2", "skew"): 2, ("SE3", "skew"): 4, ("SE23", "skew"): 6,
             ("SO2", "skew"): 0, ("S3", "vec"): 0, ("S3", "sign_vec"): 0}  # fmt: skip
    found = {(one.group, one.law): [rest.dimension for rest in one.rests]
             for one in catalogue().verdicts if one.rests}  # fmt: skip
    assert found == {key: [size] for key, size in sizes.items()}
    assert [one.repels for one in verdict("S3", "sign_vec").rests] == [False]
    assert [one.repels for one in verdict("S3", "vec").rests] == [True]
    assert verdict("SO3", "skew").rests[0].is_every
    assert not verdict("SE3", "skew").rests[0].is_every


def test_v_rises_for_sign_vec_on_the_far_half_alone() -> None:
    rises = verdict("S3", "sign_vec").falls[0].rises
    assert rises == pytest.approx((np.pi, 2 * np.pi), abs=0.05)
    assert rises[0] > np.pi
    assert "V'/V = 0." in verdict("S3", "sign_vec").falls[0].example


def test_what_unwinds() -> None:
    found = [(one.group, one.law) for one in catalogue().verdicts if one.unwinds]
    assert found == [("S3", law) for law in ("log", "half_log", "mrp", "vec", "cayley")]


def test_v_square_of_log_falls_by_two_on_every_group() -> None:
    for group in GROUPS:
        one = next(f for f in verdict(group, "log").falls if f.morse == "|log|^2/2")
        assert (one.low, one.high) == pytest.approx((2, 2))
        assert one.factor == "2"
        assert one.misfit < 1e-6


FACTORS = [
    (table, morse, law)
    for table in ("SO3", "S3")
    for morse, laws in (factor._TURN if table == "SO3" else factor._SPHERE).items()
    for law in laws
]


@pytest.mark.parametrize(("group", "morse", "law"), FACTORS)
def test_the_text_of_a_factor_is_its_function(group: str, morse: str, law: str) -> None:
    stated = factor.claimed(group, law, morse)
    assert stated is not None
    for angle in (0.3, 1.1, 2.9) + ((3.9, 6.1) if group == "S3" else ()):
        names = {sympy.Symbol("phi"): angle, sympy.Symbol("theta"): angle / 2}
        wanted = float(sympy.sympify(stated.text).subs(names))
        assert stated.of_angle(np.array([angle]))[0] == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize(("group", "law"), LAWS, ids=map("-".join, LAWS))
def test_the_warnings_are_what_is_found(group: str, law: str) -> None:
    peers = [one for one in catalogue().verdicts if one.group == group]
    found = consequence.cautions(verdict(group, law), peers)
    stated = cautions(GROUPS[group], law, laws_of(GROUPS[group]))
    assert list(stated) == found


def test_the_warnings_know_no_other_law() -> None:
    assert set(CAUTIONS) < set(LAWS)
    assert all(one.instead in (*laws_of(GROUPS[group]), "") for (group, _), one in CAUTIONS.items())


@pytest.mark.parametrize("name", ["SO3 x R3", "S3 x R3", "SO3 x S3"])
def test_a_product_is_warned_of_where_it_fails(name: str) -> None:
    group = named(name)
    verdicts = report([group]).verdicts
    for one in verdicts:
        found = consequence.cautions(one, verdicts)
        stated = cautions(group, one.law, laws_of(group))
        if name == "SO3 x S3":  # where no law is free of poles, that of one factor is told
            assert bool(stated) == (one.law == "cayley")
            assert not found
        else:
            assert [told.endswith(f" (factor 1, {name[:-5]})") for told in stated] == [
                True for _ in found
            ]


def _false(law: KinematicLaw, write: Any = None, **claims: Any) -> KinematicLaw:
    return replace(law, write=write or law.write, **claims)


def _w(let: Any, error: Any) -> Any:
    return error.w


SO3_LOG, GIBBS = LAWS["SO3", "log"], LAWS["SO3", "gibbs"]


@pytest.mark.parametrize(
    ("group", "law", "told"),
    [
        ("SO3", _false(SO3_LOG, is_pole=True), "states a pole, and the law only jumps"),
        ("SO3", _false(GIBBS, is_pole=False), "states no pole"),
        (
            "SO3",
            _false(SO3_LOG, Quaternion(lambda let, error: K(error.w), None)),
            "where its clearance",
        ),
        (
            "SO3",
            _false(SO3_LOG, Quaternion(lambda let, error: K(error.w) / 2, _w)),
            "y = phi/2*cot",
        ),
        ("S3", _false(LAWS["S3", "log"], is_pole=False), "states no pole"),
    ],
)
def test_a_false_claim_is_a_contradiction(group: str, law: KinematicLaw, told: str) -> None:
    found = judge(GROUPS[group], law)
    assert any(told in one for one in found.contradictions)
    assert not report_of(found).ok
    assert "CONTRADICTION" in report_of(found).table()


def report_of(one: Verdict) -> Any:
    return replace(catalogue(), verdicts=(one,))


def _value(value: Callable[[Any], Any]) -> KinematicLaw:
    """A law of SO3 by a formula in R."""

    def write(let: Any, group: Any, g: Matrix) -> Written:
        return Written(value(g.reshape(3, 3)), lambda let, nu: nu, sympy.S.One)

    return KinematicLaw("mine", write, "for a test")


def _odd_part(a: Matrix) -> Matrix:
    return Matrix([a[2, 1] - a[1, 2], a[0, 2] - a[2, 0], a[1, 0] - a[0, 1]]) / 2


def test_a_law_that_is_not_zero_at_the_identity() -> None:
    found = judge(GROUPS["SO3"], _value(lambda R: _odd_part(R) + Matrix([0, 0, R[0, 0]])))
    assert not found.is_zero_at_e
    assert "NO" in report_of(found).table()


def test_weighted_traces_are_not_odd() -> None:
    """(P R - R^T P)^vee with distinct weights violates (ii); with equal ones it does not."""
    P = diag(1, 2, 3)
    found = judge(GROUPS["SO3"], _value(lambda R: _odd_part(P * R - R.T * P) / 2))
    assert "general position" in found.odd.fails
    assert "some samples" in found.odd.fails
    assert found.odd.example.startswith("g = (")
    assert not judge(GROUPS["SO3"], _value(_odd_part)).odd.fails


def test_a_law_that_leads_away() -> None:
    found = judge(GROUPS["SO3"], _value(lambda R: -_odd_part(R)))
    assert found.rises
    assert found.falls[0].high < 0
    assert "rise" in consequence.cautions(found, [found])[-1]


def test_groups_of_ones_own() -> None:
    skew, cayley = (judge(SL2, law) for law in laws_of(SL2).values())
    place = "elements with det(g + 1) = 0"
    assert [(one.place, one.dimension, one.repels) for one in skew.rests] == [(place, 0, True)]
    assert [(one.place, one.size) for one in cayley.jumps] == [(place, INF)]
    assert skew.odd.is_exact
    assert not skew.odd.fails
    log = judge(HEISENBERG, laws_of(HEISENBERG)["log"])
    assert not (log.jumps)
    assert not (log.rests)
    assert not (log.odd.fails)
    assert not (log.rises)


def test_a_pole_is_found_where_no_curve_from_the_identity_leads() -> None:
    cayley = judge(GL2, laws_of(GL2)["cayley"])
    assert [(one.place, one.size) for one in cayley.jumps] == [
        ("elements with det(g + 1) = 0", INF)
    ]


@pytest.mark.parametrize("group", [SO4, POSE, HEISENBERG, SL2, GALILEAN], ids=lambda one: one.name)
def test_units_are_words_and_change_no_verdict(group: Group) -> None:
    """Angular or not, whatever the order of the basis."""
    plain = judge(group, laws_of(group)["skew"])
    for unit in ("rad/s", "m/s"):
        other = replace(group, units=(unit,) * group.dim)
        assert judge(other, laws_of(other)["skew"]) == plain


def test_a_pole_that_is_stated_has_to_be_found() -> None:
    law = replace(laws_of(GROUPS["SO3"])["skew"], is_pole=True)
    told = judge(GROUPS["SO3"], law).contradictions
    assert told == ("the record states a pole, and none is found",)
