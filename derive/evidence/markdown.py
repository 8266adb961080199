"""Tables of Markdown, and the words of tools as they can stand in them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from tempfile import gettempdir

_SCRATCH = re.compile(re.escape(gettempdir()) + r"/(?:derive-|tmp)\w{8}(?!\w)")
"""Folders that are made for a measurement: their names are of no use afterwards."""

_PLACE = re.compile(r"(?<![\w/.)\]])/(?:[\w.+-]+/)+")


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table of Markdown, its columns but the last one below the other for who reads the text."""
    both = [head, *rows]
    widths = [max(3, *(len(row[i]) for row in both)) for i in range(len(head) - 1)]
    rule = ["-" * width for width in (*widths, 3)]
    return "\n".join(_joined(row, (*widths, 0)) for row in (head, rule, *rows))


def _joined(row: Sequence[str], widths: Sequence[int]) -> str:
    return f"| {' | '.join(f'{cell:{width}}' for cell, width in zip(row, widths, strict=True))} |"


def shown(text: str) -> str:
    """Words of a tool as they can stand in a table: one line, no markup, no place of a file."""
    line = " ".join(_PLACE.sub("", _SCRATCH.sub("scratch", text)).split())
    return re.sub(r"([|*<\\`])", r"\\\1", line)


def quoted(*words: str) -> tuple[str, ...]:
    """Words as they are typed."""
    return tuple(f"`{word}`" for word in words)
