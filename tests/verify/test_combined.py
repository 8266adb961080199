"""Golden vectors: each is what the oracle says with the inertia, and all kinds are there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

import pytest

from derive import selftest
from derive.control.kinematic import laws_of
from derive.vehicle import Vehicle, load
from derive.vehicle.group import group_of
from derive.verify.combined import Answer, Limits, answers
from derive.verify.golden import golden, is_known
from derive.verify.limits import EPS
from derive.verify.oracle import baseline_truth, matrix_truth, truth
from derive.verify.plant import Plant
from tests.verify.subjects import FILES, vehicle

VEHICLES = (
    *(load(path) for path in FILES),
    vehicle("SO3", "log", "pd_plus", ("external", "momentum")),
    vehicle("SO3", "log", "lsf", ("external", "momentum")),
    vehicle("SO2 x SE2", "log", "reaching", ("external",)),
    vehicle("Heisenberg", "skew", "gsmc", ("momentum",)),
)
ONE = VEHICLES[[path.stem for path in FILES].index("paper_so3")]

every_vehicle = pytest.mark.parametrize("one", VEHICLES, ids=lambda v: f"{v.name}_{v.controller}")


@cache
def kept(one: Vehicle) -> dict[str, Any]:
    law = laws_of(group_of(one))[one.law]
    return golden(selftest.plant_of(one), is_pole=law.is_pole, scalars=("f32", "f64"))


def found(one: Vehicle, scalar: str, limits: Limits | None = None) -> list[Answer | None]:
    given = (one.controller, one.inertia, one.gains, limits or Limits())
    return answers(kept(one), scalar, *given, is_own=one.own is not None)


def told(judged: Plant, scalar: str, given: dict[str, Any]) -> dict[str, Any]:
    """The oracle, with the paper's inverse inertia, on the numbers as that scalar stores them."""
    inertia, (first, second) = judged.stored(scalar)
    if judged.is_baseline:
        named = judged.named_gains(scalar)
        return baseline_truth.tracking(judged.controller, inertia, named, **given)
    if judged.is_attitude:
        write = truth.tracking if judged.has_reference else truth.reaching
        return write(judged.group, judged.law, inertia, first, second, **given)
    run = matrix_truth.tracking if judged.has_reference else matrix_truth.reaching
    return run(judged.space, judged.law, inertia, first, second, **given)


@every_vehicle
@pytest.mark.parametrize("scalar", ["f32", "f64"])
def test_what_is_put_together_is_the_oracles_answer(one: Vehicle, scalar: str) -> None:
    """To 40 digits of the largest term: force and s, the law and its rate."""
    judged = selftest.plant_of(one)
    rows = zip(kept(one)["rows"][scalar], found(one, scalar), strict=True)
    good = [(row, answer) for row, answer in rows if answer and answer.outputs]
    assert len(good) >= 6
    for row, answer in good[:: 5 if judged.is_attitude else 6]:
        exact = told(judged, scalar, row["given"])
        names = {"force", "s", "nu_u", *(["nu_u_dot"] if not judged.is_baseline else [])}
        assert set(answer.outputs) == names
        for name, (numbers, allowed) in answer.outputs.items():
            off = [abs(truth.mp.mpf(str(x)) - y) for x, y in zip(numbers, exact[name], strict=True)]
            assert max(off) <= 1e-32 * allowed, (row["doc"], name)
            assert allowed > 0


@every_vehicle
def test_every_input_is_spoilt_in_every_way(one: Vehicle) -> None:
    judged = selftest.plant_of(one)
    inputs = ["g", "nu", *one.options]
    inputs += ["g_r", "nu_r", "nu_r_dot"] if judged.has_reference else []
    for rows in kept(one)["rows"].values():
        docs = [row["doc"] for row in rows]
        for name in inputs:
            for what in ("not a number", "infinite", "out of range"):
                assert docs.count(f"{name} {what}") == 1
        for name in {"g", "g_r"} & {*inputs}:
            assert f"{name} off the group" in docs
        statuses = Counter(row["status"] for row in rows)
        assert statuses["NONFINITE_INPUT"] == 2 * len(inputs)
        assert statuses["OUT_OF_RANGE"] >= len(inputs)
        assert statuses["NOT_ON_GROUP"] >= 1
        assert statuses["OK"] >= 6


