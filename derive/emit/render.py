"""Printed routines and a vehicle's values in, {path: text} out. Nothing is written here."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import jinja2

from derive.emit import layout, statement
from derive.emit.condition import conditions
from derive.emit.literal import c_literal, decimal
from derive.emit.rows import rows
from derive.emit.target import SCALARS, TARGETS, Target

ABOUT = {
    "params": "inertia and gains, from the vehicle file or tuned on the target",
    "state": "what is measured",
    "reference": "where to be, and how that moves",
    "command": "what is to be done, and what it was made of",
    "side": "which way round is taken, kept from call to call; all zero to begin with",
}
"""What the structs of an emitted header are for."""

GUARDS = {"c99": conditions, "numpy": rows}
"""Target -> what its guard compares, made of all the rest that its templates read."""


@cache
def environment() -> jinja2.Environment:
    """The template loader: beside the package in a checkout, inside it in a wheel."""
    package = Path(__file__).parent.parent
    folder = next(f for f in (package / "_templates", package.parent / "templates") if f.is_dir())
    env = jinja2.Environment(
        loader=jinja2.FileSystemLoader(folder),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
        optimized=False,  # costs more than it saves: a template is rendered twice at most
    )
    env.filters.update(layout.FILTERS | statement.FILTERS)
    return env


def render(
    target: Target, printed: Mapping[str, Any], values: Mapping[str, Any],
    tests: Mapping[str, Any] | None = None,
) -> dict[str, str]:  # fmt: skip
    """Every file of one target.

    printed: {scalar: {"name", "routines", "kernels", ...}} as the pipeline prints and keeps it
    values:  name, scalars, inertia (upper triangle) and gains of a vehicle, exact
    tests:   {scalar: table} of `selftest`; nothing for a vehicle without a self-test
    """
    texts: dict[str, str] = {}
    for scalar in target.scalars:
        if scalar not in printed:
            continue
        context = {
            **printed[scalar],
            **spelled(scalar, target, values),
            **(tests or {}).get(scalar, {}),
        }
        context |= GUARDS[target.name](context)
        for file in (one for one in target.files if tests or not one.is_test):
            path = file.path.format(name=values["name"], scalar=scalar)
            texts[path] = environment().get_template(file.template).render(context)
    return texts


def spelled(scalar: str, target: Target, values: Mapping[str, Any]) -> dict[str, Any]:
    """A vehicle's names and numbers as one target writes them in one scalar."""
    number = c_literal if target.name == "c99" else decimal
    kind = SCALARS[scalar]
    prefix = f"{values['name']}_{scalar}"

    def text(value: Fraction) -> str:
        return number(value, scalar)

    drift = values["max_drift"] or kind.max_drift
    constants = kind.constants(values["is_own"], values["has_reference"], values["hysteresis"])
    return {
        "vehicle": values["name"],
        "prefix": prefix,
        "macro": prefix.upper(),
        "scalar": kind,
        "constants": [(name, text(x), doc) for name, x, doc in constants],
        "inertia": [text(value) for value in values["inertia"]],
        "gains": [(name, text(value)) for name, value in values["gains"]],
        "force_limit": [text(value) for value in values["force_limit"]],
        "max_drift": text(drift),
        "number": text,
        "about": ABOUT,
    }


def manifest(version: str, values: Mapping[str, Any], costs: Mapping[str, Any],
             texts: Mapping[str, str]) -> str:  # fmt: skip
    """MANIFEST.toml: what wrote the folder, what it costs, and the hash of every file."""
    hashes = {path: sha256(text.encode()).hexdigest() for path, text in sorted(texts.items())}
    template = environment().get_template("package/MANIFEST.toml.jinja")
    return template.render(version=version, values=values, costs=costs, hashes=hashes)


def trace(printed: Mapping[str, Any], texts: Mapping[str, str]) -> str:
    """trace.csv: paper equation, routine, step, file, first and last line of its code.

    In the order in which the steps are computed; of a step that stands twice, where it is first.
    """
    rows = ["equation,routine,step,file,first_line,last_line"]
    equations = _equations(printed)
    for path, text in sorted(texts.items()):
        found: dict[tuple[str, str], tuple[int, int]] = {}
        for routine, step, first, last in _located(text):
            found.setdefault((routine, step), (first, last))
        known = [name for name in equations if name in found]
        for name in (*known, *(name for name in found if name not in equations)):
            cells = (equations.get(name, ""), *name, path, *map(str, found[name]))
            rows.append(",".join(cells))
    return "\n".join(rows) + "\n"


def _equations(printed: Mapping[str, Any]) -> dict[tuple[str, str], str]:
    return {
        (routine["name"], step["name"]): step["source"] or routine["source"]
        for routine in printed["routines"]
        for step in routine["steps"]
    }


def _located(text: str) -> list[tuple[str, str, int, int]]:
    """(routine, step, first line, last line) of every step, found by its marking comment."""
    found: list[tuple[str, str, int, int]] = []
    routine = ""
    for number, line in enumerate(text.splitlines(), 1):
        begins = re.match(r"\s*(?:/\*|#) -- (\w+) --", line)
        marks = re.match(r"\s*(?:/\*|#) (\w+): .*\[", line)
        if begins:
            routine = begins[1] if begins[1] != "end" else ""
        elif marks and routine:
            found.append((routine, marks[1], number, number))
        elif found and found[-1][0] == routine and line.strip():
            found[-1] = (*found[-1][:3], number)
    return found


def targets(names: tuple[str, ...]) -> list[Target]:
    """The targets of that name, in the order of the table."""
    return [target for name, target in TARGETS.items() if name in names]
