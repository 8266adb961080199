"""A derivation as plain printed data: everything a template needs, and nothing of sympy.

This is what the pipeline keeps on disk. Expressions are text here; values of a vehicle's
inertia and gains are not part of it.
"""

from __future__ import annotations

from typing import Any

import sympy
from sympy import Expr, Symbol

from derive.emit import printer
from derive.emit.literal import c_literal, decimal
from derive.emit.printer import Dialect
from derive.lie.kernel import NAMES, Arc, coefficients
from derive.routine.cost import cost
from derive.routine.derivation import Derivation, Quantity, Step

Printed = dict[str, Any]
"""JSON-able data: dictionaries, lists, strings, numbers, booleans."""


def routine(d: Derivation, dialect: Dialect) -> Printed:
    """Print one derivation: inputs, steps, outputs and cost, in the order they were written."""
    counted = cost(d)
    return {
        "name": d.name,
        "doc": d.doc,
        "source": d.source,
        "inputs": [_input(d, quantity) for quantity in d.inputs],
        "steps": [_step(step, dialect) for step in d.steps],
        "outputs": [_output(*output, dialect) for output in d.outputs],
        "operations": counted.operations,
        "temporaries": counted.temporaries,
    }


def kernels(derivations: list[Derivation], scalar: str) -> list[Printed]:
    """Horner polynomials, highest power first, of the kernel functions the derivations call."""
    called = {
        int(call.args[0])
        for d in derivations
        for _, value in d.terms()
        for call in value.atoms(Arc)
    }
    number = c_literal if scalar == "f32" else decimal
    return [
        {
            "name": NAMES[order],
            "terms": [
                ["-" if c < 0 else "+", number(abs(c), scalar)]
                for c in reversed(coefficients(order, scalar))
            ],
        }
        for order in sorted(called)
    ]


def _described(quantity: Quantity) -> Printed:
    names = ("name", "size", "unit", "doc", "source", "is_scalar", "holder", "member")
    return {name: getattr(quantity, name) for name in names}


def _input(d: Derivation, quantity: Quantity) -> Printed:
    symbols = quantity.symbols()
    used = zip(symbols, d.used(quantity), strict=True)
    entries = [[str(symbol), i] for i, (symbol, is_used) in enumerate(used) if is_used]
    return {**_described(quantity), "entries": entries}


def _output(quantity: Quantity, entries: tuple[Expr, ...], dialect: Dialect) -> Printed:
    return {**_described(quantity), "entries": [printer.text(entry, dialect) for entry in entries]}


def _step(step: Step, dialect: Dialect) -> Printed:
    """lines: plain assignments; or cases: [condition, lines] of one choice, the last without."""
    terms = step.terms
    printed = {**_described(step.quantity), "names": [str(symbol) for symbol, _ in terms]}
    if isinstance(terms[0][1], sympy.Piecewise):
        return {**printed, "lines": [], "cases": _cases(terms, dialect)}
    return {**printed, "lines": _lines(terms, dialect), "cases": []}


def _cases(terms: tuple[tuple[Symbol, Expr], ...], dialect: Dialect) -> list[Printed]:
    """One block per condition; all entries of a step share their conditions."""
    conditions = [condition for _, condition in terms[0][1].args]
    if any([c for _, c in value.args] != conditions for _, value in terms):
        raise ValueError(f"the entries of {terms[0][0]} choose by different conditions")
    return [
        {
            "condition": "" if when == sympy.true else printer.condition(when, dialect),
            "lines": _lines(tuple((s, value.args[i][0]) for s, value in terms), dialect),
        }
        for i, when in enumerate(conditions)
    ]


def _lines(terms: tuple[tuple[Symbol, Expr], ...], dialect: Dialect) -> list[list[str]]:
    return [[str(symbol), printer.text(value, dialect)] for symbol, value in terms]
