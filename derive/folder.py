"""Emitted folders on disk: read whole, replaced whole, never mixed with foreign files.

New folders are written beside the old ones and renamed into their places, all of a call or none,
under a lock on the folder that holds them.
"""

from __future__ import annotations

import fcntl
import os
import shutil
import tempfile
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

MANIFEST = "MANIFEST.toml"
PART = (".derive-", ".part")
"""How the name of a folder begins and ends that is being written; left behind only by a crash."""


def read(folder: Path) -> dict[str, str]:
    """Everything below folder but folders, by relative path; caches of Python left out.

    The text of regular files; what a link, a socket or the like holds is not looked at.
    """
    found: dict[str, str] = {}
    for path in sorted(folder.rglob("*")):
        if "__pycache__" in path.relative_to(folder).parts:
            continue
        name = path.relative_to(folder).as_posix()
        if path.is_symlink() or not (path.is_file() or path.is_dir()):
            found[name] = "(not a regular file)\n"
        elif path.is_file():
            found[name] = path.read_bytes().decode("utf-8", "surrogateescape")
    return found


def strangers(folder: Path) -> list[str]:
    """What below folder its manifest does not know; all of it when there is no manifest.

    NotADirectoryError when the place is taken by something else than a folder.
    """
    if folder.is_symlink() or not folder.is_dir():
        if os.path.lexists(folder):
            raise NotADirectoryError(f"{folder.name} is not a folder")
        return []
    known = _known(folder / MANIFEST)
    return [path for path in read(folder) if path not in known]


def _known(manifest: Path) -> set[str]:
    """The manifest itself and the files it names; nothing when it cannot be read."""
    try:
        files = tomllib.loads(manifest.read_text(encoding="utf-8"))["files"]
        return {*files, MANIFEST} if isinstance(files, dict) else set()
    except (OSError, ValueError, KeyError, RecursionError):
        return set()


def replace(out: Path, folders: Mapping[str, Mapping[str, str]]) -> dict[str, bool]:
    """Make each out/NAME hold exactly its texts, all of them or none; OSError when it cannot.

    Returns whether each was changed: False where it held the same bytes already.
    """
    out.mkdir(parents=True, exist_ok=True)
    with _locked(out):
        changed = {name: read(out / name) != dict(texts) for name, texts in folders.items()}
        names = [name for name, is_changed in changed.items() if is_changed]
        if names:
            beside = Path(tempfile.mkdtemp(dir=out, prefix=PART[0], suffix=PART[1]))
            try:
                for name in names:
                    _fill(beside / "new" / name, folders[name])
                _swap(out, beside, names)
            finally:
                shutil.rmtree(beside, ignore_errors=True)
    return changed


@contextmanager
def _locked(out: Path) -> Iterator[None]:
    """One writer at a time, and what an earlier one that was killed left behind is cleared away."""
    handle = os.open(out, os.O_RDONLY)
    try:
        with suppress(OSError):  # a file system without locks: the renames alone must do
            fcntl.flock(handle, fcntl.LOCK_EX)
            _recover(out)
        yield
    finally:
        os.close(handle)


def _recover(out: Path) -> None:
    """Put back what was moved away by a call that then was killed, and drop its new folders."""
    for beside in sorted(out.glob("*".join(PART))):
        for old in sorted((beside / "old").glob("*")):
            if not os.path.lexists(out / old.name):
                old.rename(out / old.name)
        shutil.rmtree(beside, ignore_errors=True)


def _swap(out: Path, beside: Path, names: list[str]) -> None:
    """Move the old folders away and the new ones in; the old ones come back when one fails."""
    (beside / "old").mkdir()
    try:
        for name in names:
            with suppress(FileNotFoundError):
                (out / name).rename(beside / "old" / name)
            (beside / "new" / name).rename(out / name)
    except BaseException:  # Ctrl-C too
        for name in names:
            if not (beside / "new" / name).exists():
                (out / name).rename(beside / "new" / name)
            if (beside / "old" / name).exists():
                (beside / "old" / name).rename(out / name)
        raise


def _fill(folder: Path, texts: Mapping[str, str]) -> None:
    for path, text in texts.items():
        place = folder / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(text.encode("utf-8"))


def save(path: Path, text: str) -> None:
    """Write one file whole or not at all: beside its place, then renamed into it; OSError.

    A device or a pipe has no such place, and is written to as it is.
    """
    if path.exists() and not path.is_file():
        path.write_text(text, encoding="utf-8")
        return
    place = path.resolve()  # a link stays one
    beside = place.with_name(f"{PART[0]}{os.urandom(8).hex()}{PART[1]}")
    try:
        beside.write_text(text, encoding="utf-8")
        beside.replace(place)
    except BaseException:
        with suppress(OSError):
            beside.unlink()
        raise
