"""One run of proofs: every statement, on every subject it can be decided on."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import chain
from time import perf_counter
from typing import Any, NamedTuple

from derive.lie.catalogue import GROUPS
from derive.lie.group import Group
from derive.verify.proof import dynamics, logarithm, mistake_loop, mistake_space, motion, tangent
from derive.verify.proof.algebra import Setting
from derive.verify.proof.model import Elements, Words
from derive.verify.proof.motion import FreeMotion, GroupMotion
from derive.verify.proof.report import ProofReport, Row
from derive.verify.proof.statement import Statement

STATEMENTS: tuple[Statement, ...] = tuple(
    chain.from_iterable(
        room.STATEMENTS
        for room in (tangent, dynamics, motion, logarithm, mistake_loop, mistake_space)
    )
)
"""Every statement, in the order it is shown."""

GENERIC = (3, 6)
"""Dimensions in which structure constants and inertia are symbols."""

LARGEST = 6
"""Dimension up to which a symbolic inertia has an adjugate of bearable size."""

ELEMENTS, ELEMENT = "exact elements, odd nu_u", "an exact element"
"""Methods on one group: rational elements, where an identity may hold by chance."""

Inertia = Sequence[Sequence[Fraction]]


class Subject(NamedTuple):
    """What a statement is decided on, its name, and the method where it is not the statement's."""

    name: str
    value: Any
    method: str = ""


Subjects = dict[str, list[Subject]]


def prove(
    group_name: str | Group | None,
    inertia: Inertia | None = None,
    progress: Callable[[str], None] = lambda _: None,
    statements: Sequence[Statement] | None = None,
) -> ProofReport:
    """Decide the statements for any group, and for one: by name, or as a record of one's own.

    inertia: (n, n) exact, of the vehicle; symbols where it is left out. statements: all of
    them, where left out.
    """
    group = GROUPS[group_name] if isinstance(group_name, str) else group_name
    subjects = generic()
    skipped: tuple[str, ...] = ()
    if group is None:
        subjects["rotation"] = [
            Subject(name, GROUPS[name]) for name in sorted(logarithm.EXPONENTIAL)
        ]
    else:
        own, skipped = concrete(group, inertia)
        for kind, more in own.items():
            subjects.setdefault(kind, []).extend(more)
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
        "paper": [Subject("the paper", None)],
    }


def concrete(group: Group, inertia: Inertia | None) -> tuple[Subjects, tuple[str, ...]]:
    """One group and what is known of its body, and what cannot be decided there."""
    name = group.name
    known = [Subject(name, Setting.of(group, inertia))]
    subjects: Subjects = {"algebra": known}
    if inertia is not None or group.dim <= LARGEST:
        subjects["inverse"] = known
    if name in logarithm.EXPONENTIAL:
        subjects["rotation"] = [Subject(name, group)]
    try:
        elements = [Subject(name, Elements(group), ELEMENTS)]
    except ValueError as reason:
        return subjects, (str(reason),)
    subjects |= {"tangent": elements, "motion": [Subject(name, GroupMotion(group), ELEMENT)]}
    if not any(map(any, group.structure)):
        return subjects, (f"{name}: Remark 1, as its elements commute and nu_u may be additive",)
    return {**subjects, "closure": elements}, ()


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
