"""All evidence on one package: every kind, two steps at a time, and whatever breaks down is told.

A tool that is not here spares the rest of its step. One that breaks down, or does not end in time,
is a check that fails: no evidence is not good evidence.
"""

from __future__ import annotations

import traceback
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from itertools import count
from pathlib import Path

from derive.evidence.emitted import Emitted
from derive.evidence.kind import KINDS, Kind, Step, Work
from derive.evidence.lack import Lack, lack, merged
from derive.evidence.tool import ToolFailed, ToolMissing
from derive.native.compile import CompileError
from derive.verify.check import Check
from derive.verify.limits import LIMITS

WORKERS = 2


@dataclass(frozen=True)
class Outcome:
    """What one step came to. missing: what could not be run here; broken: a tool's last words."""

    checks: tuple[Check, ...]
    missing: tuple[Lack, ...] = ()
    broken: str = ""


@dataclass(frozen=True)
class Section:
    """What one kind came to; missing: each thing once, however many steps lack it."""

    kind: Kind
    checks: tuple[Check, ...]
    missing: tuple[Lack, ...]


@dataclass(frozen=True)
class Evidence:
    """What was gathered. sections: by kind, in order; left_out: by a quick run."""

    work: Work
    sections: tuple[Section, ...]
    left_out: tuple[str, ...]
    broken: tuple[str, ...]

    @property
    def all_checks(self) -> tuple[Check, ...]:
        """Of all kinds."""
        return tuple(check for section in self.sections for check in section.checks)

    @property
    def missing(self) -> tuple[Lack, ...]:
        """What could not be run here, of all kinds."""
        return tuple(one for section in self.sections for one in section.missing)

    @property
    def failed(self) -> tuple[Check, ...]:
        """The checks that did not pass."""
        return tuple(check for check in self.all_checks if not check.is_ok)

    @property
    def is_whole(self) -> bool:
        """Whether everything was run."""
        return not self.missing and not self.left_out


def gather(work: Work, kinds: Sequence[Kind] = KINDS) -> Evidence:
    """Run every step of every kind on a package."""
    jobs = [(kind, step, those) for kind in kinds for step in kind.steps
            for those in _shared(step, work.packages)]  # fmt: skip
    number = count(1)

    def done(job: tuple[Kind, Step, tuple[Emitted, ...]]) -> Outcome:
        _, step, those = job
        doing = " ".join([work.name, step.name, *(one.scalar for one in those)])
        at = f"{doing} ({next(number)} of {len(jobs)})"
        work.progress(at)
        return outcome(replace(work, progress=lambda what: work.progress(f"{at}: {what}")),
                       step, those)  # fmt: skip

    single = [job for job in jobs if not job[1].is_crew]
    crews = [job for job in jobs if job[1].is_crew]
    with ThreadPoolExecutor(WORKERS) as pool:
        pairs = list(zip(single, pool.map(done, single), strict=True))
    pairs += [(job, done(job)) for job in crews]
    return _sorted(work, kinds, [(kind, found) for (kind, _, _), found in pairs])


def _shared(step: Step, packages: tuple[Emitted, ...]) -> list[tuple[Emitted, ...]]:
    """What each run of a step is given."""
    return [packages] if step.is_crew else [(one,) for one in packages]


def outcome(work: Work, step: Step, packages: Sequence[Emitted]) -> Outcome:
    """One step, with what came before its tool was missed or broke down."""
    found: list[Check | Lack] = []
    broken = ""
    try:
        found.extend(step.run(work, packages))
    except ToolMissing as missing:
        on = [one.scalar for one in packages]
        found.append(lack(step.name, missing, on, is_part=bool(found)))
    except Exception as error:  # whatever it is: the other steps and packages go on
        broken = f"{_named(step, packages)}: {_words(error)}"
        found.append(_failure(step, packages, error))
    return Outcome(
        tuple(one for one in found if isinstance(one, Check)),
        tuple(one for one in found if isinstance(one, Lack)),
        broken,
    )


def _failure(step: Step, packages: Sequence[Emitted], error: Exception) -> Check:
    """A step that did not run to its end, as a check that fails: the reason in one line."""
    reason = str(error).partition("\n")[0] or type(error).__name__
    if isinstance(error, ToolFailed):
        reason = f"{Path(error.command[0]).name} {error.why}"
    subject = " ".join(one.scalar for one in packages)
    return Check(f"{step.name}: broke down", subject, 1, LIMITS["runs"], 1, reason)


def _words(error: Exception) -> str:
    """What a tool or the system said; of a mistake of our own, where it was made."""
    if isinstance(error, ToolFailed | CompileError | OSError | ValueError):
        return str(error)
    return "".join(traceback.format_exception(error)).rstrip()


def _named(step: Step, packages: Sequence[Emitted]) -> str:
    return ", ".join([step.name, *(one.scalar for one in packages)])


def _sorted(work: Work, kinds: Sequence[Kind], found: Sequence[tuple[Kind, Outcome]]) -> Evidence:
    sections = []
    for kind in kinds:
        those = [one for of, one in found if of is kind]
        checks = tuple(check for one in those for check in one.checks)
        missing = merged(one for outcome in those for one in outcome.missing)
        sections.append(Section(kind, checks, missing))
    steps = [step for kind in kinds for step in kind.steps]
    left_out = [step.quick for step in steps if step.quick] if work.is_quick else []
    broken = [one.broken for _, one in found if one.broken]
    return Evidence(work, tuple(sections), tuple(left_out), tuple(broken))
