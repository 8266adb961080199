"""Pictures of a sweep: how long it takes from how far away, and from where it does not settle."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.simulate.chunk import Rows
from derive.simulate.style import COLOURS, GREY, ruled, sheet, written

Values = NDArray[np.float64]

SIZE, BINS = (6.4, 4.2), 16
FEW = 10  # runs, of which no quantiles are drawn if there are fewer
MARGIN, ROOF, RUG = 0.02, 1.12, 0.04  # beside and above the runs, and of the ticks: of the axes
BLUE, ORANGE = COLOURS[:2]


def pictures(rows: Rows, title: str, seconds: float) -> dict[str, bytes]:
    """File name -> bytes, PNG and SVG of each; equal rows are equal bytes. PlotterMissing.

    seconds: that a run flew at most
    """
    count = len(rows["run"])
    head = f"{title}, {count} run{'s' if count > 1 else ''}"
    found: dict[str, bytes] = {}
    for name, draw in (("settling_time", partial(times, seconds=seconds)), ("success_map", _map)):
        with ruled():
            figure = draw(rows, head)
        found |= {f"{name}{form}": data for form, data in written(figure).items()}
    return found


def times(rows: Rows, title: str, seconds: float) -> Any:
    """Settling time over how far the start is: every run, and quantiles of slices."""
    label, far = _distance(rows)
    settled = rows["settled"]
    taken = rows["settling_time"][settled]
    figure, axes = _axes(title)
    low, high = _ends(far)
    axes.set(xlabel=label, ylabel="settling time  [s]",
             xlim=(low - MARGIN * (high - low), high + MARGIN * (high - low)),
             ylim=(0.0, ROOF * (float(taken.max(initial=0.0)) or seconds)))  # fmt: skip
    if len(taken):
        axes.scatter(far[settled], taken, s=4 if len(taken) > FEW else 16, color=GREY,
                     linewidths=0, alpha=0.45 if len(taken) > FEW else 1.0, rasterized=True,
                     label="a run that settles")  # fmt: skip
    else:
        axes.text(0.5, 0.5, f"no run settles within {seconds:g} s", ha="center", va="center",
                  transform=axes.transAxes)  # fmt: skip
    if len(taken) >= FEW:
        _band(axes, far[settled], taken, "" if settled.all() else ", of runs that settle")
    if not settled.all():
        _rug(axes, far[~settled], len(far))
    legend = figure.legend(
        loc="outside lower center", ncols=2, markerscale=2 if len(taken) > FEW else 1
    )
    for handle in legend.legend_handles[: len(taken) > 0]:
        handle.set_alpha(1.0)
    return figure


def _band(axes: Any, far: Values, taken: Values, of: str) -> None:
    """Quantiles of slices, drawn to the first and the last run."""
    middle, low, mid, high = _bands(far, taken)
    axes.fill_between(middle, low, high, color=BLUE, alpha=0.3, linewidth=0, label=f"5 to 95 %{of}")
    axes.plot(middle, mid, color=BLUE, linewidth=2, label=f"median{of}")


def _rug(axes: Any, lost: Values, count: int) -> None:
    """A tick at the upper edge for each run that does not settle; the fainter, the more there are.

    The legend has a mark of its own: a faint one would not be seen there.
    """
    axes.vlines(lost, 1 - RUG, 1, color=ORANGE, linewidth=0.8, rasterized=True,
                alpha=min(1.0, max(0.06, 60 / len(lost))),
                transform=axes.get_xaxis_transform())  # fmt: skip
    share = f"{len(lost)} of {count}, {100 * len(lost) / count:.2f} %"
    axes.plot([], [], "|", color=ORANGE, markersize=5, label=f"not settled: {share}")


def _map(rows: Rows, title: str) -> Any:
    """Share of settled runs over how far and how fast the start is."""
    label, far = _distance(rows)
    shares, xs, ys = _shares(far, rows["initial_rate"], rows["settled"])
    figure, axes = _axes(f"{title} (blank: none starts there)")
    axes.grid(visible=False)
    mesh = axes.pcolormesh(xs, ys, shares.T, cmap="cividis", vmin=0.0, vmax=1.0)
    figure.colorbar(mesh, ax=axes, label="share of runs that settle")
    axes.set(xlabel=label, ylabel=r"initial $\Vert\nu_e\Vert$")
    return figure


def _axes(title: str) -> tuple[Any, Any]:
    figure = sheet(*SIZE)
    figure.set_layout_engine("constrained")
    return figure, figure.add_subplot(title=title)


def _shares(far: Values, speed: Values, settled: NDArray[Any]) -> tuple[Any, Values, Values]:
    """Share of each cell, masked where nothing starts, and the edges of the cells."""
    edges = [np.linspace(*_ends(values), BINS + 1) for values in (far, speed)]
    count, xs, ys = np.histogram2d(far, speed, bins=edges)
    good, *_ = np.histogram2d(far[settled], speed[settled], bins=edges)
    shares = np.ma.masked_invalid(good / np.where(count, count, np.nan))
    return shares, xs, ys


def _distance(rows: Rows) -> tuple[str, Values]:
    """The initial angle, or the height where nothing turns."""
    angle = rows["initial_angle"]
    if np.isfinite(angle).all():
        return "initial angle  [rad]", angle
    return "initial height", rows["initial_height"]


def _bands(far: Values, taken: Values) -> tuple[Values, ...]:
    """Middle, and the 5, 50 and 95 % quantiles, of slices with as many runs each.

    The outer slices reach to the first and to the last run.
    """
    order = np.argsort(far, kind="stable")
    slices = np.array_split(order, min(BINS, len(order) // FEW))
    middle = np.array([np.median(far[one]) for one in slices])
    found = np.array([np.quantile(taken[one], (0.05, 0.5, 0.95)) for one in slices])
    ends = np.concatenate([[far.min()], middle, [far.max()]])
    return (ends, *np.pad(found, ((1, 1), (0, 0)), "edge").T)


def _ends(values: Values) -> tuple[float, float]:
    low, high = float(values.min()), float(values.max())
    return (low, high) if high > low else (max(0.0, low - 0.5), high + 0.5)
