"""Every group in closed loop through the emitted numpy: W falls as exp(-2 k_s t), exactly."""

from __future__ import annotations

import builtins
import math
import re
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from bench import flight, loop
from bench.flight import Found
from bench.loop import CASES
from bench.motion import Case
from derive.lie.catalogue import GROUPS
from derive.verify.limits import LIMITS

LIMIT = LIMITS["loop"].figure
text = cache(loop.emitted)


def flown(case: Case, source: str, folder: Path) -> Found:
    return loop.closed(case, source, folder, seed=1)


def keeps(found: Found) -> bool:
    return found.energy < LIMIT  # not of a NaN


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_the_energy_of_the_error_falls_as_promised(case: Case, tmp_path: Path) -> None:
    found = flown(case, text(case), tmp_path)
    assert keeps(found)
    assert loop.is_regular(found)
    assert found.fallen == pytest.approx(math.exp(-16), rel=2 * LIMIT)
    # What the integration lost of the group, and the plant against one that is written here.
    assert found.drift < 1e-12
    assert found.plant < 1e-13


def test_every_group_is_flown_with_every_option() -> None:
    assert {case.group for case in CASES} > {*GROUPS, "Heisenberg", "SL2"}
    assert any(" x " in case.group for case in CASES)
    assert {option for case in CASES for option in case.options} == {"external", "momentum"}


def mutated(source: str, step: str, pattern: str, by: str) -> str:
    """The module with a pattern replaced in one step of its tracking law."""
    start = source.index("def _law(")
    head, law = source[:start], source[start:]
    block = re.search(rf"    # {step}: .*?(?=\n    # )", law, re.DOTALL)
    assert block
    wrong, count = re.subn(pattern, by, block[0])
    assert count
    return head + law.replace(block[0], wrong, 1)


CURVED = ("SO3", "S3", "SE2", "SE3", "SE23", "SE3 x SO3", "Heisenberg")
AD = ("eta_dot", r"\bnu_e_(\d+)", r"(-nu_e_\1)")
"""The sign of ad(nu_e) eta within eta_dot."""

BENT = [
    *((name, *AD) for name in CURVED),
    ("SE3", "wanted", r"\beta_dot_(\d+)", r"(-eta_dot_\1)"),
    ("SE3", "wanted", r"\bnu_u_dot_(\d+)", r"(-nu_u_dot_\1)"),
    ("SE3", "turning", r"\beta_(\d+)", r"(-eta_\1)"),
    ("SE2", "turning", r"\beta_(\d+)", r"(-eta_\1)"),
]


@pytest.mark.parametrize(("name", "step", "pattern", "by"), BENT)
def test_a_wrong_sign_breaks_it(
    name: str, step: str, pattern: str, by: str, tmp_path: Path
) -> None:
    case = Case(name)
    found = judged(case, mutated(text(case), step, pattern, by), tmp_path)
    assert found is None or found.energy > 1e5 * LIMIT


@pytest.mark.parametrize("name", ["SO2", "R3", "SL2"])
def test_a_wrong_sign_of_the_rate_of_the_reference_breaks_it(name: str, tmp_path: Path) -> None:
    case = next(case for case in CASES if case.group == name and not case.options)
    wrong, count = re.subn(r"\bnu_r_dot\[", "-nu_r_dot[", text(case))
    assert count
    found = judged(case, wrong, tmp_path)
    assert found is None or found.energy > 1e5 * LIMIT


@pytest.mark.parametrize("option", ["external", "momentum"])
def test_an_option_that_is_not_heeded_breaks_it(option: str, tmp_path: Path) -> None:
    case = Case("SE3", options=("external", "momentum"))
    source = text(case)
    start = source.index("def _law(")
    end = source.index("def _reaching(")
    wrong, count = re.subn(rf"\b{option}\[", f"0 * {option}[", source[start:end])
    assert count
    found = judged(case, source[:start] + wrong + source[end:], tmp_path)
    assert found is None or found.energy > 1e5 * LIMIT


def test_a_wrong_plant_is_seen_as_such(tmp_path: Path) -> None:
    case = Case("SE3", options=("external", "momentum"))
    head, mark, plant = text(case).partition("def _plant(")
    found = flown(case, head + mark + plant.replace("external[", "-external["), tmp_path)
    assert found.plant > 1e-3


def test_a_rough_integration_is_seen_as_such(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(flight, "TOLERANCE", 1e-6)
    found = flown(Case("SO3"), text(Case("SO3")), tmp_path)
    assert found.drift > 1e-10
    assert not keeps(found)


@pytest.mark.parametrize(("turn", "statuses"), [(3.0, {0}), (1.0, {0, 2}), (1.0, {16})])
def test_near_the_cut_or_refused_is_no_figure(
    turn: float, statuses: set[int], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = Found(1e-12, turn, 0.0, 0.0, math.exp(-16), frozenset(statuses))
    monkeypatch.setattr(loop, "closed", lambda *_: found)
    with pytest.raises(ArithmeticError, match="loop SO2: the loop left where the law is smooth"):
        loop.measure(tmp_path)


def judged(case: Case, source: str, folder: Path) -> Found | None:
    """What a mutant shows; None where it does not even come to an end."""
    try:
        return flown(case, source, folder)
    except ArithmeticError:
        return None


def test_without_scipy_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def refuse(name: str, *rest: Any, **more: Any) -> Any:
        if name.startswith("scipy"):
            raise ImportError(name)
        return real(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", refuse)
    with pytest.raises(SystemExit, match=r"pip install -e '\.\[test\]'"):
        flight._integrator()
