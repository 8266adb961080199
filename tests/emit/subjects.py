"""What the tests of the emitted code run over: every vehicle file, every law, every controller.

A subject is a vehicle; its texts are derived once per test run and shared.
"""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from derive import pipeline
from derive.control.table import CONTROLLERS
from derive.lie.group import Group
from derive.native.compile import SHARED, Compiler, build
from derive.native.load import Library
from derive.vehicle import Vehicle, load
from derive.vehicle.group import OwnGroup, group_of
from tests.control.drawn import LAWS
from tests.groups import ALL, BASES, MADE, Rows, listed

Array = NDArray[np.float64]

PATTERNS: dict[str, Callable[[int, int], bool]] = {
    "full": lambda i, j: True,
    "diagonal": lambda i, j: i == j,
    "partial": lambda i, j: i == j or (i, j) in ((0, 2), (2, 0)),
}
"""Which entries of an inertia are not zero."""

COMPILERS = tuple(name for name in ("gcc", "clang") if shutil.which(name))
CPP = {"gcc": "g++", "clang": "clang++"}


def _made(
    group: str, law: str, controller: str = "gsmc", pattern: str = "full", *options: str
) -> Vehicle:
    """A vehicle with a diagonally dominant inertia; its numbers all differ."""
    n, present = ALL[group].dim, PATTERNS[pattern]
    entry = [
        [(Fraction(5 + i) if i == j else Fraction(i + j, 10)) * present(i, j) for j in range(n)]
        for i in range(n)
    ]
    gains = tuple(
        (name, Fraction(2 + k, 4)) for k, name in enumerate(CONTROLLERS[controller].names)
    )
    words = (group.lower().replace(" x ", "_"), law, controller, pattern, *options)
    units = ALL[group].units
    return Vehicle(
        name="_".join(words),
        group=group,
        law=law,
        controller=controller,
        inertia=tuple(tuple(row) for row in entry),
        gains=gains,
        scalars=("f32", "f64"),
        targets=("c99", "numpy"),
        source="made for a test",
        own=OwnGroup(group, _frozen(BASES[group]), units) if group in BASES else None,
        options=options,
    )


def _frozen(basis: Sequence[Rows]) -> tuple[tuple[tuple[Fraction, ...], ...], ...]:
    return tuple(tuple(tuple(row) for row in e) for e in basis)


FILES = tuple(load(path) for path in sorted(Path(__file__).parents[2].glob("vehicles/*.toml")))
"""The vehicles that come with the repository."""

WHOLE = ("SO3", "S3", "SE2")
"""Groups of which every law is emitted; of the others one, so that each law has its turn."""


def _sampled(groups: Iterable[str]) -> list[tuple[str, str]]:
    laws = {group: [law for of, law in LAWS if of == group] for group in groups}
    return [
        (group, law)
        for turn, (group, names) in enumerate(laws.items())
        for law in (names if group in WHOLE else [names[turn % len(names)]])
    ]


def _is_random(group: str) -> bool:
    return any(name in group for name in MADE)


LAWFUL = tuple(_made(*pair) for pair in _sampled(name for name in ALL if not _is_random(name)))
"""A law, or all of them, on every group that a vehicle file can name or describe."""

RANDOM = tuple(
    _made(*pair) for pair in _sampled(("Random0", "Random1", "Random2", "SO2 x Random2"))
)
"""A law on random groups of each kind."""

SPARSE = tuple(
    _made(group, law, "gsmc", pattern)
    for group, law in _sampled((*WHOLE, "SE3", "R3", "SL2", "S3 x SE2"))
    for pattern in PATTERNS
    if pattern != "full"
)
STEERED = tuple(
    _made(group, law, controller)
    for group, law in (
        ("SO3", "log"),
        ("S3", "log"),
        ("SE2", "log"),
        ("R3", "log"),
        ("SL2", "skew"),
    )
    for controller, one in CONTROLLERS.items()
    if controller != "gsmc" and one.law in (None, law) and one.exists_on(group)
)
OPTED = (
    _made("SE3", "log", "gsmc", "full", "external", "momentum"),
    _made("S3", "vec", "reaching", "full", "momentum"),
    _made("S3 x SE2", "log", "gsmc", "diagonal", "external"),
    _made("SO3", "skew", "lsf", "partial", "external", "momentum"),
    _made("SO3", "lee", "pd_plus", "diagonal", "external", "momentum"),
)
"""With wheels, and with a known force."""

GUARDED = (*FILES, *LAWFUL, *RANDOM, *STEERED, *OPTED)
"""Every vehicle file, laws on every group, every controller and option."""

ALIKE = (*FILES, *STEERED, *OPTED, *RANDOM[:1])
"""What stands for all of them where the law makes no difference."""

EACH = (*GUARDED, *SPARSE)
"""As GUARDED, and with the zero patterns of an inertia."""


@cache
def group(vehicle: Vehicle) -> Group:
    """The group of a vehicle, those made for the tests included."""
    with listed():
        return group_of(vehicle)


@cache
def texts(vehicle: Vehicle) -> dict[str, str]:
    """Every emitted file by path. A group made for the tests is listed meanwhile."""
    with listed():
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
