"""How pictures look: colours that the colour-blind tell apart, lines that print apart, bytes.

matplotlib is imported only where something is drawn, without its global state and without a
display. Equal flights give equal bytes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib.util import find_spec
from io import BytesIO
from math import ceil, floor, inf, isnan, log10
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#000000", "#CC79A7", "#E69F00")
"""Okabe and Ito's, those that are dark enough for a line on paper first."""

DASHES: tuple[Any, ...] = ("-", (0, (5, 1.6)), (0, (1.2, 1.2)), (0, (6, 1.5, 1.2, 1.5)))
GREY, FAINT = "#5A5A5A", "#D4D4D4"

WIDE = 7.1  # inches, two columns of a journal
DOTS = 200  # per inch, of a PNG
LETTER = 8.5  # points, of a label
GAP = 1.25  # heights of a letter from one label to the next

RULES: dict[Any, Any] = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 9.5,
    "axes.titlesize": 10,
    "axes.labelsize": 9.5,
    "xtick.labelsize": 8.5,
    "ytick.labelsize": 8.5,
    "axes.linewidth": 0.6,
    "axes.edgecolor": GREY,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.axisbelow": True,
    "axes.grid": True,
    "grid.color": FAINT,
    "grid.linewidth": 0.4,
    "xtick.color": GREY,
    "ytick.color": GREY,
    "xtick.labelcolor": "black",
    "ytick.labelcolor": "black",
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "lines.linewidth": 1.25,
    "lines.solid_capstyle": "round",
    "legend.frameon": False,
    "svg.hashsalt": "derive",
    "svg.fonttype": "path",
}


class PlotterMissing(Exception):
    """matplotlib is not installed."""


def is_drawable() -> bool:
    """Whether pictures can be drawn here."""
    return find_spec("matplotlib") is not None


def need() -> None:
    """Raise PlotterMissing where nothing can be drawn."""
    if not is_drawable():
        raise PlotterMissing("matplotlib is not installed")


@contextmanager
def ruled() -> Iterator[None]:
    """Our rules while something is drawn or written, and none of the user's."""
    need()
    import matplotlib

    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(RULES)
        yield


def sheet(width: float, height: float) -> Figure:
    """An empty figure, in inches."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), dpi=DOTS)
    FigureCanvasAgg(figure)
    return figure


def panels(
    rows: int, columns: int, tall: float, right: float, between: float = 0.62, **shared: Any
) -> tuple[Figure, Any]:
    """A page of panels and its axes, (rows, columns); tall, right and between are in inches.

    tall: of a panel; right: room for names beside the last column. Nothing is measured, so that
    a layout is quick and the same everywhere.
    """
    above, below, left, over = 0.62, 0.5, 0.62, 0.42
    height = above + rows * tall + (rows - 1) * over + below
    figure = sheet(WIDE, height)
    wide = (WIDE - left - right - (columns - 1) * between) / columns
    place = {
        "left": left / WIDE,
        "right": 1 - right / WIDE,
        "top": 1 - above / height,
        "bottom": below / height,
        "wspace": between / wide,
        "hspace": over / tall,
    }
    return figure, figure.subplots(rows, columns, squeeze=False, gridspec_kw=place, **shared)


def headed(figure: Figure, title: str) -> None:
    """A title over the whole page."""
    figure.text(0.5, 1 - 0.2 / figure.get_figheight(), title, ha="center", va="center",
                fontsize=10.5)  # fmt: skip


def written(figure: Figure) -> dict[str, bytes]:
    """The picture by the ending of its file: .png and .svg."""
    found: dict[str, bytes] = {}
    with ruled():
        for kind, facts in (("png", {"Software": None}), ("svg", {"Date": None, "Creator": None})):
            buffer = BytesIO()
            figure.savefig(buffer, format=kind, metadata=facts, facecolor="white")
            found[f".{kind}"] = buffer.getvalue()
    return found


def line(index: int) -> dict[str, Any]:
    """Colour and dashes of the line with that index."""
    return {"color": COLOURS[index % len(COLOURS)], "linestyle": DASHES[index % len(DASHES)]}


def logarithmic(axes: Axes, deepest: float) -> None:
    """A logarithmic height from `deepest` up, with ticks also where it spans less than a decade."""
    axes.set_yscale("log")
    axes.minorticks_off()
    low, high = axes.get_ylim()
    low = max(low, min(deepest, high / 10))
    axes.set_ylim(low, high)
    if floor(log10(high)) - ceil(log10(low)) < 1:  # one power of ten at most
        _tick_between(axes, low, high)


def _tick_between(axes: Axes, low: float, high: float) -> None:
    """Ticks also between the powers of ten; two or more, each with its number."""
    from matplotlib import ticker

    steps = (1, 2, 5, 10)
    is_wide, is_plain = high / low >= 5, low >= 1e-3 and high < 1e4
    axes.yaxis.set_major_locator(
        ticker.LogLocator(subs=steps[:3]) if is_wide else ticker.MaxNLocator(4, steps=steps)
    )
    axes.yaxis.set_major_formatter(
        ticker.StrMethodFormatter("{x:g}") if is_plain
        else ticker.LogFormatterSciNotation(minor_thresholds=(inf, inf))
    )  # fmt: skip


def label_ends(axes: Axes, names: Sequence[str], ends: Sequence[float]) -> None:
    """Name each line at the right edge, where it ends; names that would overlap are moved apart.

    ends: the last values, in the data of axes whose place, limits and scale are final. What ends
    outside of the limits is named at their edge, in the order of the values; what has no last
    value, NaN, at the bottom
    """
    low, high = axes.get_ylim()
    known = [-inf if isnan(end) else end for end in ends]
    order = sorted(range(len(names)), key=known.__getitem__)
    shown = [(0.0, min(max(known[i], low), high)) for i in order]
    rows = axes.transAxes.inverted().transform(axes.transData.transform(shown))
    tall = axes.transAxes.transform((0, 1))[1] - axes.transAxes.transform((0, 0))[1]
    gap = LETTER * GAP * axes.figure.dpi / 72 / tall
    for i, y in zip(order, apart([float(y) for y in rows[:, 1]], gap), strict=True):
        axes.annotate(names[i], (1.015, y), xycoords="axes fraction", va="center",
                      fontsize=LETTER, color=line(i)["color"], annotation_clip=False)  # fmt: skip


def apart(wanted: Sequence[float], gap: float) -> list[float]:
    """Places as near as can be to the wanted ones, which rise, a gap apart.

    All are half a gap or more inside 0 to 1, so that names stand beside their axes; what does not
    fit stands over at the top.
    """
    groups: list[list[float]] = []
    for place in wanted:
        groups.append([place])
        while len(groups) > 1 and _start(groups[-1], gap) < gap + _end(groups[-2], gap):
            groups[-2:] = [groups[-2] + groups[-1]]
    return [_start(group, gap) + rank * gap for group in groups for rank in range(len(group))]


def _start(group: list[float], gap: float) -> float:
    """Where a group of names begins that stand a gap apart about the middle of their places."""
    long = gap * (len(group) - 1)
    middle = sum(group) / len(group)
    return max(min(middle - long / 2, 1.0 - gap / 2 - long), gap / 2)


def _end(group: list[float], gap: float) -> float:
    return _start(group, gap) + gap * (len(group) - 1)
