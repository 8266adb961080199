"""{path: text} against {path: text}: what differs, and where first. Reads and writes nothing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import zip_longest


@dataclass(frozen=True)
class Drift:
    """One path that is not as derived: line 0 when the file is missing or unknown."""

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
    pairs = zip_longest(expected.splitlines(True), found.splitlines(True), fillvalue="")
    number, (right, wrong) = next((n, pair) for n, pair in enumerate(pairs, 1) if pair[0] != pair[1])
    return Drift(path, number, right.rstrip("\n") or "end of file", wrong.rstrip("\n") or "end of file")
