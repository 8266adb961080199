"""One run of proofs: every statement, on every subject it can be decided on."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import chain
from time import perf_counter
from typing import Any, NamedTuple

from derive.control.kinematic import laws_of
from derive.lie.catalogue import GROUPS
from derive.lie.group import Group
from derive.verify.proof import (
    differential,
    dynamics,
    emitted,
    extras,
    logarithm,
    loop,
    mistake_loop,
    mistake_space,
    motion,
    tangent,
)
from derive.verify.proof.algebra import Inertia, Setting
from derive.verify.proof.emitted import Lawful
from derive.verify.proof.loop import Steered
from derive.verify.proof.model import Elements, Words
from derive.verify.proof.motion import FreeMotion, GroupMotion
from derive.verify.proof.report import ProofReport, Row
from derive.verify.proof.statement import Statement

ROOMS = (
    tangent, dynamics, extras, motion, logarithm, differential, emitted, loop,
    mistake_loop, mistake_space,
)  # fmt: skip

STATEMENTS: tuple[Statement, ...] = tuple(chain.from_iterable(room.STATEMENTS for room in ROOMS))
"""Every statement, in the order it is shown."""

GENERIC = (3, 6)
"""Dimensions in which structure constants and inertia are symbols."""

LARGEST = 6
"""Dimension up to which a symbolic inertia has an adjugate of bearable size."""

ELEMENTS, ELEMENT = "exact elements, error < 2^-40", "an exact element, error < 2^-40"
"""Methods on one group: random elements, where an identity may hold by chance."""


class Subject(NamedTuple):
    """What a statement is decided on, its name, and the method where it is not the statement's."""

    name: str
    value: Any
    method: str = ""


Subjects = dict[str, list[Subject]]


def prove(
    group: Group | None,
    inertia: Inertia | None = None,
    progress: Callable[[str], None] = lambda _: None,
    statements: Sequence[Statement] | None = None,
    law: str = "",
    options: tuple[str, ...] = (),
) -> ProofReport:
    """Decide the statements for any group, and for one.

    inertia: (n, n) exact, of the vehicle; symbols where it is left out. statements: all of
    them, where left out. law, options: of the vehicle; the group's first law where left out.
    """
    subjects = generic()
    skipped: tuple[str, ...] = ()
    more = catalogue() if group is None else {}
    if group is not None:
        more, skipped = concrete(group, inertia, law, options)
        for kind, those in witnesses(group).items():
            subjects[kind] = those if kind in more else []
    for kind, those in more.items():
        subjects.setdefault(kind, []).extend(those)
    rows: list[Row] = []
    for statement in STATEMENTS if statements is None else statements:
        progress(statement.name)
        rows += _rows(statement, subjects.get(statement.kind, []))
    return ProofReport(group.name if group else "any group", tuple(rows), skipped)


def generic() -> Subjects:
    """What stands for every group at once, and the paper itself."""
    symbolic = [Subject(f"n = {n}", Setting(n)) for n in GENERIC]
    return {
        "tangent": [Subject(Words.name, Words())],
        "closure": [Subject(Words.name, Words())],
        "bundle": [Subject(Words.name, Words(is_law=False))],
        "algebra": symbolic,
        "inverse": [*symbolic],
        "motion": [Subject(FreeMotion.name, FreeMotion())],
        "reduction": [Subject("z^a (z^2+phi^2)^c", None)],
        "paper": [Subject("the paper", None)],
    }


def catalogue() -> Subjects:
    """The logarithm of every group that comes with the product."""
    found: Subjects = {}
    for group in GROUPS.values():
        for kind, those in _logarithms(group).items():
            found.setdefault(kind, []).extend(those)
    return found


def witnesses(group: Group) -> Subjects:
    """SE2, where no false version is true: on a group that commutes many a one is."""
    other = GROUPS["SE2"]
    if group.name == other.name:
        return {}
    return {**_logarithms(other), "law": _vehicle(other, None, "log", ())["law"]}


def concrete(
    group: Group, inertia: Inertia | None, law: str = "", options: tuple[str, ...] = ()
) -> tuple[Subjects, tuple[str, ...]]:
    """One group and what is known of its body, and what cannot be decided there."""
    name = group.name
    known = [Subject(name, Setting.of(group, inertia))]
    subjects: Subjects = {"algebra": known}
    if inertia is not None or group.dim <= LARGEST:
        subjects["inverse"] = known
    try:
        elements = [Subject(name, Elements(group), ELEMENTS)]
    except ValueError as reason:
        return subjects, (str(reason),)
    subjects |= {"tangent": elements, "motion": [Subject(name, GroupMotion(group), ELEMENT)]}
    subjects |= _logarithms(group) | _vehicle(group, inertia, law, options)
    if any(map(any, group.structure)):
        return {**subjects, "closure": elements}, ()
    silent = ["Remark 1", *(["momentum"] if subjects.pop("momentum", None) else [])]
    return subjects, (f"{name}: {' and '.join(silent)}, as its elements commute",)


def _logarithms(group: Group) -> Subjects:
    """What has a logarithm: the group, and the minimal polynomial of each factor."""
    laws = laws_of(group)
    if "log" not in laws:
        return {}
    factors = {one.name: one for one in group.factors or (group,)}
    return {
        "logarithm": [Subject(group.name, Lawful(group, laws["log"]))],
        "spectrum": [Subject(name, one) for name, one in factors.items()],
    }


def _vehicle(group: Group, inertia: Inertia | None, law: str, options: tuple[str, ...]) -> Subjects:
    """The law as it is derived, and the loop with what the vehicle carries and knows."""
    laws = laws_of(group)
    chosen = laws[law] if law else next(iter(laws.values()))
    name = f"{group.name}, {chosen.name}"
    steered = [Subject(name, Steered(group, chosen, inertia, options))]
    extra = dict.fromkeys(options, steered)
    return {"law": [Subject(name, Lawful(group, chosen))], "vehicle": steered, **extra}


def _rows(statement: Statement, subjects: list[Subject]) -> Iterator[Row]:
    for subject in subjects:
        start = perf_counter()
        facts, survivors = statement.judge(subject.value)
        yield Row(
            statement=statement.name,
            label=statement.label,
            of=subject.name,
            method=subject.method or statement.method,
            seconds=perf_counter() - start,
            broken=tuple(fact.what for fact in facts if not fact.holds),
            mutants=len(statement.mutants),
            survivors=survivors,
            shown=tuple(fact.shown for fact in facts if fact.shown),
        )
