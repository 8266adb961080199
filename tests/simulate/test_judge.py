"""Verdicts on flights made up by hand: each can be had, and a bent flight changes it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace

import numpy as np
import pytest

from derive.comparison import Comparison
from derive.simulate.claim import CLAIMS, Claim, judged
from derive.simulate.flight import Flight
from derive.simulate.judge import (
    AT_ONE,
    AT_SOME,
    NOT,
    NOT_AT_ONE,
    PSI,
    REPRODUCED,
    VERDICTS,
    Finding,
    measured,
    order,
    search,
)
from derive.simulate.reading import settled_between, settling, swings, until
from derive.simulate.space import Array

T = np.linspace(0.0, 40.0, 801)


def falling(fall: float, start: float = 1.0, since: float = 0.0) -> Flight:
    """Nothing but a height that falls as exp(-fall t) from an instant on."""
    blank = {one.name: np.zeros(len(T)) for one in fields(Flight)}
    height = start * np.exp(-fall * np.maximum(T - since, 0.0))
    return Flight(**{**blank, "t": T, "height": height})


def three(*flights: Flight) -> dict[str, Flight]:
    return dict(zip(("gsmc", "lsf", "pd_plus"), flights, strict=True))


def times(*falls: float) -> Mapping[str, Flight]:
    return three(*(falling(fall) for fall in falls))


def test_settling_is_found_between_two_instants() -> None:
    found = settled_between(T, falling(0.7).height, np.array([1.0, 1e-3, 1e-9, 1e-13]))
    np.testing.assert_allclose(found[:3], -np.log([1.0, 1e-3, 1e-9]) / 0.7, atol=1e-12)
    assert np.isnan(found[3])


def test_what_rises_again_has_not_settled() -> None:
    values = np.where((T >= 20) & (T <= 20.01), 0.5, falling(1.0).height)
    one = falling(1.0)
    assert settling(one, values, 0.6) == pytest.approx(-np.log(0.6))
    late = settling(one, values, 0.1)
    assert late is not None
    assert 20.0 <= late <= 20.05
    assert settling(one, np.where(T[-1] == T, 1.0, values), 0.1) is None
    assert settling(one, np.where(T == 3.0, np.nan, values), 0.1) is None


def test_swings_of_rounding_are_not_counted() -> None:
    assert swings(np.array([1.0, 0.5, -1e-9, 1e-9, 0.1])) == 0
    assert swings(np.array([1.0, -0.5, -0.1, 0.2])) == 2
    assert swings(np.zeros(3)) == 0


def test_until_keeps_its_end() -> None:
    kept = until(falling(1.0), 30.0)
    assert kept.t[-1] == 30.0
    assert len(kept.height) == len(kept.t) == 601


@pytest.mark.parametrize(
    ("said", "falls", "verdict"),
    [
        ((10.0, 10.0, 20.0), (1.0, 1.0, 0.5), AT_ONE),
        ((10.0, 10.0, 12.0), (1.0, 1.0, 0.5), NOT_AT_ONE),
        ((10.0, 10.0, 90.0), (1.0, 1.0, 0.5), NOT),
        ((10.0, 10.0, 20.0), (0.0, 1.0, 0.5), NOT),
    ],
)
def test_a_threshold_is_searched(
    said: tuple[float, ...], falls: tuple[float, ...], verdict: str
) -> None:
    assert search(PSI, said, 0.5)(times(*falls)).verdict == verdict


def test_the_threshold_that_fits_best_is_told() -> None:
    found = search(PSI, (10.0, 10.0, 20.0), 0.5)(times(1.0, 1.0, 0.5))
    assert found.best == pytest.approx(np.exp(-10.0), rel=0.06)
    assert found.residual == pytest.approx(0.0, abs=0.06)
    assert found.least == pytest.approx(np.exp(-10.25), rel=0.06)
    assert found.most == pytest.approx(np.exp(-9.75), rel=0.06)
    assert "Ψ = 4.5e-05 (" in found.threshold


def test_a_gap_that_never_changes_is_reproduced() -> None:
    late = three(falling(1.0), falling(1.0), falling(1.0, since=5.0))
    gaps = search(PSI, (5.0,), 0.1, lambda found: (found[2] - found[0])[None, :])
    assert gaps(late).verdict == REPRODUCED


@pytest.mark.parametrize(
    ("last", "verdict"),
    [
        (falling(0.5), REPRODUCED),
        (falling(2.0, since=4.0), AT_SOME),
        (falling(2.0), NOT),
        (falling(0.0), NOT),
    ],
)
def test_an_order_is_judged_over_all_thresholds(last: Flight, verdict: str) -> None:
    assert order(PSI, ("pd_plus",))(three(falling(1.0), falling(1.0), last)).verdict == verdict


def test_how_many_thresholds_an_order_holds_at_is_told() -> None:
    late = three(falling(1.0), falling(1.0), falling(2.0, since=4.0))  # until both are at exp(-8)
    some = order(PSI, ("pd_plus",))(late)
    count = int((PSI.thresholds > np.exp(-8.0)).sum())
    assert some.measured.endswith(f"holds at {count} of 401 thresholds")
    every = order(PSI, ("pd_plus",))(three(falling(1.0), falling(1.0), falling(0.9)))
    assert every.measured.endswith("holds at all 401 thresholds")


def test_what_is_allowed_is_told_beside_what_it_is_off_by() -> None:
    found = search(PSI, (10.0, 10.0, 12.0), 0.25)(times(1.0, 1.0, 0.5))
    off = max(abs(x - said) for x, said in zip(found.numbers, (10, 10, 12), strict=True))
    assert found.measured.endswith(f" s, off by {off:.2f} s at most, 0.25 allowed")
    assert found.verdict == NOT_AT_ONE


@pytest.mark.parametrize(("holds", "verdict"), [(True, REPRODUCED), (False, NOT)])
def test_a_statement_without_threshold_holds_or_not(holds: bool, verdict: str) -> None:
    found = measured(lambda _: (holds, "so", (1.0,)))(times(1.0, 1.0, 1.0))
    assert found == Finding(verdict, "so", (1.0,))
    assert found.threshold == ""


def test_every_claim_of_the_paper_is_judged(compared: Comparison) -> None:
    assert [one.claim for one in compared.claims] == list(CLAIMS)
    assert len({claim.name for claim in CLAIMS}) == len(CLAIMS)
    for one in compared.claims:
        assert {one.printed.verdict, one.corrected.verdict} <= set(VERDICTS)
        assert one.printed.measured


EXPECTED = {
    "gamma": REPRODUCED, "equal energy": REPRODUCED, "convergence 1": AT_ONE,
    "10 s longer": AT_ONE, "last 1": REPRODUCED, "reaching": REPRODUCED,
    "oscillation": REPRODUCED, "following": REPRODUCED, "convergence 2": NOT_AT_ONE,
    "rate 2": NOT_AT_ONE, "together": AT_ONE, "5 s longer": AT_ONE, "5 s longer, rate": AT_ONE,
    "last 2": AT_SOME, "less energy": REPRODUCED, "delays": NOT_AT_ONE,
    "longest delay": REPRODUCED, "faster": REPRODUCED, "faster, rate": REPRODUCED,
    "more energy": REPRODUCED,
}  # fmt: skip
"""As the emitted code gives it, and scipy too: test_scenario holds the flights to its own."""


def test_the_paper_is_reproduced_as_far_as_it_is(compared: Comparison) -> None:
    assert {one.claim.name: one.printed.verdict for one in compared.claims} == EXPECTED
    corrected = {one.claim.name: one.corrected.verdict for one in compared.claims}
    assert corrected == {**EXPECTED, "equal energy": NOT, "together": NOT}


def slowed(flight: Flight, by: float) -> Flight:
    return replace(flight, t=flight.t * by)


def stronger(flight: Flight, by: float) -> Flight:
    return replace(flight, energy=flight.energy * by)


def still(flight: Flight) -> Flight:
    return replace(flight, s=np.abs(flight.s))


def shaken(flight: Flight) -> Flight:
    wave: Array = np.sin(3 * flight.t)[:, None] * 0.1
    return replace(flight, s=flight.s + wave)


BENT = [
    ("gamma", "pd_plus", lambda one: replace(one, s=one.s + 0.01 * one.nu_u)),
    ("equal energy", "gsmc", lambda one: stronger(one, 1.0002)),
    ("convergence 1", "pd_plus", lambda one: slowed(one, 0.8)),
    ("10 s longer", "gsmc", lambda one: slowed(one, 0.5)),
    ("last 1", "pd_plus", lambda one: slowed(one, 0.3)),
    ("reaching", "gsmc", shaken),
    ("oscillation", "lsf_printed", still),
    ("following", "pd_plus", shaken),
    ("last 2", "pd_plus", lambda one: slowed(one, 0.1)),
    ("together", "lsf_printed", lambda one: slowed(one, 0.5)),
    ("less energy", "gsmc", lambda one: stronger(one, 1.1)),
    ("delays", "lsf_printed", lambda one: slowed(one, 0.9)),
    ("longest delay", "lsf_printed", lambda one: slowed(one, 0.1)),
    ("faster", "gsmc", lambda one: slowed(one, 2.0)),
    ("faster, rate", "gsmc", lambda one: slowed(one, 2.0)),
    ("more energy", "gsmc", lambda one: stronger(one, 0.5)),
]


@pytest.mark.parametrize(("name", "controller", "bend"), BENT, ids=[name for name, *_ in BENT])
def test_a_bent_flight_changes_the_verdict(
    compared: Comparison, name: str, controller: str, bend: object
) -> None:
    claim: Claim = next(one for one in CLAIMS if one.name == name)
    flights = dict(compared.flights[claim.scenario])
    assert callable(bend)
    flights[controller] = bend(flights[controller])
    bent = next(one for one in judged({claim.scenario: flights}) if one.claim is claim)
    assert bent.printed.verdict != EXPECTED[name]
