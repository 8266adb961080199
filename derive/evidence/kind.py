"""The kinds of evidence: what each one runs, and how much less of it in a quick run."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from derive.evidence import bound, coverage, defect, eva, flip, fuzz, limit, target
from derive.evidence.emitted import Emitted
from derive.evidence.lack import Lack
from derive.evidence.rule import RULES, Rule
from derive.verify import run
from derive.verify.check import Check
from derive.verify.plant import Plant

QUICK_RUNS = 100_000
"""Of the fuzzer."""

QUICK_STEP = 64
"""Of the numbers that a kernel polynomial is tried on."""


@dataclass(frozen=True)
class Work:
    """What is measured.

    texts: {path: text} of the package; packages: the same on disk, one per scalar of C
    plant: what the truth is told; scratch: a folder for what is built
    """

    name: str
    texts: Mapping[str, str]
    packages: tuple[Emitted, ...]
    plant: Plant
    scratch: Path
    is_quick: bool = False
    progress: Callable[[str], None] = lambda _: None

    def place(self, one: Emitted, what: str) -> Path:
        """A folder of its own for what is built of one scalar."""
        return self.scratch / f"{one.prefix}_{what}"


@dataclass(frozen=True)
class Step:
    """One measurement. run: gives its checks, and what could not be run here.

    is_crew: it takes the whole package, and the whole machine; else one scalar, on one core
    quick: what a quick run leaves out
    """

    name: str
    run: Callable[[Work, Sequence[Emitted]], Iterator[Check | Lack]]
    is_crew: bool = False
    quick: str = ""


@dataclass(frozen=True)
class Kind:
    """Steps that are shown together; key: of its words in the page."""

    key: str
    steps: tuple[Step, ...]


def _accuracy(work: Work, _: Sequence[Emitted]) -> Iterator[Check | Lack]:
    report = run.run(work.name, work.texts, work.plant, progress=work.progress)
    yield from report.checks
    for text in report.skipped:
        where, why = text.split(": ", 1)  # C f64 and f32
        tools = ("cc, gcc or clang",)
        yield Lack(f"accuracy of {where}", tools, why, is_part=bool(report.checks))


def _proofs(_: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    for one in packages:
        yield from eva.proofs(one)
        if limit.is_limited(one):
            yield limit.limits(one)


def _teeth(work: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    for one in () if work.is_quick else packages:
        work.progress(f"seeded defects, {one.scalar}")
        yield defect.teeth(one)


def _bounds(_: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    for one in packages:
        yield from bound.bounds(one)


def _maxima(work: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    for one in packages:
        yield from bound.maxima(one, QUICK_STEP if work.is_quick else 1)


def _fuzz(work: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    for one in packages:
        runs = QUICK_RUNS if work.is_quick else fuzz.RUNS
        yield from fuzz.fuzz(one, work.plant, work.place(one, "fuzz"), runs)


def _flip(work: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    for one in packages:
        yield from flip.flip(one, work.plant, work.place(one, "flip"))


def _coverage(work: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    for one in packages:
        yield from coverage.coverage(one, work.place(one, "coverage"))


def _targets(work: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    yield from target.targets(packages, work.progress)
    for one in target.lacks() if packages else ():
        yield replace(one, what=f"target {one.what}")


def held(name: str, rule: Rule) -> Step:
    """A rule as a step of its own: a tool that is missing or breaks down spares the others."""

    def run(_: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
        for one in packages:
            yield from rule(one)

    return Step(name, run)


KINDS = (
    Kind("proof", (
        Step("Eva", _proofs),
        Step("seeded defects", _teeth, is_crew=True, quick="seeded defects"),
    )),
    Kind("kernel", (
        Step("kernel bounds", _bounds),
        Step("kernel maxima", _maxima,
             quick=f"kernel maxima: {QUICK_STEP - 1} of {QUICK_STEP} numbers"),
    )),
    Kind("accuracy", (Step("accuracy", _accuracy, is_crew=True),)),
    Kind("target", (Step("targets", _targets, is_crew=True),)),
    Kind("attack", (
        Step("fuzzing", _fuzz, quick=f"fuzzing: {fuzz.RUNS - QUICK_RUNS:,} of {fuzz.RUNS:,} runs"),
        Step("bit flips", _flip),
        Step("coverage", _coverage),
    )),
    Kind("rule", tuple(held(*item) for item in RULES.items())),
)  # fmt: skip
"""In the order of the page."""
