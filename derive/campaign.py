"""The route of a sweep: what it is defined by, its folder, and going on where it stopped."""

from __future__ import annotations

import hashlib
import json
import math
import shutil
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from time import monotonic
from typing import Any

from derive import __version__, folder, place
from derive.course import course
from derive.demand import backend_of
from derive.flight import craft, overridden, setting_of, spread_of
from derive.simulate import executor, summary, table
from derive.simulate.chunk import CannotFly, Plan, Rows, lean
from derive.simulate.cluster import Cluster
from derive.simulate.executor import Chunk, Crew
from derive.vehicle import InputError, Vehicle

DEFINITION, CHUNKS, SUMMARY = "sweep.json", "chunks", "summary.json"


@dataclass(frozen=True)
class Asked:
    """What a command line says of a sweep.

    rates: of the controller, Hz, one of which each run takes; none for the vehicle file's
    given: keys of Experiment that replace those of the vehicle file
    chunk: runs that fly together
    """

    runs: int
    seed: int
    backend: str
    box: float
    speed: float
    settle: float
    rates: tuple[float, ...]
    given: Mapping[str, Any]
    chunk: int


@dataclass(frozen=True)
class Sweep:
    """A sweep that can be flown: its plan, its chunks, and the folder of its results."""

    plan: Plan
    chunks: tuple[Chunk, ...]
    definition: Mapping[str, Any]
    out: Path
    form: str

    @property
    def results(self) -> Path:
        """The file of the rows, written last."""
        return self.out / f"results.{self.form}"

    @property
    def whole(self) -> Path | None:
        """The results, in whatever format, where an earlier call has come to the end."""
        places = (self.out / f"results.{form}" for form in table.FORMATS)
        return next((place for place in places if place.exists()), None)

    @property
    def kept(self) -> list[Chunk]:
        """The chunks that an earlier call has finished."""
        return [chunk for chunk in self.chunks if self._place(chunk).is_file()]

    def keep(self, chunk: Chunk, rows: Rows) -> None:
        """Write the rows of a chunk. Raises InputError."""
        save(self._place(chunk), table.packed(rows))

    def drop_damaged(self) -> None:
        """Forget chunks that cannot be read; they are flown again."""
        for chunk in self.kept:
            rows = table.unpacked(self._place(chunk))
            if rows is None or rows["run"].tolist() != list(range(*chunk)):
                self._place(chunk).unlink()

    def rows(self) -> Rows:
        """All of them, in the order of the runs."""
        parts = [table.unpacked(self._place(chunk)) for chunk in self.chunks]
        return table.joined([part for part in parts if part is not None])

    def finish(self, rows: Rows) -> None:
        """Write the results, and drop what they were made of. Raises InputError."""
        save(self.results, table.FORMATS[self.form](rows))
        shutil.rmtree(self.out / CHUNKS, ignore_errors=True)

    def _place(self, chunk: Chunk) -> Path:
        return self.out / CHUNKS / f"{chunk[0] // self.chunks[0][1]:05}.npz"


def plan(vehicle: Vehicle, cached: Path | None, asked: Asked) -> Plan:
    """The vehicle and the command line as what a worker needs. Raises InputError."""
    one = overridden(vehicle, asked.given)
    made = craft(one, cached)
    rated = [overridden(one, {"rate": rate}) for rate in asked.rates] or [one]
    followed = course(one, made)
    return Plan(
        craft=lean(made),
        backend=backend_of(asked.backend),
        course=followed,
        settings=tuple(setting_of(each, made, followed.reference()) for each in rated),
        spread=spread_of(one, asked.box, asked.speed),
        settle=asked.settle,
        root=asked.seed,
    )


