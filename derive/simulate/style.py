"""How pictures look: colours that the colour-blind tell apart, lines that print apart, bytes.

matplotlib is imported only where something is drawn, without its global state and without a
display. Equal flights give equal bytes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib.util import find_spec
from io import BytesIO
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


def label_ends(axes: Axes, names: Sequence[str], ends: Sequence[float]) -> None:
    """Name each line at the right edge, where it ends; names that would overlap are moved apart.

    ends: the last values, in the data of axes whose place, limits and scale are final
    """
    rows = axes.transAxes.inverted().transform(axes.transData.transform([(0.0, y) for y in ends]))
    tall = axes.transAxes.transform((0, 1))[1] - axes.transAxes.transform((0, 0))[1]
    gap = LETTER * GAP * axes.figure.dpi / 72 / tall
    inside = [min(max(float(y), 0.0), 1.0) for y in rows[:, 1]]
    for index, (name, y) in enumerate(zip(names, apart(inside, gap), strict=True)):
        axes.annotate(name, (1.015, y), xycoords="axes fraction", va="center", fontsize=LETTER,
                      color=line(index)["color"], annotation_clip=False)  # fmt: skip


def apart(wanted: Sequence[float], gap: float) -> list[float]:
    """Places as near as can be to the wanted ones in 0 to 1, in their order, a gap apart."""
    order = sorted(range(len(wanted)), key=lambda i: wanted[i])
    groups: list[list[int]] = []
    for i in order:
        groups.append([i])
        while len(groups) > 1 and _start(groups[-1], wanted, gap) < gap + _end(
            groups[-2], wanted, gap
        ):
            groups[-2:] = [groups[-2] + groups[-1]]
    places = [0.0] * len(wanted)
    for group in groups:
        for rank, i in enumerate(group):
            places[i] = _start(group, wanted, gap) + rank * gap
    return places


def _start(group: list[int], wanted: Sequence[float], gap: float) -> float:
    """Where a group of names begins that stand a gap apart about the middle of their places."""
    long = gap * (len(group) - 1)
    middle = sum(wanted[i] for i in group) / len(group)
    return max(min(middle - long / 2, 1.0 - long), 0.0)


def _end(group: list[int], wanted: Sequence[float], gap: float) -> float:
    return _start(group, wanted, gap) + gap * (len(group) - 1)
