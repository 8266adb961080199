"""The guard's parts: they give the law, they know what the group bounds, and what is off it."""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from random import Random
from typing import Any

import pytest
from sympy import Matrix

from derive.control.controller import WRITERS, Routines, routines
from derive.control.guard import Guarded, bounded, guarded
from derive.control.kinematic import laws_of
from derive.control.port import ERROR
from derive.control.table import CONTROLLERS
from derive.lie.catalogue import GROUPS
from derive.lie.group import Group
from derive.routine.derivation import Derivation, Quantity
from derive.verify.oracle.precise import mp
from tests import points
from tests.control.drawn import full, numbers
from tests.evaluation import exactly
from tests.groups import ALL, each_group

LIMIT = mp.mpf("1e-100")
OFF, SEEN = Fraction(1, 1000), 1e-12
"""How far a stored number is moved, and the square of a distance that it is at least seen by."""

BOTH = [
    (group, controller)
    for group in ALL
    for controller in WRITERS
    if CONTROLLERS[controller].exists_on(group)
]
each_both = pytest.mark.parametrize(("group", "controller"), BOTH, ids=map("-".join, BOTH))
each_seed = pytest.mark.parametrize("seed", range(2))


@cache
def derived(group: str, controller: str) -> Routines:
    known, laws = ALL[group], laws_of(ALL[group])
    law = laws[CONTROLLERS[controller].law or next(iter(laws))]
    return routines(known, law, controller, full(known))


def given(group: str, seed: int) -> dict[str, Any]:
    """Exact inputs of any controller."""
    gains = {gain.symbol: Fraction(3, 2) for one in CONTROLLERS.values() for gain in one.gains}
    return gains | numbers(ALL[group], seed)


def apart(a: Sequence[Any], b: Sequence[Any]) -> Any:
    return max(abs(x - y) for x, y in zip(a, b, strict=True))


def test_every_controller_is_parted_somewhere() -> None:
    assert {controller for _, controller in BOTH} == set(WRITERS)
    assert {group for group, _ in BOTH} == set(ALL)


@each_both
@each_seed
def test_head_and_tail_give_what_the_whole_gives(group: str, controller: str, seed: int) -> None:
    parts, values = derived(group, controller), given(group, seed)
    whole, guard = exactly(parts.main, **values), parts.guard
    if guard.error is not None:
        values = {name: x for name, x in values.items() if name not in ("g", "g_r")}
        values |= exactly(guard.error, **given(group, seed))
    found = exactly(guard.law, **values)
    assert set(found) == set(whole)
    assert all(apart(found[name], whole[name]) < LIMIT for name in whole)


@each_both
def test_only_the_error_is_seen_where_there_is_one(group: str, controller: str) -> None:
    guard = derived(group, controller).guard
    names = {q.name for q in guard.law.inputs}
    if guard.error is None:
        assert controller == "reaching"
        assert ("g" in names, guard.seen) == (True, None)
        return
    assert {q.name for q in guard.error.inputs} == {"g", "g_r"}
    assert not names & {"g", "g_r"}
    assert ERROR in names


@each_both
@each_seed
def test_seen_is_the_error_as_far_as_the_law_reads_it(
    group: str, controller: str, seed: int
) -> None:
    guard, values = derived(group, controller).guard, given(group, seed)
    if guard.error is None or guard.seen is None:
        assert guard.error is guard.seen
        return
    ((quantity, _),) = guard.error.outputs
    is_read = guard.law.used(quantity)
    error, seen = exactly(guard.error, **values)[ERROR], exactly(guard.seen, **values)[ERROR]
    assert seen == tuple(x for x, read in zip(error, is_read, strict=True) if read)
    assert len([*guard.seen.terms()]) <= len([*guard.error.terms()])


@each_both
@each_seed
def test_the_error_is_the_quotient(group: str, controller: str, seed: int) -> None:
    """Against matrices of fractions: the error passed on is g_r^-1 g, stored."""
    guard, values, known = derived(group, controller).guard, given(group, seed), ALL[group]
    if guard.error is not None:
        a, b = (points.embedded(known, values[name]) for name in ("g_r", "g"))
        exact = points.stored(known, points.inverse(a) @ b)
        found = exactly(guard.error, **values)[ERROR]
        assert apart(found, [mp.mpf(x.numerator) / x.denominator for x in exact]) < LIMIT


