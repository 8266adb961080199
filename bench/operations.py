"""Operations and temporaries of tracking on every group: + - * / sqrt, polynomials left out.

On SE3 and SE2 they are held to a count by hand of the same task; see bench/hand_count.py.
"""

from __future__ import annotations

from pathlib import Path

from bench import made
from bench.algebra import OWN
from bench.figure import Figure
from bench.hand_count import BY_HAND, total
from derive.control.kinematic import laws_of
from derive.lie.catalogue import GROUPS
from derive.routine.cost import cost
from derive.verify.limits import LIMITS

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
            if is_full and name in BY_HAND:
                figures.append(_over_hand(name, found.operations))
    return figures


def _over_hand(group: str, operations: int) -> Figure:
    """Emitted operations over those of the count by hand."""
    by_hand, limit = total(group), LIMITS["by hand"]
    label, aside = f"{group} tracking, over a count by hand", f"{by_hand} operations by hand"
    return Figure(label, operations / by_hand, limit.unit, bound=limit, aside=aside)
