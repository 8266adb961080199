"""Exact time derivatives: the chain rule, step by step, over the named steps.

A step is differentiated through its formula, not through how it was lowered, so a kernel
function obeys its own rule (K.fdiff = -H) and numerics never enter a derivative.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy
from sympy import Expr, Matrix, Symbol

from derive.routine.derivation import Derivation, Step


def rate(d: Derivation, value: Matrix, known: Mapping[Symbol, Expr]) -> Matrix:
    """d/dt of value (k, 1), given the rates of some symbols; other inputs are constants.

    Steps between value and the known symbols get a step of their own, named `NAME_dot`.
    """
    rates: dict[Symbol, Expr] = dict(known)
    owners = {symbol: step for step in d.steps for symbol, _ in step.terms}
    return Matrix([_along(d, entry, rates, owners) for entry in value])


def _along(
    d: Derivation, value: Expr, rates: dict[Symbol, Expr], owners: Mapping[Symbol, Step]
) -> Expr:
    """Sum over the symbols of value of partial derivative times rate."""
    total = sympy.S.Zero
    for symbol in sorted(value.free_symbols, key=str):
        if symbol not in rates:
            _write(d, symbol, rates, owners)
        if rates[symbol] != 0:
            total += sympy.diff(value, symbol) * rates[symbol]
    return total


def _write(
    d: Derivation, symbol: Symbol, rates: dict[Symbol, Expr], owners: Mapping[Symbol, Step]
) -> None:
    """Differentiate the step that owns the symbol, all its entries at once."""
    step = owners.get(symbol)
    if step is None:
        rates[symbol] = sympy.S.Zero
        return
    values = [_along(d, entry, rates, owners) for entry in step.formula]
    if any(values):
        quantity = step.quantity
        shaped = values[0] if quantity.is_scalar else Matrix(values)
        name, unit = f"{quantity.name}_dot", f"{quantity.unit}/s"
        written = d.let(name, shaped, unit, f"rate of {quantity.name}")
        values = [written] if quantity.is_scalar else list(written)
    for own, value in zip(step.symbols, values, strict=True):
        if own.is_Symbol:
            rates.setdefault(own, value)
