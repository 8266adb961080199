"""Pictures of a sweep: how long it takes from how far away, and from where it does not settle."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.simulate.chunk import Rows
from derive.simulate.style import COLOURS, GREY, ruled, sheet, written

Values = NDArray[np.float64]

SIZE, BINS = (6.4, 4.2), 16
BLUE, ORANGE = COLOURS[:2]


def pictures(rows: Rows, title: str) -> dict[str, bytes]:
    """File name -> bytes, PNG and SVG of each; equal rows are equal bytes. PlotterMissing."""
    found: dict[str, bytes] = {}
    for name, draw in (("settling_time", _times), ("success_map", _map)):
        with ruled():
            figure = draw(rows, title)
        found |= {f"{name}{form}": data for form, data in written(figure).items()}
    return found


def _times(rows: Rows, title: str) -> Any:
    """Settling time over how far the start is: every run, and quantiles of slices."""
    label, far = _distance(rows)
    settled = rows["settled"]
    figure, axes = _axes(title)
    axes.scatter(far[settled], rows["settling_time"][settled], s=4, color=GREY, linewidths=0,
                 alpha=0.45, rasterized=True, label="a run")  # fmt: skip
    middle, low, mid, high = _bands(far[settled], rows["settling_time"][settled])
    axes.fill_between(middle, low, high, color=BLUE, alpha=0.3, linewidth=0, label="5 to 95 %")
    axes.plot(middle, mid, color=BLUE, linewidth=2, label="median")
    if not settled.all():
        lost = far[~settled]
        axes.plot(lost, np.ones(len(lost)), "x", color=ORANGE, markersize=5, clip_on=False,
                  transform=axes.get_xaxis_transform(), label="not settled")  # fmt: skip
    axes.set(xlabel=label, ylabel="settling time  [s]")
    axes.legend(loc="lower right", markerscale=2)
    return figure


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


def _bands(far: Values, times: Values) -> tuple[Values, ...]:
    """Middle, and the 5, 50 and 95 % quantiles, of slices with as many runs each."""
    order = np.argsort(far, kind="stable")
    slices = [one for one in np.array_split(order, BINS) if len(one)]
    middle = np.array([np.median(far[one]) for one in slices])
    found = np.array([np.quantile(times[one], (0.05, 0.5, 0.95)) for one in slices])
    return (middle, *found.reshape(-1, 3).T)


def _ends(values: Values) -> tuple[float, float]:
    low, high = float(values.min()), float(values.max())
    return (low, high) if high > low else (low - 0.5, high + 0.5)
