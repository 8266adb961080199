"""Every kinematic law: its value, its rate by three ways, and Definition 1 of the paper."""

from fractions import Fraction
from functools import cache
from random import Random
from typing import Any

import pytest
from sympy import Matrix

from derive.control.kinematic import LAWS
from derive.lie.catalogue import GROUPS
from derive.routine.derivation import Derivation, Quantity
from derive.routine.rate import rate
from derive.verify import truth
from derive.verify.precise import exactly as exactly_stored
from tests.evaluation import exactly
from tests.points import STORED, Row, conjugate, unit, vector

mp = truth.mp
LIMIT = mp.mpf("1e-45")
each_law = pytest.mark.parametrize(("group", "name"), LAWS, ids=map("-".join, LAWS))
each_seed = pytest.mark.parametrize("seed", range(4))

FACTORS = {
    ("SO3", "log"): lambda u: u * mp.cot(u / 2),
    ("SO3", "lee"): lambda u: mp.cos(u / 2) ** 2,
    ("SO3", "skew"): lambda u: mp.sin(2 * u) * mp.cot(u / 2) / 2,
    ("SO3", "gibbs"): lambda u: mp.tan(u) * mp.cot(u / 2),
    ("SO3", "mrp"): lambda u: mp.mpf(2),
    ("S3", "log"): lambda u: u / 2 * mp.cot(u / 2),
    ("S3", "half_log"): lambda u: u / 4 * mp.cot(u / 2),
    ("S3", "mrp"): lambda u: mp.one,
    ("S3", "vec"): lambda u: (1 + mp.cos(u)) / 2,
    ("S3", "sign_vec"): lambda u: mp.sign(mp.cos(u)) * (1 + mp.cos(u)) / 4,
}
"""y of property (iv), V' = -y V, as a function of half the angle."""

CUTS = {
    ("SO3", "log"): "pi", ("SO3", "lee"): "pi", ("SO3", "skew"): "", ("SO3", "gibbs"): "pi",
    ("SO3", "mrp"): "pi", ("S3", "log"): "-i", ("S3", "half_log"): "-i", ("S3", "mrp"): "-i",
    ("S3", "vec"): "", ("S3", "sign_vec"): "pi",
}  # fmt: skip
"""Where each law jumps or ends."""

_NEAR = Fraction(1, 10**12)
PLACES = {
    "pi": ((0, 1, 0, 0), unit((1 - _NEAR, 0, 0))),
    "-i": ((-1, 0, 0, 0), unit((1 / _NEAR, 0, 0))),
}
"""The quaternion of a cut, and one close by."""

MORSE = {"SO3": lambda w: 2 - 2 * w, "S3": lambda w: mp.sqrt(1 - w)}
"""V_1 and V_2 of the paper as functions of w."""


def quantity(name: str, size: int) -> Quantity:
    return Quantity(name, size, "1", name, place=name)


def begun(group: str) -> tuple[Derivation, Matrix, Matrix]:
    d = Derivation("law", "", "")
    return d, d.take(quantity("g", len(GROUPS[group].identity))), d.take(quantity("nu", 3))


@cache
def applied(group: str, name: str) -> Derivation:
    """(g, nu) -> nu_u, its closed-form rate and the clearance, as the controllers write them."""
    d, g, nu = begun(group)
    nu_u, nu_u_dot, clearance = LAWS[group, name].apply(d, GROUPS[group], g, nu)
    d.give(quantity("nu_u", 3), nu_u)
    d.give(quantity("nu_u_dot", 3), nu_u_dot)
    d.give(quantity("clearance", 1), Matrix([clearance]))
    return d.pruned()


@cache
def chained(group: str, name: str) -> Derivation:
    """(g, nu) -> the rate of 2 p v by sympy's chain rule from the rates of w and v."""
    d, g, nu = begun(group)
    cover = GROUPS[group].cover(d.let, g)
    factor = LAWS[group, name].factor(d.let, cover.w, cover.v)
    value = d.let("value", 2 * factor * cover.v, "rad", "")
    d.give(quantity("rate", 3), rate(d, value, cover.rate(d.let, nu)))
    return d.pruned()


def exact_point(group: str, seed: int) -> tuple[Row, tuple[Any, ...]]:
    """A rational unit quaternion, its w > 0 for even seeds, and how a law sees it."""
    x = vector(Random(seed))
    size = sum(abs(a) for a in x)
    q = unit([(1 + seed % 2) * a / size for a in x])
    assert (q[0] > 0) == (seed % 2 == 0)
    folded = [-x for x in q] if group == "SO3" and q[0] < 0 else q
    return q, tuple(map(exactly_stored, folded))


