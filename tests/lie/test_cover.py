"""The way from stored numbers to the unit quaternion: right, firm near the group, and tied."""

from fractions import Fraction
from functools import cache
from itertools import permutations, product
from random import Random
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.linalg import polar
from scipy.spatial.transform import Rotation
from sympy import Matrix

from derive.lie.catalogue import GROUPS
from derive.lie.kernel import H, K
from derive.routine.derivation import Derivation, Quantity
from tests.evaluation import exactly, in_double
from tests.points import STORED, hamilton, rotation, unit, vector

ANGLES = (0, 1e-300, 1e-8, 1e-3, 1, 3, np.pi - 1e-6, np.pi)


COVERED = [name for name, group in GROUPS.items() if group.cover]


def test_the_tests_know_every_group_with_a_quaternion() -> None:
    assert set(COVERED) == set(STORED)


def quantity(name: str, size: int) -> Quantity:
    return Quantity(name, size, "1", name, is_scalar=size == 1, place=name)


@cache
def covering(group: str) -> Derivation:
    """Nothing but the cover: (g, nu) -> w, v, k, h, the rotation vector 2 k v and its rates."""
    d = Derivation("cover", "", "")
    g = d.take(quantity("g", len(GROUPS[group].identity)))
    nu = d.take(quantity("nu", 3))
    write = GROUPS[group].cover
    assert write is not None
    cover = write(d.let, g)
    w, v = cover.w, cover.v
    rates = cover.rate(d.let, nu)
    d.give(quantity("q", 4), Matrix([w, *v]))
    d.give(quantity("kernel", 2), d.let("kernel", Matrix([K(w), H(w)]), "1", ""))
    d.give(quantity("log", 3), d.let("log", 2 * K(w) * v, "rad", ""))
    d.give(quantity("q_dot", 4), Matrix([rates[symbol] for symbol in (w, *v)]))
    return d.pruned()


@cache
def run(group: str) -> Any:
    return in_double(covering(group))


def cover(group: str, stored: Any) -> dict[str, Any]:
    """The cover in double. Warnings are errors, so nothing in it overflows or divides by zero."""
    out: dict[str, Any] = run(group)(g=np.ravel(stored), nu=np.zeros(3))
    return out


def canonical(q: Any) -> Any:
    return -q if q[0] < 0 else q


@pytest.mark.parametrize("group", COVERED)
@pytest.mark.parametrize("seed", range(6))
def test_it_finds_the_quaternion_to_any_digits(group: str, seed: int) -> None:
    rng = Random(seed)
    q, nu = unit(vector(rng)), vector(rng)
    out = exactly(covering(group), g=STORED[group](q), nu=nu)
    wanted = canonical(np.array(q)) if group == "SO3" else np.array(q)
    rates = hamilton(wanted, (0, *nu)) / 2
    for found, exact in zip((*out["q"], *out["q_dot"]), (*wanted, *rates), strict=True):
        assert abs(found * exact.denominator - exact.numerator) < 1e-50


@pytest.mark.parametrize("angle", ANGLES)
@pytest.mark.parametrize("axis", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (2, -3, 6), (-1, 4, 8)])
def test_in_double_it_is_that_of_scipy(angle: float, axis: tuple[int, ...]) -> None:
    turn = Rotation.from_rotvec(angle * np.array(axis) / np.linalg.norm(axis))
    q = turn.as_quat(scalar_first=True)
    assert_allclose(cover("S3", q)["q"], q, atol=4e-16)
    found = cover("SO3", turn.as_matrix())["q"]
    at_pi = angle == np.pi and found @ q < 0
    assert_allclose(-found if at_pi else found, q, atol=6e-16)


@pytest.mark.parametrize("angle", ANGLES[:-1])
def test_twice_k_times_v_is_the_rotation_vector(angle: float) -> None:
    vector = angle * np.array([2.0, -3.0, 6.0]) / 7
    turn = Rotation.from_rotvec(vector)
    rows = {"SO3": turn.as_matrix(), "S3": turn.as_quat(scalar_first=True)}
    for group, stored in rows.items():
        assert_allclose(cover(group, stored)["log"], vector, rtol=1e-15, atol=2e-16)


