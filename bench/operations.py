"""Operations and temporaries of tracking on every group: + - * / sqrt, polynomials left out."""

from __future__ import annotations

from pathlib import Path

from bench import made
from bench.algebra import OWN
from bench.figure import Figure
from derive.control.kinematic import laws_of
from derive.lie.catalogue import GROUPS
from derive.routine.cost import cost

SUBJECTS = (*GROUPS, "SO3 x R3", "SO3 x SO3", "SE3 x SO3", *OWN)
INERTIAS = {"diagonal": False, "full": True}


def measure(_: Path) -> list[Figure]:
    """Every group with its first law, a diagonal inertia and a full one."""
    figures = []
    for name in SUBJECTS:
        group = made.group(name)
        law = next(iter(laws_of(group)))
        for inertia, is_full in INERTIAS.items():
            found = cost(made.derived(name, law, is_full).main)
            label = f"{name} tracking, {law}, {inertia}"
            aside = f"dim {group.dim}, {found.temporaries} temporaries"
            figures.append(Figure(label, found.operations, "operations", aside=aside))
    return figures
