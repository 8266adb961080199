"""What the tests of the emitted code run over: every vehicle file, every law, every controller.

A subject is a vehicle; its texts are derived once per test run and shared.
"""

from __future__ import annotations

import shutil
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from derive import pipeline
from derive.control.kinematic import LAWS
from derive.control.table import CONTROLLERS
from derive.lie.catalogue import GROUPS
from derive.native.compile import SHARED, Compiler, build
from derive.native.load import Library
from derive.vehicle import Vehicle, load

Array = NDArray[np.float64]

PATTERNS: dict[str, Callable[[int, int], bool]] = {
    "full": lambda i, j: True,
    "diagonal": lambda i, j: i == j,
    "partial": lambda i, j: i == j or (i, j) in ((0, 2), (2, 0)),
}
"""Which entries of an inertia are not zero."""

COMPILERS = tuple(name for name in ("gcc", "clang") if shutil.which(name))
CPP = {"gcc": "g++", "clang": "clang++"}


def _made(group: str, law: str, controller: str, pattern: str) -> Vehicle:
    """A vehicle with a diagonally dominant inertia; its numbers all differ."""
    n, present = GROUPS[group].dim, PATTERNS[pattern]
    entry = [
        [(Fraction(5 + i) if i == j else Fraction(i + j, 10)) * present(i, j) for j in range(n)]
        for i in range(n)
    ]
    gains = tuple((name, Fraction(2 + k, 4)) for k, name in enumerate(CONTROLLERS[controller]))
    return Vehicle(
        name=f"{group.lower()}_{law}_{controller}_{pattern}",
        group=group,
        law=law,
        controller=controller,
        inertia=tuple(tuple(row) for row in entry),
        gains=gains,
        scalars=("f32", "f64"),
        targets=("c99", "numpy"),
        source="made for a test",
    )


FILES = tuple(load(path) for path in sorted(Path(__file__).parents[2].glob("vehicles/*.toml")))
"""The vehicles that come with the repository."""

LAWFUL = tuple(_made(group, law, "gsmc", "full") for group, law in LAWS)
SPARSE = tuple(
    _made(group, law, "gsmc", pattern)
    for group, law in LAWS
    for pattern in PATTERNS
    if pattern != "full"
)
STEERED = tuple(
    _made(group, "log", controller, "full")
    for group in GROUPS
    for controller in CONTROLLERS
    if controller != "gsmc"
)

GUARDED = (*FILES, *LAWFUL, *STEERED)
"""Every vehicle file, every law on every group, every controller."""

ALL = (*GUARDED, *SPARSE)
"""As GUARDED, and every law with the zero patterns of an inertia."""


@cache
def texts(vehicle: Vehicle) -> dict[str, str]:
    """Every emitted file by path."""
    return pipeline.texts(vehicle)


def place(vehicle: Vehicle, folder: Path) -> Path:
    """Write the emitted files below folder/NAME, once; that folder."""
    root = folder / vehicle.name
    for path, text in texts(vehicle).items():
        if not (file := root / path).exists():
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
    return root


def header(vehicle: Vehicle, scalar: str, folder: Path) -> Path:
    return place(vehicle, folder) / f"c/include/{vehicle.name}_{scalar}.h"


def source(vehicle: Vehicle, scalar: str, folder: Path) -> Path:
    return place(vehicle, folder) / f"c/src/{vehicle.name}_{scalar}.c"


def library(vehicle: Vehicle, scalar: str, folder: Path) -> Library:
    """The emitted C of one scalar, compiled by gcc or whatever there is, and loaded."""
    include = header(vehicle, scalar, folder)
    code = source(vehicle, scalar, folder)
    built = build([code], include.parent, folder / vehicle.name, SHARED, Compiler.find())
    return Library(include, built, f"{vehicle.name}_{scalar}")


def rotation(axis: Array, angle: float) -> Array:
    """Rotation matrix by Rodrigues' formula."""
    x, y, z = axis / np.linalg.norm(axis)
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K)


def quaternion(axis: Array, angle: float) -> Array:
    """Unit quaternion, scalar first."""
    unit = axis / np.linalg.norm(axis)
    return np.concatenate(([np.cos(angle / 2)], np.sin(angle / 2) * unit))


ELEMENT = {"SO3": rotation, "S3": quaternion}
"""Group name -> element of an axis and an angle, in the group's storage, by textbook formula."""
