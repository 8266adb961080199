"""The vehicles that are measured, and the states they are measured at."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from derive import pipeline
from derive.lie.catalogue import named
from derive.vehicle import Vehicle, load

Array = NDArray[np.float64]

ROOT = Path(__file__).parents[1]
ROUTINES = ("tracking", "reaching", "control", "plant")
MEASURED = {
    "paper_so3": ROUTINES,
    "paper_s3": ROUTINES,
    "hovercraft": ("tracking",),
    "freeflyer": ("tracking",),
    "underwater": ("tracking",),
}
"""Vehicle -> the routines whose instructions are counted: on SO3, S3, SE2, SE3 and SE3."""

ANGLES = (0.0, 1e-12, 1e-8, 1e-4, 1e-2, 0.1, 1.0, 2.0, 3.0, np.pi - 1e-2, np.pi - 1e-6, np.pi)
AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (-1.0, 0.0, 0.0), (1.0, -2.0, 3.0))


def vehicle(name: str) -> Vehicle:
    """A vehicle of the repository by name."""
    return load(ROOT / "vehicles" / f"{name}.toml")


def place(name: str, folder: Path) -> Path:
    """Emit a vehicle below folder and return its own folder."""
    root = folder / name
    for path, text in pipeline.texts(vehicle(name)).items():
        file = root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return root


def _rotation(axis: Array, angle: float) -> Array:
    x, y, z = axis / np.linalg.norm(axis)
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K)


def _quaternion(axis: Array, angle: float) -> Array:
    unit = axis / np.linalg.norm(axis)
    return np.concatenate(([np.cos(angle / 2)], np.sin(angle / 2) * unit))


def _pose(axis: Array, angle: float) -> Array:
    """A rotation, and the axis itself as translation."""
    g = np.eye(4)
    g[:3, :3], g[:3, 3] = _rotation(axis, angle), axis
    return g


def _plane_pose(axis: Array, angle: float) -> Array:
    g = np.eye(3)
    g[:2, :2], g[:2, 2] = _rotation(np.array([0.0, 0.0, 1.0]), angle)[:2, :2], axis[:2]
    return g


ELEMENT = {"SO3": _rotation, "S3": _quaternion, "SE2": _plane_pose, "SE3": _pose}
"""Group -> element of an axis and an angle, in the group's storage."""


def states(group: str) -> Iterator[dict[str, Array]]:
    """g, nu and a reference at the identity, over the ladder of angles and a handful of axes.

    What a vehicle has besides, a known force, stays zero.
    """
    random = np.random.default_rng(1)
    element, n = ELEMENT[group], named(group).dim
    for axis in AXES:
        for angle in ANGLES:
            yield {
                "g": element(np.array(axis), angle).ravel(),
                "nu": random.normal(size=n),
                "g_r": element(np.array(axis), 0.0).ravel(),
                "nu_r": random.normal(size=n),
                "nu_r_dot": random.normal(size=n),
            }
