"""What was not measured, for want of which tool, and how to get that: one line for each thing."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from derive.evidence.tool import ToolMissing


@dataclass(frozen=True)
class Lack:
    """A measurement that was not made.

    what:    of the steps of a kind of evidence
    tools:   what it needs and is not here
    why:     that in a sentence, with what a person types to get it
    on:      scalars, where it is made on each of them
    is_part: whether some of it was made all the same
    """

    what: str
    tools: tuple[str, ...]
    why: str
    on: tuple[str, ...] = ()
    is_part: bool = False

    @property
    def subject(self) -> str:
        """The scalars."""
        return " and ".join(self.on)

    def __str__(self) -> str:
        part = "in part" if self.is_part else ""
        return f"{', '.join(filter(None, (self.what, self.subject, part)))}: {self.why}"


def lack(what: str, missing: ToolMissing, on: Iterable[str], *, is_part: bool) -> Lack:
    """The same of tools that are not here."""
    tools = tuple(tool.command for tool in missing.tools)
    return Lack(what, tools, str(missing), tuple(on), is_part)


def merged(lacks: Iterable[Lack]) -> tuple[Lack, ...]:
    """One for all scalars that lack the same."""
    found: dict[tuple[str, str], Lack] = {}
    for one in lacks:
        if first := found.get((one.what, one.why)):
            on = tuple(dict.fromkeys((*first.on, *one.on)))
            one = replace(first, on=on, is_part=first.is_part or one.is_part)
        found[one.what, one.why] = one
    return tuple(found.values())
