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


def symbol(d: Derivation) -> str:
    """The function over columns of a derivation."""
    return f"{d.name}_columns"


def prototypes(derivations: Sequence[Derivation]) -> str:
    """Declarations of the functions over columns."""
    return " ".join(f"{_prototype(d)};" for d in derivations)


def over_columns(derivations: Sequence[Derivation]) -> str:
    """C source: one function for each over columns, `x_step` 1, or 0 where all rows share x."""
    return "\n".join(
        [functions(derivations), *(line for d in derivations for line in _over(d)), ""]
    )


def _prototype(d: Derivation) -> str:
    takes = [f"const double *{one.name}, long {one.name}_step" for one in d.inputs]
    gives = [f"double *{quantity.name}_out" for quantity, _ in d.outputs]
    return f"void {symbol(d)}(long rows, {', '.join([*takes, *gives])})"


def _over(d: Derivation) -> Iterator[str]:
    """A loop over the rows, of each of which the columns are gathered and scattered."""
    given = [quantity for quantity, _ in d.outputs]
    yield from (_prototype(d), "{", "    for (long i = 0; i < rows; ++i) {")
    for one in d.inputs:
        wide = f"({one.name}_step ? rows : 1)"
        entries = (f"{one.name}[{j} * {wide} + i * {one.name}_step]" for j in range(one.size))
        yield f"        const double {one.name}_row[{one.size}] = {{{', '.join(entries)}}};"
    yield from (f"        double {one.name}_new[{one.size}];" for one in given)
    arguments = [f"{one.name}_row" for one in d.inputs] + [f"{one.name}_new" for one in given]
    yield f"        {d.name}({', '.join(arguments)});"
    for one in given:
        yield from (f"        {one.name}_out[{j} * rows + i] = {one.name}_new[{j}];"
                    for j in range(one.size))  # fmt: skip
    yield from ("    }", "}")


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
