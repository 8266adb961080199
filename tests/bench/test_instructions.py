"""The bare law on SO(3) in double keeps to its budget of instructions, at every angle."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from bench import instructions
from bench.subject import ANGLES, AXES
from derive.verify.limits import LIMITS

BUDGET = LIMITS["paper_so3 f64 tracking"].figure


def test_tracking_keeps_to_its_budget(tmp_path: Path) -> None:
    if not instructions.is_possible():
        assert os.environ.get("CI") != "true", "CI must have valgrind and gcc"
        pytest.skip("valgrind and gcc are needed to count instructions")
    counts = instructions.calls("paper_so3", "f64", "tracking", tmp_path)
    assert len(counts) == len(ANGLES) * len(AXES)
    assert min(counts) > 200  # callgrind saw the function
    assert max(counts) <= BUDGET


def test_the_budget_is_the_promised_one() -> None:
    assert BUDGET == 560