def test_far_quaternions_go_on_to_two_pi() -> None:
    for angle in (3.2, 5.0, 2 * np.pi - 1e-6):
        q = np.array([np.cos(angle / 2), 0, np.sin(angle / 2), 0])
        assert_allclose(cover("S3", q)["log"], [0, angle, 0], rtol=1e-9)


@pytest.mark.parametrize("seed", range(8))
def test_a_drift_of_1e_minus_7_costs_less_than_1e_minus_13(seed: int) -> None:
    rng = np.random.default_rng(seed)
    stored = Rotation.random(rng=rng).as_matrix() + 1e-7 * rng.uniform(-1, 1, (3, 3))
    nearest, _ = polar(stored)
    wanted = canonical(Rotation.from_matrix(nearest).as_quat(scalar_first=True))
    assert_allclose(cover("SO3", stored)["q"], wanted, rtol=0, atol=1e-13)


@pytest.mark.parametrize("length", [1e-3, 1 - 1e-7, 1 + 1e-7, 1e3])
def test_the_length_of_a_quaternion_does_not_count(length: float) -> None:
    q = np.array([-1.0, 4.0, -8.0, 0.0]) / 9
    assert_allclose(cover("S3", length * q)["q"], q, atol=4e-16)


AXES = [*np.eye(3, dtype=int), *product((1, -1), repeat=3), *permutations((0, 1, -1)), (-2, 3, -6)]


@pytest.mark.parametrize("axis", AXES, ids=str)
def test_at_pi_the_largest_component_is_positive_and_the_first_wins(axis: Any) -> None:
    n = np.array([Fraction(int(x)) for x in axis])
    exact = 2 * np.outer(n, n) / (n @ n) - np.eye(3, dtype=int)
    first = next(x for x in n if abs(x) == max(map(abs, n)))
    wanted = np.array(n, float) * np.sign(float(first)) / np.sqrt(float(n @ n))
    doubled = cover("SO3", np.array(exact, float))
    assert doubled["q"][0] == 0
    assert_allclose(doubled["q"][1:], wanted, atol=4e-16)
    assert_allclose(doubled["log"], np.pi * wanted, rtol=1e-15)
    precise = exactly(covering("SO3"), g=exact.ravel(), nu=(0, 0, 0))
    assert_allclose(np.array(precise["q"], float), [0, *wanted], atol=1e-16)


@pytest.mark.parametrize("seed", range(8))
def test_opposite_quaternions_are_one_rotation_bit_for_bit(seed: int) -> None:
    q = np.random.default_rng(seed).normal(size=4)
    q /= np.linalg.norm(q)
    one, other = (cover("SO3", rotation(list(sign * q))) for sign in (1, -1))
    for name in ("q", "log"):
        assert_array_equal(one[name], other[name])
    assert_array_equal(cover("S3", q)["q"], -cover("S3", -q)["q"])


@pytest.mark.parametrize(("tail", "length"), [(0, 0), (1e-50, 2 * np.pi), (-1e-8, 2 * np.pi)])
def test_at_minus_i_the_logarithm_is_zero_and_near_it_two_pi(tail: float, length: float) -> None:
    with np.errstate(over="ignore"):  # h = -dk/dw has no bound there
        out = run("S3")(g=(-1, 0, tail, 0), nu=np.zeros(3))
    assert_allclose(out["log"], [0, np.copysign(length, tail), 0], rtol=0, atol=1e-7)


@pytest.mark.parametrize("tail", [1e-59, 1e-30])
def test_even_nearer_it_stays_below_two_pi(tail: float) -> None:
    with np.errstate(over="ignore"):
        out = run("S3")(g=(-1, 0, 0, tail), nu=np.zeros(3))
    assert 0 < out["log"][2] < 2 * np.pi * 1.0001
