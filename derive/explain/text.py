"""Formulas on a line of plain text, in the names of the code."""

from __future__ import annotations

from collections.abc import Sequence

from derive.explain.notation import RENAMED, Cases, Notation, conditions


def _cases(cases: Cases) -> str:
    width = max(len(value) for value, _ in cases)
    rows = conditions(cases, "if %s", "otherwise")
    return "".join(f"\n    {value:<{width}}  {condition}" for value, condition in rows)


def _matrix(rows: Sequence[Sequence[str]]) -> str:
    """As a vehicle file has it."""
    return f"[{', '.join(['[' + ', '.join(row) + ']' for row in rows])}]"


TEXT = Notation(
    symbol=lambda name: RENAMED.get(name, name),
    is_flat=True,
    width=10**6,  # lines are folded where they are laid out
    product=" ",
    plus=" + ",
    minus="-",
    less=" - ",
    fraction="%s/%s",
    power="%s^%s",
    root="sqrt(%s)",
    absolute="|%s|",
    group="(%s)",
    opening="(",
    closing=")",
    call="%s(%s)",
    prime="%s'",
    actions={"Ad": "Ad(%s)", "ad": "ad(%s)", "coad": "ad*(%s)"},
    relation=" %s ",
    relations={},
    both=" and ",
    column=lambda entries: f"({', '.join(entries)})",
    matrix=_matrix,
    cases=_cases,
    single="%s",
    rows=lambda rows: "\n".join(f"{left} = {right}" for left, right in rows),
    plain=str,
    code=str,
)
