"""Which files a page of evidence measured, and whether they are still the same."""

from __future__ import annotations

import re
from collections.abc import Mapping
from hashlib import sha256
from pathlib import Path

PAGE = "EVIDENCE.md"
"""The page in a package. It is measured, not derived: no manifest names it."""

_MEASURED = re.compile(r"(?:c/(?:include|src)|numpy)/[^/]+\.(?:c|h|py)")
_ROW = re.compile(r"^\| `([^`]+)` +\| `([0-9a-f]{64})` +\|$", re.MULTILINE)


def hashes(texts: Mapping[str, str]) -> dict[str, str]:
    """SHA-256 of what flies: sources, the headers that they need, and the numpy module.

    texts: {path: text} of a package
    """
    return {
        path: sha256(texts[path].encode("utf-8", "surrogateescape")).hexdigest()
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


def _order(path: str) -> tuple[bool, str]:
    """Sources first."""
    return not path.endswith(".c"), path
