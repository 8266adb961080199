"""Mutants on trial: every one that moves an output must be caught by the checks of the suite.

A derivation is run line by line in numpy; a mutant shares all values up to its own line. What
no check catches is measured against the unharmed derivation on a domain of its own, and counts
as equivalent only when it moves nothing by as much as the limit says.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from types import CodeType
from typing import Any

import numpy as np
import sympy
from numpy.typing import NDArray
from sympy import Expr

from derive.emit import printer
from derive.lie.kernel import NAMES, coefficients
from derive.routine.derivation import Derivation
from derive.verify.limits import EPS, LIMITS
from derive.verify.mutant import Mutant, kernel_orders, of_kernel, of_steps
from derive.verify.reference import Truth, block_lengths, block_scale
from derive.verify.shape import Block

Array = NDArray[Any]
Values = dict[str, Any]


@dataclass(frozen=True)
class Case:
    """Inputs by name, (k, N) columns, the truth of the outputs, and how far off each may be.

    limits: output name -> largest relative error per row, (N,) or one number
    """

    inputs: Mapping[str, Array]
    truth: Truth
    limits: Mapping[str, Array | float]

    def rejects(self, outputs: Values) -> bool:
        """Whether a check of the suite would fail on these outputs."""
        judged = {name: outputs[name] for name in self.limits if name in outputs}
        errors = self.truth.errors(judged)
        return any(bool((error > self.limits[name]).any()) for name, error in errors.items())


@dataclass(frozen=True)
class Domain:
    """Inputs on which movement is measured, and the outputs whose movement counts there.

    scales: output name -> length below which its own is not its scale, (N,), (N, blocks) or one
    keep:   rows off the cut locus, where there is one right value, (N,)
    eps:    what movement is counted in
    blocks: of coordinates, each on its own scale; none where outputs are judged whole
    """

    inputs: Mapping[str, Array]
    scales: Mapping[str, Array | float]
    keep: Array
    eps: float = EPS["f64"]
    blocks: tuple[Block, ...] = ()

    def movement(self, before: Values, after: Values) -> float:
        """Largest change of an output over its scale, eps."""
        worst = 0.0
        for name in self.scales.keys() & before.keys():
            blocks = () if name == "clearance" else self.blocks
            with np.errstate(all="ignore"):
                change = block_lengths(blocks, after[name] - before[name])
                scale = block_scale(blocks, before[name], self.scales[name])
                moved = (change / np.where(scale > 0, scale, 1.0) / self.eps).max(-1)
            moved = np.where(np.isnan(moved), np.inf, moved)[self.keep]
            worst = max(worst, float(moved.max()))
        return worst


class Runner:
    """A derivation compiled line by line for numpy, as it is printed for the emitted module."""

    def __init__(self, d: Derivation, scalar: str = "f64") -> None:
        self.derivation = d
        self._dialect = printer.numpy(scalar)
        self._lines = [(symbol, self._compiled(value)) for symbol, value in d.terms()]
        self._kernels = {
            f"_{NAMES[n]}": _horner(coefficients(n, scalar)) for n in range(len(NAMES))
        }

    def values(self, inputs: Mapping[str, Array]) -> Values:
        """Every input and step by symbol name, each an array (N,)."""
        known: Values = {"np": np, **self._kernels}
        for quantity in self.derivation.inputs:
            columns = inputs[quantity.name]
            known |= {str(s): columns[i] for i, s in enumerate(quantity.symbols())}
        return self._run(known, 0)

    def outputs(self, values: Values) -> Values:
        """Outputs by name, (N, n)."""
        count = len(next(value for value in values.values() if isinstance(value, np.ndarray)))
        return {
            quantity.name: np.stack(
                [np.broadcast_to(_entry(entry, values), count) for entry in entries], -1
            )
            for quantity, entries in self.derivation.outputs
        }

    def harmed(self, mutant: Mutant, values: Values) -> Values:
        """Outputs with the mutant in place, from the values of the unharmed run."""
        known = dict(values)
        if mutant.symbol is None:
            known[f"_{NAMES[mutant.kernel]}"] = _horner(mutant.polynomial)
            return self.outputs(self._run(known, 0))
        place = next(i for i, (symbol, _) in enumerate(self._lines) if symbol == mutant.symbol)
        with np.errstate(all="ignore"):
            known[str(mutant.symbol)] = eval(self._compiled(mutant.value), known)
        return self.outputs(self._run(known, place + 1))

    def _run(self, known: Values, start: int) -> Values:
        with np.errstate(all="ignore"):
            for symbol, code in self._lines[start:]:
                known[str(symbol)] = eval(code, known)
        return known

    def _compiled(self, value: Expr | None) -> CodeType:
        return compile(_source(value, self._dialect), "<step>", "eval")


@dataclass(frozen=True)
class Outcome:
    """What became of the mutants: how many, the missed ones, the equivalent ones with bounds.

    there: how many there are, of which some may have been tried
    """

    tried: int
    there: int
    missed: tuple[tuple[str, float], ...]
    equivalent: tuple[tuple[str, float], ...]

    @property
    def bound(self) -> float:
        """Largest movement of an equivalent mutant, eps."""
        return max((moved for _, moved in self.equivalent), default=0.0)


def trial(
    d: Derivation,
    cases: list[Case],
    domains: list[Domain],
    scalar: str = "f64",
    most: int | None = None,
    seed: int = 0,
    least: float = LIMITS["mutant"].figure,
) -> Outcome:
    """Judge every mutant on the cases; measure on the domains what they let through.

    In double every mutant of every step, and of the kernel; in float those of its own kernel.
    most: as many of them by the seed, where there are more; least: eps of a movement that counts
    """
    runner = Runner(d, scalar)
    on_cases = [(case, runner.values(case.inputs)) for case in cases]
    on_domains = []
    for domain in domains:
        values = runner.values(domain.inputs)
        on_domains.append((domain, values, runner.outputs(values)))
    missed: list[tuple[str, float]] = []
    equivalent: list[tuple[str, float]] = []
    everyone = list(mutants(d, scalar))
    tried = _some(everyone, most, seed)
    for mutant in tried:
        if any(case.rejects(runner.harmed(mutant, values)) for case, values in on_cases):
            continue
        moved = max(
            domain.movement(before, runner.harmed(mutant, values))
            for domain, values, before in on_domains
        )
        found = missed if moved >= least else equivalent
        found.append((mutant.what, moved))
    return Outcome(len(tried), len(everyone), tuple(missed), tuple(equivalent))


def _some(everyone: list[Mutant], most: int | None, seed: int) -> list[Mutant]:
    """All of them, or `most` in their order."""
    if most is None or len(everyone) <= most:
        return everyone
    chosen = np.random.default_rng([seed, 6]).choice(len(everyone), most, replace=False)
    return [everyone[i] for i in sorted(chosen)]


def mutants(d: Derivation, scalar: str) -> Iterator[Mutant]:
    """Of every step, once, and of every kernel polynomial the steps call."""
    if scalar == "f64":
        yield from of_steps(d)
    for order in kernel_orders(d):
        yield from of_kernel(order, scalar)


def _entry(entry: Expr, values: Values) -> Any:
    return values[str(entry)] if entry.is_Symbol else float(entry)


def _horner(terms: tuple[Any, ...]) -> Callable[[Array], Array]:
    numbers = [float(term) for term in reversed(terms)]

    def polynomial(w: Array) -> Array:
        z = 1.0 - w
        total: Any = numbers[0]
        for number in numbers[1:]:
            total = total * z + number
        return np.asarray(total)

    return polynomial


def _source(value: Any, dialect: printer.Dialect) -> str:
    """One expression in numpy; a choice as nested np.where."""
    if not isinstance(value, sympy.Piecewise):
        return printer.text(value, dialect)
    *cases, (last, _) = value.args
    line = printer.text(last, dialect)
    for case, condition in reversed(cases):
        when = printer.condition(condition, dialect)
        line = f"np.where({when}, {printer.text(case, dialect)}, {line})"
    return line
