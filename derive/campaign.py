"""The route of a sweep: what it is defined by, its flight, and what is said of it."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from time import monotonic
from typing import Any

from derive import __version__
from derive.course import course
from derive.demand import backend_of
from derive.flight import ROOM, craft, overridden, setting_of, spread_of
from derive.simulate import executor, summary
from derive.simulate.chunk import CannotFly, Plan, Rows, lean
from derive.simulate.cluster import Cluster
from derive.simulate.craft import NoRoom
from derive.simulate.executor import Crew
from derive.sweep_folder import SUMMARY, Sweep, alone, as_json, refuse
from derive.vehicle import InputError, Vehicle


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


def plan(vehicle: Vehicle, cached: Path | None, asked: Asked) -> Plan:
    """The vehicle and the command line as what a worker needs. Raises InputError."""
    one = overridden(vehicle, asked.given)
    made = craft(one, cached)
    rated: list[dict[str, Any]] = [{"rate": rate} for rate in asked.rates] or [{}]
    followed = course(one, made)
    return Plan(
        craft=lean(made),
        backend=backend_of(asked.backend),
        course=followed,
        settings=tuple(
            setting_of(overridden(one, rate), {**asked.given, **rate}, made, followed.reference())
            for rate in rated
        ),
        spread=spread_of(one, asked.given, asked.box, asked.speed),
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
    refuse(out, wanted, is_resumed)
    sweep = Sweep(made, asked.runs, asked.chunk, wanted, out, form)
    if not sweep.whole:
        sweep.begin()
    return sweep


@contextmanager
def held(made: Plan, asked: Asked, out: Path, form: str, is_resumed: bool) -> Iterator[Sweep]:
    """The same, with no other call in that folder meanwhile. Raises InputError."""
    refuse(out, defined(made, asked), is_resumed)  # before a folder is made
    with alone(out):
        yield opened(made, asked, out, form, is_resumed)


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
    except (executor.WorkersLost, CannotFly, NoRoom) as fault:
        raise _lost(sweep, crew, fault) from fault
    return sweep.rows()


def told(rows: Rows, sweep: Sweep) -> tuple[dict[str, Any], str]:
    """The summary, which is written as well, and the same for people. Raises InputError."""
    found = summary.summary(rows)
    sweep.save(sweep.out / SUMMARY, as_json(found))
    return found, summary.text(found)


def _progress(done: int, total: int, seconds: float) -> str:
    if not done:
        return f"0 of {total} runs"
    left = math.ceil(seconds * (total - done) / done)
    return f"{done} of {total} runs, {done / max(seconds, 1e-9):.0f} runs/s, {left} s left"


def _digest(value: object) -> str:
    return hashlib.sha256(repr(value).encode()).hexdigest()


def _lost(sweep: Sweep, crew: Crew, fault: Exception) -> InputError:
    """What to say when nobody can fly on."""
    cause = type(fault) if type(fault) in CAUSES else type(crew)
    key, expected, remedy = CAUSES.get(cause, OTHER)
    found = str(fault).splitlines()[0]
    return InputError(str(sweep.out), key, f"{expected}; {sweep.count}", found, remedy)


CAUSES = {
    CannotFly: ("--backend", "a C compiler that builds the emitted code on every worker",
                "install gcc or clang there, or fly --backend numpy"),
    NoRoom: ("TMPDIR", "a folder for temporary files that takes some megabytes, on every worker",
             f"{ROOM}; go on with --resume"),
    Cluster: ("--cluster", "a scheduler and workers that stay alive",
              "start them again, then go on with --resume"),
}  # fmt: skip
OTHER = (
    *("--workers", "workers that stay alive"),
    "go on with --resume; fewer --workers, or a smaller --chunk, need less memory",
)
"""What stopped a sweep -> the option to blame, what it expects, what to do."""
