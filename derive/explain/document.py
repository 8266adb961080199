"""A vehicle's derivations as one document. Text in, text out; nothing is written here.

The lines of every step are those that trace.csv gives, so that the page and the code agree.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping, Sequence
from itertools import takewhile
from typing import Any

import sympy
from sympy import Symbol

from derive.emit.layout import fold
from derive.emit.literal import decimal
from derive.emit.render import environment
from derive.emit.target import CONSTANTS
from derive.explain import paper
from derive.explain.formula import function_name
from derive.explain.latex import LATEX
from derive.explain.mathml import MATHML
from derive.explain.notation import Notation
from derive.explain.section import Algebra, Lines, Printed, algebra, label, section, shown
from derive.explain.text import TEXT
from derive.lie.kernel import DEGREES, NAMES
from derive.routine.derivation import Derivation, Step

FORMATS = {
    "text": ("text.jinja", TEXT),
    "latex": ("article.tex.jinja", LATEX),
    "html": ("page.html.jinja", MATHML),
}
"""Format -> its template, and how its formulas are spelled."""

SCALAR = "f64"


def labels(derivations: Sequence[Derivation]) -> list[str]:
    """Every equation label once, in the order of the steps."""
    return list(dict.fromkeys(label(d, step) for d in derivations for step in d.steps))


def document(
    derivations: Sequence[Derivation],
    facts: Mapping[str, str],
    texts: Mapping[str, str],
    form: str,
    equation: str | None = None,
    basis: Algebra = (),
) -> str:
    """The document in one of FORMATS, of all steps or of those with one label.

    facts: vehicle (its name), group, dim, law, controller and storage, in words
    texts: {path: text} of its emitted folder, C in double precision and trace.csv among them
    basis: of the group's algebra, where it is to be shown
    """
    template, n = FORMATS[form]
    path = f"c/src/{facts['vehicle']}_{SCALAR}.c"
    blocks = _blocks(texts, path)
    sections = [section(d, equation, blocks, n) for d in derivations]
    steps = [step for d in derivations for step in shown(d, equation)]
    context = {
        **{key: n.plain(value) for key, value in facts.items()},
        "path": n.plain(path),
        "algebra": algebra(basis, n),
        "routines": [one for one in sections if one["steps"]],
        "kernels": _kernels(steps, n),
        "constants": _constants(steps, n),
        "fold": fold,
        "fold_formula": fold_formula,
    }
    return environment().get_template(f"explain/{template}").render(context)


def fold_formula(line: str, then: int) -> str:
    """Break a long formula in text between its terms; further lines are indented by `then`."""
    return fold(re.sub(r"(?<=[\w)|]) (?=[\w(|])", "\0", line), then).replace("\0", " ")


def _blocks(texts: Mapping[str, str], path: str) -> dict[tuple[str, str], Lines]:
    """(routine, step) -> its numbered lines, from where trace.csv says to the next empty line."""
    lines = texts[path].splitlines()
    rows = csv.DictReader(texts["trace.csv"].splitlines())
    starts = {
        (row["routine"], row["step"]): int(row["first_line"]) for row in rows if row["file"] == path
    }
    return {
        key: list(enumerate(takewhile(str.strip, lines[first - 1 :]), first))
        for key, first in starts.items()
    }


def _kernels(steps: Sequence[Step], n: Notation) -> list[Printed]:
    """The special functions that the steps call."""
    calls = _atoms(steps, sympy.Function)
    called = {function_name(c): c for c in calls if not isinstance(c, sympy.Abs | sympy.Piecewise)}
    return [
        {
            "paper": [paper.said(one, n) for one in paper.KERNELS.get(name, ())],
            "doc": n.plain(_computed(name, called[name])),
        }
        for name in sorted(called)
    ]


def _computed(name: str, call: sympy.Function) -> str:
    if name in NAMES:
        degree = DEGREES[SCALAR][NAMES.index(name)]
        return f"Computed in double precision by a polynomial of degree {degree} in 1 - w."
    return (call.func.__doc__ or name).partition("\n")[0]


def _constants(steps: Sequence[Step], n: Notation) -> list[Printed]:
    """The named constants that the steps mention."""
    mentioned = {str(symbol) for symbol in _atoms(steps, Symbol)}
    return [
        {
            "symbol": n.symbol(name),
            "value": n.plain(decimal(CONSTANTS[name][SCALAR], SCALAR)),
            "doc": n.plain(paper.CONSTANTS.get(name, "")),
        }
        for name in sorted(CONSTANTS.keys() & mentioned)
    ]


def _atoms(steps: Sequence[Step], kind: type) -> set[Any]:
    """Whatever of that kind the formulas hold."""
    formulas = (entry for step in steps for entry in step.formula)
    return {atom for formula in formulas for atom in formula.atoms(kind)}
