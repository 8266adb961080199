"""The controllers against the paper's formulas in 130 digits, and the closed loop they promise."""

from collections.abc import Callable
from functools import cache
from random import Random
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import solve_ivp
from sympy import Pow

from derive.control.controller import WRITERS, routines
from derive.control.sliding import reaching, tracking
from derive.control.table import CONTROLLERS
from derive.routine.derivation import Derivation
from derive.verify.oracle.precise import mp
from tests import points
from tests.control.drawn import LAWS, Pattern, each_law, full, numbers, sparse
from tests.evaluation import exactly, in_double
from tests.groups import ALL
from tests.oracle import distance, norm, truth
from tests.points import STORED, conjugate, embedded, hamilton, point

LIMIT = mp.mpf("1e-60")
OUTPUTS = {"force", "s", "nu_u", "nu_u_dot"}
KINDS = {"tracking": tracking, "reaching": reaching}
OPTIONS = (("momentum",), ("external",), ("external", "momentum"))
FAVOURITES = [next(pair for pair in LAWS if pair[0] == group) for group in ALL]
"""One law of each group: the logarithm where there is one."""
Vector = np.ndarray[Any, np.dtype[np.float64]]

each_kind = pytest.mark.parametrize("kind", KINDS)
each_favourite = pytest.mark.parametrize(
    ("group", "name"), FAVOURITES, ids=map("-".join, FAVOURITES)
)


@cache
def derived(
    group: str, name: str, kind: str, pattern: Pattern = (), options: tuple[str, ...] = ()
) -> Derivation:
    pattern = pattern or full(ALL[group])
    return KINDS[kind](ALL[group], LAWS[group, name], pattern, options)


def paper(group: str, name: str, kind: str, given: dict[str, Any]) -> dict[str, Any]:
    known = truth(ALL[group])
    return known.reaching(name, given) if kind == "reaching" else known.tracking(name, given)


def without_extras(given: dict[str, Any], *asked: str) -> dict[str, Any]:
    """As the truth is told: an extra that no option asks for is none."""
    return {k: x for k, x in given.items() if k not in ("momentum", "external") or k in asked}


def assert_same(found: dict[str, Any], wanted: dict[str, Any]) -> None:
    for name in OUTPUTS:
        assert distance(found[name], wanted[name]) < LIMIT * (1 + norm(wanted[name])), name


@each_law
@each_kind
def test_everything_commanded_is_the_papers(group: str, name: str, kind: str) -> None:
    """Formed with the inverse inertia there, and with differences for every rate."""
    given = without_extras(numbers(ALL[group], 1))
    assert_same(exactly(derived(group, name, kind), **given), paper(group, name, kind, given))


@each_favourite
@each_kind
@pytest.mark.parametrize("options", OPTIONS, ids=map("-".join, OPTIONS))
def test_wheels_turn_along_and_known_forces_are_taken_off(
    group: str, name: str, kind: str, options: tuple[str, ...]
) -> None:
    given = without_extras(numbers(ALL[group], 2), *options)
    d = derived(group, name, kind, (), options)
    assert_same(exactly(d, **given), paper(group, name, kind, given))
    assert {q.name for q in d.inputs} >= set(options)
    assert {q.place for q in d.inputs if q.name in options} == {f"state.{one}" for one in options}


@each_favourite
@each_kind
def test_a_zero_of_the_pattern_is_a_zero_of_the_inertia(group: str, name: str, kind: str) -> None:
    pattern = sparse(ALL[group])
    given = without_extras(numbers(ALL[group], 9, pattern))
    d = derived(group, name, kind, pattern)
    assert_same(exactly(d, **given), paper(group, name, kind, given))
    assert d.used(next(q for q in d.inputs if q.name == "inertia")) == pattern


@each_favourite
def test_reaching_is_tracking_of_rest_at_the_identity(group: str, name: str) -> None:
    given = numbers(ALL[group], 5)
    still = (0,) * ALL[group].dim
    rest = {"g_r": ALL[group].identity, "nu_r": still, "nu_r_dot": still}
    alone = exactly(derived(group, name, "reaching"), **given)
    assert_same(exactly(derived(group, name, "tracking"), **{**given, **rest}), alone)


@each_favourite
def test_tracking_does_not_see_where_the_world_is(group: str, name: str) -> None:
    """Left invariance: one element before both configurations changes nothing."""
    known, given = ALL[group], numbers(ALL[group], 3)
    shift = embedded(known, point(known, Random(8)))
    moved = {key: points.stored(known, shift @ embedded(known, given[key])) for key in ("g", "g_r")}
    d = derived(group, name, "tracking")
    assert_same(exactly(d, **{**given, **moved}), exactly(d, **given))
    assert moved["g"] != given["g"]


