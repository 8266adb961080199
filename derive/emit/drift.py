"""{path: text} against {path: text}: what differs, and where first. Reads and writes nothing."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import zip_longest

LONGEST = 200  # characters of a line that are shown


@dataclass(frozen=True)
class Drift:
    """One path that is not as derived: line 0 when the file is missing or unknown.

    expected and found are lines as they can be shown anywhere.
    """

    path: str
    line: int
    expected: str
    found: str


def compare(expected: Mapping[str, str], found: Mapping[str, str]) -> list[Drift]:
    """Every path that differs, in order, with its first differing line."""
    drifts = []
    for path in sorted(expected.keys() | found.keys()):
        if path not in found:
            drifts.append(Drift(path, 0, "a file", "no file"))
        elif path not in expected:
            drifts.append(Drift(path, 0, "no such file", "a file"))
        elif expected[path] != found[path]:
            drifts.append(_first(path, expected[path], found[path]))
    return drifts


def _first(path: str, expected: str, found: str) -> Drift:
    pairs = zip_longest(_lines(expected), _lines(found), fillvalue="")
    number, (right, wrong) = next(
        (n, pair) for n, pair in enumerate(pairs, 1) if pair[0] != pair[1]
    )
    return Drift(path, number, _shown(right), _shown(wrong))


def _lines(text: str) -> list[str]:
    """Lines with their ends, as editors count them."""
    return re.findall(r"[^\n]*\n|[^\n]+", text)


def _shown(line: str) -> str:
    """A line so that a difference can be seen: blanks at its ends and odd characters escaped."""
    body = line.removesuffix("\n")
    if not body:
        return "an empty line" if line else "the end of the file"
    plain = body if body.isprintable() and body == body.rstrip() else ascii(body)
    cut = plain if len(plain) <= LONGEST else plain[:LONGEST] + "..."
    return cut if line.endswith("\n") else f"{cut} (without a newline)"