def test_the_ladder_reaches_from_nothing_to_either_side_of_the_cut() -> None:
    """The angle and the side, found again from the stored numbers by the quaternion oracle."""
    for scalar, close in (("f32", 1e-4), ("f64", 1e-8)):
        angles, docs = [], []
        for row in kept(ONE)["rows"][scalar]:
            if row["known"]:
                q = truth.error("SO3", row["given"]["g_r"], row["given"]["g"])
                angles.append(float(2 * truth.mp.acos(abs(q[0]))))
                docs.append(row["doc"])
        assert min(angles) < 1e-12
        far = sorted(float(truth.mp.pi) - angle for angle in angles)
        assert far[:3] == [0, 0, 0]
        assert 0 < far[3] < close
        for rest in ("1e-2", "1e-3", {"f32": "1e-5", "f64": "1e-9"}[scalar]):
            for side in ("before", "beyond"):
                assert f"error {rest} rad {side} the cut, moving reference" in docs


def test_both_signs_of_a_quaternion_are_there() -> None:
    quadrotor = next(v for v in VEHICLES if v.name == "quadrotor")
    for rows in kept(quadrotor)["rows"].values():
        for name in ("g", "g_r"):
            signs = {row["given"][name][0] > 0 for row in rows if row["known"]}
            assert signs == ({True, False} if name == "g" else {True})


def test_a_group_that_no_oracle_knows_has_no_golden_vectors() -> None:
    assert is_known(selftest.plant_of(ONE))
    assert not is_known(Plant("Random0", "log", (), ()))


def largest(answer: Answer) -> Decimal:
    return max(map(abs, answer.outputs["force"][0]))


def held_to(force: Sequence[Decimal], most: Sequence[int], keeps_direction: bool) -> list[Decimal]:
    """The force within its limits, in 28 digits."""
    shares = [Decimal(y) / abs(x) for x, y in zip(force, most, strict=True)]
    share = min([Decimal(1), *shares])
    if keeps_direction:
        return [x * share for x in force]
    return [max(Decimal(-y), min(Decimal(y), x)) for x, y in zip(force, most, strict=True)]


@pytest.mark.parametrize("scalar", ["f32", "f64"])
@pytest.mark.parametrize("keeps_direction", [True, False])
def test_what_is_allowed_of_a_held_force_follows_it(keeps_direction: bool, scalar: str) -> None:
    """Errors either way of the free force stay within what is allowed, which is not much more."""
    most, seen = (2, 3, 1), 0
    limits = Limits([Fraction(x) for x in most], keeps_direction)
    for plain, held in zip(found(ONE, scalar), found(ONE, scalar, limits), strict=True):
        if not plain or not held or not plain.outputs or plain.outputs == held.outputs:
            continue
        (force, error), (kept, allowed) = plain.outputs["force"], held.outputs["force"]
        worst = Decimal(0)
        for signs in product((-1, 0, 1), repeat=3):
            moved = [x + sign * Decimal(error) for x, sign in zip(force, signs, strict=True)]
            other = held_to(moved, most, keeps_direction)
            worst = max(worst, *(abs(x - y) for x, y in zip(other, kept, strict=True)))
        assert worst <= Decimal(allowed) * (1 + Decimal("1e-12"))
        rounding = 5 * EPS[scalar] * float(max(map(abs, kept)))
        assert allowed <= 4 * float(worst) + 1.01 * rounding if keeps_direction else error
        seen += 1
    assert seen >= 10


@pytest.mark.parametrize("keeps_direction", [True, False])
def test_a_force_is_held_to_its_limits_in_truth_too(keeps_direction: bool) -> None:
    limits = Limits((Fraction(2), Fraction(3), Fraction(1)), keeps_direction)
    free = found(ONE, "f64")
    seen = Counter[str]()
    for plain, held in zip(free, found(ONE, "f64", limits), strict=True):
        if not plain or not plain.outputs or not held:
            continue
        a, b = plain.outputs["force"][0], held.outputs["force"][0]
        inside = all(abs(x) <= y for x, y in zip(a, (2, 3, 1), strict=True))
        seen[held.status] += 1
        assert held.status == (plain.status if inside or plain.status != "OK" else "SATURATED")
        assert all(abs(x) <= y for x, y in zip(b, (2, 3, 1), strict=True))
        if inside:
            assert a == b
        elif keeps_direction:
            share = [y / x for x, y in zip(a, b, strict=True)]
            assert max(share) - min(share) < Decimal("1e-25")
        else:
            assert b == [
                max(-y, min(y, x)) for x, y in zip(a, map(Decimal, (2, 3, 1)), strict=True)
            ]
    assert seen["OK"] >= 1
    assert seen["SATURATED"] >= 10
