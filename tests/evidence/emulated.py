"""Packages that are run on targets, whole or with a defect."""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import pytest

from derive import pipeline
from derive.evidence.emitted import Emitted
from derive.evidence.machine import MACHINES, Machine
from derive.evidence.target import missing
from derive.vehicle import load

VEHICLES = Path(__file__).parents[2] / "vehicles"
BY_NAME = {machine.name: machine for machine in MACHINES}
M4F, M7 = BY_NAME["Cortex-M4F"], BY_NAME["Cortex-M7"]


def need(*machines: Machine) -> None:
    """Skip, on a laptop, what this machine has no tools for."""
    if reasons := missing(machines or MACHINES):
        assert os.environ.get("CI") != "true", f"CI must run every machine: {reasons}"
        pytest.skip("; ".join(reasons))


@cache
def texts(name: str) -> Mapping[str, str]:
    """The files of a vehicle of the repository, as this tree emits them."""
    return pipeline.texts(load(VEHICLES / f"{name}.toml"))


def package(name: str, scalar: str, folder: Path) -> Emitted:
    """A vehicle's package below a folder, to be changed at will."""
    root = folder / name
    for path, text in texts(name).items():
        if not (file := root / path).exists():
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
    return Emitted(root, name, scalar)


def inject(emitted: Emitted, routine: str, statement: str) -> Emitted:
    """Put a statement at the head of a routine: of a law, where what follows the error begins."""
    text = emitted.source.read_text(encoding="utf-8")
    mark = f"    /* -- {routine} -- */\n"
    assert mark in text
    emitted.source.write_text(text.replace(mark, f"    {statement}\n{mark}", 1), encoding="utf-8")
    return emitted
