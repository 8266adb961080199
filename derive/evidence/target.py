"""All target evidence: a package on every machine, as many images at a time as there are cores."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from derive.evidence import bits, cost, size, stack
from derive.evidence.board import SECONDS, Reading, read
from derive.evidence.emitted import Emitted
from derive.evidence.firmware import Image, build
from derive.evidence.lack import Lack, lack
from derive.evidence.machine import LEVELS, MACHINES, Machine
from derive.evidence.tool import Tool, ToolFailed, ToolMissing, need, run
from derive.verify.check import Check
from derive.verify.limits import LIMITS


@dataclass(frozen=True)
class Outcome:
    """One image: what it said and, when measured, its call graph and sizes; or why it failed."""

    image: Image
    reading: Reading | None = None
    calls: str = ""
    sizes: tuple[Check, ...] = ()
    why: str = ""


def missing(machines: Sequence[Machine] = MACHINES) -> tuple[str, ...]:
    """For each machine on which nothing can be run here: not run, the reason, and what to do."""
    return tuple(f"{one.what} was not run: {one.why}" for one in lacks(machines))


def lacks(machines: Sequence[Machine] = MACHINES) -> tuple[Lack, ...]:
    """The same as records."""
    return tuple(found for machine in machines if (found := _lack(machine)))


def targets(
    packages: Sequence[Emitted],
    progress: Callable[[str], None] = lambda _: None,
    machines: Sequence[Machine] = MACHINES,
    levels: Sequence[str] = LEVELS,
    seconds: float = SECONDS,
) -> Iterator[Check]:
    """Every check of every package on the machines whose tools are here.

    seconds: after which an emulator is ended
    A compiler or an emulator that fails, or does not end, is a check that fails and says so;
    the others go on. Packages are only read. Raises NotEmitted.
    """
    for emitted in packages:
        emitted.refuse_absent()
    present = [machine for machine in machines if not _lack(machine)]
    pool = ThreadPoolExecutor(os.cpu_count())
    try:
        jobs = []
        for emitted in packages:
            images = _images(emitted, present, levels)
            jobs.append([(image, pool.submit(_outcome, image, seconds)) for image in images])
        for those in jobs:
            outcomes = []
            for image, future in those:
                progress(f"{image.emitted.name} {image.title}")
                outcomes.append(future.result())
            yield from _checks(outcomes)
    finally:
        pool.shutdown(cancel_futures=True)  # an interrupt waits for what runs, not for what would


def _images(
    emitted: Emitted, machines: Sequence[Machine], levels: Sequence[str]
) -> Iterator[Image]:
    """One image per level and machine that takes the package's scalar."""
    for machine in machines:
        if emitted.scalar in machine.scalars:
            yield from (Image(emitted, machine, level) for level in levels)


def _outcome(image: Image, seconds: float) -> Outcome:
    """Build and run one image in a temporary folder."""
    with tempfile.TemporaryDirectory(prefix="derive-") as name:
        folder = Path(name)
        try:
            reading = read(image, build(image, folder), seconds)
            if not image.is_measured:
                return Outcome(image, reading)
            (graph,) = folder.glob(f"*{image.emitted.prefix}.ci")
            sizes = tuple(size.checks(image.emitted, image.machine, folder))
            return Outcome(image, reading, graph.read_text(encoding="utf-8"), sizes)
        except (ToolFailed, ToolMissing, OSError) as error:
            return Outcome(image, why=" | ".join(str(error).split("\n")))


def _checks(outcomes: Sequence[Outcome]) -> Iterator[Check]:
    """The checks of one package in one scalar, machine by machine."""
    model = next((one.reading for one in outcomes if one.reading), None)
    for machine in dict.fromkeys(one.image.machine for one in outcomes):
        those = [one for one in outcomes if one.image.machine == machine]
        yield _built(those)
        if model and (readings := [one.reading for one in those if one.reading]):
            yield from bits.checks(readings, model)
        for one in those:
            if one.reading and one.image.is_measured:
                yield from cost.checks(one.reading)
                yield from stack.checks(one.reading, one.calls)
                yield from one.sizes


def _built(outcomes: Sequence[Outcome]) -> Check:
    """Whether all images of a machine were built and ran to their end; else the tool's words."""
    image = outcomes[0].image
    failed = [f"{one.image.level}: {one.why}" for one in outcomes if one.why]
    subject = f"{image.emitted.scalar} {image.machine.name}"
    return Check(
        "built and run", subject, len(failed), LIMITS["images"], len(outcomes),
        failed[0] if failed else "", tuple(failed),
    )  # fmt: skip


def _lack(machine: Machine) -> Lack | None:
    """What is missing for a machine, and how to get it; nothing when all is here."""
    try:
        need(*machine.tools)
        if machine.needs and not _has(machine.compiler.path, machine.needs):
            where = f"where {machine.compiler.command} looks for it"
            raise ToolMissing(Tool(machine.needs, machine.compiler.install, where))
    except ToolMissing as error:
        return lack(machine.name, error, (), is_part=False)
    return None


def _has(compiler: str, file: str) -> bool:
    """Whether a compiler finds a file of its library: it answers with a path, not with the name.

    One that does not answer is not missing: what is built with it tells its words.
    """
    try:
        return run([compiler, f"-print-file-name={file}"], 10).strip() != file
    except (ToolFailed, OSError):
        return True
