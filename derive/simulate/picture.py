"""Pictures of flights side by side: performance in four panels, sliding variables against zero."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from derive.control.motion import measure
from derive.lie.group import Group
from derive.simulate.flight import Flight
from derive.simulate.space import Array
from derive.simulate.style import GREY, headed, label_ends, line, logarithmic, panels, ruled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Entry = tuple[str, Flight]
"""What a line is called, and what it shows."""

DEEPEST = 1e-12  # lowest value on a logarithmic axis
BESIDE = 0.95  # inches, for names
FLOOR = 1e-300  # a logarithm of zero is not drawn


@dataclass(frozen=True)
class Captions:
    """What the four panels show, each with its unit, in mathtext."""

    height: str
    rate: str
    force: str
    energy: str

    @property
    def each(self) -> tuple[str, str, str, str]:
        """In the order of the panels."""
        return self.height, self.rate, self.force, self.energy


ROOT = r"$\sqrt{\mathrm{s}}$"

PAPER = Captions(
    r"$\Psi(R_e)$",
    r"$\Vert\Omega_e\Vert$  [rad/s]",
    r"$\Vert\tau\Vert$  [N m]",
    r"$(\int_0^t\,\tau^{\mathsf{T}}\tau\,\mathrm{d}t)^{1/2}$" + f"  [N m {ROOT}]",
)


def captions_of(group: Group) -> Captions:
    """Names and units on any group."""
    far, force = measure(group), _raised(group.force_unit)
    root = rf"({force}) {ROOT}" if ", " in force else f"{force} {ROOT}"
    return Captions(
        f"{_symbols(far.name)}  [{_raised(far.unit)}]",
        rf"$\Vert\nu_e\Vert$  [{_raised(group.unit)}]",
        rf"$\Vert$force$\Vert$  [{force}]",
        rf"$(\int_0^t\,\Vert$force$\Vert^2\,\mathrm{{d}}t)^{{1/2}}$  [{root}]",
    )


def _symbols(name: str) -> str:
    """The name of a Morse function as a formula."""
    told = re.sub(r"\bq0\b", "q_0", name)
    told = re.sub(r"\b(Psi|log)\b", r"\\\1", told)
    return f"${told}$"


def _raised(unit: str) -> str:
    """A unit with its powers raised."""
    return re.sub(r"\^(\d+)", r"$^{\1}$", unit)


@dataclass(frozen=True)
class Panel:
    """One row of the figure: what it shows, and whether all of it stands on a logarithmic scale."""

    values: Callable[[Flight], Array]
    is_log: bool


PANELS = (
    Panel(lambda flight: flight.height, True),
    Panel(lambda flight: flight.rate_error(), True),
    Panel(lambda flight: flight.effort(), True),
    Panel(lambda flight: flight.energy, False),
)


def performance(
    entries: Sequence[Entry], captions: Captions, title: str = "", first: float = 10.0
) -> Figure:
    """Height, |nu_e|, |force| and energy over time: the first seconds, and beside them all.

    What falls by decades is linear on the left and logarithmic on the right.
    """
    whole = max(float(flight.t[-1]) for _, flight in entries)
    with ruled():
        figure, grid = panels(4, 2, 1.32, BESIDE if len(entries) > 1 else 0.2, sharex="col")
        for letter, (left, right), panel, caption in zip(
            "abcd", grid, PANELS, captions.each, strict=True
        ):
            lines = [(name, flight.t, panel.values(flight)) for name, flight in entries]
            _fill(left, lines, min(first, whole), is_log=False)
            _fill(right, lines, whole, is_log=panel.is_log)
            left.set_title(f"({letter})  {caption}", loc="left")
        for axes in grid[-1]:
            axes.set_xlabel("time  [s]")
        headed(figure, title)
        for axes, panel in zip(grid[:, 1], PANELS, strict=True):
            _name(axes, [(name, panel.values(flight)) for name, flight in entries])
    return figure


def _fill(
    axes: Axes, lines: Sequence[tuple[str, Array, Array]], seconds: float, *, is_log: bool
) -> None:
    for index, (name, t, values) in enumerate(lines):
        shown = np.where(values > FLOOR, values, np.nan) if is_log else values
        axes.plot(t, shown, label=name, **line(index))
    axes.set_xlim(0, seconds)
    if is_log:
        logarithmic(axes, DEEPEST)
    else:
        axes.set_ylim(bottom=0)


def _name(axes: Axes, lines: Sequence[tuple[str, Array]]) -> None:
    """Each line named where it ends; one alone needs no name."""
    if len(lines) > 1:
        label_ends(axes, *zip(*((name, float(values[-1])) for name, values in lines), strict=True))


def sliding(
    entries: Sequence[Entry],
    names: Sequence[str],
    unit: str,
    title: str = "",
    seconds: float | None = None,
) -> Figure:
    """The components of s, one panel for each entry, against s = 0.

    names: of the components; seconds: what is shown, from the start; None for everything
    """
    with ruled():
        rows = -(-len(entries) // 2)
        figure, grid = panels(rows, min(2, len(entries)), 1.75, 0.2, 0.3, sharex=True, sharey=True)
        for axes in grid.flat[len(entries) :]:
            axes.remove()
        for axes, letter, (name, flight) in zip(grid.flat, "abcdefgh", entries, strict=False):
            axes.axhline(0.0, color=GREY, linewidth=0.8)
            for index, values in enumerate(flight.s.T):
                axes.plot(flight.t, values, label=names[index], **line(index))
            axes.set_xlim(0, seconds or flight.t[-1])
            axes.set_title(f"({letter})  {name}" if len(entries) > 1 else name, loc="left")
        for axes in grid[-1]:
            axes.set_xlabel("time  [s]")
        for axes in grid[:, 0]:
            axes.set_ylabel(f"components of $s$  [{unit}]")
        grid.flat[0].legend(loc="upper right", handlelength=3.2, fontsize=8.5)
        grid.flat[0].locator_params(axis="x", steps=[1, 2, 5, 10])
        headed(figure, title)
    return figure
