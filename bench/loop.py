"""The closed loop on every group: W = s' I s/2 must fall as exp(-2 k_s t), exactly."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from bench import made
from bench.figure import Figure
from bench.flight import Flight, Found
from bench.motion import Case
from derive.native.load import load_module
from derive.terminal import progress
from derive.verify.limits import LIMITS

CUT_MARGIN = 0.3  # rad, that every error must keep from the cut

BOTH = ("external", "momentum")
CASES = (
    *map(Case, ("SO2", "SO3", "S3", "SE2", "SE3", "SE23", "R3", "SO3 x R3", "SE3 x SO3")),
    *(Case("Heisenberg"), Case("SL2", "skew"), Case("SL2", "cayley"), Case("SE3", "cayley")),
    *(Case("SO3", options=("momentum",)), Case("S3", options=BOTH)),
    *(Case("SE2", options=("external",)), Case("SE3", options=BOTH)),
    Case("Heisenberg", options=BOTH),
)


def emitted(case: Case) -> str:
    """The numpy module of a case, as text."""
    return made.texts(case.group, case.law, case.options)["numpy/made.py"]


def closed(case: Case, text: str, folder: Path, seed: int = 0) -> Found:
    """Close the loop through the module of that text."""
    file = made.place({"made.py": text}, folder) / "made.py"
    return Flight(case, load_module(file), seed).run()


def is_regular(found: Found) -> bool:
    """Whether no error came near the cut and no call was refused or warned of."""
    return found.turn < np.pi - CUT_MARGIN and found.statuses == {0}


def measure(folder: Path) -> list[Figure]:
    """Every case; ArithmeticError where the loop left where the law is smooth."""
    show = progress()
    figures = []
    for case in CASES:
        show(case.name)
        found = closed(case, emitted(case), folder)
        if not is_regular(found):
            raise ArithmeticError(f"{case.name}: the loop left where the law is smooth, {found}")
        figures.append(Figure(case.name, found.energy, "relative", bound=LIMITS["loop"]))
    show("")
    return figures