@each_law
@each_kind
def test_nothing_is_divided_by_the_inertia(group: str, name: str, kind: str) -> None:
    d = derived(group, name, kind)
    symbols = set(next(q for q in d.inputs if q.name == "inertia").symbols())
    powers = [power for _, value in d.terms() for power in value.atoms(Pow)]
    assert not any(power.exp.is_negative and power.free_symbols & symbols for power in powers)
    assert any(value.free_symbols & symbols for _, value in d.terms())


@each_favourite
@pytest.mark.parametrize("controller", ["gsmc", "reaching"])
def test_each_controller_has_its_routines(group: str, name: str, controller: str) -> None:
    parts = routines(ALL[group], LAWS[group, name], controller, full(ALL[group]))
    assert {q.name for q, _ in parts.main.outputs} == OUTPUTS | {"clearance"}
    for d in parts.public:
        assert {q.name for q, _ in d.outputs} in (OUTPUTS, {"nu_dot"})
    names = [d.name for d in (parts.main, *parts.public, *parts.inner)]
    assert len(set(names)) == len(names)
    assert {"plant", "definiteness", "reaching"} <= set(names)
    assert (parts.guard.drift is None) == (group in ("R1", "R3", "R6", "GL2"))
    assert (parts.guard.error is None) == (controller == "reaching")
    assert {q.name for q, _ in parts.guard.law.outputs} == OUTPUTS | {"clearance"}
    assert parts.main.name == {"gsmc": "tracking", "reaching": "reaching"}[controller]


def test_the_table_of_controllers_is_the_one_that_can_be_written() -> None:
    assert set(WRITERS) == set(CONTROLLERS)
    for name, one in CONTROLLERS.items():
        law = LAWS["SO3", one.law or "log"]
        written = [write(ALL["SO3"], law, (True,) * 6) for write in WRITERS[name]]
        assert tuple(d.name for d in written) == one.routines
        for d in written:
            gains = [q for q in d.inputs if q.holder == "params" and q.is_scalar]
            assert tuple(q.member for q in gains) == one.names
            assert [(q.unit, q.name) for q in gains] == [(g.unit, g.symbol) for g in one.gains]


# The closed loop: quaternions of body and reference are integrated without renormalising.

J = np.array([[3.6046, -0.0706, 0.1491], [-0.0706, 8.6868, 0.0449], [0.1491, 0.0449, 9.3484]])
RATE_GAIN, REACH_GAIN, SPAN = 0.5, 1.0, 4.0


def wanted_velocity(t: float) -> tuple[Vector, Vector]:
    """A reference that never rests: its body velocity in rad/s and the rate of that."""
    frequency = np.array([0.7, 1.1, 0.4])
    return 0.6 * np.sin(frequency * t + 0.3), 0.6 * frequency * np.cos(frequency * t + 0.3)


def loop(group: str, name: str) -> Callable[[float, Vector], tuple[Vector, float]]:
    """(t, (q, q_r, nu)) -> its rate, and W = I(s, s)/2."""
    run = in_double(derived(group, name, "tracking"))
    fixed = {"inertia": J[np.triu_indices(3)], "rate_gain": RATE_GAIN, "reach_gain": REACH_GAIN}

    def at(t: float, y: Vector) -> tuple[Vector, float]:
        q, q_r, nu = y[:4], y[4:8], y[8:]
        nu_r, nu_r_dot = wanted_velocity(t)
        g, g_r = (STORED[group](list(p / np.linalg.norm(p))) for p in (q, q_r))
        out = run(g=g, nu=nu, g_r=g_r, nu_r=nu_r, nu_r_dot=nu_r_dot, **fixed)
        nu_dot = np.linalg.solve(J, np.cross(J @ nu, nu) + out["force"])
        turns = [hamilton(p, (0, *speed)) / 2 for p, speed in ((q, nu), (q_r, nu_r))]
        return np.concatenate([*turns, nu_dot]), float(out["s"] @ J @ out["s"]) / 2

    return at


@pytest.mark.parametrize(("group", "name"), [("SO3", "log"), ("S3", "half_log")])
def test_W_decays_at_twice_the_reaching_gain(group: str, name: str) -> None:
    at = loop(group, name)
    start = np.array([0.5, 0.5, 0.5, 0.5, 0.8, 0.0, 0.6, 0.0, 0.4, -0.3, 0.5])
    times = np.linspace(0, SPAN, 9)
    path = solve_ivp(
        lambda t, y: at(t, y)[0], (0, SPAN), start, "DOP853", times, rtol=1e-12, atol=1e-13
    )
    W = np.array([at(t, y)[1] for t, y in zip(times, path.y.T, strict=True)])
    assert_allclose(W / W[0], np.exp(-2 * REACH_GAIN * times), rtol=1e-8)
    errors = [hamilton(conjugate(y[4:8]), y[:4])[0] for y in path.y.T]
    assert errors[0] < 0.75
    assert min(errors) > 0.1  # no cut is crossed
    assert_allclose(np.linalg.norm(path.y[:4], axis=0), 1, rtol=1e-10)
