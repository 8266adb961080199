"""Printed routines and a vehicle's values in, {path: text} out. Nothing is written here."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import jinja2

from derive.emit.condition import conditions
from derive.emit.literal import c_literal, decimal, python_name
from derive.emit.target import SCALARS, TARGETS, Target

WIDTH = 100

BRIEF = {"control force": "force", "kinematic law": "law"}
"""What a command holds, where nothing else can be meant."""

ABOUT = {
    "params": "inertia and gains, from the vehicle file or tuned on the target",
    "state": "what is measured",
    "reference": "where to be, and how that moves",
    "command": "what is to be done, and what it was made of",
    "side": "which way round is taken, kept from call to call; all zero to begin with",
}
"""What the structs of an emitted header are for."""


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
    env.filters.update(
        fold=fold,
        assign=assign,
        comment=comment,
        sentence=sentence,
        batched=batched,
        listed=listed,
        python_name=python_name,
        pack=pack,
        prototype=prototype,
        narrow=narrow,
        leading=leading,
        conjunction=conjunction,
    )
    return env


def fold(line: str, then: int | str) -> str:
    """Break a long line at spaces; `then` is the indent of the lines that follow, or its width."""
    if len(line) <= WIDTH and "\n" not in line:
        return line.rstrip()
    indent = then if isinstance(then, str) else " " * then
    return textwrap.fill(
        line, WIDTH, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
    )


def narrow(text: str) -> str:
    """C text of a vehicle with a long name: what is too wide gets lines of its own."""
    lines = (line if len(line) <= WIDTH else _narrow(line) for line in text.splitlines())
    return "\n".join(lines) + "\n"


def _narrow(line: str) -> str:
    """Put the remark at the end of a line above it; then break at spaces."""
    indent = " " * (len(line) - len(line.lstrip()))
    found = re.fullmatch(r"(.*\S) (/\*\*?)<? (.*)", line)
    lines = [f"{indent}{found[2]} {found[3]}", found[1]] if found else [line]
    return "\n".join(fold(one, indent + " " * 8) for one in lines)


def prototype(line: str, then: int = 8) -> str:
    """Names separated by commas, broken only after them; further lines are indented by `then`."""
    return fold(re.sub(r"(?<!,) ", "\0", line), then).replace("\0", " ")


def pack(items: list[str], head: str) -> str:
    """A C declaration of several names, broken only between them."""
    return prototype(head + ", ".join(items) + ";")


def conjunction(conditions: list[str], first: str = "    if (!(", indent: int = 12) -> str:
    """Conditions of C that all have to hold, behind what stands first, broken before && only."""
    kept = [one.replace(" ", "\0") for one in conditions]
    line = (first + " && ".join(kept)).replace("if (", "if\0(").replace(" && ", " &&\0")
    return fold(line, indent).replace("\0", " ")[len(first) :]


def leading(term: list[str]) -> str:
    """The first term of a polynomial, its sign written only when negative."""
    sign, number = term
    return f"-{number}" if sign == "-" else number


def assign(name: str, value: str) -> str:
    """A Python assignment inside a function, in parentheses where it needs several lines."""
    line = f"    {name} = {value}"
    if len(line) <= WIDTH:
        return line
    inner = fold(f"        {value}", 8)
    many = f"    {name} = ("
    if len(many) > WIDTH:
        many = f"    (\n{fold(f'        {name},', 8)}\n    ) = ("
    return f"{many}\n{inner}\n    )"


def comment(quantity: Mapping[str, Any]) -> str:
    """What a quantity is, in one line: name, sentence, unit, equation."""
    source = f", {quantity['source']}" if quantity["source"] else ""
    return f"{quantity['name']}: {quantity['doc']} [{quantity['unit']}]{source}"


def sentence(text: str) -> str:
    """First letter upper, full stop at the end."""
    return f"{text[0].upper()}{text[1:]}."


def listed(quantities: list[Mapping[str, Any]]) -> str:
    """What quantities are, the last after `and`: force, sliding variable, law and its rate."""
    *others, last = (BRIEF.get(one["doc"], one["doc"]) for one in quantities)
    return f"{', '.join(others)} and {last}"


def batched(shape: list[int]) -> str:
    """A shape over leading axes, as docstrings write it."""
    return f"(..., {', '.join(map(str, shape))})"


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
        if target.name == "c99":
            context |= conditions(context)
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
