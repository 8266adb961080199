"""An emitted folder on disk: read whole, replaced whole, never mixed with foreign files."""

from __future__ import annotations

import os
import shutil
import tempfile
import tomllib
from collections.abc import Mapping
from pathlib import Path

MANIFEST = "MANIFEST.toml"


def read(folder: Path) -> dict[str, str]:
    """Every file below folder as text by its relative path; caches of Python left out."""
    found: dict[str, str] = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file() and "__pycache__" not in path.parts:
            raw = path.read_bytes()
            found[path.relative_to(folder).as_posix()] = raw.decode("utf-8", "surrogateescape")
    return found


def strangers(folder: Path) -> list[str]:
    """Files below folder that its manifest does not know; all of them when it has none."""
    if not folder.exists():
        return []
    try:
        known = tomllib.loads((folder / MANIFEST).read_text(encoding="utf-8"))["files"]
    except (OSError, ValueError, KeyError):
        known = {}
    return [path for path in read(folder) if path not in known and path != MANIFEST or not known]


def replace(folder: Path, texts: Mapping[str, str]) -> bool:
    """Make folder hold exactly these texts; False when it did already. OSError when it cannot.

    The new folder is written beside the old one and renamed into its place.
    """
    if folder.is_dir() and read(folder) == dict(texts):
        return False
    folder.parent.mkdir(parents=True, exist_ok=True)
    beside = Path(tempfile.mkdtemp(dir=folder.parent, prefix=f".{folder.name}."))
    try:
        _fill(beside / "new", texts)
        if folder.exists():
            os.rename(folder, beside / "old")
        os.rename(beside / "new", folder)
    finally:
        if not folder.exists() and (beside / "old").exists():
            os.rename(beside / "old", folder)
        shutil.rmtree(beside, ignore_errors=True)
    return True


def _fill(folder: Path, texts: Mapping[str, str]) -> None:
    for path, text in texts.items():
        place = folder / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(text.encode("utf-8"))
