"""The folder of a sweep: its definition, the chunks that have come back, and the results."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from derive import folder, place
from derive.simulate import table
from derive.simulate.chunk import Plan, Rows, columns
from derive.simulate.executor import Chunk
from derive.vehicle import InputError

DEFINITION, CHUNKS, SUMMARY = "sweep.json", "chunks", "summary.json"
FOLDER = "a folder that can be written to"
GO_ON = "make room, or mend what is there, then go on with --resume; another --out begins anew"


@dataclass(frozen=True)
class Sweep:
    """A sweep that can be flown: its plan, its size, and the folder of its results.

    size:       runs of a chunk
    definition: all that the results depend on; chunks are sealed with it
    """

    plan: Plan
    runs: int
    size: int
    definition: Mapping[str, Any]
    out: Path
    form: str

    @property
    def chunks(self) -> tuple[Chunk, ...]:
        """All of them, in the order of their runs."""
        cuts = range(0, self.runs, self.size)
        return tuple((first, min(first + self.size, self.runs)) for first in cuts)

    @property
    def results(self) -> Path:
        """The file of the rows, written last."""
        return self.out / f"results.{self.form}"

    @property
    def whole(self) -> Path | None:
        """The results, in another format if need be, where an earlier call has come to the end."""
        others = (self.out / f"results.{form}" for form in table.FORMATS)
        return next((one for one in (self.results, *others) if one.exists()), None)

    @property
    def kept(self) -> list[Chunk]:
        """The chunks that an earlier call has finished."""
        return [chunk for chunk in self.chunks if self._place(chunk).is_file()]

    @property
    def count(self) -> str:
        """How many those are, told."""
        return f"{len(self.kept)} of {len(self.chunks)} chunks are kept"

    def begin(self) -> None:
        """Make the folder ready; what is damaged in it is flown again. Raises InputError."""
        with place.told(self.out, FOLDER):
            self.out.mkdir(parents=True, exist_ok=True)
            folder.save_bytes(self.out / DEFINITION, as_json(self.definition))
            (self.out / CHUNKS).mkdir(exist_ok=True)
            for chunk in self.chunks:
                if self._read(chunk) is None:
                    _remove(self._place(chunk))

    def keep(self, chunk: Chunk, rows: Rows) -> None:
        """Write the rows of a chunk. Raises InputError."""
        self.save(self._place(chunk), table.packed(rows, as_json(self.definition)))

    def rows(self) -> Rows:
        """All of them, in the order of the runs. Raises InputError."""
        parts = [self._read(chunk) for chunk in self.chunks]
        there = [part for part in parts if part is not None]
        if len(there) < len(parts):
            expected, found = "every chunk that was written", f"{len(parts) - len(there)} damaged"
            raise InputError(str(self.out / CHUNKS), "", expected, found, "go on with --resume")
        return table.joined(there)

    def save(self, path: Path, data: bytes) -> None:
        """Write a file of the folder whole or not at all. Raises InputError."""
        try:
            folder.save_bytes(path, data)
        except OSError as fault:
            with place.told(path, f"{place.FILE}; {self.count}", remedy=GO_ON):
                raise fault

    def finish(self, rows: Rows) -> None:
        """Write the results, and drop what they were made of. Raises InputError."""
        self.save(self.results, table.FORMATS[self.form](rows))
        shutil.rmtree(self.out / CHUNKS, ignore_errors=True)

    def rewrite(self, there: Path) -> None:
        """Write the results in their format from those in another. Raises InputError."""
        try:
            rows = table.READERS[there.suffix[1:]](there.read_bytes())
            if (*rows,) != columns(self.plan) or rows["run"].tolist() != [*range(self.runs)]:
                raise ValueError("rows of another sweep")
        except (OSError, ValueError, ImportError) as fault:
            found = str(fault).splitlines()[0]
            remedy = "install what reads it, or remove it and fly the sweep again by --resume"
            raise InputError(
                str(there), "--format", "the sweep's results", found, remedy
            ) from fault
        self.save(self.results, table.FORMATS[self.form](rows))

    def _read(self, chunk: Chunk) -> Rows | None:
        """Its rows, unless they are not there, damaged, or of another chunk or sweep."""
        path = self._place(chunk)
        try:
            kept = path.read_bytes() if path.is_file() else b""
        except OSError:
            return None
        rows = table.unpacked(kept, as_json(self.definition))
        if rows is None or (*rows,) != columns(self.plan):
            return None
        return rows if rows["run"].tolist() == [*range(*chunk)] else None

    def _place(self, chunk: Chunk) -> Path:
        return self.out / CHUNKS / f"{chunk[0] // self.size:05}.chunk"


def as_json(data: Mapping[str, Any]) -> bytes:
    """A file of the folder."""
    return (json.dumps(data, indent=1) + "\n").encode()


@contextmanager
def alone(out: Path) -> Iterator[None]:
    """Make the folder, and let no other call into it meanwhile. Raises InputError."""
    with ExitStack() as stack:
        try:
            with place.told(out, FOLDER):
                out.mkdir(parents=True, exist_ok=True)
                stack.enter_context(folder.sole(out))
        except InputError as fault:
            if not isinstance(fault.__cause__, BlockingIOError):
                raise
            expected, found = "a folder that no other call flies into", "one that does"
            remedy = "wait for its end, or choose another folder"
            raise InputError(str(out), "--out", expected, found, remedy) from None
        yield


def refuse(out: Path, wanted: Mapping[str, Any], is_resumed: bool) -> None:
    """Raise InputError where the folder does not hold that sweep, or, if it is new, holds any."""
    if is_resumed:
        _refuse_other(out / DEFINITION, wanted)
    else:
        _refuse_taken(out)


def _refuse_taken(out: Path) -> None:
    """Raise InputError for a folder that holds something."""
    with place.told(out, "a folder, or none"):
        if not out.exists() or not any(out.iterdir()):
            return
    is_ours = (out / DEFINITION).is_file()
    found = "a sweep" if is_ours else "other files"
    remedy = "go on with it by --resume, or choose another" if is_ours else "choose another"
    raise InputError(str(out), "--out", "a folder that is empty, or not there", found, remedy)


def _refuse_other(file: Path, wanted: Mapping[str, Any]) -> None:
    """Raise InputError where the folder's sweep is not the one that is asked for."""
    try:
        kept = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        kept = None
    if not isinstance(kept, dict):
        remedy = "leave --resume out to begin one, or name its folder"
        found = "no such file" if not file.exists() else "not readable as one"
        raise InputError(str(file), "--resume", "the definition of a sweep", found, remedy)
    for key in (*wanted, *kept):
        asked, there = wanted.get(key), kept.get(key)
        if asked != there:
            remedy = "give the options of that sweep, or another --out"
            raise InputError(str(file), key, f"{there}, as the sweep there has it", f"{asked}",
                             remedy)  # fmt: skip


def _remove(path: Path) -> None:
    """Whatever is there; OSError."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    elif os.path.lexists(path):
        path.unlink()
