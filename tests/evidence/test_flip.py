"""No flipped bit breaks a promise; what is planted is found; the rates are counted right."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from derive.evidence import flip
from derive.evidence.case import COUNT, good
from derive.evidence.emitted import Emitted
from derive.evidence.interface import interface
from derive.evidence.tool import ToolFailed
from tests.evidence import attacked

BITS = {"f32": 32, "f64": 64}
NUMBERS = {"paper_so3": 27, "underwater": 56, "two_bodies": 77, "paper_s3": 17}
"""Of state and reference together."""


def flips(emitted: Emitted, folder: Path) -> flip.Flips:
    attacked.need(flip.GCC)
    return flip.flips(emitted, attacked.plant(emitted.name), folder)


@pytest.mark.parametrize(
    ("name", "scalar"),
    [("paper_so3", "f32"), ("underwater", "f64"), ("two_bodies", "f32"), ("paper_s3", "f32")],
)
def test_no_flip_breaks_a_promise(tmp_path: Path, name: str, scalar: str) -> None:
    attacked.need(flip.GCC)
    emitted = attacked.package(name, scalar)
    check, missed = flip.flip(emitted, attacked.plant(name), tmp_path)
    assert check.is_ok, check.details
    found, harmful = map(int, re.findall(r"(\d+) of (\d+) harmful", check.details[0])[0])
    assert missed.measured == pytest.approx(100 * (harmful - found) / harmful)
    assert (missed.samples, missed.limit.is_promised) == (harmful, False)
    params = sum(one.count for one in interface(emitted).structs["params"])
    assert check.samples == BITS[scalar] * (NUMBERS[name] * COUNT + params)
    assert check.details[0].startswith("state and reference: ")


def test_a_flip_of_a_matrix_is_mostly_noticed(tmp_path: Path) -> None:
    """Six equations bind nine numbers: what moves the force leaves the group, nearly always."""
    found = flips(attacked.package("paper_so3", "f32"), tmp_path)
    of_g = found.over("g", "state.g", "reference.g")
    assert of_g.tried == 2 * 9 * 32 * COUNT
    assert of_g.rate > 0.95
    assert of_g.harmful > of_g.tried / 4


SPOILT = {
    "status": "the status is no documented one: status 3",
    "nan": "an output is not finite: status 0",
    "unwritten": "an output is left unwritten: status 17",
    "command": "the input is refused, and the command is not zero: status 16",
    "unseen": "an input is not finite, and the status does not say so: status 0",
    "limit": "the force is beyond its limit: status 0",
    "params": "an output is not finite",
}


@pytest.fixture(scope="module")
def spoilt(tmp_path_factory: pytest.TempPathFactory) -> Emitted:
    package = attacked.package("paper_so3", "f32")
    return attacked.spoilt(package, tmp_path_factory.mktemp("spoilt"))


@pytest.mark.parametrize("defect", SPOILT)
def test_a_planted_defect_is_found(
    spoilt: Emitted, tmp_path: Path, defect: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    attacked.need(flip.GCC)
    monkeypatch.setenv("DEFECT", defect)
    check, _ = flip.flip(spoilt, attacked.plant("paper_so3"), tmp_path)
    assert not check.is_ok
    assert SPOILT[defect] in check.worst


def test_a_guard_that_sees_no_drift_shows_in_the_rate(tmp_path: Path) -> None:
    made = attacked.copy(attacked.package("paper_so3", "f32"), tmp_path)
    text = made.source.read_text(encoding="utf-8")
    blind, count = re.subn(r"\S+ (/\* max_drift)", r"1.0e9F \1", text)
    assert count == 1
    made.source.write_text(blind, encoding="utf-8")
    found = flips(made, tmp_path)
    assert found.over("g", "state.g", "reference.g").rate < 0.5
    assert found.over("nu", "state.nu").rate > 0


def test_a_case_that_is_refused_is_no_good_case(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("derive.evidence.driver.good", lambda *_: ["{ { { 2 } } }"])
    attacked.need(flip.GCC)
    plant = attacked.plant("paper_so3")
    check, _ = flip.flip(attacked.package("paper_so3", "f32"), plant, tmp_path)
    assert check.measured == 1
    assert check.worst == "CASE 0 is refused with 16"


def test_the_tallies_are_what_python_counts(tmp_path: Path) -> None:
    """Of the velocity, by the same flips in numpy: which are refused for their size alone."""
    package, plant = attacked.package("paper_so3", "f32"), attacked.plant("paper_so3")
    rows = [case.split("}")[1].split("{")[1] for case in good(plant, interface(package))]
    nu = np.array([[float.fromhex(x) for x in row.split(",")] for row in rows], np.float32)
    masks = np.uint32(1) << np.arange(32, dtype=np.uint32)
    turned = (nu.view(np.uint32)[..., None] ^ masks).view(np.float32)
    refused = ~(np.abs(turned) <= 1e6)
    tally = flips(package, tmp_path).over("nu", "state.nu")
    assert tally.tried == turned.size
    assert tally.found + tally.spared == int(refused.sum())


def test_a_driver_that_ends_early_is_no_evidence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    attacked.need(flip.GCC)
    monkeypatch.setattr(flip, "run", lambda *_: "MEMBER state.g 1 1 1 0\n")
    with pytest.raises(ToolFailed, match="did not count to its end"):
        flips(attacked.package("paper_so3", "f32"), tmp_path)


def test_rates_are_shares_of_what_does_harm() -> None:
    tallies = (flip.Tally("state.g", 100, 40, 30, 5), flip.Tally("state.nu", 50, 10, 5, 0))
    found = flip.Flips((*tallies, flip.Tally("params.k", 9, 0, 0, 1)), 0, 0, ())
    both = found.over("state", "state.")
    assert (both.tried, both.harmful, both.found, both.spared) == (150, 50, 35, 5)
    assert both.rate == pytest.approx(0.7)
    assert replace(both, harmful=0, found=0).rate == 1
    assert str(tallies[0]) == "state.g: 30 of 40 harmful flips found (75.0 %), 100 tried"
