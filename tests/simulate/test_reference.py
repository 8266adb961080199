"""References: their rates are exact, a slew arrives, a table passes through its rows."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from bench.algebra import Array, algebra, exp
from derive.simulate.reference import Course, Reference, rest, slew, steady, tabled

E = np.eye(3).reshape(9, 1)
ALONG = np.array([[0.7], [-0.4], [0.5]])
TIMES = np.array([0.5, 1.0, 1.3, 2.0])
TABLE = np.random.default_rng(2).normal(size=(2, 4, 3))

MOVING = {
    "rest": rest(E, 3),
    "steady": steady(E, ALONG),
    "slew": slew(E, ALONG, 2.0),
    "table": tabled(E, TIMES, *TABLE),
}
each_kind = pytest.mark.parametrize("kind", MOVING)


def rate(reference: Reference, t: float) -> Array:
    """Of nu_r, by differences of order 6: to 1e-12 for the polynomials here."""
    h = 1e-3
    weights = ((1, 45.0), (2, -9.0), (3, 1.0))
    each = (w * (reference.at(t + i * h)[0] - reference.at(t - i * h)[0]) for i, w in weights)
    return np.asarray(sum(each) / (60 * h))


@each_kind
def test_the_rate_is_that_of_the_velocity(kind: str) -> None:
    for t in (0.55, 0.8, 1.15, 1.6, 1.95):
        found = MOVING[kind].at(t)
        assert found[0].shape == found[1].shape == (3, 1)
        np.testing.assert_allclose(found[1], rate(MOVING[kind], t), atol=1e-11)


@each_kind
def test_the_velocity_does_not_jump(kind: str) -> None:
    for t in (0.0, *TIMES, 3.0):
        before, after = (MOVING[kind].at(t + off)[0] for off in (-1e-9, 1e-9))
        np.testing.assert_allclose(before, after, atol=1e-7)


def test_a_slew_arrives_at_rest() -> None:
    """At g_r exp(along), wherever it starts; by scipy and matrices."""
    space, motion = algebra("SO3"), MOVING["slew"]
    solved = solve_ivp(lambda t, g: space.flow(g, motion.at(t)[0][:, 0]), (0, 2.0), E[:, 0],
                       rtol=1e-12, atol=1e-13)  # fmt: skip
    np.testing.assert_allclose(
        solved.y[:, -1].reshape(3, 3), exp(space.hat(ALONG[:, 0])), atol=1e-10
    )
    for t in (-1.0, 0.0, 2.0, 5.0):
        assert not np.any(motion.at(t))
    # Its rate does not jump either, and it is fastest in the middle.
    for t in (0.0, 2.0):
        assert np.abs(motion.at(t + 1e-6)[1]).max() < 1e-4
    np.testing.assert_allclose(motion.at(1.0)[0], ALONG * 2772 / 2048, rtol=1e-14)


def test_a_table_passes_through_its_rows_with_their_rates() -> None:
    """At the first and the last row too, where a step of the integration starts or ends."""
    for row, t in enumerate(TIMES):
        found = MOVING["table"].at(float(t))
        np.testing.assert_allclose(found[0][:, 0], TABLE[0, row], rtol=1e-13)
        np.testing.assert_allclose(found[1][:, 0], TABLE[1, row], rtol=1e-12)
    late = np.nextafter(TIMES[-1], 3)
    np.testing.assert_allclose(MOVING["table"].at(float(late))[1][:, 0], TABLE[1, 3], rtol=1e-12)


def test_a_table_keeps_its_velocity_before_and_after() -> None:
    for t, row in ((0.0, 0), (2.5, 3)):
        velocity, still = MOVING["table"].at(t)
        np.testing.assert_array_equal(velocity[:, 0], TABLE[0, row])
        assert not still.any()


def test_a_cubic_is_found_again() -> None:
    times = np.array([0.0, 0.4, 1.5])
    c = np.random.default_rng(1).normal(size=(4, 2))
    values = sum(c[i] * times[:, None] ** i for i in range(4))
    rates = sum(i * c[i] * times[:, None] ** (i - 1) for i in range(1, 4))
    motion = tabled(np.zeros((2, 1)), times, np.asarray(values), np.asarray(rates))
    for t in (0.1, 0.39, 0.9, 1.49):
        wanted = sum(c[i] * t**i for i in range(4))
        np.testing.assert_allclose(motion.at(t)[0][:, 0], wanted, rtol=1e-12)


COURSES = {
    "rest": ((0.0, 0.0, 0.0),),
    "steady": (tuple(ALONG[:, 0]),),
    "slew": (tuple(ALONG[:, 0]), (2.0,)),
    "table": tuple((t, *nu, *dot) for t, nu, dot in zip(TIMES, *TABLE, strict=True)),
}


@each_kind
def test_a_course_is_the_same_in_plain_numbers(kind: str) -> None:
    course = Course(kind, tuple(E[:, 0]), COURSES[kind])
    motion = course.reference()
    np.testing.assert_array_equal(motion.start, E)
    assert motion.is_at_rest == (kind == "rest")
    for t in (0.0, 0.7, 1.9, 4.0):
        np.testing.assert_array_equal(motion.at(t), MOVING[kind].at(t))
    assert hash(course) == hash(Course(kind, tuple(E[:, 0]), COURSES[kind]))


def test_an_unknown_kind_is_refused() -> None:
    with pytest.raises(KeyError, match="spiral"):
        Course("spiral", (1.0,), ((0.0,),)).reference()
