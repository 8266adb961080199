"""Every law of every group, with 130 digits: its value, its rate, and where it ends."""

from fractions import Fraction
from functools import cache
from random import Random
from typing import Any

import pytest
from sympy import Matrix

from derive.control.kinematic import apply, why_not
from derive.routine.derivation import Derivation, Quantity
from derive.verify.oracle.precise import mp
from tests import points
from tests.control.drawn import HALF_TURNS, LAWS, beside, each_law, turning
from tests.evaluation import exactly
from tests.groups import ALL
from tests.oracle import LAWS as KNOWN
from tests.oracle import distance, norm, truth
from tests.points import embedded, point, vector

LIMIT = mp.mpf("1e-60")
each_seed = pytest.mark.parametrize("seed", range(2))

NOWHERE = {"skew", "vec"}
"""Laws without a cut."""


def quantity(name: str, size: int) -> Quantity:
    return Quantity(name, size, "1", name, place=name)


@cache
def applied(group: str, name: str, *only: str) -> Derivation:
    """(g, nu) -> nu_u, its closed-form rate and the clearance, as the controllers write them."""
    known, d = ALL[group], Derivation("law", "", "")
    g, nu = d.take(quantity("g", known.size)), d.take(quantity("nu", known.dim))
    nu_u, nu_u_dot, clearance = apply(LAWS[group, name], d, known, g, nu)
    outputs = {"nu_u": nu_u, "nu_u_dot": nu_u_dot, "clearance": Matrix([clearance])}
    for key, value in outputs.items():
        if not only or key in only:
            d.give(quantity(key, len(value)), value)
    return d.pruned()


def at(group: str, name: str, g: Any, nu: Any = None, *only: str) -> dict[str, Any]:
    still = (0,) * ALL[group].dim
    return exactly(applied(group, name, *only), g=g, nu=nu or still)


def is_cut(group: str, name: str) -> bool:
    """Whether a turn of the group's matrices by pi, or on S3 by pi/2, stops the law."""
    parts = ALL[group].factors or (ALL[group],)
    return name not in NOWHERE and any(one.name in HALF_TURNS for one in parts)


def test_the_truth_knows_every_law() -> None:
    assert {name for _, name in LAWS} == set(KNOWN)
    assert {group for group, _ in LAWS} == set(ALL)
    assert all(law.name == name for (_, name), law in LAWS.items())


@each_law
@each_seed
def test_the_value_and_the_rate_are_those_of_matrices(group: str, name: str, seed: int) -> None:
    """The rate by central differences along g exp(t hat(nu))."""
    known, rng = ALL[group], Random(seed)
    p, nu = point(known, rng), vector(rng, known.dim)
    out, g = at(group, name, p, nu), truth(known).matrix(p)
    wanted, rate = truth(known).law(name, g), truth(known).rate(name, g, nu)
    assert distance(out["nu_u"], wanted) < LIMIT * (1 + norm(wanted))
    assert distance(out["nu_u_dot"], rate) < LIMIT * (1 + norm(rate))
    assert norm(wanted) > 0


@each_law
def test_property_i_at_the_identity_the_law_is_zero_and_smooth(group: str, name: str) -> None:
    known = ALL[group]
    nu = vector(Random(3), known.dim)
    out = at(group, name, known.identity, nu)
    assert not any(out["nu_u"])
    rate = truth(known).rate(name, truth(known).matrix(known.identity), nu)
    assert distance(out["nu_u_dot"], rate) < LIMIT * (1 + norm(rate))


@each_law
@each_seed
def test_property_ii_the_inverse_has_the_opposite_law(group: str, name: str, seed: int) -> None:
    known = ALL[group]
    p = point(known, Random(seed))
    back = points.stored(known, points.inverse(embedded(known, p)))
    there, other = at(group, name, p)["nu_u"], at(group, name, back)["nu_u"]
    assert distance(there, [-x for x in other]) < LIMIT * (1 + norm(there))
    assert any(there)


@each_law
def test_the_clearance_is_zero_at_the_cut_and_nowhere_else(group: str, name: str) -> None:
    known = ALL[group]
    away = [at(group, name, point(known, Random(s)), None, "clearance") for s in range(6)]
    assert all(value["clearance"][0] > 0 for value in away)
    if not is_cut(group, name):
        assert all(value["clearance"] == (1,) for value in away) or name == "cayley"
        return
    end = turning(known, Fraction(1) if name == "sign_vec" else None)
    for g in (end, beside(known, end, 1), beside(known, end, 2)):
        assert abs(at(group, name, g, None, "clearance")["clearance"][0]) < mp.mpf("1e-100")


TURNING = [(group, name) for group, name in LAWS if is_cut(group, "log")]
"""Laws of groups in which something turns."""


@pytest.mark.parametrize(("group", "name"), TURNING, ids=map("-".join, TURNING))
@pytest.mark.parametrize("side", [1, -1])
def test_a_pole_is_a_law_or_rate_without_bound(group: str, name: str, side: int) -> None:
    """A hair before the cut; where there is none, at a half turn and beyond."""
    known = ALL[group]
    far = Fraction(10**12)
    near = 1 + side / far if name == "sign_vec" else side * far
    g = beside(known, turning(known, near), 1)
    out = at(group, name, g, vector(Random(4), known.dim))
    largest = max(map(abs, (*out["nu_u"], *out["nu_u_dot"])))
    assert (largest > 1e6) == (LAWS[group, name].is_pole and is_cut(group, name))
    assert largest > 1e6 or largest < 1e4


def test_why_a_law_is_missing_is_told() -> None:
    assert "closed form" in why_not(ALL["SL2"], "log")
    assert "SL3" in why_not(ALL["SL3"], "cayley")
    assert why_not(ALL["SE3"], "mrp") == ""


def test_an_additive_factor_takes_any_law_and_a_curved_one_only_its_own() -> None:
    laws = {name: {law for group, law in LAWS if group == name} for name in ALL}
    assert laws["SO3 x R3"] == laws["SO3"]
    assert laws["S3 x SE2"] == laws["S3"] & laws["SE2"]
    assert laws["SE3 x SO3"] == laws["SE3"] & laws["SO3"]
    assert laws["R6"] == {"log"}
    assert all("log" in laws[name] for name in ("Heisenberg", "Random0", "SO2 x Random2"))
    assert all("log" not in laws[name] for name in ("SL2", "SO4", "Sim2", "GL2", "Aff1", "SL3"))
