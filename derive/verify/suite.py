"""Every check of a vehicle, one after the other: what `derive verify` runs."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from derive.control.table import CONTROLLERS
from derive.verify import closed, symbolic
from derive.verify.accuracy import accuracy, forces, plants, rotations, ties
from derive.verify.batch import ladder
from derive.verify.check import Check
from derive.verify.derivative import derivatives
from derive.verify.guard import guard
from derive.verify.limits import LIMITS
from derive.verify.sample import States
from derive.verify.subject import Subject, rows


def checks(subject: Subject, progress: Callable[[str], None] = lambda _: None) -> Iterator[Check]:
    """All checks, in the order they are shown; progress is told what comes next."""
    for what, run, of in PLAN:
        if subject.vehicle.controller in of:
            progress(what)
            yield from run(subject)


def symbolics(subject: Subject) -> Iterator[Check]:
    """Identities of the kernel, and sympy's chain rule against the emitted closed form."""
    exact, seed = LIMITS["symbolic"], subject.seed
    kernel = symbolic.kernel_residual(points := 40, seed)
    yield Check("kernel k, h, m: identities", "derivation", kernel, exact, points)
    rule = symbolic.chain_rule_residual(subject.vehicle, points := 6, seed)
    yield Check("nu_u_dot: chain rule", "derivation", rule, exact, points)


def loops(subject: Subject) -> Iterator[Check]:
    """What the controller makes of the plant, as an identity."""
    off = closed.lsf_residual(subject.vehicle, points := 6, subject.seed)
    name = "loop: I (nu' - nu_r' - nu x nu_r) = -k I s"
    yield Check(name, "derivation", off, LIMITS["symbolic"], points)


def agreement(subject: Subject) -> Iterator[Check]:
    """Rows in which C double and numpy differ in any bit, and rows that are not finite."""
    states = _moving(subject, "f64")
    double = [backend for backend in subject.backends if backend.scalar == "f64"]
    if len(double) == 2:
        for routine in (*subject.routines, "plant", "control"):
            force = states.nu_r if routine == "plant" else None
            first, second = (backend.run(routine, states, force) for backend in double)
            unlike = [np.atleast_2d((first[n] != second[n]).T).any(0) for n in first]
            name = f"{routine}: bits, C and numpy"
            yield rows(name, "f64", np.any(unlike, axis=0), states)
    for backend in subject.backends:
        narrow = _moving(subject, backend.scalar)
        command = backend.run(subject.law, narrow)
        bad = np.any([~np.isfinite(value).all(-1) for value in command.values()], axis=0)
        yield rows("not finite", backend.name, bad, narrow)


def _moving(subject: Subject, scalar: str) -> States:
    return ladder(subject.vehicle, scalar, subject.each, subject.seed, is_moving=True)


EVERY = tuple(CONTROLLERS)
RATED = tuple(name for name, one in CONTROLLERS.items() if not one.is_baseline)
"""Controllers whose law has an exact rate; those the paper compares with need none."""

PLAN: tuple[tuple[str, Callable[[Subject], Iterator[Check]], tuple[str, ...]], ...] = (
    ("kernel and chain rule in 50 digits", symbolics, RATED),
    ("the loop that closes, in 50 digits", loops, ("lsf",)),
    ("law and rate against truth", accuracy, EVERY),
    ("rotations against truth", rotations, EVERY),
    ("side at the cut locus", ties, EVERY),
    ("force against truth", forces, EVERY),
    ("plant against truth", plants, EVERY),
    ("differences along the flow", derivatives, RATED),
    ("backends against each other", agreement, EVERY),
    ("the guard", guard, EVERY),
)
"""What is checked, by what, and of which controllers."""
