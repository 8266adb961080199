"""One routine as what a template lays out: its quantities, and its steps with their lines."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from sympy import Expr, ImmutableMatrix, Symbol

from derive.explain import paper
from derive.explain.formula import display, matrix_of
from derive.explain.notation import Notation
from derive.routine.derivation import Derivation, Quantity, Step

Printed = dict[str, Any]
Lines = list[tuple[int, str]]
"""Lines of code with their numbers."""


Algebra = Sequence[tuple[ImmutableMatrix, str]]
"""Basis matrices (m, m), each with the unit of a velocity's coordinate."""


def label(d: Derivation, step: Step) -> str:
    """Equation label of a step, its routine's where it has none: eq. (TckCtrl) is TckCtrl."""
    source = step.quantity.source or d.source
    inside = re.search(r"\((.+)\)", source)
    return inside[1] if inside else source


def shown(d: Derivation, equation: str | None) -> list[Step]:
    """The steps of one label; all of them for none."""
    return [step for step in d.steps if equation in (None, label(d, step))]


def algebra(basis: Algebra, n: Notation) -> list[Printed]:
    """A basis, matrix by matrix, with the unit of its coordinate."""
    return [
        {"formula": matrix_of(f"E_{i}", e, n), "unit": n.plain(unit)}
        for i, (e, unit) in enumerate(basis)
    ]


def section(
    d: Derivation, equation: str | None, blocks: Mapping[tuple[str, str], Lines], n: Notation
) -> Printed:
    """All of a routine, or the steps of one label alone; blocks: (routine, step) -> its lines."""
    steps = shown(d, equation)
    names = {step.quantity.name for step in d.steps}
    bare = [output for output in d.outputs if output[0].name not in names]
    is_whole = equation is None
    return {
        "name": d.name,
        "doc": n.plain(d.doc),
        "source": n.plain(d.source),
        "paper": _said(paper.routine(d), n),
        "inputs": [_quantity(q, n) for q in d.inputs] if is_whole else [],
        "steps": [_step(d, step, blocks[d.name, step.quantity.name], n) for step in steps],
        "outputs": [_quantity(q, n) for q, _ in d.outputs] if is_whole else [],
        "given": [_formula(d, q, values, n) for q, values in bare],
    }


def _step(d: Derivation, step: Step, lines: Lines, n: Notation) -> Printed:
    return {
        **_quantity(step.quantity, n),
        "number": d.steps.index(step) + 1,
        "label": n.plain(label(d, step)),
        "paper": _said(paper.step(d, step.quantity.name), n),
        "formula": _formula(d, step.quantity, step.formula, n),
        "lines": [(number, n.code(line)) for number, line in lines],
    }


def _quantity(q: Quantity, n: Notation) -> Printed:
    return {
        "name": q.name,
        "plain_name": n.plain(q.name),
        "symbol": n.symbol(q.name),
        "doc": n.plain(q.doc),
        "unit": n.plain(q.unit),
        "shape": "scalar" if q.is_scalar else f"({q.size}, 1)",
        "place": n.plain(q.place),
    }


def _formula(d: Derivation, q: Quantity, values: Sequence[Expr], n: Notation) -> str:
    quantities = (*d.inputs, *(step.quantity for step in d.steps), *(one for one, _ in d.outputs))
    sizes = {one.name: one.size for one in quantities if not one.is_scalar}
    entries = _inertia_entries(d)
    return display(q.name, [value.xreplace(entries) for value in values], sizes, n)


def _inertia_entries(d: Derivation) -> dict[Symbol, Symbol]:
    """Entries of the inertia, kept as a row of numbers, by their row and column in I."""
    kept = next((q.symbols() for q in d.inputs if q.name == "inertia"), ())
    size = next(k for k in range(len(kept) + 1) if k * (k + 1) // 2 == len(kept))
    places = ((i, j) for i in range(size) for j in range(i, size))
    return {one: Symbol(f"I_{i}_{j}", real=True) for one, (i, j) in zip(kept, places, strict=True)}


def _said(source: str, n: Notation) -> str:
    return paper.said(source, n) if source else ""
