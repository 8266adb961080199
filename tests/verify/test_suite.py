"""The suite passes on everything the product can emit, and never raises a false alarm."""

from __future__ import annotations

from pathlib import Path

import pytest

from derive import pipeline
from derive.control.kinematic import LAWS
from derive.lie.catalogue import GROUPS
from derive.vehicle import Vehicle, load
from derive.verify.check import Check, Report
from derive.verify.limits import LIMITS, SEEDS

ROOT = Path(__file__).parents[2]
PAPER = load(ROOT / "vehicles" / "paper_so3.toml")
FILES = sorted((ROOT / "vehicles").glob("*.toml"))


def with_law(group: str, law: str, controller: str = "gsmc") -> Vehicle:
    """The paper's body with another law."""
    fields = {**PAPER.__dict__, "group": group, "law": law, "controller": controller}
    return Vehicle(**{**fields, "name": f"{group.lower()}_{law}"})


def verified(vehicle: Vehicle, each: int, seed: int = 0) -> Report:
    return pipeline.verify(vehicle, None, lambda _: None, each=each, seed=seed)


def failures(report: Report) -> list[str]:
    return [f"{c.name} on {c.subject}: {c.measured:.3g}, {c.worst}" for c in report.checks
            if not c.is_ok]  # fmt: skip


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_every_vehicle_file_passes(file: Path) -> None:
    assert failures(verified(load(file), each=12)) == []


@pytest.mark.parametrize(("group", "law"), LAWS)
def test_every_law_passes(group: str, law: str) -> None:
    report = verified(with_law(group, law), each=6)
    assert failures(report) == []
    assert report.skipped == ()


@pytest.mark.parametrize("group", GROUPS)
def test_a_controller_without_reference_passes(group: str) -> None:
    report = verified(with_law(group, "log", "reaching"), each=6)
    assert failures(report) == []
    assert not any("eta" in check.name for check in report.checks)


@pytest.mark.parametrize("name", ["paper_so3", "paper_s3"])
def test_no_seed_raises_a_false_alarm(name: str) -> None:
    vehicle = load(ROOT / "vehicles" / f"{name}.toml")
    alarms = {seed: failures(verified(vehicle, each=3, seed=seed)) for seed in range(1, SEEDS + 1)}
    assert {seed: lines for seed, lines in alarms.items() if lines} == {}


def test_every_backend_and_every_way_to_differentiate_is_there() -> None:
    report = verified(PAPER, each=1)
    assert {c.subject for c in report.checks} >= {"numpy f64", "C f64", "C f32"}
    ways = ("truth", "6th-order", "complex step", "CasADi", "chain rule", "identit")
    assert all(any(way in c.name for c in report.checks) for way in ways)


def test_a_figure_that_is_no_number_fails() -> None:
    check = Check("x", "y", float("nan"), LIMITS["log"], 1)
    assert not check.is_ok
    assert not Report("v", (check,)).ok
    assert "FAILED" in Report("v", (check,)).table()
