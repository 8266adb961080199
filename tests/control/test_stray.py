"""Ways off a group: each is as far off as it is long, and every equation is left by one."""

from __future__ import annotations

import math
from functools import cache

import pytest
from sympy import Matrix, Rational, Symbol

from derive.control.stray import Stray, strays
from derive.lie.catalogue import GROUPS
from tests.control.test_guard import BOTH, derived
from tests.groups import ALL

SIZE = Rational(1, 10**6)
LEFT = {"SL2": 1, "SO4": 10, "Lorentz": 6}
"""Ways of groups whose determinant says nothing that its forms do not say."""

each_both = pytest.mark.parametrize(("group", "controller"), BOTH, ids=map("-".join, BOTH))


@cache
def found(group: str, controller: str) -> list[Stray]:
    return strays(ALL[group].identity, derived(group, controller).guard)


@cache
def equations(group: str) -> tuple[tuple[Symbol, ...], Matrix]:
    """Those of the group itself, as functions of what is stored."""
    symbols = tuple(Symbol(f"x_{i}") for i in range(ALL[group].size))
    return symbols, ALL[group].residual(Matrix(symbols))


def off(group: str, way: Stray) -> list[float]:
    """What they say at the end of a way that is SIZE long, over SIZE."""
    symbols, rows = equations(group)
    end = dict(zip(symbols, ALL[group].identity, strict=True))
    for index, share in way.shares:
        end[symbols[index]] += SIZE * Rational(share)
    return [float(x / SIZE) for x in rows.xreplace(end)]


@each_both
def test_a_way_is_as_far_off_as_it_is_long(group: str, controller: str) -> None:
    for way in found(group, controller):
        assert math.hypot(*off(group, way)) == pytest.approx(1, rel=1e-5)


@each_both
def test_every_equation_is_left_by_some_way(group: str, controller: str) -> None:
    """By at least what makes a tenth more than the largest drift too much without it."""
    guard, ways = derived(group, controller).guard, found(group, controller)
    if guard.drift is None:
        assert not ways
        return
    left = zip(*(off(group, way) for way in ways), strict=True)
    assert all(max(map(abs, of_one)) > 0.44 for of_one in left)
    if group in GROUPS:
        assert len(ways) == len(guard.drift.step("off").formula)
    if group in LEFT:
        assert len(ways) == LEFT[group]


def test_what_only_the_reference_holds_is_left_there() -> None:
    holders = [way.holder for way in found("SE3", "gsmc")]
    assert (holders.count("state"), holders.count("reference")) == (10, 4)
    assert {way.holder for way in found("SE3", "reaching")} == {"state"}
    assert {way.holder for way in found("SO3", "gsmc")} == {"state"}
