"""Emitted folders on disk: read whole, replaced whole, never mixed with foreign files.

New folders are written beside the old ones and renamed into their places, all of a call or none,
under a lock on the folder that holds them. A page of evidence is measured and not derived: it stays
where it is when the rest of its folder is replaced.
"""

from __future__ import annotations

import fcntl
import os
import shutil
import tempfile
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from errno import EACCES, EISDIR, ENOTDIR
from pathlib import Path

from derive.evidence.stamp import PAGE, is_page

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


def derived(folder: Path) -> dict[str, str]:
    """The same without a page of evidence."""
    is_there = is_page(folder / PAGE)
    return {name: text for name, text in read(folder).items() if not (is_there and name == PAGE)}


def strangers(folder: Path) -> list[str]:
    """What below folder its manifest does not know; all of it when there is no manifest.

    An empty folder counts. NotADirectoryError when something else than a folder is there.
    """
    if folder.is_symlink() or not folder.is_dir():
        if os.path.lexists(folder):
            raise NotADirectoryError(ENOTDIR, os.strerror(ENOTDIR), str(folder))
        return []
    known = _known(folder / MANIFEST)
    if known and is_page(folder / PAGE):
        known.add(PAGE)
    return [path for path in (*read(folder), *_empty(folder, known)) if path not in known]


def _empty(folder: Path, known: set[str]) -> Iterator[str]:
    """Folders below that hold nothing and that no known file has its place in: NAME/."""
    homes = {parent for path in known for parent in (folder / path).parents}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder)
        if "__pycache__" in name.parts or path in homes or path.is_symlink() or not path.is_dir():
            continue
        if not any(path.iterdir()):
            yield f"{name.as_posix()}/"


def _known(manifest: Path) -> set[str]:
    """The manifest itself and the files it names; nothing when it cannot be read."""
    try:
        files = tomllib.loads(manifest.read_text(encoding="utf-8"))["files"]
        return {*files, MANIFEST} if isinstance(files, dict) else set()
    except (OSError, ValueError, KeyError, RecursionError):
        return set()


def replace(out: Path, folders: Mapping[str, Mapping[str, str]]) -> dict[str, bool]:
    """Make each out/NAME hold exactly its texts, all of them or none; OSError when it cannot.

    A page of evidence is kept beside them.
    Returns whether each was changed: False where it held the same bytes already.
    """
    out.mkdir(parents=True, exist_ok=True)
    with _locked(out):
        changed = {name: derived(out / name) != dict(texts) for name, texts in folders.items()}
        names = [name for name, is_changed in changed.items() if is_changed]
        if names:
            beside = Path(tempfile.mkdtemp(dir=out, prefix=PART[0], suffix=PART[1]))
            try:
                for name in names:
                    fill(beside / "new" / name, folders[name])
                    if is_page(page := out / name / PAGE):
                        shutil.copy2(page, beside / "new" / name / PAGE)
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


@contextmanager
def sole(out: Path) -> Iterator[None]:
    """Nobody else who asks for this has the folder meanwhile; BlockingIOError where one has it."""
    handle = os.open(out, os.O_RDONLY)
    try:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise
        except OSError:  # a file system without locks
            pass
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


def fill(folder: Path, texts: Mapping[str, str]) -> None:
    """Write texts below a folder."""
    for path, text in texts.items():
        place = folder / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(text.encode("utf-8", "surrogateescape"))


def save(path: Path, text: str) -> None:
    """Write one file whole or not at all: beside its place, then renamed into it; OSError.

    A device or a pipe has no such place, and is written to as it is.
    """
    save_bytes(path, text.encode())


def save_bytes(path: Path, data: bytes) -> None:
    """The same for bytes."""
    if path.exists() and not path.is_file():
        path.write_bytes(data)
        return
    place = path.resolve()  # a link stays one
    with _beside(place) as beside:
        beside.write_bytes(data)
        beside.replace(place)


def probe(path: Path) -> None:
    """OSError where `save` would raise one, before there is a text; leaves all as it is."""
    if path.is_dir():
        raise IsADirectoryError(EISDIR, os.strerror(EISDIR), str(path))
    if not path.exists() or path.is_file():
        with _beside(path.resolve()) as beside:
            beside.touch()
    elif not os.access(path, os.W_OK):
        raise PermissionError(EACCES, os.strerror(EACCES), str(path))


@contextmanager
def _beside(place: Path) -> Iterator[Path]:
    """A new name in the folder of a file; nothing is left of it in the end."""
    beside = place.with_name(f"{PART[0]}{os.urandom(8).hex()}{PART[1]}")
    try:
        yield beside
    finally:
        with suppress(OSError):
            beside.unlink()


def save_all(out: Path, files: Mapping[str, bytes]) -> None:
    """Write files into a folder, all of them or none, beside whatever else it holds; OSError."""
    out.mkdir(parents=True, exist_ok=True)
    taken = next((out / name for name in files if (out / name).is_dir()), None)
    if taken:
        raise IsADirectoryError(EISDIR, os.strerror(EISDIR), str(taken))
    with _locked(out):
        beside = Path(tempfile.mkdtemp(dir=out, prefix=PART[0], suffix=PART[1]))
        try:
            (beside / "new").mkdir()
            for name, content in files.items():
                (beside / "new" / name).write_bytes(content)
            _swap(out, beside, list(files))
        finally:
            shutil.rmtree(beside, ignore_errors=True)
