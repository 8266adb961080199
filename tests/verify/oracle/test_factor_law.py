"""The laws of factors, by quaternions and means of exp, against matrix functions."""

from __future__ import annotations

from typing import Any

import pytest

from derive.verify.oracle import factor_law, matrix_function, matrix_group
from tests.verify.oracle.coordinates import NAMES, TINY, at_angle, draw, mp, off, worst

LAWS = sorted(matrix_group.LAWS)
SL2 = (((0, 1), (0, 0)), ((0, 0), (1, 0)), ((1, 0), (0, -1)))
HEISENBERG = (
    ((0, 1, 0), (0, 0, 0), (0, 0, 0)),
    ((0, 0, 0), (0, 0, 1), (0, 0, 0)),
    ((0, 0, 1), (0, 0, 0), (0, 0, 0)),
)


def both(name: Any, law: str, g: Any, nu: Any, *, flip: bool = False) -> tuple[Any, Any]:
    """nu_u and its rate of a whole group, factor by factor."""
    parts = zip(matrix_group.factors(name), g, matrix_group.coordinates(name, nu), strict=True)
    value: list[Any] = []
    rate: list[Any] = []
    for one, a, (_, x) in parts:
        at = factor_law.lifted(one, a, flip=flip)
        value += factor_law.law(at, law)
        rate += factor_law.rate(at, law, x)
    return value, rate


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("name", NAMES)
def test_a_law_and_its_rate_are_those_of_matrices(name: str, law: str) -> None:
    x, nu = draw(name, 21, 2)
    g = matrix_group.exp(name, [entry / 2 for entry in x])
    value, rate = both(name, law, g, nu)
    assert worst(name, value, matrix_group.law(name, law, g)) < TINY
    assert worst(name, rate, matrix_group.rate(name, g, nu, law)) < TINY


@pytest.mark.parametrize("angle", ["0", "1e-300", "1e-8", "2", "3.14159265358"])
@pytest.mark.parametrize("name", ["SE2", "SE3", "SE23"])
def test_the_log_keeps_its_digits_at_the_edges(name: str, angle: str) -> None:
    x = at_angle(name, angle, "1e6")
    value, _ = both(name, "log", matrix_group.exp(name, x), draw(name, 22)[0])
    assert worst(name, value, x) < TINY


@pytest.mark.parametrize("name", ["SO2", "SO3", "SE2", "SE3", "SE23"])
def test_across_the_cut_exp_still_gives_the_element(name: str) -> None:
    x, nu = at_angle(name, "3.1", 2), draw(name, 23)[0]
    g = matrix_group.exp(name, x)
    value, rate = both(name, "log", g, nu, flip=True)
    assert off(value, x) > 0.1
    back = matrix_group.exp(name, value)
    assert matrix_function.distance(back[0], g[0]) < TINY
    # The rate across the cut, by the flow of exp: exp(value + h rate) = g exp(h nu) to O(h^2).
    h = mp.mpf("1e-30")
    ahead = matrix_group.exp(name, [a + h * b for a, b in zip(value, rate, strict=True)])
    flown = matrix_group.times(g, matrix_group.exp(name, [h * mp.mpf(entry) for entry in nu]))
    assert matrix_function.distance(ahead[0], flown[0]) < mp.mpf("1e-55")


def test_no_side_is_across_on_s3() -> None:
    x, nu = at_angle("S3", "3.1", 0), draw("S3", 24)[0]
    g = matrix_group.exp("S3", x)
    assert both("S3", "log", g, nu, flip=True) == both("S3", "log", g, nu)


@pytest.mark.parametrize("basis", [SL2, HEISENBERG])
def test_a_group_of_ones_own_is_its_matrices(basis: Any) -> None:
    x = [mp.mpf(3) / 10, mp.mpf(-2) / 5, mp.mpf(1) / 7]
    g = matrix_group.exp(basis, x)
    assert off(matrix_group.log(basis, g), x) < TINY
    assert matrix_group.element(basis, matrix_group.store(basis, g)) == g
    one = matrix_function.identity(len(g[0]))
    back = matrix_function.product(matrix_group.inverse(basis, g)[0], g[0])
    assert matrix_function.distance(back, one) < TINY
    bracket = matrix_group.bracket(basis, (1, 0, 0), (0, 1, 0))
    assert off(bracket, (0, 0, 1)) < TINY  # both bases are written so


def test_vee_is_the_nearest_of_a_basis_that_is_not_orthogonal() -> None:
    basis = (((0, 1), (1, 0)), ((0, 1), (0, 1)))
    (one,) = matrix_group.factors(basis)
    # The off-diagonal pair (1, 3) and the corner 2: normal equations 2a + b = 4, a + 2b = 3.
    found = one.vee(((mp.mpf(7), mp.mpf(1)), (mp.mpf(3), mp.mpf(2))))
    assert off(found, (mp.mpf(5) / 3, mp.mpf(2) / 3)) < TINY