def at(group: str, name: str, q: Any, nu: Any = (0, 0, 0)) -> dict[str, Any]:
    return exactly(applied(group, name), g=STORED[group](q), nu=nu)


def distance(a: Any, b: Any) -> Any:
    return mp.sqrt(sum((x - y) ** 2 for x, y in zip(a, b, strict=True)))


def test_the_tests_know_every_law() -> None:
    assert set(LAWS) == set(truth.LAWS) == set(FACTORS) == set(CUTS)
    assert {group for group, _ in LAWS} == set(GROUPS) == set(MORSE)
    assert all(law.name == name and group in law.groups for (group, name), law in LAWS.items())


@each_law
@each_seed
def test_the_value_is_the_papers(group: str, name: str, seed: int) -> None:
    stored, q = exact_point(group, seed)
    assert distance(at(group, name, stored)["nu_u"], truth.law(group, name, q)) < LIMIT


@each_law
@each_seed
def test_the_rate_is_that_of_the_paper_along_the_flow(group: str, name: str, seed: int) -> None:
    stored, q = exact_point(group, seed)
    nu = vector(Random(seed + 100))
    found = at(group, name, stored, nu)["nu_u_dot"]
    assert distance(found, truth.rate(group, name, q, nu)) < LIMIT


@each_law
@each_seed
def test_the_closed_form_is_the_chain_rule(group: str, name: str, seed: int) -> None:
    stored, _ = exact_point(group, seed)
    nu = vector(Random(seed + 100))
    chain = exactly(chained(group, name), g=STORED[group](stored), nu=nu)["rate"]
    assert distance(at(group, name, stored, nu)["nu_u_dot"], chain) < LIMIT


@each_law
def test_property_i_at_the_identity_the_law_is_zero_and_smooth(group: str, name: str) -> None:
    identity, nu = (1, 0, 0, 0), (1, 2, 3)
    out = at(group, name, identity, nu)
    assert not any(out["nu_u"])
    assert distance(out["nu_u_dot"], truth.rate(group, name, truth.normalise(identity), nu)) < LIMIT


@each_law
@each_seed
def test_property_ii_the_inverse_has_the_opposite_law(group: str, name: str, seed: int) -> None:
    stored, _ = exact_point(group, seed)
    there, back = at(group, name, stored)["nu_u"], at(group, name, conjugate(stored))["nu_u"]
    assert distance(there, [-x for x in back]) < LIMIT
    assert any(there)


@each_law
@each_seed
def test_properties_iii_and_iv_the_morse_function_falls(group: str, name: str, seed: int) -> None:
    """V' = dV/dw w' with w' = v.nu_u/2 along g' = -g nu_u; y > 0 but for sign_vec at w < 0."""
    stored, q = exact_point(group, seed)
    nu_u = at(group, name, stored)["nu_u"]
    fall = mp.diff(MORSE[group], q[0]) * sum(x * y for x, y in zip(q[1:], nu_u, strict=True)) / 2
    factor = FACTORS[group, name](mp.acos(q[0]))
    assert abs(fall + factor * MORSE[group](q[0])) < mp.mpf("1e-40")
    assert (factor > 0) != (name == "sign_vec" and q[0] < 0)


@each_law
def test_the_clearance_is_zero_at_the_cut_and_nowhere_else(group: str, name: str) -> None:
    cut = CUTS[group, name]
    alone = applied(group, name).without("nu_u").without("nu_u_dot")
    if cut:
        there = exactly(alone, g=STORED[group](PLACES[cut][0]), nu=(0, 0, 0))
        assert abs(there["clearance"][0]) < mp.mpf("1e-100")
    away = [at(group, name, exact_point(group, seed)[0])["clearance"][0] for seed in range(4)]
    assert all(0 < value <= 1 for value in away)
    assert cut or set(away) == {1}


@each_law
def test_a_pole_is_a_law_or_rate_without_bound(group: str, name: str) -> None:
    cut = CUTS[group, name]
    nearby = [PLACES[cut][1]] if cut else [near for _, near in PLACES.values()]
    outs = [at(group, name, near, (1, 2, 3)) for near in nearby]
    largest = max(abs(x) for out in outs for x in (*out["nu_u"], *out["nu_u_dot"]))
    assert (largest > 1e6) == LAWS[group, name].is_pole
    assert largest > 1e6 or largest < 1e3
