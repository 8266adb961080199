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
    """Count a derivation; a subterm that stands twice within one step is counted once.

    Of a Piecewise its dearest case counts, and no comparison; |x| is free.
    """
    operations = kernels = 0
    for step in d.steps:
        shared, terms = sympy.cse([value for _, value in step.terms], order="none")
        for value in [value for _, value in shared] + terms:
            operations += _operations(value)
            kernels += len(value.atoms(sympy.Function) - value.atoms(sympy.Abs, sympy.Piecewise))
    return Cost(operations, sum(1 for _ in d.terms()), kernels)


def _operations(value: Expr) -> int:
    """Operations of one expression, as it is printed: x**3 takes two, a sign within a sum none."""
    if isinstance(value, sympy.Piecewise):
        return max(_operations(case) for case, _ in value.args)
    if value.is_Add:
        return _of_sum(value)
    if value.is_Mul or (value.is_Pow and value.exp.is_negative):
        return _of_product(value)
    if value.is_Pow:
        own = 1 if value.exp == sympy.S.Half else int(value.exp) - 1
        return own + _operations(value.base)
    return sum(_operations(arg) for arg in value.args)


def shared_coefficient(value: Expr) -> tuple[Expr, list[Expr]]:
    """How a sum is computed: the coefficient its terms share up to sign, and what it multiplies.

    a/2 - b/2 is 1/2 (a - b); where coefficients differ, nothing is taken out.
    """
    coefficients = {abs(term.as_coeff_Mul()[0]) for term in value.args}
    shared = coefficients.pop() if len(coefficients) == 1 else sympy.S.One
    return shared, [term / shared for term in value.args]


def _of_sum(value: Expr) -> int:
    content, bare = shared_coefficient(value)
    is_negative = [term.could_extract_minus_sign() for term in bare]
    factor = content != 1 or all(is_negative)
    terms = (-t if minus else t for t, minus in zip(bare, is_negative, strict=True))
    return factor + len(is_negative) - 1 + sum(map(_operations, terms))


def _of_product(value: Expr) -> int:
    if value.could_extract_minus_sign():
        return 1 + _operations(-value)
    parts = [sympy.Mul.make_args(part) for part in value.as_numer_denom()]
    over, under = ([factor for factor in part if factor != 1] for part in parts)
    return max(len(over), 1) + len(under) - 1 + sum(map(_operations, over + under))
