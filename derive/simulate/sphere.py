"""Where a body axis points: paths on the unit sphere, seen from one side.

The sphere is drawn as a plane picture, its far side faint, so that what is behind it looks so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from derive.simulate.flight import Flight
from derive.simulate.picture import Entry
from derive.simulate.space import Array
from derive.simulate.style import GREY, headed, line, ruled, sheet

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SEEN, BEHIND = 1.0, 0.28  # opacity of a path on the near and on the far side
MESH = 30  # degrees between the lines of the mesh
REFERENCE = "#9C9C9C"
RISEN = 0.62  # rad, of the eye over or under the middle of the reference path


def pointing(entries: Sequence[Entry], axis: int, title: str = "") -> Figure:
    """The path of a body axis, 1 to 3, of flights on SO3, and of the same axis of the reference.

    Inertial coordinates; a ring marks where each path begins, a dot where it ends.
    """
    with ruled():
        figure = sheet(6.1, 4.6)
        axes = figure.add_axes((0.01, 0.01, 0.70, 0.91))
        reference = _path(entries[0][1].g_r, axis)
        paths = [_path(flight.g, axis) for _, flight in entries]
        eye = _eye(reference, paths)
        _sphere(axes, eye)
        _draw(axes, reference @ eye.T, REFERENCE, "-", 3.4, "reference")
        for index, ((name, _), path) in enumerate(zip(entries, paths, strict=True)):
            style = line(index)
            _draw(axes, path @ eye.T, style["color"], style["linestyle"], 1.4, name)
        axes.set(aspect="equal", xlim=(-1.06, 1.06), ylim=(-1.06, 1.06))
        axes.set_axis_off()
        handles, names = axes.get_legend_handles_labels()
        figure.legend(handles, names, loc="center left", bbox_to_anchor=(0.73, 0.5),
                      handlelength=3.2, fontsize=9, title="ring: start, dot: end",
                      title_fontsize=9, alignment="left")  # fmt: skip
        headed(figure, title)
    return figure


def in_space(flight: Flight) -> Flight:
    """A flight on S3 as one on SO3, (T, 9) for (T, 4); any other as it is."""
    if flight.g.shape[1] != 4:
        return flight
    return replace(flight, g=_matrices(flight.g), g_r=_matrices(flight.g_r))


def _matrices(q: Array) -> Array:
    """Rotation matrices, row by row, of unit quaternions, scalar first."""
    w, x, y, z = q.T
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )
    return np.stack([entry for row in rows for entry in row], axis=-1)


def _path(g: Array, axis: int) -> Array:
    """R e_axis over time, (T, 3), of stored matrices (T, 9)."""
    return np.asarray(g.reshape(-1, 3, 3)[:, :, axis - 1])


def _eye(path: Array, others: Sequence[Array]) -> Array:
    """Rows: right, up and towards the eye, (3, 3), which sees the path and most of the others."""
    towards = _unit(path.sum(axis=0), path[0])
    turns = np.cross(path[0], path[len(path) // 2])
    aside = np.cross(towards, np.eye(3)[np.abs(towards).argmin()])
    up = _unit(turns - turns.dot(towards) * towards, aside)
    every = np.concatenate(others)
    both = [np.cos(RISEN) * towards + side * np.sin(RISEN) * up for side in (1, -1)]
    seen = max(both, key=lambda eye: float(np.count_nonzero(every @ eye > 0)))
    right = _unit(np.cross(up, seen), aside)
    return np.stack([right, np.cross(seen, right), seen])


def _unit(x: Array, otherwise: Array) -> Array:
    """x, or the other vector where x is none, as of an axis at rest, made a unit."""
    given = x if np.linalg.norm(x) > 1e-9 else otherwise
    return np.asarray(given / np.linalg.norm(given))


def _sphere(axes: Axes, eye: Array) -> None:
    """Outline and mesh; the mesh of inertial coordinates, on the near side."""
    around = np.linspace(0.0, 2 * np.pi, 181)
    axes.fill(np.cos(around), np.sin(around), facecolor="#F6F6F4", edgecolor=GREY, linewidth=0.7)
    for degrees in range(-90 + MESH, 90, MESH):
        up = np.radians(degrees)
        level = np.full_like(around, np.sin(up))
        ring = np.stack([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), level], axis=-1)
        _thin(axes, ring @ eye.T)
    for degrees in range(0, 180, MESH):
        turn = np.radians(degrees)
        flat = np.cos(around)
        ring = np.stack([flat * np.cos(turn), flat * np.sin(turn), np.sin(around)], axis=-1)
        _thin(axes, ring @ eye.T)
    for name, tip in zip("xyz", eye.T, strict=True):
        if tip[2] > 0:
            axes.text(
                1.03 * tip[0], 1.03 * tip[1], f"${name}$", ha="center", fontsize=9, color=GREY
            )


def _thin(axes: Axes, ring: Array) -> None:
    near = np.where((ring[:, 2] > 0)[:, None], ring, np.nan)
    axes.plot(near[:, 0], near[:, 1], color="#C4C4C0", linewidth=0.5, linestyle="-")


def _draw(axes: Axes, path: Array, colour: str, dashes: object, width: float, name: str) -> None:
    """One path, its far part faint, with a ring at its start and a dot at its end."""
    far = np.where((path[:, 2] < 0)[:, None], path, np.nan)
    near = np.where((path[:, 2] >= 0)[:, None], path, np.nan)
    axes.plot(far[:, 0], far[:, 1], color=colour, linewidth=0.7 * width, alpha=BEHIND,
              linestyle="-")  # fmt: skip
    axes.plot(near[:, 0], near[:, 1], color=colour, linewidth=width, linestyle=dashes,
              label=name)  # fmt: skip
    for at, face in ((0, "white"), (-1, colour)):
        shown = SEEN if path[at, 2] >= 0 else BEHIND
        axes.plot(path[at, 0], path[at, 1], marker="o", markersize=3.6 + width / 3, color=colour,
                  markerfacecolor=face, alpha=shown, zorder=4)  # fmt: skip
