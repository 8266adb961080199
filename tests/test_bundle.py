"""The tangent bundle in numbers: Lemmas 1 and 2 at 1e-12 on every group, law and batch."""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from derive import bundle
from derive.bundle import Bundle, State
from derive.control.kinematic import LAWS, laws_of
from derive.lie.catalogue import named
from derive.lie.group import Group
from derive.vehicle import InputError
from derive.verify.law.space import Space
from derive.verify.oracle import truth
from tests.command import ROOT
from tests.own import HEISENBERG, SL2

Array = NDArray[Any]

MORE = [named("SO3 x R3"), named("S3 x SE2"), named("SO3 x SO3"), SL2, HEISENBERG]
EVERY = [(*pair, None) for pair in LAWS] + [
    (group.name, law, group) for group in MORE for law in laws_of(group)
]
each = pytest.mark.parametrize(
    ("name", "law", "group"), EVERY, ids=[f"{name}-{law}" for name, law, _ in EVERY]
)
COUNT, LIMIT = 64, 1e-12
CALM = 0.5
"""Largest angle and size of three elements, so that no product meets a cut or a pole."""


def made(name: str, law: str, group: Group | None) -> Bundle:
    return bundle.make(group or name, law, rate_gain=0.7)


def states(b: Bundle, seed: int, size: float = CALM) -> State:
    """(COUNT, …) states by the exponential of the basis; |x| <= size."""
    rng = np.random.default_rng(seed)
    x = rng.normal(size=(COUNT, b.group.dim))
    x *= rng.uniform(0, size, (COUNT, 1)) / np.linalg.norm(x, axis=1, keepdims=True)
    space = Space(b.group)
    g = space.store(space.exp(x)).reshape(COUNT, *b.group.shape)
    return State(g, rng.normal(size=(COUNT, b.group.dim)))


def close(a: tuple[Array, Array], b: tuple[Array, Array]) -> None:
    np.testing.assert_allclose(a[0], np.broadcast_to(b[0], a[0].shape), rtol=0, atol=LIMIT)
    np.testing.assert_allclose(a[1], np.broadcast_to(b[1], a[1].shape), rtol=0, atol=LIMIT)


@each
def test_star_is_a_group(name: str, law: str, group: Group | None) -> None:
    b = made(name, law, group)
    x, y, z = (states(b, seed) for seed in range(3))
    close(b.star(b.star(x, y), z), b.star(x, b.star(y, z)))
    close(b.star(x, b.identity), x)
    close(b.star(b.identity, x), x)
    close(b.star(x, b.inverse(x)), b.identity)
    close(b.star(b.inverse(x), x), b.identity)


@each
def test_h_is_closed_and_s_is_a_homomorphism(name: str, law: str, group: Group | None) -> None:
    b = made(name, law, group)
    x, y = (states(b, seed) for seed in (3, 4))
    np.testing.assert_allclose(b.s(b.star(x, y)), b.s(x) + b.s(y), rtol=0, atol=LIMIT)
    np.testing.assert_allclose(b.s(b.inverse(x)), -b.s(x), rtol=0, atol=LIMIT)
    h1, h2 = b.above(x.g), b.above(y.g)
    for inside in (h1, b.star(h1, h2), b.inverse(h1), b.identity):
        assert b.is_sliding(inside, LIMIT).all()
    assert not b.is_sliding(x, LIMIT).any()
    np.testing.assert_allclose(b.s(x), x.nu + 0.7 * b.law(x.g), rtol=0, atol=LIMIT)


@each
def test_the_product_is_that_of_matrices(name: str, law: str, group: Group | None) -> None:
    b = made(name, law, group)
    rng, space = np.random.default_rng(5), Space(b.group)
    one, two = (space.exp(CALM * rng.normal(size=(COUNT, b.group.dim))) for _ in range(2))
    stored = [space.store(g).reshape(COUNT, *b.group.shape) for g in (one, two, one @ two)]
    zero = np.zeros(b.group.dim)
    found = b.star((stored[0], zero), (stored[1], zero)).g
    np.testing.assert_allclose(found, stored[2], rtol=0, atol=LIMIT)
    back = space.store(np.linalg.inv(one)).reshape(COUNT, *b.group.shape)
    np.testing.assert_allclose(b.inverse((stored[0], zero)).g, back, rtol=0, atol=LIMIT)


