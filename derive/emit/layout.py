"""How emitted text is laid out: where long lines break and how words are joined, as filters."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping
from typing import Any

from derive.emit.literal import python_name

WIDTH = 100

BRIEF = {"control force": "force", "kinematic law": "law"}
"""What a command holds, where nothing else can be meant."""


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


FILTERS = {
    one.__name__: one
    for one in (
        *(fold, narrow, prototype, pack, conjunction, leading, assign),
        *(comment, sentence, listed, batched, python_name),
    )
}
"""Name in a template -> what it calls."""
