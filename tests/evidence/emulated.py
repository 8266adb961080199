"""Packages that are run on targets: copies of the committed ones, whole or with a defect."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

from derive.evidence.emitted import Emitted
from derive.evidence.machine import MACHINES, Machine
from derive.evidence.target import missing
from tests.evidence import standin

GENERATED = Path(__file__).parents[2] / "generated"
BY_NAME = {machine.name: machine for machine in MACHINES}
M4F, M7 = BY_NAME["Cortex-M4F"], BY_NAME["Cortex-M7"]


def need(*machines: Machine) -> None:
    """Skip, on a laptop, what this machine has no tools for."""
    if reasons := missing(machines or MACHINES):
        assert os.environ.get("CI") != "true", f"CI must run every machine: {reasons}"
        pytest.skip("; ".join(reasons))


def package(name: str, scalar: str, folder: Path) -> Emitted:
    """A copy of a committed package, to be changed at will."""
    root = folder / name
    if not root.exists():
        shutil.copytree(GENERATED / name, root)
    emitted = Emitted(root, name, scalar)
    if not (root / "test" / f"{emitted.prefix}_test.c").exists():
        standin.write(emitted, folder / f"{emitted.prefix}_built")
    return emitted


def inject(emitted: Emitted, routine: str, statement: str) -> Emitted:
    """Put a statement at the head of a routine, and what it may need at the head of the file."""
    text = emitted.source.read_text(encoding="utf-8")
    mark = f"    /* -- {routine} -- */\n"
    assert text.count(mark) == 1
    emitted.source.write_text(text.replace(mark, f"    {statement}\n{mark}"), encoding="utf-8")
    return emitted
