"""The rules that emitted C is held to, each by a tool of its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from derive.evidence.diagnostic import compiled, tidied
from derive.evidence.documentation import documented
from derive.evidence.emitted import Emitted
from derive.evidence.misra import misra
from derive.evidence.symbol import symbols
from derive.verify.check import Check

Rule = Callable[[Emitted], Iterator[Check]]
"""Gives the checks of one scalar; raises ToolMissing, also after checks that came before it, and
ToolFailed when a tool breaks down: that is no evidence of anything."""

RULES: dict[str, Rule] = {
    "warnings of compilers": compiled,
    "clang-tidy": tidied,
    "MISRA C:2012": misra,
    "symbols": symbols,
    "doxygen": documented,
}
"""What is looked at, and by what."""
