"""Printed C as a plain Python program: the same operations in the same order, rounded alike.

What a compiled routine must give to the last bit is found without a compiler. In double Python's
own numbers are C's. In float every operation is done in double and rounded once more, which for
+ - * / and the root is what rounding once gives: 53 bits are more than twice 24 and two.
"""

from __future__ import annotations

import ast
import math
import re
import struct
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from derive.emit.target import SCALARS

ERROR, PAST = "_of_error", "_past_error"
"""The law in two, where a sign comes between."""

Given = Mapping[str, Sequence[float]]
Routine = Callable[[Given], dict[str, list[float]]]

FORMAT = {"f32": "f", "f64": "d"}
PRIME, BASIS, MASK = 16777619, 2166136261, 0xFFFFFFFF
"""Of FNV-1a in 32 bits."""


def program(printed: Mapping[str, Any], scalar: str) -> str:
    """Python text of every routine of the C in one scalar, by the name it has there."""
    lines = [line for kernel in printed["kernels"] for line in _kernel(kernel)]
    lines += [line for routine in printed["routines"] for line in _routine(routine)]
    parts = {ERROR: printed["error"], PAST: printed["core"]} if printed["has_side"] else {}
    lines += [line for name, one in parts.items() for line in _routine({**one, "symbol": name})]
    text = "\n".join(map(_python, lines))
    if scalar == "f64":
        return text
    return ast.unparse(_Rounded().visit(ast.parse(text)))


def run(text: str) -> dict[str, Routine]:
    """The routines of a program by name: inputs by name to outputs by member."""
    scope: dict[str, Any] = {"_sqrt": math.sqrt, "_rounded": rounded}
    exec(compile(text, "<printed>", "exec"), scope)
    return scope


def rounded(value: float) -> float:
    """The float next to a double; OverflowError beyond the largest."""
    return float(_FLOAT.unpack(_FLOAT.pack(value))[0])


_FLOAT = struct.Struct("f")


def bits(numbers: Sequence[float], scalar: str) -> int:
    """FNV-1a, 32 bit, over the bytes of numbers in memory, each number's lowest byte first."""
    found = BASIS
    for byte in pack(numbers, scalar):
        found = (found ^ byte) * PRIME & MASK
    return found


def pack(numbers: Sequence[float], scalar: str) -> bytes:
    """Numbers as they lie in the memory of a machine whose lowest byte comes first."""
    return struct.pack(f"<{len(numbers)}{FORMAT[scalar]}", *numbers)


@dataclass(frozen=True)
class Limit:
    """The largest force of each coordinate, nothing where none is limited.

    keeps_direction: whether the force shrinks as a whole
    """

    force: tuple[float, ...]
    keeps_direction: bool


def limited(force: Sequence[float], limit: Limit, scalar: str) -> list[float]:
    """A force within its limits, by the operations of the emitted code."""
    kept = rounded if scalar == "f32" else float
    pairs = list(zip(force, limit.force, strict=bool(limit.force)))
    if not any(abs(x) > most for x, most in pairs):
        return list(force)
    if not limit.keeps_direction:
        return [max(-most, min(most, x)) for x, most in pairs]
    least = min(kept(most / abs(x)) for x, most in pairs if abs(x) > most)
    share = kept(least * float(SCALARS[scalar].shrunk))
    return [kept(x * share) for x in force]


def _kernel(kernel: Mapping[str, Any]) -> Iterator[str]:
    """Horner's scheme in 1 - w, as the C has it."""
    (sign, first), *rest = kernel["terms"]
    yield f"def _{kernel['name']}(w):"
    yield "    z = 1.0 - w"
    yield f"    sum = {'-' if sign == '-' else ''}{first}"
    yield from (f"    sum = sum * z {sign} {term}" for sign, term in rest)
    yield "    return sum"


def _routine(routine: Mapping[str, Any]) -> Iterator[str]:
    yield f"def {routine['symbol']}(_given):"
    for one in routine["inputs"]:
        yield from (f"    {name} = _given['{one['name']}'][{i}]" for name, i in one["entries"])
    for step in routine["steps"]:
        yield from (f"    {name} = {value}" for name, value in step["lines"])
        for place, case in enumerate(step["cases"]):
            word = "if" if place == 0 else "elif"
            yield f"    {word} {case['condition']}:" if case["condition"] else "    else:"
            yield from (f"        {name} = {value}" for name, value in case["lines"])
    outputs = (f"'{one['member']}': [{', '.join(one['entries'])}]" for one in routine["outputs"])
    yield f"    return {{{', '.join(outputs)}}}"


_WORDS = (
    (re.compile(r"(?<=\d)F\b"), ""),
    (re.compile(r"\bsqrtf?\("), "_sqrt("),
    (re.compile(r"\bfabsf?\("), "abs("),
    (re.compile(r"\b\w+_f(?:32|64)_(\w+)\("), r"_\1("),
    (re.compile(r"&&"), "and"),
)
"""What C spells otherwise: constants, the root, sizes, kernel functions, conjunctions."""


def _python(line: str) -> str:
    for pattern, word in _WORDS:
        line = pattern.sub(word, line)
    return line


class _Rounded(ast.NodeTransformer):
    """Every constant as float keeps it, and every operation rounded to float."""

    def visit_Constant(self, node: ast.Constant) -> ast.expr:
        value = node.value
        return ast.Constant(rounded(value)) if isinstance(value, float) else node

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        return self._call(node)

    def visit_Call(self, node: ast.Call) -> ast.expr:
        is_root = isinstance(node.func, ast.Name) and node.func.id == "_sqrt"
        return self._call(node) if is_root else self._inside(node)

    def _call(self, node: ast.expr) -> ast.expr:
        return ast.Call(ast.Name("_rounded", ast.Load()), [self._inside(node)], [])

    def _inside(self, node: ast.expr) -> ast.expr:
        found = self.generic_visit(node)
        assert isinstance(found, ast.expr)
        return found
