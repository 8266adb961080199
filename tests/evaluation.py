"""A derivation's outputs from numbers: to many digits, or in double as numpy is printed."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import sympy

from derive.emit import printer
from derive.emit.printed import routine
from derive.lie.kernel import NAMES, SMALL, TINY, coefficients
from derive.routine.derivation import Derivation
from derive.verify.truth import mp

ABSENT = sympy.Rational(1, 10**300)
"""What TINY is here: far below what 60 digits see beside anything but zero."""


def exactly(d: Derivation, digits: int = 60, **given: Any) -> dict[str, tuple[Any, ...]]:
    """Outputs by name as mpf, from exact numbers by the name of their input."""
    values: dict[sympy.Symbol, sympy.Expr] = {TINY: ABSENT, SMALL: ABSENT}
    for quantity in d.inputs:
        row = [given[quantity.name]] if quantity.is_scalar else list(given[quantity.name])
        values |= zip(quantity.symbols(), map(sympy.Rational, row), strict=True)
    outputs = d.evaluate(values, digits)
    return {name: tuple(map(number, entries)) for name, entries in outputs.items()}


def number(value: Any) -> Any:
    """A sympy number as an mpf that keeps all its digits."""
    return mp.mpf(sympy.Float(value, 60)._mpf_)


def in_double(d: Derivation) -> Callable[..., dict[str, Any]]:
    """The derivation as a function of rows by input name, run line by line as printed."""
    lines = [line for step in routine(d, printer.numpy())["steps"] for line in _lines(step)]
    code = compile("\n".join(lines), d.name, "exec")
    kernels = {f"_{name}": _kernel(order) for order, name in enumerate(NAMES)}

    def run(**given: Any) -> dict[str, Any]:
        scope = {"np": np, **kernels}
        for quantity in d.inputs:
            row = np.atleast_1d(np.asarray(given[quantity.name]))
            scope |= zip(map(str, quantity.symbols()), row, strict=True)
        exec(code, scope)
        outputs = {quantity.name: entries for quantity, entries in d.outputs}
        return {name: np.array([_entry(e, scope) for e in row]) for name, row in outputs.items()}

    return run


def _entry(entry: sympy.Expr, scope: Mapping[str, Any]) -> Any:
    return scope[str(entry)] if entry.is_Symbol else float(entry)


def _lines(step: Mapping[str, Any]) -> Sequence[str]:
    """Every assignment of a step; a choice is spelled with Python's own `if`."""
    if not step["cases"]:
        return [f"{name} = {text}" for name, text in step["lines"]]
    *cases, last = step["cases"]
    lines = []
    for row, (name, otherwise) in enumerate(last["lines"]):
        chosen = [f"({case['lines'][row][1]}) if {case['condition']} else " for case in cases]
        lines.append(f"{name} = {''.join(chosen)}{otherwise}")
    return lines


def _kernel(order: int) -> Callable[[Any], Any]:
    horner = [float(c) for c in reversed(coefficients(order, "f64"))]
    return lambda w: np.polyval(horner, 1.0 - w)
