"""Which mutants a vehicle's derivations are tried with, and on which states."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.control.controller import routines
from derive.control.kinematic import LAWS
from derive.lie.catalogue import GROUPS
from derive.routine.derivation import Derivation
from derive.verify import rates, reference, sample
from derive.verify.check import Check
from derive.verify.limits import EPS, LIMITS
from derive.verify.reference import Plant, Truth
from derive.verify.sample import States
from derive.verify.trial import Case, Domain, Outcome, trial

Array = NDArray[Any]
Trial = tuple[list[Case], list[Domain]]

EACH = 12
"""States per rung of the ladder on which mutants must be caught."""

DENSE = {False: 4000, True: 400}
"""States at random angles, at rest and on the move, on which mutants must be caught too."""

WIDE = 1500
"""States at random angles on which the movement of what was not caught is measured."""


def mutation(
    vehicle: Plant, controller: str, seed: int = 0, progress: Callable[[str], None] = lambda _: None
) -> Iterator[Check]:
    """One check per routine: mutants that move an output and that no check caught."""
    for d, outcome in outcomes(vehicle, controller, seed, progress):
        caught = outcome.tried - len(outcome.missed) - len(outcome.equivalent)
        worst = ", ".join(what for what, _ in outcome.missed[:3])
        told = worst or (
            f"{caught} caught, {len(outcome.equivalent)} move nothing by {outcome.bound:.2g} eps"
        )
        missed = float(len(outcome.missed))
        listed = tuple(f"{what}: {moved:.2g} eps" for what, moved in outcome.equivalent)
        name, rows = f"mutants missed: {d.name}", LIMITS["rows"]
        yield Check(name, "derivation", missed, rows, outcome.tried, told, listed)


def outcomes(
    vehicle: Plant, controller: str, seed: int = 0, progress: Callable[[str], None] = lambda _: None
) -> Iterator[tuple[Derivation, Outcome]]:
    """Each derivation of the vehicle with what became of its mutants."""
    law = LAWS[vehicle.group, vehicle.law]
    pattern = tuple(value != 0 for value in _upper(vehicle))
    parts = routines(GROUPS[vehicle.group], law, controller, pattern)
    for d in (parts.main, *parts.public, *parts.inner):
        progress(f"mutants of {d.name}")
        yield d, trial(d, *_CASES[d.name](vehicle, seed))


def _laws(routine: str) -> Callable[[Plant, int], Trial]:
    """Cases of a control law: law and rate at rest, force and s on the move, as the suite does."""

    def cases(vehicle: Plant, seed: int) -> Trial:
        run = reference.tracking if routine == "tracking" else reference.reaching
        moving = _judging(vehicle, seed, is_moving=True)
        table = run(vehicle, moving, "f64")
        force = LIMITS["force_f64"].figure / table.conditioning
        on_move = Case(_inputs(vehicle, moving), table, {"force": force, "s": force})
        rng = np.random.default_rng([seed, 2])
        return [*_at_rest(vehicle, seed), on_move], _wide(vehicle, rng)

    return cases


@cache
def _at_rest(vehicle: Plant, seed: int) -> tuple[Case, ...]:
    """Law and rate at rest, and on SO3 the choice at exact ties, where one branch is right."""
    still = _judging(vehicle, seed, is_moving=False)
    table = reference.reaching(vehicle, still, "f64")
    cases = [Case(_inputs(vehicle, still), table, _law_limits(still))]
    if vehicle.group == "SO3":
        ties = sample.ties("f64", np.random.default_rng([seed, 3]))
        strict = reference.reaching(vehicle, ties, "f64").first()
        cases.append(Case(_inputs(vehicle, ties), strict, _law_limits(ties)))
    return tuple(cases)


def _judging(vehicle: Plant, seed: int, *, is_moving: bool) -> States:
    """The ladder and random angles, at rest or on the move."""
    rng = np.random.default_rng([seed, 1, is_moving])
    ladder = sample.angles(vehicle.group, vehicle.law)
    dense = rng.uniform(0, ladder[-1], DENSE[is_moving])
    angle = np.concatenate([sample.spread(ladder, EACH), dense])
    return sample.states(vehicle.group, angle, "f64", rng, is_moving=is_moving)


def _wide(vehicle: Plant, rng: np.random.Generator) -> list[Domain]:
    """Where movement counts: the law at rest, and force and s on the move, off the cut."""
    ladder = sample.angles(vehicle.group, vehicle.law)
    angle = np.concatenate([rng.uniform(0, ladder[-1], WIDE), sample.spread(ladder, 20)])
    keep = np.abs(np.cos(angle / 2)) > reference.EITHER * EPS["f64"]
    domains = []
    for is_moving in (False, True):
        states = sample.states(vehicle.group, angle, "f64", rng, is_moving=is_moving)
        terms = rates.term_scales(vehicle, states)
        scales: dict[str, Array | float] = {"force": terms["force"], "s": terms["nu_u_dot"]}
        if not is_moving:
            scales |= {"nu_u": np.sin(angle / 2), "nu_u_dot": terms["nu_u_dot"], "clearance": 1.0}
        near = np.sin(angle / 2) if vehicle.group == "S3" and is_moving else 1.0
        kept = keep if not is_moving else keep & ((angle <= np.pi) | (near > 1e-2))
        domains.append(Domain(_inputs(vehicle, states), scales, kept))
    return domains


def _law_limits(states: States) -> dict[str, Array | float]:
    beyond = states.angle > np.pi
    far = LIMITS["beyond_pi"].figure
    eps = EPS["f64"]
    log, rate = (np.where(beyond, far, LIMITS[name].figure) * eps for name in ("log", "rate"))
    return {"nu_u": log, "nu_u_dot": rate, "clearance": LIMITS["mutant"].figure * eps}


def _inputs(vehicle: Plant, states: States) -> dict[str, Array]:
    """Inputs of every routine by name, (k, N) columns."""
    count = len(states.angle)
    params = {
        "inertia": [float(value) for value in _upper(vehicle)],
        "rate_gain": [float(vehicle.rate_gain)],
        "reach_gain": [float(vehicle.reach_gain)],
    }
    spread = {name: np.repeat(np.array(x)[:, None], count, 1) for name, x in params.items()}
    names = ("g", "nu", "g_r", "nu_r", "nu_r_dot")
    return spread | {name: getattr(states, name).T for name in names} | {"force": states.nu_r.T}


def _plant(vehicle: Plant, seed: int) -> Trial:
    moving = _judging(vehicle, seed, is_moving=True)
    table = reference.plant(vehicle, moving, moving.nu_r)
    inputs = _inputs(vehicle, moving)
    case = Case(inputs, table, {"nu_dot": LIMITS["force_f64"].figure})
    return [case], [_everywhere(inputs, "nu_dot", 0.0)]


def _residual(vehicle: Plant, seed: int) -> Trial:
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


def _definiteness(vehicle: Plant, seed: int) -> Trial:
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


def _everywhere(inputs: Mapping[str, Array], output: str, scale: float) -> Domain:
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
