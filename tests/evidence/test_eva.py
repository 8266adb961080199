"""Eva proves what is emitted, and does not prove what is spoilt."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from derive.evidence import defect, eva, quaternion
from derive.evidence.analysed import MARK, analysed, places, statements
from derive.evidence.emitted import Emitted
from derive.evidence.entry import ANY_BITS
from derive.evidence.tool import ToolFailed, ToolMissing
from tests.evidence.attacked import needed
from tests.evidence.tools import hide

GENERATED = Path(__file__).parents[2] / "generated"
PACKAGES = [
    Emitted(folder, folder.name, scalar)
    for folder, scalar in product(sorted(GENERATED.iterdir()), ("f32", "f64"))
]
SOURCE = """#include "x.h"
#ifdef X
static const float table[2] = {
    1.0F, 2.0F
};
#endif

/* f: of x. */
static float f(const float x,
        const float y)
{
    /* one
       two; */
    const float a = x + /* here */
        y;
    float b;
    if (fabsf(table[(int)y]) <= a && !(fabsf(a) > 2.0F)) {
        b = 1.0F;
    } else {
        *p = 0.0F;
    }
#ifdef X_CHECK
    return 2.0F;
#endif
    return b;
}
"""


def package(name: str, scalar: str) -> Emitted:
    return Emitted(GENERATED / name, name, scalar)


def test_statements_are_marked_where_they_begin_and_comparisons_are_spelled() -> None:
    lines = SOURCE.splitlines()
    found = [lines[number - 1].split()[0] for number in statements(SOURCE)]
    assert found == ["const", "float", "if", "b", "*p", "return"]
    text = analysed(SOURCE)
    assert text.count(MARK) == len(found)
    assert "EVA_ABS(table[(int)y]) <= a && !(fabsf(a) > 2.0F)" in text
    assert [line.replace(MARK, "").split() for line in text.splitlines()][:16] == [
        line.split() for line in lines[:16]
    ]
    assert set(places(SOURCE).values()) == {"f"}


@pytest.mark.parametrize("scalar", ["f32", "f64"])
def test_the_boxes_leave_no_quaternion_out(scalar: str) -> None:
    rng = np.random.default_rng(5)
    bounds = np.array(
        [[float(x.rstrip("F")) for x in box.split(", ")] for box in quaternion.boxes(scalar)]
    ).reshape(-1, 4, 2)
    v = rng.normal(size=(2000, 3)) * 10.0 ** rng.uniform(-12, 0, size=(2000, 1))
    v = np.vstack([v[np.linalg.norm(v, axis=1) <= 1], np.zeros(3), np.eye(3), -np.eye(3)])
    q = np.column_stack([np.sqrt(np.maximum(0, 1 - (v**2).sum(1))), v])[:, None, :]
    inside = np.all((bounds[..., 0] <= q) & (q <= bounds[..., 1]), axis=2)
    assert np.all(np.any(inside, axis=1))


@pytest.mark.parametrize("emitted", PACKAGES, ids=lambda one: one.prefix)
def test_ten_defects_have_a_place_in_every_source(emitted: Emitted) -> None:
    source = emitted.source.read_text(encoding="utf-8")
    defects = defect.applicable(source)
    texts = {defect.edited(one, emitted, source) for one in defects}
    assert len(texts) == len(defects) >= 10
    assert source not in texts


def test_a_defect_without_a_place_is_told() -> None:
    emitted = package("paper_so3", "f32")
    astray = replace(defect.DEFECTS[0], pattern="nowhere", instead="")
    with pytest.raises(defect.DefectNotApplicable, match=r"paper_so3_f32\.c: .*no range of the"):
        defect.edited(astray, emitted, emitted.source.read_text(encoding="utf-8"))


@pytest.mark.parametrize("emitted", PACKAGES, ids=lambda one: one.prefix)
def test_everything_is_proved(emitted: Emitted) -> None:
    with needed():
        checks = tuple(eva.proofs(emitted))
    assert [(one.name, one.details) for one in checks if not one.is_ok] == []
    assert [one.name for one in checks] == [
        "any bits: alarms", "any bits: not proved", "any bits: not reached", "in range: alarms"
    ]  # fmt: skip
    assert all(one.samples > 20 for one in checks)


@pytest.mark.parametrize(
    ("name", "scalar", "every"), [("paper_so3", "f32", 3), ("freeflyer", "f64", 5)]
)
def test_no_defect_is_missed(
    name: str, scalar: str, every: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(defect, "DEFECTS", defect.DEFECTS[1::every])
    with needed():
        check = defect.teeth(package(name, scalar))
    assert check.is_ok, check.details
    assert check.samples >= 20 // every - 1


def test_a_defect_that_changes_nothing_is_missed(monkeypatch: pytest.MonkeyPatch) -> None:
    harmless = defect.Defect("a copy", "law", r"command->s\[0\] = ", "command->s[0] = 1 * ")
    monkeypatch.setattr(defect, "DEFECTS", (harmless,))
    with needed():
        check = defect.teeth(package("sl2", "f64"))
    assert not check.is_ok
    assert check.details == ("a copy",)


@pytest.mark.parametrize("command", ["frama-c", "gcc"])
def test_without_its_preprocessor_it_is_missing_not_broken(
    monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    for look in (lambda one: list(eva.proofs(one)), defect.teeth):
        hide(monkeypatch, command)
        with pytest.raises(ToolMissing, match=f"{command} is not on PATH; get it with"):
            look(package("sl2", "f64"))


def test_a_source_that_is_no_c_is_a_clear_failure() -> None:
    emitted = package("sl2", "f64")
    with needed(), pytest.raises(ToolFailed, match=r"frama-c ended with"):
        eva.ran(emitted, emitted.source.read_text(encoding="utf-8") + "\nint {", ANY_BITS)
