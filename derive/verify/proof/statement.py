"""A statement of the paper: what is claimed, how it is decided, and false claims it must reject.

A claim is a frozen record of the paper's formulas. The function that proves a statement takes
the claim as data, so a mutant is the same record with one formula replaced, and it is judged by
the very function that accepts the paper's.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath
import sympy


@dataclass(frozen=True)
class Fact:
    """One thing that has to hold for a statement to stand; `shown` is what was found, in words."""

    what: str
    holds: bool
    shown: str = ""


def vanish(what: str, values: Iterable[Any]) -> Fact:
    """The fact that every value is exactly zero; an inexact number is refused with TypeError."""
    return Fact(what, all(_is_zero(value) for value in values))


def _is_zero(value: Any) -> bool:
    if isinstance(value, sympy.Basic):
        if value.has(sympy.Float):
            raise TypeError(f"{value} is not exact")
        return bool(sympy.expand(value) == 0)
    if isinstance(value, float | complex | mpmath.mpf):
        raise TypeError(f"{value} is not exact")
    return not value


Prove = Callable[[Any, Any], Iterator[Fact]]


@dataclass(frozen=True)
class Statement:
    """A row of the table of statements.

    kind:    what it is about: the key of its subjects in `run`
    prove:   (subject, claim) -> the facts the statement consists of
    claim:   the paper's formulas
    mutants: what is wrong with it -> the claim with one formula replaced
    """

    name: str
    label: str
    method: str
    kind: str
    prove: Prove
    claim: Any
    mutants: Mapping[str, Any]

    def judge(self, subject: Any) -> tuple[tuple[Fact, ...], tuple[str, ...]]:
        """The facts of the claim, and the mutants that the same facts do not reject."""
        facts = tuple(self.prove(subject, self.claim))
        survivors = tuple(
            what
            for what, claim in self.mutants.items()
            if all(fact.holds for fact in self.prove(subject, claim))
        )
        return facts, survivors
