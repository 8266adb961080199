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
from derive.control.kinematic import LAWS
from derive.control.sliding import reaching, tracking
from derive.control.table import CONTROLLERS
from derive.lie.catalogue import GROUPS
from derive.routine.derivation import Derivation
from derive.verify import truth
from tests.evaluation import exactly, in_double
from tests.points import STORED, conjugate, hamilton, unit, vector

mp = truth.mp
LIMIT = mp.mpf("1e-35")
FULL = (True,) * 6
SPARSE = (True, False, True, True, False, True)
OUTPUTS = {"force", "s", "nu_u", "nu_u_dot"}
Vector = np.ndarray[Any, np.dtype[np.float64]]

each_law = pytest.mark.parametrize(("group", "name"), LAWS, ids=map("-".join, LAWS))
each_seed = pytest.mark.parametrize("seed", range(4))


@cache
def derived(group: str, name: str, kind: str, pattern: tuple[bool, ...] = FULL) -> Derivation:
    write = {"tracking": tracking, "reaching": reaching}[kind]
    return write(GROUPS[group], LAWS[group, name], pattern)


def numbers(group: str, seed: int, pattern: tuple[bool, ...] = FULL) -> dict[str, Any]:
    """Exact inputs of `tracking` by name: gains, inertia, a state and a reference."""
    rng = Random(seed)
    upper = [x / 4 if there else 0 for x, there in zip(vector(rng, 6), pattern, strict=True)]
    for place, least in ((0, 3), (3, 4), (5, 5)):
        upper[place] += least
    given: dict[str, Any] = {name: vector(rng) for name in ("nu", "nu_r", "nu_r_dot")}
    given |= {name: STORED[group](unit(vector(rng))) for name in ("g", "g_r")}
    gains = [abs(x) + 1 for x in vector(rng, 2)]
    return {"inertia": upper, "rate_gain": gains[0], "reach_gain": gains[1], **given}


def square(upper: Any) -> list[list[Any]]:
    a, b, c, d, e, f = upper
    return [[a, b, c], [b, d, e], [c, e, f]]


def paper(group: str, name: str, kind: str, given: dict[str, Any]) -> dict[str, Any]:
    head = (group, name, square(given["inertia"]), given["rate_gain"], given["reach_gain"])
    if kind == "reaching":
        return truth.reaching(*head, given["g"], given["nu"])
    names = ("g_r", "g", "nu", "nu_r", "nu_r_dot")
    return truth.tracking(*head, *(given[one] for one in names))


def assert_same(found: dict[str, Any], wanted: dict[str, Any]) -> None:
    for name in OUTPUTS:
        error = max(abs(a - b) for a, b in zip(found[name], wanted[name], strict=True))
        assert error < LIMIT * (1 + max(map(abs, wanted[name]))), name


@each_law
@pytest.mark.parametrize("kind", ["tracking", "reaching"])
@each_seed
def test_everything_commanded_is_the_papers(group: str, name: str, kind: str, seed: int) -> None:
    given = numbers(group, seed)
    assert_same(exactly(derived(group, name, kind), **given), paper(group, name, kind, given))


@each_law
@pytest.mark.parametrize("kind", ["tracking", "reaching"])
def test_a_zero_of_the_pattern_is_a_zero_of_the_inertia(group: str, name: str, kind: str) -> None:
    given = numbers(group, 9, SPARSE)
    d = derived(group, name, kind, SPARSE)
    assert_same(exactly(d, **given), paper(group, name, kind, given))
    assert d.used(next(q for q in d.inputs if q.name == "inertia")) == SPARSE


@each_law
def test_reaching_is_tracking_of_rest_at_the_identity(group: str, name: str) -> None:
    given = numbers(group, 5)
    rest = {"g_r": GROUPS[group].identity, "nu_r": (0, 0, 0), "nu_r_dot": (0, 0, 0)}
    alone = exactly(derived(group, name, "reaching"), **given)
    assert_same(exactly(derived(group, name, "tracking"), **{**given, **rest}), alone)


@each_law
@each_seed
def test_tracking_does_not_see_where_the_world_is(group: str, name: str, seed: int) -> None:
    """Left invariance: one element before both configurations changes nothing."""
    rng = Random(seed)
    given, moved = numbers(group, seed), numbers(group, seed)
    q, q_r, shift = (unit(vector(rng)) for _ in range(3))
    given |= {"g": STORED[group](q), "g_r": STORED[group](q_r)}
    moved |= {"g": STORED[group](hamilton(shift, q)), "g_r": STORED[group](hamilton(shift, q_r))}
    d = derived(group, name, "tracking")
    assert_same(exactly(d, **moved), exactly(d, **given))


@each_law
@pytest.mark.parametrize("kind", ["tracking", "reaching"])
def test_nothing_is_divided_by_the_inertia(group: str, name: str, kind: str) -> None:
    d = derived(group, name, kind)
    symbols = set(next(q for q in d.inputs if q.name == "inertia").symbols())
    powers = [power for _, value in d.terms() for power in value.atoms(Pow)]
    assert not any(power.exp.is_negative and power.free_symbols & symbols for power in powers)
    assert any(value.free_symbols & symbols for _, value in d.terms())


@each_law
@pytest.mark.parametrize("controller", WRITERS)
def test_each_controller_has_its_routines(group: str, name: str, controller: str) -> None:
    parts = routines(GROUPS[group], LAWS[group, name], controller, FULL)
    assert {q.name for q, _ in parts.main.outputs} == OUTPUTS | {"clearance"}
    for d in parts.public:
        assert {q.name for q, _ in d.outputs} in (OUTPUTS, {"nu_dot"})
    names = [d.name for d in (parts.main, *parts.public, *parts.inner)]
    assert len(set(names)) == len(names)
    assert {"plant", "residual", "definiteness", "reaching"} <= set(names)
    assert parts.main.name == {"gsmc": "tracking", "reaching": "reaching"}[controller]


def test_the_table_of_controllers_is_the_one_that_can_be_written() -> None:
    assert set(WRITERS) == set(CONTROLLERS)
    main = routines(GROUPS["SO3"], LAWS["SO3", "log"], "gsmc", FULL).main
    gains = tuple(q.member for q in main.inputs if q.holder == "params" and q.is_scalar)
    assert gains == CONTROLLERS["gsmc"]


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
