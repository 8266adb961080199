"""scenarioN.json: plain, whole, and its numbers those of the flights."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from derive.comparison import Comparison
from derive.simulate.claim import CLAIMS
from derive.simulate.digest import SETTLED, figures

SIZES = {"g": 9, "nu": 3, "g_r": 9, "s": 3, "force": 3}


def refuse(word: str) -> float:
    raise AssertionError(word)


def read(compared: Comparison, number: int) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(compared.as_json(number), parse_constant=refuse)
    return found


@pytest.mark.parametrize("number", [1, 2, 3])
def test_the_file_holds_what_it_promises(compared: Comparison, number: int) -> None:
    found = read(compared, number)
    assert found["schema"] == 1
    assert (found["scenario"], found["vehicle"], found["backend"]) == (number, "paper_so3", "f64")
    assert found["differs_from_paper"] == []
    assert list(found["controllers"]) == ["gsmc", "lsf_printed", "lsf", "pd_plus"]
    told = [one["name"] for one in found["claims"]]
    assert told == [claim.name for claim in CLAIMS if claim.scenario == number]
    for one in found["controllers"].values():
        assert set(one) == {"title", "law", "gains", "energy", "settled", "peak", "invariants",
                            "trajectory"}  # fmt: skip
        assert set(one["peak"]) == {"force", "height", "rate_error"}
        kept = one["trajectory"]
        rows = len(kept["t"])
        assert 100 < rows <= 601
        assert (kept["t"][0], kept["t"][-1]) == (0.0, pytest.approx(30.0, abs=1e-12))
        assert all(np.shape(kept[name]) == (rows, size) for name, size in SIZES.items())
        assert np.shape(kept["height"]) == (rows,)


def test_numbers_are_kept_to_the_last_bit(compared: Comparison) -> None:
    kept = read(compared, 1)["controllers"]["pd_plus"]["trajectory"]
    flight = compared.flights[1]["pd_plus"]
    at = np.searchsorted(flight.t, np.array(kept["t"]))
    for name in (*SIZES, "t", "height"):
        np.testing.assert_array_equal(np.array(kept[name]), getattr(flight, name)[at])


def test_figures_are_those_of_the_flight(compared: Comparison) -> None:
    one = read(compared, 1)["controllers"]["gsmc"]
    flight = compared.flights[1]["gsmc"]
    force = np.array(one["trajectory"]["force"])
    t = np.array(one["trajectory"]["t"])
    assert one["energy"] == pytest.approx(np.sqrt(np.trapezoid((force**2).sum(1), t)), rel=2e-3)
    assert one["peak"]["force"] == pytest.approx(np.sqrt((force**2).sum(1)).max(), rel=1e-12)
    for threshold in SETTLED["height"]:
        when = one["settled"]["height"][f"{threshold:g}"]
        assert (flight.height[flight.t >= when] <= threshold).all()
        assert flight.height[flight.t < when][-1] > threshold


def test_what_never_settles_is_null(compared: Comparison) -> None:
    flight = compared.flights[1]["gsmc"]
    up = figures(replace(flight, height=flight.height + 1))
    assert set(up["settled"]["height"].values()) == {None}


def test_no_number_is_infinite(compared: Comparison) -> None:
    flights = {n: dict(each) for n, each in compared.flights.items()}
    one = flights[1]["lsf"]
    flights[1]["lsf"] = replace(one, height=np.where(one.t > 5, np.nan, one.height))
    broken = replace(compared, flights=flights)
    assert None in read(broken, 1)["controllers"]["lsf"]["trajectory"]["height"]
