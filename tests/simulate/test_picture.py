"""Pictures of flights: whole files, the same twice, every panel labelled, legible."""

from __future__ import annotations

import struct
import subprocess
import sys
import xml.etree.ElementTree as ET
import zlib
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from derive.comparison import AXIS, Comparison
from derive.lie.catalogue import GROUPS
from derive.lie.family import product
from derive.simulate import style
from derive.simulate.flight import Flight
from derive.simulate.picture import PAPER, captions_of, performance, sliding
from derive.simulate.reading import until
from derive.simulate.space import Array
from derive.simulate.sphere import pointing
from derive.simulate.style import COLOURS, LETTER, PlotterMissing, apart, line, need, written

NAMES = ["axis 1", "axis 2", "axis 3"]
SMALLEST = 8.0  # points
VALUES: tuple[Callable[[Flight], Array], ...] = (
    lambda flight: flight.height,
    lambda flight: np.sqrt((flight.nu_e**2).sum(1)),
    lambda flight: np.sqrt((flight.force**2).sum(1)),
    lambda flight: flight.energy,
)
"""What the panels of the performance figure show, of a Flight."""


def entries(compared: Comparison, number: int = 1) -> list[tuple[str, Flight]]:
    return [(name, until(one, 30.0)) for name, one in compared.flights[number].items()]


def drawn(compared: Comparison) -> dict[str, Any]:
    shown = entries(compared)
    return {
        "performance": performance(shown, PAPER, "a title"),
        "sliding": sliding(shown, NAMES, "rad/s", "a title", 15.0),
        "pointing": pointing(shown, AXIS, "a title"),
    }


def test_every_picture_is_a_whole_png_and_svg_and_the_same_twice(compared: Comparison) -> None:
    first, second = drawn(compared), drawn(compared)
    for name, figure in first.items():
        files = written(figure)
        assert files == written(second[name])
        assert list(files) == [".png", ".svg"]
        wide, tall = png_size(files[".png"])
        assert wide > 1000
        assert tall > 800
        root = ET.fromstring(files[".svg"])
        assert root.tag.endswith("svg")
        assert b"<dc:date>" not in files[".svg"]
        assert b"matplotlib" not in files[".png"].lower()


def panels(figure: Any) -> Any:
    """The axes of the performance figure, (4, 2)."""
    return np.array(figure.axes, dtype=object).reshape(4, 2)


def png_size(content: bytes) -> tuple[int, int]:
    """Width and height; every chunk is read and its sum held against what stands there."""
    assert content[:8] == b"\x89PNG\r\n\x1a\n"
    at, kinds = 8, []
    while at < len(content):
        (long,) = struct.unpack(">I", content[at : at + 4])
        kind, data = content[at + 4 : at + 8], content[at + 8 : at + 8 + long]
        assert struct.unpack(">I", content[at + 8 + long : at + 12 + long])[0] == zlib.crc32(
            kind + data
        )
        kinds.append(kind)
        at += 12 + long
    assert kinds[0] == b"IHDR"
    assert kinds[-1] == b"IEND"
    wide, tall = struct.unpack(">II", content[16:24])
    return int(wide), int(tall)


def test_panels_tell_what_they_show(compared: Comparison) -> None:
    figures = drawn(compared)
    rows = panels(figures["performance"])
    for axes, caption in zip(rows[:, 0], PAPER.each, strict=True):
        assert caption in axes.get_title(loc="left")
    assert [axes.get_xlabel() for axes in rows[-1]] == ["time  [s]"] * 2
    assert [axes.get_yscale() for axes in rows[:, 1]] == ["log", "log", "log", "linear"]
    for axes, values in zip(rows[:, 1], VALUES, strict=True):
        ends = sorted(entries(compared), key=lambda one: float(values(one[1])[-1]))
        by_height = sorted(axes.texts, key=lambda one: one.xy[1])
        assert [one.get_text() for one in by_height] == [name for name, _ in ends]
    boxes = figures["sliding"].axes
    assert [axes.get_title(loc="left")[5:] for axes in boxes] == list(compared.flights[1])
    assert all("rad/s" in axes.get_ylabel() for axes in boxes[::2])
    assert [one.get_text() for one in boxes[0].get_legend().get_texts()] == NAMES


def test_lines_show_the_flights(compared: Comparison) -> None:
    figure = performance(entries(compared), PAPER)
    for index, (_, flight) in enumerate(entries(compared)):
        for axes, values in zip(panels(figure)[:, 0], VALUES, strict=True):
            np.testing.assert_array_equal(axes.lines[index].get_ydata(), values(flight))
            assert axes.lines[index].get_color() == COLOURS[index]
    styles = {str(line(index)["linestyle"]) for index in range(len(entries(compared)))}
    assert len(styles) == len(entries(compared))


def test_nothing_is_set_smaller_than_can_be_read(compared: Comparison) -> None:
    from matplotlib.text import Text

    for figure in drawn(compared).values():
        figure.canvas.draw()
        texts = [one for one in figure.findobj(Text) if one.get_text()]
        assert texts
        assert min(one.get_fontsize() for one in texts) >= SMALLEST


