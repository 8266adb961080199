"""A vehicle on any group, a full or a diagonal inertia, and what is derived and emitted for it."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from pathlib import Path

from bench.algebra import OWN, algebra
from derive import pipeline
from derive.control.controller import Routines
from derive.lie.group import Group
from derive.vehicle import OwnGroup, Vehicle
from derive.vehicle.group import group_of

GAINS = (("lambda", Fraction(1, 2)), ("k_s", Fraction(1)))
"""As in the paper, 1/s."""


@cache
def vehicle(
    name: str, law: str = "log", options: tuple[str, ...] = (), is_full: bool = True
) -> Vehicle:
    """A vehicle on a group of the catalogue, a product, or one that is made of its basis."""
    n = algebra(name).dim
    entry = {True: Fraction(5), False: Fraction(is_full, 10)}
    return Vehicle(
        name="made",
        group=name,
        law=law,
        controller="gsmc",
        inertia=tuple(tuple(entry[i == j] for j in range(n)) for i in range(n)),
        gains=GAINS,
        scalars=("f32", "f64"),
        targets=("c99", "numpy"),
        source="made to be measured",
        own=_own(name) if name in OWN else None,
        options=options,
    )


def _own(name: str) -> OwnGroup:
    basis = algebra(name).basis.tolist()
    exact = tuple(tuple(tuple(map(Fraction, row)) for row in e) for e in basis)
    return OwnGroup(name, exact, ("1/s",) * len(basis))


def group(name: str) -> Group:
    """The same group as derive has it."""
    return group_of(vehicle(name))


def derived(name: str, law: str, is_full: bool = True) -> Routines:
    """All its routines."""
    return pipeline.derivations(vehicle(name, law, (), is_full))


@cache
def texts(name: str, law: str = "log", options: tuple[str, ...] = ()) -> dict[str, str]:
    """The emitted files by path, prefix `made`."""
    return pipeline.texts(vehicle(name, law, options))


def place(files: dict[str, str], root: Path) -> Path:
    """Write emitted files below root."""
    for path, text in files.items():
        file = root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return root
