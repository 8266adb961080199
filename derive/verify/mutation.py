"""Which mutants a vehicle's derivations are tried with, and on which states."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.control.table import CONTROLLERS
from derive.verify import rates, sample
from derive.verify.batch import Batch, at_rest, at_ties, on_the_move, turned, under_force
from derive.verify.check import Check
from derive.verify.derived import parts_of
from derive.verify.limits import EPS, LIMITS
from derive.verify.membership import pivots, residual
from derive.verify.natural import Natural, blocks_of
from derive.verify.plant import Plant
from derive.verify.reference import Truth
from derive.verify.sample import States
from derive.verify.shape import space
from derive.verify.trial import Case, Domain, Outcome, trial

Array = NDArray[Any]
Trial = tuple[list[Case], list[Domain]]

WIDE = 1500
"""States at random angles on which the movement of what was not caught is measured."""


MOST = 3000
"""Mutants of one routine that are tried: where there are more, so many of them, by the seed."""


def mutation(
    vehicle: Plant,
    each: int = 120,
    seed: int = 0,
    progress: Callable[[str], None] = lambda _: None,
) -> Iterator[Check]:
    """One check per routine: mutants that move an output and that no check caught."""
    for routine, outcome in outcomes(vehicle, each, seed, progress):
        if outcome is None:
            continue
        caught = outcome.tried - len(outcome.missed) - len(outcome.equivalent)
        worst = ", ".join(what for what, _ in outcome.missed[:3])
        some = f"{outcome.tried} of {outcome.there} tried, " * (outcome.tried < outcome.there)
        told = worst or (
            f"{some}{caught} caught, "
            f"{len(outcome.equivalent)} move nothing by {outcome.bound:.2g} eps"
        )
        missed = float(len(outcome.missed))
        listed = tuple(f"{what}: {moved:.2g} eps" for what, moved in outcome.equivalent)
        name, rows = f"mutants missed: {routine}", LIMITS["rows"]
        yield Check(name, "derivation", missed, rows, outcome.tried, told, listed)


def unjudged(vehicle: Plant) -> list[str]:
    """What mutants are not made of, with the reason."""
    if vehicle.own is None:
        return []
    return [f"mutants of drift: what vanishes on {vehicle.group} is known from its basis alone"]


def outcomes(
    vehicle: Plant,
    each: int = 120,
    seed: int = 0,
    progress: Callable[[str], None] = lambda _: None,
) -> Iterator[tuple[str, Outcome | None]]:
    """Each routine of the vehicle, and its kernel in float, with what became of the mutants.

    None for what nothing here can judge.
    """
    parts = parts_of(vehicle)
    least = LIMITS["mutant" if vehicle.own is None else "mutant_own"].figure
    run = partial(trial, most=MOST, seed=seed, least=least)
    drift = parts.guard.drift
    for d in (parts.main, *parts.public, *([drift] if drift else ()), *parts.inner):
        progress(f"mutants of {d.name}")
        cases = _CASES[d.name](vehicle, each, seed)
        yield d.name, run(d, *cases) if cases else None
    progress("mutants of the kernel in float")
    yield "kernel in float", run(parts.main, *_float(vehicle, each, seed), scalar="f32")


def _laws(routine: str) -> Callable[[Plant, int, int], Trial]:
    """A control law on the very batches of the suite: at rest, at exact ties, on the move."""

    def cases(vehicle: Plant, each: int, seed: int) -> Trial:
        batches = [at_rest(vehicle, "f64", each, seed), at_ties(vehicle, "f64", seed)]
        batches.append(turned(vehicle, "f64", each, seed))
        if routine == "tracking":
            batches.append(on_the_move(vehicle, "f64", max(1, each // 4), seed))
        rng = np.random.default_rng([seed, 2])
        judged = [_case(vehicle, batch) for batch in batches if batch is not None]
        return judged, _wide(vehicle, rng)

    return cases


def _float(vehicle: Plant, each: int, seed: int) -> Trial:
    """The law at rest, in float."""
    both = turned(vehicle, "f32", each, seed), at_rest(vehicle, "f32", each, seed)
    batches = [batch for batch in both if batch is not None]
    states = batches[0].states
    domain = _at_rest_domain(vehicle, states, np.ones(len(states.angle), dtype=bool))
    return [_case(vehicle, batch) for batch in batches], [replace(domain, eps=EPS["f32"])]


def _case(vehicle: Plant, batch: Batch) -> Case:
    return Case(_inputs(vehicle, batch.states), batch.truth, batch.limits)


def _wide(vehicle: Plant, rng: np.random.Generator) -> list[Domain]:
    """Where movement counts: the law at rest, and force and s on the move, off the cut."""
    ladder = sample.angles(vehicle)
    angle = np.concatenate([rng.uniform(0, ladder[-1], WIDE), sample.spread(ladder, 20)])
    still, moving = (sample.states(vehicle, angle, "f64", rng, is_moving=m) for m in (False, True))
    keep = np.abs(np.cos(angle / 2)) > LIMITS["either side"].figure * EPS["f64"]
    # Towards -i the product of a moving reference is itself rounded at eps/s.
    near = (angle > np.pi) & (np.sin(angle / 2) < 1e-2)
    scales = {name: _movement(vehicle, moving)[name] for name in ("force", "s")}
    on_move = Domain(_inputs(vehicle, moving), scales, keep & ~near, blocks=blocks_of(vehicle))
    return [_at_rest_domain(vehicle, still, keep), on_move]


def _at_rest_domain(vehicle: Plant, states: States, keep: Array) -> Domain:
    """Where the law itself counts."""
    scales = _movement(vehicle, states)
    return Domain(_inputs(vehicle, states), scales, keep, blocks=blocks_of(vehicle))


def _movement(vehicle: Plant, states: States) -> dict[str, Array]:
    """What a movement is counted against: how far inputs round, and what truth is judged on.

    The law counts on half of what it is judged on; force and s on their terms over 20.
    """
    half = np.sin(states.angle / 2)
    sine = np.repeat(half[:, None], len(space(vehicle.space).shapes), 1)
    natural = Natural(vehicle, states, sine, {})
    terms, judged = rates.term_scales(vehicle, states), natural.scales()
    s = np.maximum(terms["nu_u_dot"], judged["s"] / LIMITS["cancellation"].figure)
    return {
        "force": np.maximum(terms["force"], judged["force"]),
        "s": s,
        "nu_u": natural.value / 2,
        "nu_u_dot": terms["nu_u_dot"],
        "clearance": np.ones_like(half),
    }


def _inputs(vehicle: Plant, states: States) -> dict[str, Array]:
    """Inputs of every routine by name, (k, N) columns."""
    count = len(states.angle)
    params = {
        "inertia": [float(value) for value in _upper(vehicle)],
    }
    gains = zip(CONTROLLERS[vehicle.controller].gains, vehicle.gains, strict=True)
    params |= {gain.symbol: [float(value)] for gain, value in gains}
    spread = {
        name: np.repeat(np.array(x, states.g.dtype)[:, None], count, 1)
        for name, x in params.items()
    }
    names = ("g", "nu", "g_r", "nu_r", "nu_r_dot", "momentum", "external")
    return spread | {name: getattr(states, name).T for name in names}


def _plant(vehicle: Plant, each: int, seed: int) -> Trial:
    batch, force = under_force(vehicle, "f64", max(1, each // 8), seed)
    inputs = _inputs(vehicle, batch.states) | {"force": force.T}
    case = Case(inputs, batch.truth, batch.limits)
    domain = _everywhere(inputs, "nu_dot", batch.truth.scales["nu_dot"])
    return [case], [replace(domain, blocks=blocks_of(vehicle))]


def _drift(vehicle: Plant, each: int, seed: int) -> Trial | None:
    """Random numbers off the group, exactly; None on a user's group.

    Of a law with a reference what turns in the error, and the rows below of both configurations.
    """
    rng = np.random.default_rng([seed, 4])
    size = sum(one.stored for one in space(vehicle.space).shapes)
    drawn = dict(zip(("g_e", "g", "g_r"), rng.normal(size=(3, 200, size)), strict=True))
    named = {name: [residual(vehicle.factors, [*map(Fraction, row)]) for row in rows]
             for name, rows in drawn.items()}  # fmt: skip
    if vehicle.own is not None or not named["g"][0] or not any(named["g"][0]):
        return None
    parts = [("g_e", 0), ("g", 1), ("g_r", 1)] if vehicle.has_reference else [("g", 0), ("g", 1)]
    rows = [
        [sum((x * x for name, part in parts for x in (named[name][i] or ())[part]), Fraction(0))]
        for i in range(len(drawn["g"]))
    ]
    return _exactly("drift", rows, {name: x.T for name, x in drawn.items()}, 0.0)


def _definiteness(vehicle: Plant, each: int, seed: int) -> Trial:
    """Pivots by elimination, exactly, over random inertias of the same pattern."""
    rng, n = np.random.default_rng([seed, 5]), len(vehicle.inertia)
    upper = np.array([float(value) for value in _upper(vehicle)])
    inertia = upper * rng.uniform(0.8, 1.2, (100, len(upper)))
    rows = [pivots([Fraction(x) for x in row], n) for row in inertia]
    return _exactly("pivot", rows, {"inertia": inertia.T}, 0.0)


def _exactly(
    output: str, rows: list[list[Fraction]], inputs: Mapping[str, Array], scale: float
) -> Trial:
    """A routine that is judged as a whole against exact numbers."""
    high = np.array([[float(x) for x in row] for row in rows])
    table = Truth(({output: (high, np.zeros_like(high))},), {})
    limits = {output: LIMITS["mutant"].figure * EPS["f64"]}
    return [Case(inputs, table, limits)], [_everywhere(inputs, output, scale)]


def _everywhere(inputs: Mapping[str, Array], output: str, scale: Array | float) -> Domain:
    count = len(next(iter(inputs.values()))[0])
    return Domain(inputs, {output: scale}, np.ones(count, dtype=bool))


def _upper(vehicle: Plant) -> list[Fraction]:
    n = len(vehicle.inertia)
    return [vehicle.inertia[i][j] for i in range(n) for j in range(i, n)]


_CASES: dict[str, Callable[[Plant, int, int], Trial | None]] = {
    "tracking": _laws("tracking"),
    "reaching": _laws("reaching"),
    "plant": _plant,
    "drift": _drift,
    "definiteness": _definiteness,
}