@pytest.mark.parametrize("number", [1, 2, 3])
def test_names_beside_lines_do_not_touch(compared: Comparison, number: int) -> None:
    figure = performance(entries(compared, number), PAPER)
    figure.canvas.draw()
    for axes in figure.axes:
        boxes = sorted((one.get_window_extent() for one in axes.texts), key=lambda box: box.y0)
        tall = LETTER * figure.dpi / 72
        middles = [(box.y0 + box.y1) / 2 for box in boxes]
        assert all(b - a >= tall for a, b in pairwise(middles))
        assert all(box.x1 <= figure.bbox.x1 for box in boxes)
        assert all(axes.bbox.y0 - 1 <= box.y0 < box.y1 <= axes.bbox.y1 + 1 for box in boxes)


def test_what_ends_below_the_panel_is_named_in_its_order(compared: Comparison) -> None:
    base = until(compared.flights[1]["gsmc"], 30.0)
    lasts = {"low": 1e-15, "none": np.nan, "lower": 1e-20, "zero": 0.0, "top": 1e-3}
    ended = [(name, replace(base, height=np.where(base.t == base.t[-1], last, base.height)))
             for name, last in lasts.items()]  # fmt: skip
    axes = panels(performance(ended, PAPER))[0, 1]
    by_height = sorted(axes.texts, key=lambda one: one.xy[1])
    assert [one.get_text() for one in by_height] == ["none", "zero", "lower", "low", "top"]


@pytest.mark.parametrize(
    "wanted", [[0.5, 0.5, 0.5], [0.0, 0.0, 1.0, 1.0], [0.1, 0.5, 0.9], [0.2, 0.9, 0.95, 1.0]]
)
def test_places_are_moved_apart_in_order_and_stay_inside(wanted: list[float]) -> None:
    found = apart(wanted, 0.1)
    steps = np.diff(found)
    assert (steps >= 0.1 - 1e-12).all()
    assert found[0] >= 0.05 - 1e-12
    assert found[-1] <= 0.95 + 1e-12
    free = np.diff(wanted).min(initial=1.0) >= 0.1
    assert not free or found == pytest.approx(wanted)


@pytest.mark.parametrize(
    ("low", "high"), [(1.1, 1.2), (0.3, 0.9), (2e-6, 9e-6), (0.5, 5.0), (2.1e-5, 9.9e-4)]
)
def test_a_panel_of_any_height_has_ticks_with_numbers(
    compared: Comparison, low: float, high: float
) -> None:
    flight = until(compared.flights[1]["gsmc"], 30.0)
    bent = replace(flight, height=np.linspace(high, low, len(flight.t)))
    figure = performance([("one", bent)], PAPER)
    figure.canvas.draw()
    axes = panels(figure)[0, 1]
    bottom, top = axes.get_ylim()
    told = [one.get_text() for one, y in zip(axes.get_yticklabels(), axes.get_yticks(), strict=True)
            if bottom <= y <= top]  # fmt: skip
    assert len(told) >= 2
    assert all(told)


def test_a_panel_alone_has_no_letter(compared: Comparison) -> None:
    (axes,) = sliding(entries(compared)[:1], NAMES, "rad/s").axes
    assert axes.get_title(loc="left") == "gsmc"


@pytest.mark.parametrize(
    ("factors", "told"),
    [
        (("SE3", "SO3"), r"$V_1 + |p|^2/2 + \Psi$  [1, m$^{2}$]"),
        (("R3", "S3"), r"$|\log|^2/2 + 1 - q_0$  [square of log, 1]"),
    ],
)
def test_heights_are_set_as_formulas(
    factors: tuple[str, ...], told: str, compared: Comparison
) -> None:
    found = captions_of(product(*(GROUPS[name] for name in factors)))
    assert found.height == told
    written(performance(entries(compared)[:1], found))  # every letter has a shape


@pytest.mark.parametrize("group", GROUPS.values(), ids=lambda group: str(group.name))
def test_every_group_has_captions_with_units(group: Any, compared: Comparison) -> None:
    told = captions_of(group)
    assert all("[" in one and "]" in one for one in told.each)
    written(performance(entries(compared)[:1], told))  # every letter has a shape


def test_one_flight_alone_needs_no_names(compared: Comparison) -> None:
    assert not any(axes.texts for axes in performance(entries(compared)[:1], PAPER).axes)


def test_rules_do_not_leak(compared: Comparison) -> None:
    import matplotlib

    before = dict(matplotlib.rcParams)
    performance(entries(compared), PAPER)
    assert dict(matplotlib.rcParams) == before


def test_a_missing_matplotlib_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(style, "find_spec", lambda name: None)
    with pytest.raises(PlotterMissing, match="matplotlib"):
        need()


def test_importing_the_comparison_does_not_import_matplotlib() -> None:
    code = "import sys, derive.comparison; sys.exit('matplotlib' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
