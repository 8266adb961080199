"""libFuzzer finds nothing in what is emitted, and finds what is planted there."""

from __future__ import annotations

from pathlib import Path

import pytest

from derive.evidence import fuzz
from derive.evidence.emitted import Emitted
from derive.evidence.tool import ToolFailed, ToolMissing
from tests.evidence import attacked

RUNS = 100_000
SPOILT = 60_000


def built(emitted: Emitted, folder: Path) -> fuzz.Fuzzer:
    """The target; skipped, on a laptop, where clang or its runtime is missing."""
    attacked.need(fuzz.CLANG)
    with attacked.needed():
        return fuzz.built(emitted, attacked.plant(emitted.name), folder)


@pytest.mark.parametrize(
    ("name", "scalar"),
    [("paper_so3", "f32"), ("paper_so3", "f64"), ("underwater", "f32"), ("cubesat_3u", "f32")],
)
def test_no_bytes_break_a_promise(tmp_path: Path, name: str, scalar: str) -> None:
    emitted = attacked.package(name, scalar)
    broken, unseen = fuzz.judged(emitted, built(emitted, tmp_path), RUNS)
    assert broken.is_ok, (broken.worst, broken.details)
    assert broken.samples == RUNS
    assert unseen.is_ok, unseen.details
    assert unseen.samples == RUNS
    assert {"status 0", "status 16", "status 17", "status 18"} <= {
        row.partition(":")[0] for row in unseen.details
    }


@pytest.fixture(scope="module")
def spoilt(tmp_path_factory: pytest.TempPathFactory) -> tuple[Emitted, fuzz.Fuzzer]:
    folder = tmp_path_factory.mktemp("spoilt")
    emitted = attacked.spoilt(attacked.package("paper_so3", "f32"), folder)
    return emitted, built(emitted, folder)


REASONS = {
    "status": "the status is no documented one: status 3",
    "infinite": "division by zero",
    "nan": "an output is not finite: status 0",
    "unwritten": "an output is left unwritten: status 17",
    "command": "the input is refused, and the command is not zero: status 16",
    "unseen": "an input is not finite, and the status does not say so: status 0",
    "limit": "the force is beyond its limit: status 0",
    "overrun": "out of bounds",
    "params": "an output is not finite",
}


@pytest.mark.parametrize("defect", REASONS)
def test_a_planted_defect_is_found_and_told_in_numbers(
    spoilt: tuple[Emitted, fuzz.Fuzzer], defect: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DEFECT", defect)
    broken, _ = fuzz.judged(*spoilt, SPOILT)
    assert not broken.is_ok
    assert REASONS[defect] in broken.worst
    names = {row.partition("[")[0].strip() for row in broken.details}
    assert {"state.g", "state.nu", "reference.nu_dot", "params.inertia", "params.k_s"} <= names


def test_the_numbers_are_those_that_broke_it(
    spoilt: tuple[Emitted, fuzz.Fuzzer], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DEFECT", "status")
    broken, _ = fuzz.judged(*spoilt, SPOILT)
    row = next(row for row in broken.details if "state.nu[0]" in row)
    assert float(row.split("=")[1]) > 9
    assert float.fromhex(row.split("=")[2]) > 9


def test_a_check_of_parameters_that_divides_by_zero_is_found(tmp_path: Path) -> None:
    made = attacked.copy(attacked.package("paper_so3", "f32"), tmp_path)
    text = made.source.read_text(encoding="utf-8")
    assert text.count("divisor_1 = 1.0F;") == 1
    made.source.write_text(text.replace("divisor_1 = 1.0F;", "divisor_1 = pivot_1;"))
    broken, _ = fuzz.judged(made, built(made, tmp_path), SPOILT)
    assert broken.worst == "division by zero"


def test_the_same_runs_are_made_every_time(tmp_path: Path) -> None:
    emitted = attacked.package("paper_so3", "f32")
    target = built(emitted, tmp_path)
    once, again = (fuzz.judged(emitted, target, 20_000)[1] for _ in range(2))
    assert once.samples == 20_000
    assert once.details == again.details


def idle(folder: Path, does: str) -> fuzz.Fuzzer:
    """A target that does only that."""
    program = folder / "idle"
    program.write_text(f"#!/bin/sh\n{does}\n", encoding="utf-8")
    program.chmod(0o755)
    return fuzz.Fuzzer(program, 8)


def test_a_run_that_takes_too_long_is_ended(tmp_path: Path) -> None:
    emitted = attacked.package("paper_so3", "f32")
    with pytest.raises(ToolFailed, match=r"did not end within 0\.2 s"):
        fuzz.judged(emitted, idle(tmp_path, "sleep 60"), 6, seconds=0.2)


def test_a_target_that_ends_early_is_no_evidence(tmp_path: Path) -> None:
    emitted, early = attacked.package("paper_so3", "f32"), idle(tmp_path, "echo Done 5 runs")
    with pytest.raises(ToolFailed, match="did neither end 6 runs"):
        fuzz.judged(emitted, early, 6)
    assert fuzz.judged(emitted, early, 5)[1].measured == 4


def test_a_clang_without_its_runtime_is_a_tool_that_is_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    clang = tmp_path / "clang"
    clang.write_text("#!/bin/sh\necho cannot find libclang_rt.fuzzer-x86_64.a\nexit 1\n")
    clang.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    emitted, plant = attacked.package("paper_so3", "f32"), attacked.plant("paper_so3")
    with pytest.raises(ToolMissing, match="libclang-rt"):
        fuzz.built(emitted, plant, tmp_path)
