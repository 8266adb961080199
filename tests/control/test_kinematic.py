"""The laws of rotations: the paper's values, the chain rule, and its Morse functions."""

from functools import cache
from random import Random
from typing import Any

import pytest
from sympy import Matrix

from derive.control.kinematic import LAWS, apply
from derive.control.quaternion_law import Quaternion
from derive.lie.catalogue import GROUPS
from derive.routine.derivation import Derivation, Quantity
from derive.routine.rate import rate
from derive.verify.oracle import truth
from derive.verify.oracle.precise import exactly as exactly_stored
from tests.evaluation import exactly
from tests.points import STORED, Row, unit, vector

mp = truth.mp
LIMIT = mp.mpf("1e-45")
TURNS = [(group, name) for group, name in LAWS if GROUPS[group].cover]
each_law = pytest.mark.parametrize(("group", "name"), TURNS, ids=map("-".join, TURNS))
each_seed = pytest.mark.parametrize("seed", range(4))

SAME = {("SO3", "cayley"): "gibbs", ("S3", "cayley"): "mrp"}
"""Laws under the name they have in every group: what they are called among rotations."""

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

MORSE = {"SO3": lambda w: 2 - 2 * w, "S3": lambda w: mp.sqrt(1 - w)}
"""V_1 and V_2 of the paper as functions of w."""


def quantity(name: str, size: int) -> Quantity:
    return Quantity(name, size, "1", name, place=name)


def begun(group: str) -> tuple[Derivation, Matrix, Matrix]:
    d = Derivation("law", "", "")
    return d, d.take(quantity("g", len(GROUPS[group].identity))), d.take(quantity("nu", 3))


@cache
def applied(group: str, name: str) -> Derivation:
    """(g, nu) -> nu_u and its closed-form rate, as the controllers write them."""
    d, g, nu = begun(group)
    nu_u, nu_u_dot, _ = apply(LAWS[group, name], d, GROUPS[group], g, nu)
    d.give(quantity("nu_u", 3), nu_u)
    d.give(quantity("nu_u_dot", 3), nu_u_dot)
    return d.pruned()


@cache
def chained(group: str, name: str) -> Derivation:
    """(g, nu) -> the rate of 2 p v by sympy's chain rule from the rates of w and v."""
    d, g, nu = begun(group)
    write = GROUPS[group].cover
    assert write is not None
    cover = write(d.let, g)
    law = LAWS[group, name].write
    assert isinstance(law, Quaternion)
    factor = law.factor(d.let, cover)
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


def known(group: str, name: str) -> tuple[str, str]:
    """The pair by which the truth and the tables know a law."""
    return group, SAME.get((group, name), name)


def test_the_tests_know_every_law() -> None:
    assert set(TURNS) == set(truth.LAWS)
    assert {known(*pair) for pair in TURNS} == set(FACTORS)
    assert {group for group, _ in TURNS} == set(MORSE) == set(STORED)


@each_law
@each_seed
def test_the_value_is_the_papers(group: str, name: str, seed: int) -> None:
    stored, q = exact_point(group, seed)
    assert distance(at(group, name, stored)["nu_u"], truth.law(*known(group, name), q)) < LIMIT


@each_law
@each_seed
def test_the_rate_is_that_of_the_paper_along_the_flow(group: str, name: str, seed: int) -> None:
    stored, q = exact_point(group, seed)
    nu = vector(Random(seed + 100))
    found = at(group, name, stored, nu)["nu_u_dot"]
    assert distance(found, truth.rate(*known(group, name), q, nu)) < LIMIT


@each_law
@each_seed
def test_the_closed_form_is_the_chain_rule(group: str, name: str, seed: int) -> None:
    stored, _ = exact_point(group, seed)
    nu = vector(Random(seed + 100))
    chain = exactly(chained(group, name), g=STORED[group](stored), nu=nu)["rate"]
    assert distance(at(group, name, stored, nu)["nu_u_dot"], chain) < LIMIT


@each_law
@each_seed
def test_properties_iii_and_iv_the_morse_function_falls(group: str, name: str, seed: int) -> None:
    """V' = dV/dw w' with w' = v.nu_u/2 along g' = -g nu_u; y > 0 but for sign_vec at w < 0."""
    stored, q = exact_point(group, seed)
    nu_u = at(group, name, stored)["nu_u"]
    fall = mp.diff(MORSE[group], q[0]) * sum(x * y for x, y in zip(q[1:], nu_u, strict=True)) / 2
    factor = FACTORS[known(group, name)](mp.acos(q[0]))
    assert abs(fall + factor * MORSE[group](q[0])) < mp.mpf("1e-40")
    assert (factor > 0) != (name == "sign_vec" and q[0] < 0)
