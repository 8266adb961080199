"""Emitted code against the truth: the law, its rate, the force, the plant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify import reference, sample, truth
from derive.verify.backend import Backend
from derive.verify.check import Check
from derive.verify.limits import EPS
from derive.verify.reference import Truth
from derive.verify.sample import States
from derive.verify.subject import Subject, by_scalar, ladder, worst

Array = NDArray[Any]
LOGS = ("log", "half_log")


def accuracy(subject: Subject) -> Iterator[Check]:
    """nu_u, nu_u_dot and exp(nu_u) against truth, with the identity as reference."""
    for scalar, backends in by_scalar(subject):
        states = ladder(subject, scalar, subject.each, is_moving=False)
        table = reference.reaching(subject.vehicle, states, scalar)
        beyond = states.angle > np.pi
        for backend in backends:
            found = backend.run(subject.law, states)
            errors = table.errors(found)
            for name, what in (("nu_u", "log"), ("nu_u_dot", "rate")):
                yield from _split(f"{name}: truth", backend, errors[name], what, states, beyond)
            if subject.vehicle.law in LOGS:
                back = _exp_error(subject, table, found["nu_u"])
                yield from _split("exp(log) = identity", backend, back, "log", states, beyond)


def ties(subject: Subject) -> Iterator[Check]:
    """At exact rotations by pi every backend must take the side that the conventions name."""
    law = (subject.vehicle.group, subject.vehicle.law)
    if law[0] != "SO3" or law in sample.REACH:
        return  # on S3 there is no tie at pi, and a law with a pole there is refused
    for scalar, backends in by_scalar(subject):
        states = sample.ties(scalar, np.random.default_rng(subject.seed))
        table = reference.reaching(subject.vehicle, states, scalar).first()
        for backend in backends:
            error = table.errors(backend.run(subject.law, states))["nu_u"] / EPS[scalar]
            yield worst("nu_u: side at the cut", backend.name, error, "log", states)


def forces(subject: Subject) -> Iterator[Check]:
    """The whole force and s against truth, along a moving reference."""
    for scalar, backends in by_scalar(subject):
        each = max(1, subject.each // 4)
        states, still = (ladder(subject, scalar, each, is_moving=m) for m in (True, False))
        run = reference.tracking if subject.has_reference else reference.reaching
        table = run(subject.vehicle, states, scalar)
        keep = _far_from_jump(subject, table, scalar)
        for backend in backends:
            errors = table.errors(backend.run(subject.law, states))
            for name in ("force", "s"):
                error = np.where(keep, errors[name] * table.conditioning, 0.0)
                yield worst(f"{name}: truth", backend.name, error, f"force_{scalar}", states)
        if subject.has_reference:
            rest = reference.reaching(subject.vehicle, still, scalar)
            for backend in backends:
                error = rest.errors(backend.run("reaching", still))["force"]
                error = np.where(_far_from_jump(subject, rest, scalar), error, 0.0)
                yield worst("force at rest: truth", backend.name, error, f"force_{scalar}", still)


def plants(subject: Subject) -> Iterator[Check]:
    """Euler-Poincare against truth."""
    for scalar, backends in by_scalar(subject):
        states = ladder(subject, scalar, 8, is_moving=True)
        table = reference.plant(subject.vehicle, states, states.nu_r)
        for backend in backends:
            error = table.errors(backend.run("plant", states, states.nu_r))["nu_dot"]
            yield worst("nu_dot: truth", backend.name, error, f"force_{scalar}", states)


def _far_from_jump(subject: Subject, table: Truth, scalar: str) -> Array:
    """Rows on which there is one truth: all but those where a law on S3 changes its sign."""
    clearance = table.branches[0]["clearance"][0][:, 0]
    if (subject.vehicle.group, subject.vehicle.law) == ("S3", "sign_vec"):
        return clearance > reference.EITHER * EPS[scalar]
    return np.ones(len(clearance), dtype=bool)


def _exp_error(subject: Subject, table: Truth, nu_u: Array) -> Array:
    """|exp(nu_u) - g_e| over half the angle, per row."""
    mp, one = truth.mp, (truth.mp.one, *[truth.mp.zero] * 3)
    whole = 1 if subject.vehicle.law == "log" else 2
    signs = (1, -1) if subject.vehicle.group == "SO3" else (1,)
    errors = np.empty(len(nu_u))
    for row, (value, q) in enumerate(zip(nu_u, table.error, strict=True)):
        turn = tuple(whole * mp.mpf(float(x)) for x in value)
        back = truth.flow(one, turn, mp.one)
        off = min(mp.norm([a - b * s for a, b in zip(q, back, strict=True)]) for s in signs)
        length = mp.norm(turn) / 2
        errors[row] = float(off / length) if length else float(off)
    return errors


def _split(
    name: str, backend: Backend, error: Array, what: str, states: States, beyond: Array
) -> Iterator[Check]:
    """One check up to angle pi, and one beyond it where there is a beyond."""
    eps = error / EPS[backend.scalar]
    yield worst(name, backend.name, np.where(beyond, 0.0, eps), what, states, ~beyond)
    if beyond.any():
        far = np.where(beyond, eps, 0.0)
        yield worst(f"{name}, beyond pi", backend.name, far, "beyond_pi", states, beyond)
