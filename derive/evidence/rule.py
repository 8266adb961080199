"""The rules that emitted C is held to, each by a tool of its own; a missing one spares the rest."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from derive.evidence.diagnostic import compiled, tidied
from derive.evidence.documentation import documented
from derive.evidence.emitted import Emitted
from derive.evidence.lack import Lack, lack
from derive.evidence.misra import misra
from derive.evidence.symbol import symbols
from derive.evidence.tool import ToolMissing
from derive.verify.check import Check

KINDS: tuple[tuple[str, Callable[[Emitted], Iterator[Check]]], ...] = (
    ("warnings of compilers", compiled),
    ("clang-tidy", tidied),
    ("MISRA C:2012", misra),
    ("symbols", symbols),
    ("doxygen", documented),
)
"""What is looked at, and by what."""


def rules(one: Emitted) -> tuple[tuple[Check, ...], tuple[Lack, ...]]:
    """The checks of one scalar, and what could not be run here, with how to get it.

    Raises ToolFailed when a tool breaks down: that is no evidence of anything.
    """
    checks: list[Check] = []
    missing: list[Lack] = []
    for name, kind in KINDS:
        before = len(checks)
        try:
            checks.extend(kind(one))  # one after the other: what came before a missing tool stays
        except ToolMissing as reason:
            missing.append(lack(name, reason, [one.scalar], is_part=len(checks) > before))
    return tuple(checks), tuple(missing)
