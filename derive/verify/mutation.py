"""Which mutants a vehicle's derivations are tried with, and on which states."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.control.controller import routines
from derive.control.kinematic import LAWS
from derive.lie.catalogue import GROUPS
from derive.verify import rates, sample
from derive.verify.batch import Batch, at_rest, at_ties, on_the_move, under_force
from derive.verify.check import Check
from derive.verify.limits import EPS, LIMITS
from derive.verify.reference import Plant, Truth
from derive.verify.sample import States
from derive.verify.trial import Case, Domain, Outcome, trial

Array = NDArray[Any]
Trial = tuple[list[Case], list[Domain]]

WIDE = 1500
"""States at random angles on which the movement of what was not caught is measured."""


def mutation(
    vehicle: Plant,
    controller: str,
    each: int = 120,
    seed: int = 0,
    progress: Callable[[str], None] = lambda _: None,
) -> Iterator[Check]:
    """One check per routine: mutants that move an output and that no check caught."""
    for routine, outcome in outcomes(vehicle, controller, each, seed, progress):
        caught = outcome.tried - len(outcome.missed) - len(outcome.equivalent)
        worst = ", ".join(what for what, _ in outcome.missed[:3])
        told = worst or (
            f"{caught} caught, {len(outcome.equivalent)} move nothing by {outcome.bound:.2g} eps"
        )
        missed = float(len(outcome.missed))
        listed = tuple(f"{what}: {moved:.2g} eps" for what, moved in outcome.equivalent)
        name, rows = f"mutants missed: {routine}", LIMITS["rows"]
        yield Check(name, "derivation", missed, rows, outcome.tried, told, listed)


def outcomes(
    vehicle: Plant,
    controller: str,
    each: int = 120,
    seed: int = 0,
    progress: Callable[[str], None] = lambda _: None,
) -> Iterator[tuple[str, Outcome]]:
    """Each routine of the vehicle, and its kernel in float, with what became of the mutants."""
    law = LAWS[vehicle.group, vehicle.law]
    pattern = tuple(value != 0 for value in _upper(vehicle))
    parts = routines(GROUPS[vehicle.group], law, controller, pattern)
    for d in (parts.main, *parts.public, *parts.inner):
        progress(f"mutants of {d.name}")
        yield d.name, trial(d, *_CASES[d.name](vehicle, each, seed))
    progress("mutants of the kernel in float")
    yield "kernel in float", trial(parts.main, *_float(vehicle, each, seed), scalar="f32")


def _laws(routine: str) -> Callable[[Plant, int, int], Trial]:
    """A control law on the very batches of the suite: at rest, at exact ties, on the move."""

    def cases(vehicle: Plant, each: int, seed: int) -> Trial:
        batches = [at_rest(vehicle, "f64", each, seed), at_ties(vehicle, "f64", seed)]
        if routine == "tracking":
            batches.append(on_the_move(vehicle, True, "f64", max(1, each // 4), seed))
        rng = np.random.default_rng([seed, 2])
        judged = [_case(vehicle, batch) for batch in batches if batch is not None]
        return judged, _wide(vehicle, rng)

    return cases


def _float(vehicle: Plant, each: int, seed: int) -> Trial:
    """The law at rest, in float."""
    batch = at_rest(vehicle, "f32", each, seed)
    domain = _at_rest_domain(vehicle, batch.states, np.ones(len(batch.states.angle), dtype=bool))
    return [_case(vehicle, batch)], [replace(domain, eps=EPS["f32"])]


def _case(vehicle: Plant, batch: Batch) -> Case:
    return Case(_inputs(vehicle, batch.states), batch.truth, batch.limits)


def _wide(vehicle: Plant, rng: np.random.Generator) -> list[Domain]:
    """Where movement counts: the law at rest, and force and s on the move, off the cut."""
    ladder = sample.angles(vehicle.group, vehicle.law)
    angle = np.concatenate([rng.uniform(0, ladder[-1], WIDE), sample.spread(ladder, 20)])
    still, moving = (
        sample.states(vehicle.group, angle, "f64", rng, is_moving=m) for m in (False, True)
    )
    keep = np.abs(np.cos(angle / 2)) > LIMITS["either side"].figure * EPS["f64"]
    terms = rates.term_scales(vehicle, moving)
    scales = {"force": terms["force"], "s": terms["nu_u_dot"]}
    # Towards -i the product of a moving reference is itself rounded at eps/s.
    near = (angle > np.pi) & (np.sin(angle / 2) < 1e-2)
    on_move = Domain(_inputs(vehicle, moving), scales, keep & ~near)
    return [_at_rest_domain(vehicle, still, keep), on_move]


def _at_rest_domain(vehicle: Plant, states: States, keep: Array) -> Domain:
    terms, half = rates.term_scales(vehicle, states), np.sin(states.angle / 2)
    scales = {"force": terms["force"], "s": terms["nu_u_dot"]}
    scales |= {"nu_u": half, "nu_u_dot": terms["nu_u_dot"], "clearance": np.ones_like(half)}
    return Domain(_inputs(vehicle, states), scales, keep)


def _inputs(vehicle: Plant, states: States) -> dict[str, Array]:
    """Inputs of every routine by name, (k, N) columns."""
    count = len(states.angle)
    params = {
        "inertia": [float(value) for value in _upper(vehicle)],
        "rate_gain": [float(vehicle.rate_gain)],
        "reach_gain": [float(vehicle.reach_gain)],
    }
    spread = {
        name: np.repeat(np.array(x, states.g.dtype)[:, None], count, 1)
        for name, x in params.items()
    }
    names = ("g", "nu", "g_r", "nu_r", "nu_r_dot")
    return spread | {name: getattr(states, name).T for name in names}


def _plant(vehicle: Plant, each: int, seed: int) -> Trial:
    batch, force = under_force(vehicle, "f64", max(1, each // 8), seed)
    inputs = _inputs(vehicle, batch.states) | {"force": force.T}
    case = Case(inputs, batch.truth, batch.limits)
    return [case], [_everywhere(inputs, "nu_dot", batch.truth.scales["nu_dot"])]


def _residual(vehicle: Plant, each: int, seed: int) -> Trial:
    """Random numbers near and off the group; R^T R - 1 and det R - 1, or |q|^2 - 1, exactly."""
    rng = np.random.default_rng([seed, 4])
    size = len(GROUPS[vehicle.group].identity)
    g = rng.normal(size=(200, size))
    rows = [_exact_residual([Fraction(x) for x in row]) for row in g]
    table = Truth(({"residual": (_floats(rows), np.zeros((200, len(rows[0]))))},), {})
    inputs = {"g": g.T}
    return [Case(inputs, table, {"residual": LIMITS["force_f64"].figure})], [
        _everywhere(inputs, "residual", 1.0)
    ]


def _exact_residual(g: list[Fraction]) -> list[Fraction]:
    if len(g) == 4:
        return [sum((x * x for x in g), Fraction(-1))]
    columns = [g[i::3] for i in range(3)]
    gram = [
        sum((a * b for a, b in zip(columns[i], columns[j], strict=True)), Fraction(-(i == j)))
        for i in range(3)
        for j in range(i, 3)
    ]
    a, b, c = columns
    cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]]
    return [*gram, sum((x * y for x, y in zip(a, cross, strict=True)), Fraction(-1))]


def _definiteness(vehicle: Plant, each: int, seed: int) -> Trial:
    """Pivots as ratios of leading minors, exactly, over random inertias of the same pattern."""
    rng = np.random.default_rng([seed, 5])
    upper = np.array([float(value) for value in _upper(vehicle)])
    inertia = upper * rng.uniform(0.8, 1.2, (100, 6))
    rows = [_exact_pivots([Fraction(x) for x in row]) for row in inertia]
    table = Truth(({"pivot": (_floats(rows), np.zeros((100, 3)))},), {})
    inputs = {"inertia": inertia.T}
    return [Case(inputs, table, {"pivot": LIMITS["force_f64"].figure})], [
        _everywhere(inputs, "pivot", 0.0)
    ]


def _everywhere(inputs: Mapping[str, Array], output: str, scale: Array | float) -> Domain:
    count = len(next(iter(inputs.values()))[0])
    return Domain(inputs, {output: scale}, np.ones(count, dtype=bool))


def _exact_pivots(upper: list[Fraction]) -> list[Fraction]:
    a, b, c, d, e, f = upper
    second = a * d - b * b
    third = a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d)
    return [a, second / a, third / second]


def _floats(rows: list[list[Fraction]]) -> Array:
    return np.array([[float(x) for x in row] for row in rows])


def _upper(vehicle: Plant) -> list[Fraction]:
    n = len(vehicle.inertia)
    return [vehicle.inertia[i][j] for i in range(n) for j in range(i, n)]


_CASES = {
    "tracking": _laws("tracking"),
    "reaching": _laws("reaching"),
    "plant": _plant,
    "residual": _residual,
    "definiteness": _definiteness,
}
