"""One chunk of a sweep: runs flown together, and the rows they leave. Imported by workers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.native.compile import CompileError, CompilerMissing
from derive.simulate.craft import Craft
from derive.simulate.draw import Spread, choice, drawn, initial_angles, seed_of
from derive.simulate.loop import Loop
from derive.simulate.outcome import OUTCOMES, Watch
from derive.simulate.reference import Course, Reference
from derive.simulate.runs import Runs, Setting
from derive.simulate.space import space_of

Rows = dict[str, NDArray[Any]]
"""Columns (N,) by name, in the order of the result."""

START = ("seed", "rate", "initial_angle", "initial_height", "initial_rate")
"""Columns before those of what was drawn per coordinate, which OUTCOMES follow."""


class CannotFly(Exception):
    """A worker has no compiler, or its compiler refuses the emitted code."""


@dataclass(frozen=True)
class Plan:
    """All that a run depends on but its number: plain data, for another process or machine.

    settings: alternatives, one of which is drawn for each run
    settle:   bound on the height and on |nu_e| below which a run is settled
    root:     the seed that the runs' seeds come from
    """

    craft: Craft
    backend: str
    course: Course
    settings: tuple[Setting, ...]
    spread: Spread
    settle: float
    root: int


def lean(craft: Craft) -> Craft:
    """The craft without the files that no backend runs."""
    used = tuple(
        one for one in craft.files if one[0].startswith(("c/include/", "c/src/", "numpy/"))
    )
    return replace(craft, files=used)


def fly(plan: Plan, first: int, last: int) -> Rows:
    """Runs first <= i < last, in their order; the same whatever flies beside them."""
    return fly_seeds(plan, [seed_of(plan.root, run) for run in range(first, last)], first)


def fly_seeds(plan: Plan, seeds: Sequence[int], first: int = 0) -> Rows:
    """The runs of these seeds, numbered from `first`. Raises CannotFly."""
    chosen = np.array([choice(seed, len(plan.settings)) for seed in seeds])
    whole: Rows = {}
    for number, setting in enumerate(plan.settings):
        places = np.flatnonzero(chosen == number)
        if not len(places):
            continue
        with np.errstate(all="ignore"):  # a run may diverge, and its row says so
            part = _flown(plan, setting, [seeds[int(i)] for i in places])
        for name, values in part.items():
            whole.setdefault(name, np.zeros(len(seeds), values.dtype))[places] = values
    return {"run": np.arange(first, first + len(seeds)), **whole}


def _flown(plan: Plan, setting: Setting, seeds: Sequence[int]) -> Rows:
    """Runs of one setting."""
    reference = plan.course.reference()
    runs = drawn(plan.craft, reference, plan.spread, seeds)
    watch = Watch(space_of(plan.craft), plan.settle, setting.period, len(seeds))
    for moment in _loop(plan, reference, setting, runs).moments():
        watch.see(moment)
    return {**_start(plan, setting.rate, runs, watch), **watch.outcomes()}


def _loop(plan: Plan, reference: Reference, setting: Setting, runs: Runs) -> Loop:
    try:
        return Loop(plan.craft, plan.backend, reference, setting, runs)
    except (CompilerMissing, CompileError) as fault:
        raise CannotFly(str(fault)) from None


def columns(plan: Plan) -> tuple[str, ...]:
    """The names of a result, in their order."""
    n = space_of(plan.craft).dim
    blocks = ("inertia", "disturbance", *_waves(plan))
    return ("run", *START, *(f"{name}_{i}" for name in blocks for i in range(n)), *OUTCOMES)


def _waves(plan: Plan) -> tuple[str, ...]:
    return ("sine", "cosine") if any(plan.spread.wave) else ()


def _start(plan: Plan, rate: float | None, runs: Runs, watch: Watch) -> Rows:
    """What was drawn, a column each."""
    n = runs.nu.shape[0]
    diagonal = np.cumsum([0, *range(n, 1, -1)])  # of an upper triangle by rows
    grown = runs.inertia[diagonal] / np.array(plan.craft.inertia)[diagonal, None]
    blocks = {"inertia": grown, "disturbance": runs.disturbance}
    blocks |= {name: getattr(runs, name) for name in _waves(plan)}
    found = (
        np.array(runs.seeds),
        np.full(len(runs), np.nan if rate is None else rate),
        initial_angles(plan.craft, runs.seeds),
        *watch.start(),
    )
    return {
        **dict(zip(START, found, strict=True)),
        **{f"{name}_{i}": row for name, rows in blocks.items() for i, row in enumerate(rows)},
    }
