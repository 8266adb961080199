"""A short sweep for tests: numpy loops on SO(3), at two rates and with noise."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from derive import campaign
from derive.crew import let_go
from derive.simulate.executor import Alone, Crew
from derive.simulate.table import csv
from derive.sweep_folder import Sweep
from tests.simulate.crafts import asked, plan

RUNS = 70
BRIEF = 0.4  # s, of every run


def opened(out: Path, chunk: int = 8, **given: Any) -> Sweep:
    """A new one."""
    said = said_of(chunk, given)
    return campaign.opened(plan(**said), asked(**said), out, "csv", False)


def said_of(chunk: int, given: dict[str, Any]) -> dict[str, Any]:
    plain = {"runs": RUNS, "rates": (20.0, 30.0), "noise_g": 0.001, "duration": BRIEF}
    return {**plain, "chunk": chunk, **given}


def flown(out: Path, crew: Crew, chunk: int = 8, told: Callable[[str], object] = len) -> bytes:
    """The bytes of the result."""
    sweep = opened(out, chunk)
    with let_go(crew):
        rows = campaign.flown(sweep, crew, told)
    sweep.finish(rows)
    assert sweep.results.read_bytes() == csv(rows)
    return csv(rows)


def again(out: Path, chunk: int, **given: Any) -> Sweep:
    """One that has been begun."""
    said = said_of(chunk, given)
    return campaign.opened(plan(**said), asked(**said), out, "csv", True)


def resumed(out: Path, chunk: int, **given: Any) -> bytes:
    """The bytes of the result of going on."""
    sweep = again(out, chunk, **given)
    rows = campaign.flown(sweep, Alone(), len)
    sweep.finish(rows)
    return sweep.results.read_bytes()
