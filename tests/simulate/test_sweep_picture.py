"""The picture of settling times: what it says where many runs fail, or few settle."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from derive.simulate.chunk import Rows
from derive.simulate.style import ruled
from derive.simulate.sweep_picture import pictures, times

SECONDS = 12.0


def rows(runs: int, settled: int) -> Rows:
    """The first so many settle, the later the farther out they start; the others do not."""
    far = np.random.default_rng(runs).permutation(np.linspace(0.1, 3.1, runs))
    good = np.arange(runs) < settled
    return {"run": np.arange(runs), "initial_angle": far, "initial_height": far,
            "initial_rate": far, "settled": good,
            "settling_time": np.where(good, 3 + far, np.nan)}  # fmt: skip


def drawn(runs: int, settled: int) -> tuple[Any, list[str]]:
    """The axes and the words of the legend, laid out."""
    with ruled():
        figure = times(rows(runs, settled), "some", SECONDS)
        figure.canvas.draw()
    return figure.axes[0], [text.get_text() for text in figure.legends[0].get_texts()]


def test_quantiles_are_of_the_runs_that_settle_and_say_so_where_some_do_not() -> None:
    _, words = drawn(300, 100)
    assert words == ["a run that settles", "5 to 95 %, of runs that settle",
                     "median, of runs that settle", "not settled: 200 of 300, 66.67 %"]  # fmt: skip
    assert drawn(300, 300)[1] == ["a run that settles", "5 to 95 %", "median"]


def test_the_band_reaches_from_the_first_run_to_the_last() -> None:
    one = rows(300, 300)
    axes, _ = drawn(300, 300)
    band = axes.collections[1].get_paths()[0].vertices[:, 0]
    line = next(one for one in axes.lines if len(one.get_xdata()))
    for x in (band, line.get_xdata()):
        assert (x.min(), x.max()) == (one["initial_angle"].min(), one["initial_angle"].max())


@pytest.mark.parametrize(("runs", "settled"), [(300, 100), (10_000, 9_900), (20, 1), (20, 0)])
def test_runs_that_do_not_settle_are_ticks_within_the_axes(runs: int, settled: int) -> None:
    axes, _ = drawn(runs, settled)
    ticks = axes.collections[-1].get_segments()
    assert len(ticks) == runs - settled
    lowest = min(float(tick[:, 1].min()) for tick in ticks)
    assert max(float(tick[:, 1].max()) for tick in ticks) <= 1.0
    top = np.nanmax([*rows(runs, settled)["settling_time"], 0.0]) / axes.get_ylim()[1]
    assert 0.9 < lowest < 1.0
    assert top < lowest  # no run is hidden behind a tick


@pytest.mark.parametrize("settled", [0, 1, 9])
def test_no_quantiles_are_drawn_of_a_few_runs(settled: int) -> None:
    axes, words = drawn(20, settled)
    assert words == [*["a run that settles"][:settled], words[-1]]
    assert words[-1].startswith("not settled: ")
    low, high = axes.get_ylim()
    assert low == 0.0
    assert high > (SECONDS if settled == 0 else 3.0)
    said = [text.get_text() for text in axes.texts]
    assert said == ([f"no run settles within {SECONDS:g} s"] if settled == 0 else [])


def test_one_run_is_a_picture_as_well() -> None:
    found = pictures(rows(1, 1), "some", SECONDS)
    assert found["settling_time.png"].startswith(b"\x89PNG")
    axes, words = drawn(1, 1)
    assert words == ["a run that settles"]
    low, high = axes.get_xlim()
    assert low < rows(1, 1)["initial_angle"][0] < high
