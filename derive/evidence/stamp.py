"""Which files a page of evidence measured, whether they are still the same, and so is the page.

The digest that a page carries of itself tells an edit or a page cut short; it is no signature.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

PAGE = "EVIDENCE.md"
"""The page in a package. It is measured, not derived: no manifest names it."""

_MEASURED = re.compile(r"(?:c/(?:include|src)|numpy)/[^/]+\.(?:c|h|py)")
_ROW = re.compile(r"^\| `([^`]+)` +\| `([0-9a-f]{64})` +\|$", re.MULTILINE)

SEAL = "SHA-256 of all that is above this line: "
"""What the last line of a page begins with."""


@dataclass(frozen=True)
class Fault:
    """What is wrong with a page: stale or edited, and the reason."""

    word: str
    reason: str


def sealed(text: str) -> str:
    """A page with its own digest in the last line, as sha256sum gives it of the lines above."""
    above = f"{text}\n"
    return f"{above}{SEAL}`{_digest(above)}`\n"


def fault(page: str, texts: Mapping[str, str]) -> Fault | None:
    """What is wrong with a page beside these texts, or nothing."""
    if reason := outdated(page, texts):
        return Fault("stale", reason)
    if reason := edited(page):
        return Fault("edited", reason)
    return None


def edited(page: str) -> str:
    """Why a page is not as it was written; nothing when it is."""
    above, mark, told = page.rpartition(SEAL)
    if not mark:
        return "its last line does not give its digest"
    return "" if told == f"`{_digest(above)}`\n" else "its last line gives another digest"


def hashes(texts: Mapping[str, str]) -> dict[str, str]:
    """SHA-256 of what flies: sources, the headers that they need, and the numpy module.

    texts: {path: text} of a package
    """
    return {
        path: _digest(texts[path])
        for path in sorted(texts, key=_order)
        if _MEASURED.fullmatch(path)
    }


def is_page(path: Path) -> bool:
    """Whether a page stands there, and not a link or the like."""
    return path.name == PAGE and path.is_file() and not path.is_symlink()


def outdated(page: str, texts: Mapping[str, str]) -> str:
    """Why a page does not speak of these texts; nothing when it does."""
    told, found = dict(_ROW.findall(page)), hashes(texts)
    if not told:
        return "it does not say what it measured"
    for path in sorted(told.keys() | found.keys(), key=_order):
        name = path.rpartition("/")[2]
        if path not in found:
            return f"it measured {name}, which is no more"
        if path not in told:
            return f"it did not measure {name}"
        if told[path] != found[path]:
            return f"it measured another {name}"
    return ""


def _digest(text: str) -> str:
    return sha256(text.encode("utf-8", "surrogateescape")).hexdigest()


def _order(path: str) -> tuple[bool, str]:
    """Sources first."""
    return not path.endswith(".c"), path