@pytest.mark.parametrize(("group", "law"), truth.LAWS)
@pytest.mark.parametrize("angle", [0.0, 1e-300, 1e-8, 1e-3, 1.0, np.pi - 1e-6])
def test_the_law_is_the_truth(group: str, law: str, angle: float) -> None:
    space = Space(bundle.make(group).group)
    stored = space.store(space.exp(angle * np.array([0.6, 0.0, -0.8])))
    wanted = np.array(
        truth.law(group, law, truth.error(group, truth.IDENTITY[group], list(stored)))
    )
    found = bundle.make(group, law).law(stored.reshape(space.group.shape))
    scale = max(np.abs(wanted.astype(float)).max(), 1e-300)
    np.testing.assert_allclose(found / scale, wanted.astype(float) / scale, rtol=0, atol=LIMIT)


def test_star_jumps_by_two_pi_lambda_where_the_product_passes_pi() -> None:
    """With log the operation is not continuous on SO3."""
    b, space = bundle.make("SO3", "log", 0.5), Space(named("SO3"))
    one = space.exp(np.array([0.0, 0.0, 1.0]))
    for law, jump in (("log", np.pi), ("skew", 0.0)):
        b = bundle.make("SO3", law, 0.5)
        ends = [np.array([0.0, 0.0, np.pi - 1 + side * 1e-9]) for side in (-1, 1)]
        nus = [b.star((one, np.zeros(3)), (space.exp(end), np.zeros(3))).nu for end in ends]
        assert np.linalg.norm(nus[1] - nus[0]) == pytest.approx(jump, abs=1e-7)


def test_a_vehicle_has_its_bundle() -> None:
    b = bundle.of(ROOT / "vehicles" / "paper_s3.toml")
    assert (b.group.name, b.kinematic.name, b.rate_gain) == ("S3", "half_log", 0.5)
    np.testing.assert_allclose(b.law([0.6, 0.8, 0.0, 0.0]), [np.arccos(0.6), 0, 0])


def test_leading_axes_broadcast() -> None:
    b = bundle.make("SE3", "log")
    h = b.star((np.eye(4)[None, None], np.ones((3, 1, 6))), (np.eye(4), np.zeros((5, 6))))
    assert (h.g.shape, h.nu.shape) == ((3, 5, 4, 4), (3, 5, 6))
    assert b.is_sliding(h, 1e-9).shape == (3, 5)
    assert b.identity.g.shape == (4, 4)


def test_heights_are_numbers_too() -> None:
    b = bundle.make("SO3", "log")
    assert list(b.heights) == ["V_1", "Psi", "|log|^2/2"]
    turn = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    assert b.heights["V_1"].value(turn) == pytest.approx(2 - 2**0.5)
    assert b.heights["Psi"].rate(turn, [1.0, 0, 0]) == pytest.approx(1.0)


def test_membership_of_h_has_the_tolerance_it_is_given() -> None:
    b = bundle.make("SO3", "log")
    g, nu = b.above(np.eye(3)[[1, 2, 0]])
    near = (g, nu + np.array([0.0, 2e-3, 0.0]))
    assert [bool(b.is_sliding(near, tolerance)) for tolerance in (1e-3, 3e-3)] == [False, True]


def test_clearance_is_zero_at_the_cut() -> None:
    assert bundle.make("SO3", "log").clearance(np.diag([1.0, -1, -1])) == pytest.approx(0)
    assert bundle.make("SO3", "skew").clearance(np.diag([1.0, -1, -1])) == 1


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("SO4",), "group: expected SO2.*found 'SO4'"),
        (("SO3 x SU2",), "found 'SU2'"),
        (("SO3", "vec"), "law: expected one of log, lee.*found 'vec'"),
        (("SO3", "log", 0.0), "rate_gain: expected a positive"),
        (("SO3", "log", -1.0), "rate_gain"),
        (("SO3", "log", float("nan")), "rate_gain"),
        (("SO3", "log", float("inf")), "rate_gain"),
    ],
)
def test_what_does_not_exist_is_refused(arguments: tuple[Any, ...], told: str) -> None:
    with pytest.raises(ValueError, match=told):
        bundle.make(*arguments)


def test_shapes_that_do_not_fit_are_refused() -> None:
    b = bundle.make("SO3")
    with pytest.raises(ValueError, match=r"g1: expected an array \(\.\.\., 3, 3\) of SO3"):
        b.star((np.eye(4), np.zeros(3)), (np.eye(3), np.zeros(3)))
    with pytest.raises(ValueError, match=r"g: expected an array .*found \(9,\)"):
        b.law(np.eye(3).ravel())
    with pytest.raises(ValueError, match=r"nu: expected an array \(\.\.\., 3\), found \(4,\)"):
        b.s((np.eye(3), np.zeros(4)))


def test_a_file_that_is_not_there_is_told() -> None:
    with pytest.raises(InputError, match="no such file"):
        bundle.of("absent.toml")
