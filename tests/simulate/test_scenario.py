"""The paper's scenarios against an integration that shares no line with ours."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from derive.comparison import Comparison
from derive.simulate.scenario import ENTRANTS, FLOWN, R_312, SCENARIOS, differences
from tests.simulate import attitude
from tests.simulate.attitude import LAWS, Array

INSTANTS = (1.0, 5.0, 10.0, 20.0)
TURNS = {1: -0.428, 2: -0.01, 3: -0.99}
FAR = [(1, name) for name in LAWS] + [(2, "gsmc"), (3, "gsmc"), (3, "pd_plus")]


@cache
def truth(number: int, controller: str) -> tuple[Array, Array, Array]:
    return attitude.flown(LAWS[controller], TURNS[number], INSTANTS)


@pytest.mark.parametrize(("number", "controller"), FAR)
def test_a_scenario_is_what_another_integrator_finds(
    compared: Comparison, number: int, controller: str
) -> None:
    flight = compared.flights[number][controller]
    at = np.searchsorted(flight.t, np.array(INSTANTS) - 1e-9)
    np.testing.assert_allclose(flight.t[at], INSTANTS, rtol=0, atol=1e-12)
    R, Omega, energy = truth(number, controller)
    np.testing.assert_allclose(flight.g[at].reshape(-1, 3, 3), R, rtol=0, atol=1e-9)
    np.testing.assert_allclose(flight.nu[at], Omega, rtol=0, atol=1e-9)
    np.testing.assert_allclose(flight.energy[at], energy, rtol=1e-8)


def test_all_of_the_paper_is_flown(compared: Comparison) -> None:
    assert {one.number: one.turns for one in SCENARIOS.values()} == TURNS
    for each in compared.flights.values():
        assert list(each) == list(ENTRANTS) == list(LAWS)
        assert all(one.t[-1] == pytest.approx(FLOWN) for one in each.values())
    assert compared.ok
    assert compared.differences == []


def test_the_energies_of_scenario_1_agree_as_printed(compared: Comparison) -> None:
    flights = compared.flights[1]
    found = {name: float(np.interp(30.0, one.t, one.energy)) for name, one in flights.items()}
    three = [found[name] for name in ("gsmc", "lsf_printed", "pd_plus")]
    assert max(three) / min(three) - 1 < 1e-4
    assert found["lsf"] / found["gsmc"] - 1 > 0.01


@pytest.mark.parametrize("angles", [(0.3, -0.7, 1.1), (0.0, -0.428 * np.pi, 0.0)])
def test_the_sequence_is_shusters(angles: tuple[float, float, float]) -> None:
    np.testing.assert_allclose(R_312(*angles), attitude.euler_312(*angles), rtol=0, atol=1e-15)


def test_the_reference_keeps_its_rate(compared: Comparison) -> None:
    flight = compared.flights[1]["gsmc"]
    at = np.searchsorted(flight.t, np.array(INSTANTS) - 1e-9)
    expected = np.stack([attitude.reference(t) for t in INSTANTS])
    np.testing.assert_allclose(flight.g_r[at].reshape(-1, 3, 3), expected, rtol=0, atol=1e-12)


def test_what_is_not_the_papers_is_told(compared: Comparison) -> None:
    from dataclasses import replace

    crafts = compared.crafts
    other = replace(crafts[0], inertia=(3.0, *crafts[0].inertia[1:]), gains=(("lambda", 1.0),))
    assert differences([other, *crafts[1:]]) == ["inertia", "gains of gsmc"]
    assert differences([replace(crafts[0], law="mrp")]) == ["law of gsmc"]
