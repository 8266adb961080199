"""What gcov counts is read right: lines and branches that were not taken, by line and text."""

from __future__ import annotations

from pathlib import Path

import pytest

from derive.evidence import coverage
from derive.evidence.emitted import Emitted
from derive.evidence.tool import ToolFailed
from tests.evidence import attacked

CODE = """#include "thing_f32.h"
static float half(float x)
{
    return x / 2;
}
float thing_f32_size(float x)
{
    if (x < 0 && x > -9) {
        return -half(x);
    }
    return x > 100 ? 100 : half(x);
}
float thing_f32_idle(float x)
{
    return x;
}
"""
HEADER = "float thing_f32_size(float x);\nfloat thing_f32_idle(float x);\n"
FULL = (
    "thing_f32_size(-1) != 0.5F || thing_f32_size(-9) > 0 || thing_f32_size(2) != 1"
    " || thing_f32_size(101) != 100 || thing_f32_idle(1) != 1"
)
IDLE = "line 13: never run: float thing_f32_idle(float x)", "line 15: never run: return x;"


def thing(folder: Path, asked: str) -> Emitted:
    """A package whose self-test asks that, each answer to be wrong."""
    files = {
        "c/include/thing_f32.h": HEADER,
        "c/src/thing_f32.c": CODE,
        "test/thing_f32_test.h": "int thing_f32_test(void);\n",
        "test/thing_f32_test.c": '#include "thing_f32.h"\n#include "thing_f32_test.h"\n'
        f"int thing_f32_test(void)\n{{\n    return {asked};\n}}\n",
        "test/main.c": '#include "thing_f32_test.h"\n'
        "int main(void)\n{\n    return thing_f32_test();\n}\n",
    }
    for path, text in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")
    return Emitted(folder, "thing", "f32")


@pytest.mark.parametrize(
    ("asked", "missed"),
    [
        (FULL, ()),
        (FULL.partition(" || thing_f32_idle")[0], IDLE),
        (
            FULL.replace("thing_f32_size(-9) > 0 || ", ""),
            ("line 8: 1 of its branches never taken: if (x < 0 && x > -9) {",),
        ),
        (
            FULL.replace("thing_f32_size(101) != 100 || ", ""),
            ("line 11: 1 of its branches never taken: return x > 100 ? 100 : half(x);",),
        ),
        (
            FULL[FULL.index("thing_f32_size(2)") :],
            (
                "line 8: 3 of its branches never taken: if (x < 0 && x > -9) {",
                "line 9: never run: return -half(x);",
            ),
        ),
    ],
)
def test_what_a_self_test_leaves_out_is_listed(
    tmp_path: Path, asked: str, missed: tuple[str, ...]
) -> None:
    attacked.need(coverage.GCC, coverage.GCOV)
    (check,) = coverage.coverage(thing(tmp_path / "thing", asked), tmp_path / "counts")
    assert check.details == missed
    assert check.is_ok == (not missed)
    assert check.worst == (missed[0] if missed else "")
    assert check.samples == 8 + 6


def test_counts_of_an_earlier_run_are_forgotten(tmp_path: Path) -> None:
    attacked.need(coverage.GCC, coverage.GCOV)
    for asked, missed in ((FULL, 0), (FULL.partition(" || thing_f32_idle")[0], 2), (FULL, 0)):
        (check,) = coverage.coverage(thing(tmp_path / "thing", asked), tmp_path / "counts")
        assert check.measured == missed


def test_a_self_test_that_fails_is_no_evidence(tmp_path: Path) -> None:
    attacked.need(coverage.GCC, coverage.GCOV)
    failing = thing(tmp_path / "thing", "thing_f32_size(2) == 1")
    with pytest.raises(ToolFailed, match="ended with 1"):
        coverage.coverage(failing, tmp_path / "counts")


def test_records_of_another_file_are_no_evidence() -> None:
    said = '{"files": [{"file": "other.c", "lines": [{"line_number": 1, "count": 0}]}]}'
    with pytest.raises(ToolFailed, match=r"does not speak of thing\.c"):
        coverage.read(said, Path("thing.c"))


@pytest.mark.parametrize("scalar", ["f32", "f64"])
@pytest.mark.parametrize("name", attacked.NAMES)
def test_the_self_test_runs_through_all_of_the_source(
    tmp_path: Path, name: str, scalar: str
) -> None:
    attacked.need(coverage.GCC, coverage.GCOV)
    (check,) = coverage.coverage(attacked.package(name, scalar), tmp_path)
    assert check.is_ok, check.details
    assert check.samples > (250 if "lsf" in name else 300)


def test_code_that_nothing_reaches_is_found(tmp_path: Path) -> None:
    attacked.need(coverage.GCC, coverage.GCOV)
    made = attacked.copy(attacked.package("paper_so3", "f32"), tmp_path)
    text = made.source.read_text(encoding="utf-8")
    line = "    command->force[0] = force_0 < -1.0e30F ? -1.0e30F : force_0;"
    assert text.count("    command->force[0] = force_0;") >= 1
    made.source.write_text(text.replace("    command->force[0] = force_0;", line))
    (check,) = coverage.coverage(made, tmp_path / "counts")
    told = f": 1 of its branches never taken: {line.strip()}"
    assert [row for row in check.details if row.endswith(told)]
