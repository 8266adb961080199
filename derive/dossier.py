"""Evidence on emitted packages: measured on a copy, written beside the code as EVIDENCE.md."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from derive import folder, pipeline, place, selftest
from derive.emit.drift import compare
from derive.evidence.stamp import PAGE, Fault, fault, is_page
from derive.vehicle import InputError, Vehicle

if TYPE_CHECKING:
    from derive.evidence.emitted import Emitted
    from derive.evidence.gather import Evidence
    from derive.verify.check import Report


@dataclass(frozen=True)
class Filed:
    """What became of one page. is_kept: an older one that has more was left in its place."""

    page: Path
    evidence: Evidence
    is_kept: bool = False


def page_of(package: Path) -> Path:
    """Where a package has its page, if it has one."""
    return package / PAGE


def is_bare(package: Path) -> bool:
    """Whether a package is there, and nothing that has the name of its page."""
    return package.is_dir() and not os.path.lexists(package / PAGE)


def page_fault(package: Path) -> Fault | None:
    """What is wrong with the page in a package; nothing where all is well, or is no page.

    Raises InputError.
    """
    if not is_page(package / PAGE):
        return None
    with place.told(package, "a folder that can be read"):
        page = (package / PAGE).read_text(encoding="utf-8", errors="replace")
        return fault(page, folder.read(package))


def refuse_unready(vehicle: Vehicle, out: Path, cached: Path | None, renewal: str) -> None:
    """Raise InputError where there is nothing to measure, or no place for what is measured.

    renewal: the command that writes the package
    """
    package = out / vehicle.name
    with place.told(package, "a folder that can be read"):
        drifts = compare(pipeline.texts(vehicle, cached), folder.derived(package))
    if drifts:
        found = f"{len(drifts)} files that differ, the first {drifts[0].path}"
        if not package.is_dir():
            found = "no such folder"
        expected = f"the package that {vehicle.source} gives"
        raise InputError(str(package), "", expected, found, f"run first: {renewal}")
    place.probe(package / PAGE, "--out")


def measured(
    vehicle: Vehicle, out: Path, progress: Callable[[str], None], *, is_quick: bool = False
) -> Evidence:
    """All evidence on the package in out/NAME; what stands there is only read."""
    from derive.evidence.gather import gather
    from derive.evidence.kind import Work

    texts = folder.derived(out / vehicle.name)
    with copied(vehicle.name, texts) as root:
        packages, plant = _packages(vehicle, root / vehicle.name), selftest.plant_of(vehicle)
        work = Work(vehicle.name, texts, packages, plant, root / "scratch", is_quick, progress)
        return gather(work)


def filed(evidence: Evidence, package: Path, *, may_lose: bool = False) -> Filed:
    """Write the page whole or not at all. Raises InputError.

    may_lose: replace also a page that fits and is of a whole run by one that lacks something
    """
    from derive.evidence.page import WHOLE, page

    path = package / PAGE
    is_kept = False
    if not evidence.is_whole and not may_lose and is_page(path) and not page_fault(package):
        is_kept = WHOLE in path.read_text(encoding="utf-8", errors="replace")
    if not is_kept:
        place.save(path, page(evidence), "--out")
    return Filed(path, evidence, is_kept)


def on_targets(
    vehicle: Vehicle, cached: Path | None, report: Report, progress: Callable[[str], None]
) -> Report:
    """A report, and what `emit` would write run on every target. Raises InputError."""
    from derive.evidence.target import missing, targets

    with copied(vehicle.name, pipeline.texts(vehicle, cached)) as root:
        packages = _packages(vehicle, root / vehicle.name)
        checks = tuple(targets(packages, progress))
    return replace(report, checks=(*report.checks, *checks), skipped=(*report.skipped, *missing()))


def refuse_without_c(vehicle: Vehicle) -> None:
    """Raise InputError for a vehicle of which there is nothing to run on a target."""
    if selftest.CODE not in vehicle.targets:
        expected, found = f"{selftest.CODE}, to run on targets", ", ".join(vehicle.targets)
        remedy = f'add "{selftest.CODE}" to it, or leave --target out'
        raise InputError(vehicle.source, "emit.targets", expected, found, remedy)


@contextmanager
def compiling(vehicle: Vehicle) -> Iterator[None]:
    """Turn a compiler that refuses what is emitted, or hangs, into an InputError."""
    from derive.native.compile import CompileError

    try:
        yield
    except CompileError as fault:
        expected = "a C compiler that takes what is emitted"
        found = str(fault).rstrip().replace("\n", "\n    ")
        remedy = "mend the compiler, or put another before it on PATH: gcc or clang"
        raise InputError(vehicle.source, "", expected, found, remedy) from fault


@contextmanager
def copied(name: str, texts: Mapping[str, str]) -> Iterator[Path]:
    """A folder that holds a package by its name, while it is measured. Raises InputError."""
    temporary, expected = Path(tempfile.gettempdir()), "room for what is built"
    remedy = "make room there, or let TMPDIR name another folder"
    with (
        place.told(temporary, expected, "", remedy),
        tempfile.TemporaryDirectory(prefix="derive-") as scratch,
    ):
        folder.fill(Path(scratch) / name, texts)
        yield Path(scratch)


def _packages(vehicle: Vehicle, package: Path) -> tuple[Emitted, ...]:
    from derive.evidence.emitted import Emitted

    scalars = vehicle.scalars if selftest.CODE in vehicle.targets else ()
    return tuple(Emitted(package, vehicle.name, scalar) for scalar in scalars)
