"""A derivation as an inline function of C over small arrays, for a compiler to put into a loop.

Its expressions are those of derive.emit.function in the same order, so C and numpy agree bit for
bit. A choice is one expression per entry, which a compiler can do without a jump.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from derive.emit import printer
from derive.emit.printed import Printed, kernels, routine
from derive.routine.derivation import Derivation

PREFIX = "row"


def functions(derivations: Sequence[Derivation]) -> str:
    """C source: `void NAME(const double *input, ..., double *output, ...)` for each of them."""
    lines = ["#include <math.h>"]
    for kernel in kernels(list(derivations), "f64"):
        lines += _kernel(kernel)
    for d in derivations:
        lines += _function(routine(d, printer.c99("f64", PREFIX)))
    return "\n".join([*lines, ""])


def _kernel(kernel: Printed) -> list[str]:
    """Horner's scheme in 1 - w, highest power first."""
    (sign, first), *rest = kernel["terms"]
    return [
        f"static inline double {PREFIX}_{kernel['name']}(double w)",
        "{",
        "    const double z = 1.0 - w;",
        f"    double value = {'-' if sign == '-' else ''}{first};",
        *(f"    value = value * z {sign} {term};" for sign, term in rest),
        "    return value;",
        "}",
    ]


def _function(printed: Printed) -> list[str]:
    takes = [f"const double *{one['name']}" for one in printed["inputs"]]
    gives = [f"double *{one['name']}_out" for one in printed["outputs"]]
    lines = [f"static inline void {printed['name']}({', '.join([*takes, *gives])})", "{"]
    for one in printed["inputs"]:
        entries = one["entries"]
        lines += [f"    const double {name} = {one['name']}[{index}];" for name, index in entries]
        lines += [] if entries else [f"    (void){one['name']};"]
    for step in printed["steps"]:
        lines += [f"    const double {name} = {value};" for name, value in _assignments(step)]
    for one in printed["outputs"]:
        lines += [f"    {one['name']}_out[{i}] = {x};" for i, x in enumerate(one["entries"])]
    return [*lines, "}"]


def _assignments(step: Printed) -> Iterator[tuple[str, str]]:
    yield from step["lines"]
    *cases, last = step["cases"] or [None]
    for row, (name, otherwise) in enumerate(last["lines"] if last else ()):
        chosen = (f"({case['condition']}) ? ({case['lines'][row][1]}) : " for case in cases)
        yield name, f"{''.join(chosen)}({otherwise})"
