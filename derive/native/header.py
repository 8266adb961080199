"""Decides what is read from an emitted header: declarations, routines and constants.

An emitted header is plain: typedefs, prototypes, one `extern const`, `#define`s of numbers.
No preprocessor is run, so a header can be read where there is no compiler.
"""

import re
from dataclasses import dataclass

_COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
_DIRECTIVE = re.compile(r"\s*#\s*(\w+)\s*(.*)")
_ATTRIBUTE = re.compile(r"__attribute__\s*\(\(.*?\)\)\s*", re.DOTALL)
_DEFINE = re.compile(r"(\w+)\s+(.+)")
_PROTOTYPE = re.compile(r"(?:^|(?<=[;}]))\s*([\w ]+?)\s+(\w+)\s*\(([^()]*)\)\s*;")
_PARAMETER = re.compile(
    r"(?P<const>const\s+)?(?P<type>\w+)\s*(?P<pointer>\*)?\s*(?P<name>\w+)\s*(?:\[(?P<size>\d+)\])?"
)


@dataclass(frozen=True)
class Parameter:
    """One pointer argument: `type *name` or `type name[size]`; `is_input` when const."""

    name: str
    type: str
    size: int | None
    is_input: bool


@dataclass(frozen=True)
class Routine:
    """A prototype: its C name, its result type (`void` or an enum) and its parameters."""

    symbol: str
    result: str
    parameters: tuple[Parameter, ...]


@dataclass(frozen=True)
class Header:
    """What a header declares: C text for cffi, routines by C name, numeric macros by name."""

    declarations: str
    routines: dict[str, Routine]
    constants: dict[str, float]


def parse(text: str) -> Header:
    """Read the text of an emitted header; raises ValueError on a prototype of another shape."""
    plain, macros = _without_directives(_COMMENT.sub(" ", text).replace("\\\n", " "))
    # cffi takes `extern const` for a constant to be computed, and refuses to read it.
    declarations = _ATTRIBUTE.sub("", plain).replace("extern const ", "extern ")
    found = (
        Routine(symbol, result, tuple(_parameter(one) for one in arguments.split(",")))
        for result, symbol, arguments in _PROTOTYPE.findall(declarations)
    )
    numbers = {name: number(value) for name, value in macros.items()}
    constants = {name: value for name, value in numbers.items() if value is not None}
    return Header(declarations, {routine.symbol: routine for routine in found}, constants)


def number(text: str) -> float | None:
    """The value of a C numeric literal, in parentheses or not; None for anything else."""
    literal = text.strip()
    while literal.startswith("(") and literal.endswith(")"):
        literal = literal[1:-1].strip()
    is_hex = literal.lower().lstrip("+-").startswith("0x")
    try:
        if is_hex:
            return float.fromhex(literal.rstrip("LlUu" if "p" not in literal.lower() else "FfLl"))
        return float(literal.rstrip("FfLlUu"))
    except ValueError:
        return None


def _parameter(text: str) -> Parameter:
    found = _PARAMETER.fullmatch(text.strip())
    if not found or not (found["pointer"] or found["size"]):
        raise ValueError(f"not the parameter of an emitted routine: {text.strip()!r}")
    size = int(found["size"]) if found["size"] else None
    return Parameter(found["name"], found["type"], size, is_input=bool(found["const"]))


def _without_directives(text: str) -> tuple[str, dict[str, str]]:
    """What a C compiler, not a C++ one, would see, and the macros with a value."""
    lines: list[str] = []
    macros: dict[str, str] = {}
    open_conditions: list[bool] = []
    for line in text.splitlines():
        directive = _DIRECTIVE.fullmatch(line)
        if directive is None:
            if all(open_conditions):
                lines.append(line)
            continue
        word, rest = directive.groups()
        if word in ("if", "ifdef", "ifndef"):
            # Include guards are open; only C++ is ever asked for, and this is not C++.
            open_conditions.append("__cplusplus" not in rest or word == "ifndef")
        elif word in ("else", "elif"):
            open_conditions.append(not open_conditions.pop())
        elif word == "endif":
            open_conditions.pop()
        elif word == "define" and all(open_conditions) and (named := _DEFINE.fullmatch(rest)):
            macros[named[1]] = named[2].strip()
    return "\n".join(lines), macros
