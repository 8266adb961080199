"""What was derived, kept on disk under a key of all that it depends on.

An entry carries the hash of its own payload: a damaged one is ignored and written anew. It is
written beside its place and renamed into it, so two processes never see half an entry.
"""

from __future__ import annotations

import json
import os
import tempfile
from contextlib import suppress
from hashlib import sha256
from importlib import metadata
from pathlib import Path
from typing import Any

from derive import __version__

DERIVING = ("lie", "routine", "control", "emit")
"""Packages whose source decides what is derived and printed."""


def default_folder() -> Path:
    """Where entries are kept for this user."""
    return Path.home() / ".cache" / "derive"


def key(**parts: object) -> str:
    """Hash of the parts, the source that derives, and the versions of what it derives with."""
    digest = sha256(json.dumps([__version__, parts], sort_keys=True, default=str).encode())
    for library in ("sympy", "mpmath"):
        digest.update(f"{library} {metadata.version(library)}".encode())
    root = Path(__file__).parent
    for package in DERIVING:
        for source in sorted((root / package).glob("*.py")):
            digest.update(f"{package}/{source.name}\n".encode() + source.read_bytes())
    return digest.hexdigest()


def read(folder: Path, name: str) -> Any:
    """The payload kept under that key, or None when there is none that is whole."""
    try:
        entry = json.loads((folder / f"{name}.json").read_text(encoding="utf-8"))
        text = entry["payload"]
        whole = entry["sha256"] == sha256(text.encode()).hexdigest()
        return json.loads(text) if whole else None
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


def write(folder: Path, name: str, payload: Any) -> None:
    """Keep a payload of plain data; a folder that cannot be written to keeps nothing."""
    text = json.dumps(payload, sort_keys=True)
    entry = json.dumps({"sha256": sha256(text.encode()).hexdigest(), "payload": text})
    with suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
        handle, beside = tempfile.mkstemp(dir=folder, suffix=".part")
        try:
            with os.fdopen(handle, "w", encoding="utf-8") as file:
                file.write(entry)
            os.replace(beside, folder / f"{name}.json")
        except OSError:
            os.unlink(beside)