def test_a_law_that_sees_a_configuration_past_the_error_is_refused() -> None:
    d, group = Derivation("sly", "", ""), GROUPS["SO2"]
    g = d.take(Quantity("g", 4, "1", "", place="state.g"))
    g_r = d.take(Quantity("g_r", 4, "1", "", place="reference.g"))
    g_e = d.let(ERROR, group.error(d.let, g_r, g), "1", "")
    d.give(Quantity("force", 1, "N m", "", place="command.force"), Matrix([g_e[1] + g[1]]))
    with pytest.raises(ValueError, match="sly: g_e is not all it knows"):
        guarded(group, d)


# What the group bounds.


def far(group: Group, seed: int) -> list[Any]:
    """Stored numbers of an element far away: the second square of a random one."""
    g = points.element(group, Random(seed))
    for _ in range(2):
        g = g @ g
    return points.stored(group, g)


@each_group
def test_what_is_said_to_be_bounded_is_at_most_1(group: Group) -> None:
    for seed in range(8):
        for stored in (far(group, seed), points.point(group, Random(seed))):
            sizes = zip(stored, bounded(group), strict=True)
            assert all(abs(x) <= 1 for x, is_bounded in sizes if is_bounded)


@pytest.mark.parametrize("name", GROUPS)
def test_on_groups_of_the_catalogue_nothing_else_is_bounded(name: str) -> None:
    """Translations grow: some element has one that is more than 1; rotations are all told."""
    group = ALL[name]
    drawn = [far(group, seed) for seed in range(12)]
    grows = tuple(any(abs(row[i]) > 1 for row in drawn) for i in range(group.size))
    assert bounded(group) == tuple(not one for one in grows)


def test_squares_bound_only_where_they_add_up_to_1() -> None:
    assert bounded(ALL["S3"]) == (True,) * 4
    assert bounded(ALL["SO3 x R3"]) == (True,) * 9 + (False,) * 3
    assert not any(bounded(ALL["SL2"]))
    assert bounded(ALL["R6"]) == (False,) * 6


def test_a_sum_of_three_products_is_not_held_to_be_bounded() -> None:
    """x y + z w is at most 1 where (x, z) and (y, w) are, as columns of a rotation are."""

    def rows(x: Matrix) -> Matrix:
        a, b, c, d, *others = x
        squares = a**2 + b**2 + c**2 + d**2 - 1, others[4] ** 2 - 1, others[3] ** 2 + 2
        bonds = others[0] - a * b, others[1] + c * d - a * b, others[2] - a * b - c * d - a * d
        return Matrix([*squares, *bonds])

    group = replace(ALL["SO3"], residual=rows)
    assert bounded(group) == (True,) * 6 + (False, False, True)


# How far off the group.


def drift(guard: Guarded, values: dict[str, Any]) -> Any:
    """Square of the distance of the error, as `control` computes it."""
    assert guard.drift is not None
    if guard.error is not None:
        values = values | exactly(guard.error, **values)
    ((found,),) = exactly(guard.drift, **values).values()
    return found


def is_open(guard: Guarded, group: Group) -> bool:
    """Whether all numbers near an element are elements, as on R^n; then there is no drift."""
    assert (guard.drift is None) == (group.dim == group.size)
    return guard.drift is None


@each_both
@each_seed
def test_on_the_group_there_is_no_drift(group: str, controller: str, seed: int) -> None:
    guard = derived(group, controller).guard
    if not is_open(guard, ALL[group]):
        assert abs(drift(guard, given(group, seed))) < LIMIT


@each_both
@pytest.mark.parametrize("name", ["g", "g_r"])
def test_any_one_number_off_the_group_is_drift(group: str, controller: str, name: str) -> None:
    """Each stored number of either configuration in turn, those of the bottom rows too."""
    guard, values, known = derived(group, controller).guard, given(group, 1), ALL[group]
    if is_open(guard, known) or (name == "g_r" and guard.error is None):
        return
    whole = points.embedded(known, values[name])
    for k in range(known.size):
        moved = [x + OFF * (i == k) for i, x in enumerate(values[name])]
        direction = points.solve(whole, points.embedded(known, moved) - whole)
        if not points.is_in_algebra(known, direction):
            assert drift(guard, values | {name: moved}) > SEEN, k


@pytest.mark.parametrize("group", ["SO3", "S3", "SO2"])
def test_both_scaled_oppositely_are_no_drift(group: str) -> None:
    """The error decides: no law can tell (2 g, g_r / 2) from (g, g_r)."""
    guard, values = derived(group, "gsmc").guard, given(group, 3)
    scaled = {"g": [2 * x for x in values["g"]], "g_r": [x / 2 for x in values["g_r"]]}
    assert abs(drift(guard, values | scaled)) < LIMIT
    assert drift(guard, values | {"g": scaled["g"]}) > 1
    assert drift(guard, values | {"g_r": scaled["g_r"]}) > 0.1
