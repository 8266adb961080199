"""A derivation: inputs, named steps in the paper's order, outputs. There is no other IR.

Writing a step returns fresh symbols, so no later expression grows and the emitted code has
the names and the order of the paper. Nothing here knows what a group or a controller is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import sympy
from sympy import Expr, Matrix, Symbol


@dataclass(frozen=True)
class Quantity:
    """What a row of numbers means: name, length, unit, sentence, equation label.

    place says where the caller keeps an input or an output: `reference.nu_dot` for the input
    nu_r_dot, a bare name for an argument of its own; empty for a step.
    """

    name: str
    size: int
    unit: str
    doc: str
    source: str = ""
    is_scalar: bool = False
    place: str = ""

    @property
    def holder(self) -> str:
        """The struct it is kept in, `reference`; empty for an argument of its own."""
        return self.place.rpartition(".")[0]

    @property
    def member(self) -> str:
        """Its name there, `nu_dot`."""
        return self.place.rpartition(".")[2]

    def symbols(self) -> tuple[Symbol, ...]:
        """One real symbol per entry: `eta_0, eta_1, ...`, or the bare name of a scalar."""
        if self.is_scalar:
            return (Symbol(self.name, real=True),)
        return tuple(Symbol(f"{self.name}_{i}", real=True) for i in range(self.size))


@dataclass(frozen=True)
class Step:
    """One quantity with its formula, exact, and the terms left to compute after lowering.

    formula: every entry in the language of the maths (kernel functions, Piecewise)
    terms:   (symbol, lowered expression) of the entries that are more than a name or a number
    """

    quantity: Quantity
    symbols: tuple[Expr, ...]
    formula: tuple[Expr, ...]
    terms: tuple[tuple[Symbol, Expr], ...]


@dataclass
class Derivation:
    """Appended to by take, let and give while it is written; never after it is returned."""

    name: str
    doc: str
    source: str
    inputs: list[Quantity] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)
    outputs: list[tuple[Quantity, tuple[Expr, ...]]] = field(default_factory=list)
    lowered: dict[Expr, Expr] = field(default_factory=dict)

    def take(self, quantity: Quantity) -> Any:
        """Declare an input; its symbol, or its symbols as (size, 1)."""
        self._refuse_second(quantity.name)
        self.inputs.append(quantity)
        return _shaped(quantity.symbols(), quantity.is_scalar)

    def let(
        self,
        name: str,
        value: Matrix | Expr,
        unit: str,
        doc: str,
        source: str = "",
        stands_for: Expr | None = None,
    ) -> Any:
        """Write a step; fresh symbols in the shape of value, (size, 1) for a matrix.

        An entry that is already a symbol or a number stays itself. `stands_for` names an
        expression that every later step shall spell as this one.
        """
        self._refuse_second(name)
        is_scalar = not isinstance(value, sympy.MatrixBase)
        formula = (sympy.sympify(value),) if is_scalar else tuple(value)
        quantity = Quantity(name, len(formula), unit, doc, source, is_scalar)
        symbols, terms = [], []
        for fresh, entry in zip(quantity.symbols(), formula, strict=True):
            lowered = entry.xreplace(self.lowered)
            is_plain = lowered.is_Symbol or lowered.is_Rational
            symbols.append(lowered if is_plain else fresh)
            if not is_plain:
                terms.append((fresh, lowered))
        self.steps.append(Step(quantity, tuple(symbols), formula, tuple(terms)))
        if stands_for is not None:
            self.lowered[stands_for] = symbols[0]
        return _shaped(symbols, is_scalar)

    def give(self, quantity: Quantity, value: Matrix | Expr) -> None:
        """Declare an output: entries of value, (size, 1) or one scalar."""
        entries = (value,) if quantity.is_scalar else tuple(value)
        self.outputs.append((quantity, tuple(sympy.sympify(entry) for entry in entries)))

    def pruned(self, keep: str = "") -> Derivation:
        """The same derivation without terms that no output needs; what to keep stays whole."""
        needed = _symbols(entry for _, entries in self.outputs for entry in entries)
        needed |= _symbols(x for s in self.steps if s.quantity.name == keep for x in s.symbols)
        kept: list[Step] = []
        for step in reversed(self.steps):
            terms = tuple((symbol, value) for symbol, value in step.terms if symbol in needed)
            needed |= _symbols(value for _, value in terms)
            if terms:
                kept.append(replace(step, terms=terms))
        return replace(self, steps=kept[::-1])

    def without(self, output: str) -> Derivation:
        """The same derivation, one output fewer, and pruned."""
        kept = [pair for pair in self.outputs if pair[0].name != output]
        return replace(self, outputs=kept).pruned()

    def parted(self, name: str) -> tuple[Derivation, Derivation]:
        """The steps up to that of a name, which they give; and the others, which take it.

        Both keep the name, the sentence and the source of the whole. Raises ValueError where an
        entry of it is an earlier symbol by another name, which the others could not take.
        """
        place = [step.quantity.name for step in self.steps].index(name) + 1
        step = self.steps[place - 1]
        passed = replace(step.quantity, place=name)
        if not set().union(*(x.free_symbols for x in step.symbols)) <= {*passed.symbols()}:
            raise ValueError(f"{self.name}: {name} is made of {step.symbols}")
        head = replace(self, steps=self.steps[:place], outputs=[(passed, step.symbols)])
        tail = replace(self, inputs=[*self.inputs, passed], steps=self.steps[place:])
        return head.pruned().needing(), tail.needing(passed)

    def needing(self, *kept: Quantity) -> Derivation:
        """The same derivation, its inputs those that are mentioned, or kept all the same."""
        return replace(self, inputs=[q for q in self.inputs if q in kept or any(self.used(q))])

    def used(self, quantity: Quantity) -> tuple[bool, ...]:
        """Which entries of an input some term or output mentions."""
        values = [value for _, value in self.terms()]
        values += [entry for _, entries in self.outputs for entry in entries]
        mentioned = _symbols(values)
        return tuple(symbol in mentioned for symbol in quantity.symbols())

    def terms(self) -> Iterator[tuple[Symbol, Expr]]:
        """Every lowered assignment, in order."""
        return (term for step in self.steps for term in step.terms)

    def step(self, name: str) -> Step:
        """The step of that name; KeyError when there is none."""
        for step in self.steps:
            if step.quantity.name == name:
                return step
        raise KeyError(name)

    def evaluate(self, values: Mapping[Symbol, Expr], digits: int = 50) -> dict[str, list[Expr]]:
        """Outputs by name from exact input values, in arithmetic of that many digits."""
        known: dict[Expr, Expr] = dict(values)
        for symbol, term in self.terms():
            known[symbol] = term.xreplace(known).evalf(digits)
        return {
            quantity.name: [entry.xreplace(known).evalf(digits) for entry in entries]
            for quantity, entries in self.outputs
        }

    def _refuse_second(self, name: str) -> None:
        taken = {quantity.name for quantity in self.inputs}
        if name in taken | {step.quantity.name for step in self.steps}:
            raise ValueError(f"{self.name}: the name {name!r} is already taken by an earlier step")


def _shaped(symbols: Iterable[Expr], is_scalar: bool) -> Any:
    entries = list(symbols)
    return entries[0] if is_scalar else Matrix(entries)


def _symbols(values: Iterable[Expr]) -> set[Symbol]:
    return set().union(*(value.free_symbols for value in values))
