"""The suite passes on everything the product can emit, and never raises a false alarm."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from derive import pipeline
from derive.vehicle import Vehicle, load
from derive.verify.check import Check, Report
from derive.verify.limits import LIMITS
from tests.verify.subjects import FILES, FIRST, GROUPS, PAIRS, PAPER, ROOT, vehicle

EXTRAS = ("external", "momentum")


def with_law(group: str, law: str, controller: str = "gsmc") -> Vehicle:
    """The paper's body with another law of attitude."""
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


@pytest.mark.parametrize(("group", "law"), PAIRS)
def test_every_law_passes(group: str, law: str) -> None:
    report = verified(vehicle(group, law), each=3)
    assert failures(report) == []
    assert report.skipped == ()


@pytest.mark.parametrize("group", GROUPS)
def test_a_controller_without_reference_passes(group: str) -> None:
    report = verified(vehicle(group, FIRST[group], "reaching"), each=3)
    assert failures(report) == []
    assert not any("eta" in check.name for check in report.checks)


@pytest.mark.parametrize("options", [EXTRAS, *((one,) for one in EXTRAS)], ids="-".join)
@pytest.mark.parametrize("group", ["SO3", "S3", "SO2", "SE3", "SO3 x R3", "SL2"])
def test_what_a_vehicle_knows_besides_is_judged(group: str, options: tuple[str, ...]) -> None:
    assert failures(verified(vehicle(group, FIRST[group], options=options), each=4)) == []


def scaled(group: str, law: str, size: str, gain: str) -> Vehicle:
    """A body that turns alike about every axis, of any size, with any gains."""
    one, zero = Fraction(size), Fraction(0)
    inertia = tuple(tuple(one if i == j else zero for j in range(3)) for i in range(3))
    gains = (("lambda", Fraction(gain)), ("k_s", Fraction(gain)))
    fields = {**with_law(group, law).__dict__, "inertia": inertia, "gains": gains}
    return Vehicle(**fields)


@pytest.mark.parametrize("size", ["1e-6", "1", "100", "1e9"])
@pytest.mark.parametrize("gain", ["1e-3", "5", "1e4"])
@pytest.mark.parametrize(("group", "law"), [("SO3", "log"), ("S3", "half_log"), ("S3", "sign_vec")])
def test_no_size_and_no_gain_raises_a_false_alarm(
    group: str, law: str, size: str, gain: str
) -> None:
    assert failures(verified(scaled(group, law, size, gain), each=4)) == []


@pytest.mark.parametrize("name", ["paper_so3", "paper_s3"])
def test_no_seed_raises_a_false_alarm(name: str) -> None:
    vehicle = load(ROOT / "vehicles" / f"{name}.toml")
    seeds = range(1, int(LIMITS["seeds"].figure) + 1)
    alarms = {seed: failures(verified(vehicle, each=3, seed=seed)) for seed in seeds}
    assert {seed: lines for seed, lines in alarms.items() if lines} == {}


@pytest.mark.parametrize("group", ["SE3", "SO2 x SE2", "SL2"])
def test_no_seed_raises_a_false_alarm_on_a_group(group: str) -> None:
    """As above, on fewer seeds: their truth takes longer."""
    seeds = range(1, 6)
    alarms = {s: failures(verified(vehicle(group, FIRST[group]), each=4, seed=s)) for s in seeds}
    assert {seed: lines for seed, lines in alarms.items() if lines} == {}


def test_a_group_without_conditions_has_no_row_off_it() -> None:
    """On R^n every number is an element: nothing can be refused as off the group."""
    assert failures(verified(vehicle("R3", "log"), each=2)) == []


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
