"""The force within its limits: what `_within` holds to be right, and that a wrong one is found."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from derive import pipeline
from derive.vehicle import Vehicle
from derive.vehicle.limits import Limits
from derive.verify.guard import _within
from derive.verify.limits import EPS
from derive.verify.plant import Plant
from derive.verify.run import run
from tests.verify.subjects import PAPER, plant
from tests.verify.test_suite import failures

LIMIT = (Fraction(1), Fraction(2), Fraction(4))
WAYS = ("direction", "axis")
BARE = np.array([[2.0, -1.0, 1.0], [0.5, -8.0, 12.0], [-1.0, 2.0, -4.0], [0.1, 0.2, -0.3]])
IS_OVER = [True, True, False, False]
RIGHT = {
    "direction": np.array([[1, -0.5, 0.5], [0.125, -2, 3], BARE[2], BARE[3]]),
    "axis": np.array([[1, -1, 1], [0.5, -2, 4], BARE[2], BARE[3]]),
}
"""By hand: the whole force by 1/2 and by 1/4; and each coordinate by itself."""


def limited(saturation: str) -> Vehicle:
    """The paper's body, whose actuators give less than the law asks for."""
    return replace(PAPER, name=f"paper_{saturation}", limits=Limits(LIMIT, saturation))


def told(saturation: str) -> Plant:
    return replace(plant(PAPER), force_limit=LIMIT, saturation=saturation)


@pytest.mark.parametrize("way", WAYS)
def test_what_is_right_is_right(way: str) -> None:
    is_over, is_right = _within(told(way), "f64", BARE, RIGHT[way])
    assert is_over.tolist() == IS_OVER
    assert is_right.all()
    other = WAYS[1 - WAYS.index(way)]
    assert _within(told(way), "f64", BARE, RIGHT[other])[1].tolist() == [False, False, True, True]


@pytest.mark.parametrize("scalar", ["f32", "f64"])
@pytest.mark.parametrize("way", WAYS)
def test_a_little_off_is_wrong(way: str, scalar: str) -> None:
    """Eight eps of any coordinate; a force that was within its limits must stay to the bit."""
    kind: Any = np.float32 if scalar == "f32" else np.float64
    bare, right = BARE.astype(kind), RIGHT[way].astype(kind)
    assert _within(told(way), scalar, bare, right)[1].all()
    for i in range(3):
        for factor in (1 - 8 * EPS[scalar], 1 + 8 * EPS[scalar]):
            wrong = right.copy()
            wrong[:, i] = (wrong[:, i].astype(float) * factor).astype(kind)
            assert not _within(told(way), scalar, bare, wrong)[1].any()
    near = np.nextafter(right, kind(9))
    assert _within(told(way), scalar, bare, near)[1][2:].tolist() == [False, False]


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("wrong", [np.nan, np.inf, 0.0])
def test_nonsense_is_wrong(way: str, wrong: float) -> None:
    assert not _within(told(way), "f64", BARE, np.full_like(BARE, wrong))[1].any()
    assert not _within(told(way), "f64", BARE, -RIGHT[way])[1].any()


def test_without_a_limit_any_force_must_stay() -> None:
    is_over, is_right = _within(plant(PAPER), "f64", 1e9 * BARE, 1e9 * BARE)
    assert not is_over.any()
    assert is_right.all()
    assert not _within(plant(PAPER), "f64", BARE, np.nextafter(BARE, 9))[1].any()


C, PYTHON = "c/src/{}_f64.c", "numpy/{}.py"
HARMS = [
    ("direction", C, "limit/size", "limit*size"),
    ("direction", C, "(a < b) ? a : b", "a"),
    ("direction", C, "command->force[1]*share", "command->force[1]"),
    ("direction", C, "[0], params->force_limit[0])", "[0], params->force_limit[0]*0.999)"),
    ("direction", C, "share*0.", "share*0.7*0."),
    ("axis", C, "? limit : -limit", "? limit : limit"),
    ("axis", C, "(fabs(force) <= limit) ? force : most", "force"),
    ("axis", C, "return PAPER_AXIS_F64_SATURATED;", "return PAPER_AXIS_F64_OK;"),
    ("direction", C, "return PAPER_DIRECTION_F64_SATURATED;", "return PAPER_DIRECTION_F64_OK;"),
    ("direction", PYTHON, "limit / size", "limit / (size + 1e-9)"),
    ("direction", PYTHON, ".min(-1, keepdims=True)", ""),
    ("axis", PYTHON, "np.where(force > 0.0, limit, -limit)", "limit"),
    ("axis", PYTHON, "np.where(usable, SATURATED", "np.where(usable, OK"),
    ("axis", PYTHON, "force_limit: Array = (1.0, 2.0", "force_limit: Array = (1.0, 2.01"),
]  # fmt: skip


def only(files: dict[str, str], path: str) -> dict[str, str]:
    """One backend alone, so that it cannot merely be unlike another."""
    is_c = path.startswith("c/")
    return {name: text for name, text in files.items() if name.endswith(".py") != is_c}


@pytest.mark.parametrize("way", WAYS)
def test_unharmed_it_is_green(way: str) -> None:
    files = pipeline.texts(limited(way))
    assert failures(run(f"paper_{way}", files, told(way), each=3)) == []


@pytest.mark.parametrize(("way", "path", "right", "wrong"), HARMS)
def test_a_saturation_that_is_wrong_is_found(way: str, path: str, right: str, wrong: str) -> None:
    name = f"paper_{way}"
    files = pipeline.texts(limited(way))
    text, count = re.subn(re.escape(right), wrong.replace("\\", r"\\"), files[path.format(name)])
    assert count, right
    harmed = only({**files, path.format(name): text}, path)
    assert failures(run(name, harmed, told(way), each=3)) != []
