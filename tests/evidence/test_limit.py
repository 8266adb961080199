"""A good command is within its limits, whatever these are: proved, and not of what is spoilt."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from derive.evidence import defect, limit
from derive.evidence.emitted import Emitted
from tests.evidence.attacked import needed

GENERATED = Path(__file__).parents[2] / "generated"

SHARED = ("cubesat_3u", "f32")
CUT = ("freeflyer", "f64")
SIDED = ("microsat", "f64")


def package(name: str, scalar: str) -> Emitted:
    return Emitted(GENERATED / name, name, scalar)


def text(emitted: Emitted) -> str:
    return emitted.source.read_text(encoding="utf-8")


def test_only_vehicles_with_limits_are_asked() -> None:
    assert limit.is_limited(package(*SHARED))
    assert not limit.is_limited(package("paper_so3", "f32"))


@pytest.mark.parametrize("which", [SHARED, CUT, SIDED], ids="-".join)
def test_every_comparison_with_a_limit_is_seen(which: tuple[str, str]) -> None:
    """None is left that WP would read as numbers; all others are as they were."""
    source = text(package(*which))
    seen = limit.compared(source)
    assert re.search(r"<= (params->force_)?limit", source)
    assert not re.search(r"<= (params->force_)?limit|limit\S* >= 0", seen)
    others = re.compile(r"fabsf?\([^()]*\)\s*<=\s*\w+_MAX_\w+")
    assert others.findall(seen) == others.findall(source) != []


@pytest.mark.parametrize("which", [SHARED, CUT, SIDED], ids="-".join)
def test_any_limits_are_kept_to(which: tuple[str, str]) -> None:
    with needed():
        check = limit.limits(package(*which))
    assert check.is_ok, check.details
    assert check.samples > 40


HARMED = (
    (SHARED, "control", r"return (\w+_verdict\()", r"return 0U*(unsigned)\1"),
    (SHARED, "verdict", r"(force\[1\]\) <= params->force_limit)\[1\]", r"\1[0]"),
    (SHARED, "saturate", r"(force\[2\]\) <= params->force_limit\[2\])", r"\1 * 1.0F"),
    (SHARED, "saturate", r"return \w+_SATURATED", r"command->force[0] *= 2.0F; \g<0>"),
    (CUT, "cut", r"\? limit : -limit", "? limit : -2*limit"),
    (CUT, "saturate", r"(_cut\(command->force\[3\], params->force_limit)\[3\]", r"\1[4]"),
    (CUT, "saturate", r"(params->force_limit\[2\]) >= 0\.0", r"\1 >= -1.0"),
)
"""Of what source, in which routine, what is changed to what."""


@pytest.mark.parametrize(("which", "within", "pattern", "instead"), HARMED)
def test_what_is_harmed_is_not_proved(
    which: tuple[str, str], within: str, pattern: str, instead: str
) -> None:
    emitted = package(*which)
    harm = defect.Defect("harmed", within, pattern, instead)
    with needed():
        failed, goals = limit.unproved(emitted, defect.edited(harm, emitted, text(emitted)))
    assert 0 < len(failed) < goals


def test_a_run_without_a_count_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limit, "RUNS", 3)
    emitted = package(*SHARED)
    with needed(), pytest.raises(ValueError, match="expected 3 counts of goals"):
        limit.unproved(emitted, text(emitted))
