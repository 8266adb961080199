"""A derivation's outputs from numbers: to many digits, or in double as numpy is printed."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import mpmath
import numpy as np
import sympy
from sympy.printing.pycode import MpmathPrinter

from derive.emit import printer
from derive.emit.printed import routine
from derive.lie.kernel import CONSTANTS, NAMES, coefficients, exact
from derive.routine.derivation import Derivation
from derive.verify.oracle.precise import exactly as precisely
from derive.verify.oracle.precise import mp

ABSENT = mp.mpf(10) ** -300
"""What each of CONSTANTS is here: far below what 60 digits see beside anything but zero."""


def exactly(d: Derivation, **given: Any) -> dict[str, tuple[Any, ...]]:
    """Outputs by name as mpf, with 130 digits, from exact numbers by the name of their input."""
    values: list[Any] = []
    for quantity in d.inputs:
        values += map(
            number, [given[quantity.name]] if quantity.is_scalar else given[quantity.name]
        )
    if id(d) not in _KEPT:
        _KEPT[id(d)] = d, _compiled(d)
    _, run = _KEPT[id(d)]
    return run(*values)


_KEPT: dict[int, tuple[Derivation, Callable[..., dict[str, tuple[Any, ...]]]]] = {}
"""What was compiled, and of which derivation, so that none takes the place of another."""


def _compiled(d: Derivation) -> Any:
    """The derivation as a function of its inputs' entries, in Python's text of its formulas."""
    entries = ", ".join(str(symbol) for quantity in d.inputs for symbol in quantity.symbols())
    lines = [f"{symbol} = {_PRINTER.doprint(value)}" for symbol, value in d.terms()]
    given = [
        f"{q.name!r}: ({''.join(f'{_PRINTER.doprint(e)}, ' for e in row)})" for q, row in d.outputs
    ]
    text = "\n    ".join([f"def run({entries}):", *lines, f"return {{{', '.join(given)}}}"])
    absent = {str(one): ABSENT for one in CONSTANTS}
    scope: dict[str, Any] = {"mpmath": mp, "Arc": _arc, **absent}
    exec(compile(text, d.name, "exec"), scope)
    return scope["run"]


_PRINTER = MpmathPrinter({"fully_qualified_modules": True, "allow_unknown_functions": True})


def _arc(order: Any, w: Any) -> Any:
    with mpmath.workprec(mp.prec):
        return mp.mpf(exact(int(order), mpmath.mpf(w)))


def number(value: Any) -> Any:
    """A rational or binary number as an mpf that keeps all its digits."""
    if isinstance(value, sympy.Rational):
        return mp.mpf(int(value.p)) / int(value.q)
    return precisely(value)


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