def defined(made: Plan, asked: Asked) -> dict[str, Any]:
    """All that the results depend on, flat: key -> a number, a word or a list of them."""
    whole = {
        "derive": __version__,
        "vehicle": made.craft.name,
        "craft": _digest(made.craft),
        "course": _digest(made.course),
        "backend": made.backend,
        "runs": asked.runs,
        "seed": made.root,
        "settle": made.settle,
        "chunk": asked.chunk,
        **{f"spread.{key}": value for key, value in asdict(made.spread).items()},
    }
    for number, setting in enumerate(made.settings):
        whole |= {f"setting.{number}.{key}": value for key, value in asdict(setting).items()}
    data: dict[str, Any] = json.loads(json.dumps(whole))
    return data


def opened(made: Plan, asked: Asked, out: Path, form: str, is_resumed: bool) -> Sweep:
    """The sweep with its folder made ready, or found again. Raises InputError."""
    wanted = defined(made, asked)
    if is_resumed:
        _refuse_other(out / DEFINITION, wanted)
    else:
        _refuse_taken(out)
    cuts = range(0, asked.runs, asked.chunk)
    chunks = tuple((first, min(first + asked.chunk, asked.runs)) for first in cuts)
    sweep = Sweep(made, chunks, wanted, out, form)
    if not sweep.whole:
        with place.told(out, "a folder that can be written to"):
            (out / CHUNKS).mkdir(parents=True, exist_ok=True)
        save(out / DEFINITION, (json.dumps(wanted, indent=1) + "\n").encode())
        sweep.drop_damaged()
    return sweep


def flown(sweep: Sweep, crew: Crew, progress: Callable[[str], object]) -> Rows:
    """Fly what is not there yet, keep each chunk at once; all rows. Raises InputError."""
    kept = set(sweep.kept)
    waiting = [chunk for chunk in sweep.chunks if chunk not in kept]
    total, start = sum(last - first for first, last in waiting), monotonic()
    done = 0
    try:
        progress(_progress(0, total, 0.0))
        for chunk, rows in executor.flown(crew, sweep.plan, waiting):
            sweep.keep(chunk, rows)
            done += chunk[1] - chunk[0]
            progress(_progress(done, total, monotonic() - start))
    except (executor.WorkersLost, CannotFly) as fault:
        raise _lost(sweep, crew, fault) from fault
    return sweep.rows()


def save(path: Path, data: bytes) -> None:
    """Write a file of the sweep whole or not at all. Raises InputError."""
    with place.told(path, "a file that can be written to"):
        folder.save_bytes(path, data)


def told(rows: Rows, sweep: Sweep) -> dict[str, Any]:
    """The summary, which is written as well. Raises InputError."""
    found = summary.summary(rows)
    save(sweep.out / SUMMARY, (json.dumps(found, indent=1) + "\n").encode())
    return found


def text(found: Mapping[str, Any]) -> str:
    """The summary for people."""
    return summary.text(found)


def _progress(done: int, total: int, seconds: float) -> str:
    if not done:
        return f"0 of {total} runs"
    left = math.ceil(seconds * (total - done) / done)
    return f"{done} of {total} runs, {done / max(seconds, 1e-9):.0f} runs/s, {left} s left"


def _digest(value: object) -> str:
    return hashlib.sha256(repr(value).encode()).hexdigest()


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


def _lost(sweep: Sweep, crew: Crew, fault: Exception) -> InputError:
    """What to say when nobody can fly on."""
    count = f"{len(sweep.kept)} of {len(sweep.chunks)} chunks are kept"
    found = str(fault).splitlines()[0]
    if isinstance(fault, CannotFly):
        key, expected = "--backend", "a C compiler that builds the emitted code on every worker"
        remedy = "install gcc or clang there, or fly --backend numpy"
    elif isinstance(crew, Cluster):
        key, expected = "--cluster", "a scheduler and workers that stay alive"
        remedy = "start them again, then go on with --resume"
    else:
        key, expected = "--workers", "workers that stay alive"
        remedy = "go on with --resume; fewer --workers, or a smaller --chunk, need less memory"
    return InputError(str(sweep.out), key, f"{expected}; {count}", found, remedy)
