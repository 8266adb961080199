"""What a derivation costs, counted on the lowered terms: operations, temporaries, stack."""

from __future__ import annotations

from dataclasses import dataclass

import sympy
from sympy import Expr

from derive.routine.derivation import Derivation


@dataclass(frozen=True)
class Cost:
    """operations: + - * / sqrt, kernel polynomials left out and counted in `kernels`."""

    operations: int
    temporaries: int
    kernels: int

    def stack_bytes(self, bytes_each: int) -> int:
        """Upper bound of the locals' storage, if no temporary ever shared a slot."""
        return self.temporaries * bytes_each


def cost(d: Derivation) -> Cost:
    """Count a derivation; a subterm that stands twice within one step is counted once."""
    operations = kernels = 0
    for step in d.steps:
        shared, terms = sympy.cse([value for _, value in step.terms], order="none")
        for value in [value for _, value in shared] + terms:
            operations += _operations(value)
            kernels += len(value.atoms(sympy.Function) - value.atoms(sympy.Abs, sympy.Piecewise))
    return Cost(operations, sum(1 for _ in d.terms()), kernels)


def _operations(value: Expr) -> int:
    if isinstance(value, sympy.Piecewise):
        return max(_operations(case) for case, _ in value.args)
    return int(value.count_ops(visual=False)) - len(value.atoms(sympy.Abs))
