"""What is said of counted instructions, and of which package a figure is promised."""

from pathlib import Path

import pytest

from derive.evidence.board import Reading, Row
from derive.evidence.cost import checks
from derive.evidence.emitted import Emitted
from derive.evidence.firmware import Image
from derive.evidence.machine import Machine
from derive.evidence.promise import promise
from derive.verify.check import Check
from tests.evidence.emulated import M4F, M7


def package(folder: Path, group: str = "SO3", controller: str = "gsmc") -> Emitted:
    manifest = f'group = "{group}"\ncontroller = "{controller}"\n'
    (folder / "MANIFEST.toml").write_text(manifest)
    return Emitted(folder, "body", "f32")


def told(folder: Path) -> dict[str, Check]:
    """Two good cases and a refused one, of a tracking that takes 100 and 120 instructions."""
    reading = Reading(
        Image(package(folder), M4F, "-O2"),
        golden={0: Row(0, 1), 1: Row(2, 1), 2: Row(17, 1)},
        known=(65, 66),
        cost={
            ("control", 0): (150, 150),
            ("control", 1): (168, 168),
            ("control", 2): (900, 900),
            ("tracking", 0): (100, 100),
            ("tracking", 1): (120, 119),
        },
    )
    return {check.name: check for check in checks(reading)}


def test_the_worst_call_counts_a_refused_one_too(tmp_path: Path) -> None:
    control = told(tmp_path)["instructions, control"]
    assert (control.measured, control.samples) == (900, 3)
    assert control.worst == "case 2; 150 to 168 in good cases"
    assert told(tmp_path)["instructions, tracking"].measured == 120


def test_ratios_are_of_good_cases(tmp_path: Path) -> None:
    found = told(tmp_path)
    assert found["tracking, most over least"].measured == pytest.approx(1.2)
    assert not found["tracking, most over least"].is_ok
    assert found["guard"].measured == pytest.approx(50)
    assert found["guard"].worst == "case 0: 150 for 100"


def test_a_wrong_clock_and_a_count_that_differs_are_told(tmp_path: Path) -> None:
    found = told(tmp_path)
    assert (found["clock"].measured, found["clock"].worst) == (1, "66 for 65")
    assert (found["counted twice"].measured, found["counted twice"].samples) == (1, 5)
    assert found["counted twice"].worst == "tracking, case 1"


def test_a_clock_that_was_never_read_does_not_pass(tmp_path: Path) -> None:
    reading = Reading(Image(package(tmp_path), M4F, "-O2"))
    assert not next(iter(checks(reading))).is_ok


@pytest.mark.parametrize(
    ("group", "controller", "machine", "figure"),
    [
        ("SO3", "gsmc", M4F, 340),
        ("S3", "gsmc", M4F, 260),
        ("SE3", "gsmc", M4F, None),
        ("SO3", "lsf", M4F, None),
        ("SO3", "gsmc", M7, None),
    ],
)
def test_figures_are_promised_of_two_groups_in_float(
    tmp_path: Path, group: str, controller: str, machine: Machine, figure: float | None
) -> None:
    limit = promise("tracking", "instructions", package(tmp_path, group, controller), machine)
    assert (limit.figure if limit.is_promised else None) == figure
    assert limit.unit == "instructions"
