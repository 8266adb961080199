"""Every check of a vehicle, one after the other: what `derive verify` runs."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from derive.verify import symbolic
from derive.verify.accuracy import accuracy, forces, plants, ties
from derive.verify.check import Check
from derive.verify.derivative import derivatives
from derive.verify.limits import LIMITS
from derive.verify.subject import Subject, ladder, rows


def checks(subject: Subject, progress: Callable[[str], None] = lambda _: None) -> Iterator[Check]:
    """All checks, in the order they are shown; progress is told what comes next."""
    plan: tuple[tuple[str, Callable[[Subject], Iterator[Check]]], ...] = (
        ("kernel and chain rule in 50 digits", symbolics),
        ("law and rate against truth", accuracy),
        ("side at the cut locus", ties),
        ("force against truth", forces),
        ("plant against truth", plants),
        ("differences along the flow", derivatives),
        ("backends against each other", agreement),
    )
    for what, run in plan:
        progress(what)
        yield from run(subject)


def symbolics(subject: Subject) -> Iterator[Check]:
    """Identities of the kernel, and sympy's chain rule against the emitted closed form."""
    vehicle, seed = subject.vehicle, subject.seed
    exact = LIMITS["symbolic"]
    kernel = symbolic.kernel_residual(points := 40, seed)
    yield Check("kernel k, h, m: identities", "derivation", kernel, exact, points)
    rule = symbolic.chain_rule_residual(vehicle.group, vehicle.law, points := 6, seed)
    yield Check("nu_u_dot: chain rule", "derivation", rule, exact, points)


def agreement(subject: Subject) -> Iterator[Check]:
    """Rows in which C double and numpy differ in any bit, and rows that are not finite."""
    states = ladder(subject, "f64", subject.each, is_moving=True)
    found = {b.name: b.run(subject.law, states) for b in subject.backends if b.scalar == "f64"}
    if len(found) == 2:
        first, second = found.values()
        differ = np.any([(first[n] != second[n]).any(-1) for n in first if n in second], axis=0)
        yield rows("bits: C f64 is numpy f64", "both", differ, states)
    for backend in subject.backends:
        narrow = ladder(subject, backend.scalar, subject.each, is_moving=True)
        command = backend.run(subject.law, narrow)
        bad = np.any([~np.isfinite(value).all(-1) for value in command.values()], axis=0)
        yield rows("not finite", backend.name, bad, narrow)
