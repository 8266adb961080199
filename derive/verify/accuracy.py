"""Emitted code against the truth: law, rate, s and force of every routine, and the plant."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.backend import Backend
from derive.verify.batch import (
    Batch,
    at_rest,
    at_ties,
    limit_of,
    on_the_move,
    rotation_limit,
    turned,
    under_force,
)
from derive.verify.branch import Turn
from derive.verify.check import Check
from derive.verify.limits import EPS
from derive.verify.oracle import matrix_function, matrix_group, truth
from derive.verify.subject import Subject, by_scalar, worst

Array = NDArray[Any]
LOGS = ("log", "half_log")


def accuracy(subject: Subject) -> Iterator[Check]:
    """Every output of every routine against truth, with the identity as reference."""
    for scalar, backends in by_scalar(subject):
        batch = at_rest(subject.vehicle, scalar, subject.each, subject.seed)
        exps: dict[bytes, tuple[Array, str]] = {}  # backends often agree in every bit
        for backend in backends:
            found = [backend.run(routine, batch.states) for routine in subject.routines]
            errors = _largest(batch, found)
            judged = (("nu_u", "log"), ("nu_u_dot", "rate"))
            for name, what in (pair for pair in judged if pair[0] in errors):
                limit = limit_of(subject.vehicle, what)
                yield from _split(f"{name}: truth", backend, errors[name], limit, batch)
            for name in ("force", "s"):
                yield _whole(subject, f"{name} at rest: truth", backend, errors[name], batch, name)
            if subject.vehicle.law in LOGS:
                nu_u = found[0]["nu_u"]
                if nu_u.tobytes() not in exps:
                    exps[nu_u.tobytes()] = _exp_error(subject, batch, nu_u)
                back, what = exps[nu_u.tobytes()]
                yield from _split("exp(log) = identity", backend, back, what, batch)


def rotations(subject: Subject) -> Iterator[Check]:
    """Law and rate of the rotations alone, on many more states where these carry something."""
    for scalar, backends in by_scalar(subject):
        batch = turned(subject.vehicle, scalar, subject.each, subject.seed)
        if batch is None:
            return
        for backend in backends:
            errors = _largest(batch, [backend.run(subject.law, batch.states)])
            for name, what in (("nu_u", "log"), ("nu_u_dot", "rate")):
                limit = rotation_limit(subject.vehicle, what)
                yield from _split(f"{name}: rotation", backend, errors[name], limit, batch)


def ties(subject: Subject) -> Iterator[Check]:
    """At exact rotations by pi every backend must take the side that the conventions name."""
    for scalar, backends in by_scalar(subject):
        batch = at_ties(subject.vehicle, scalar, subject.seed)
        if batch is None:
            return
        for backend in backends:
            found = [backend.run(routine, batch.states) for routine in subject.routines]
            error = _largest(batch, found)["nu_u"] / EPS[scalar]
            limit = limit_of(subject.vehicle, "log")
            yield worst("nu_u: side at the cut", backend.name, error, limit, batch.states)


def forces(subject: Subject) -> Iterator[Check]:
    """The whole force and s against truth, along a moving reference."""
    if not subject.vehicle.has_reference:
        return
    each = max(1, subject.each // 4)
    for scalar, backends in by_scalar(subject):
        batch = on_the_move(subject.vehicle, scalar, each, subject.seed)
        for backend in backends:
            errors = _largest(batch, [backend.run("tracking", batch.states)])
            for name in ("force", "s"):
                error = errors[name] * batch.truth.conditioning
                yield _whole(subject, f"{name}: truth", backend, error, batch, name)


def plants(subject: Subject) -> Iterator[Check]:
    """Euler-Poincare against truth."""
    each = max(1, subject.each // 8)
    for scalar, backends in by_scalar(subject):
        batch, force = under_force(subject.vehicle, scalar, each, subject.seed)
        for backend in backends:
            errors = batch.truth.errors(backend.run("plant", batch.states, force))
            error = errors["nu_dot"]
            yield _whole(subject, "nu_dot: truth", backend, error, batch, "nu_dot")


def _largest(batch: Batch, found: list[dict[str, Array]]) -> dict[str, Array]:
    """The larger error of several routines, per row and output."""
    each = [batch.truth.errors(outputs) for outputs in found]
    return {name: np.maximum.reduce([errors[name] for errors in each]) for name in each[0]}


def _whole(
    subject: Subject, name: str, backend: Backend, error: Array, batch: Batch, output: str
) -> Check:
    """A relative error where it is judged at all."""
    judged = np.where(np.isinf(batch.limits[output]), 0.0, error)
    what = "plant" if output == "nu_dot" else "force"
    limit = limit_of(subject.vehicle, f"{what}_{backend.scalar}")
    return worst(name, backend.name, judged, limit, batch.states)


def _split(name: str, backend: Backend, error: Array, what: str, batch: Batch) -> Iterator[Check]:
    """One check up to angle pi, and one beyond it where there is a beyond."""
    eps, beyond, states = error / EPS[backend.scalar], batch.beyond, batch.states
    yield worst(name, backend.name, np.where(beyond, 0.0, eps), what, states, ~beyond)
    if beyond.any():
        far = np.where(beyond, eps, 0.0)
        yield worst(f"{name}, beyond pi", backend.name, far, "beyond_pi", states, beyond)


def _exp_error(subject: Subject, batch: Batch, nu_u: Array) -> tuple[Array, str]:
    """|exp(nu_u) - g_e| per row, and the limit of it."""
    if subject.vehicle.is_attitude:
        return _turn_error(subject, batch, nu_u), "log"
    rows = zip(nu_u, batch.truth.error, strict=True)
    return np.array([_block_error(subject, value, error) for value, error in rows]), "exp"


def _turn_error(subject: Subject, batch: Batch, nu_u: Array) -> Array:
    """Over half the angle, of quaternions."""
    mp, one = truth.mp, (truth.mp.one, *[truth.mp.zero] * 3)
    whole = 1 if subject.vehicle.law == "log" else 2
    signs = (1, -1) if subject.vehicle.group == "SO3" else (1,)
    errors = np.empty(len(nu_u))
    for row, (value, (turn,)) in enumerate(zip(nu_u, batch.truth.error, strict=True)):
        back = truth.flow(one, tuple(whole * mp.mpf(float(x)) for x in value), mp.one)
        off = min(mp.norm([a - b * s for a, b in zip(turn.q, back, strict=True)]) for s in signs)
        length = whole * mp.norm([mp.mpf(float(x)) for x in value]) / 2
        errors[row] = float(off / length) if length else float(off)
    return errors


def _block_error(subject: Subject, nu_u: Array, error: tuple[Turn, ...]) -> float:
    """The largest of all factors: of B - 1 over its length, of each column of T over its own."""
    vehicle, worst_of = subject.vehicle, [0.0]
    halves = [2 if vehicle.law == "half_log" and at.name == "S3" else 1 for at in error]
    parts = matrix_group.factors(vehicle.space)
    pieces = matrix_group.split(nu_u.tolist(), [one.dim for one in parts])
    for one, half, x, at in zip(parts, halves, pieces, error, strict=True):
        back = matrix_function.exp(one.hat([half * entry for entry in x]))
        size = one.whole - one.columns
        blocks = [(0, size), *((j, j + 1) for j in range(size, one.whole))]
        for start, end in blocks:
            off, own = (
                _length([row[start:end] for row in matrix_function.combine((1, a), (-1, b))])
                for a, b in ((back, at.matrix), (at.matrix, _unit(one, start < size)))
            )
            worst_of.append(float(off / own) if own else float(off))
    return max(worst_of)


def _unit(one: Any, is_turn: bool) -> Any:
    """What the first block has a length from, and the others have not."""
    whole = matrix_function.identity(one.whole)
    return whole if is_turn else matrix_function.combine((0, whole))


def _length(rows: Any) -> Any:
    return truth.mp.norm([x for row in rows for x in row])
