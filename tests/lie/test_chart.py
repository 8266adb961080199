"""The logarithm of every group that has one, in double, against matrices of 130 digits."""

from random import Random
from typing import Any

import numpy as np
import pytest

from derive.verify.oracle import matrix_function as function
from derive.verify.oracle import matrix_truth
from derive.verify.oracle.precise import mp
from tests.evaluation import exactly
from tests.groups import REBASED
from tests.lie import written
from tests.lie.written import ANGLES, CHARTED, SHIFTS, UNTURNED, scale, split
from tests.oracle import distance, norm, truth
from tests.points import point, vector

LIMIT = mp.mpf("1e-13")
each_chart = pytest.mark.parametrize("name", CHARTED)
each_shift = pytest.mark.parametrize("shift", SHIFTS)


def sizes(name: str, x: Any) -> list[Any]:
    """The length of each block in the first basis."""
    return [norm(part) for part in split(name, written.first(name, x))]


def assert_near(found: Any, wanted: Any, measures: list[Any]) -> None:
    for x, y, size in zip(found, wanted, measures, strict=True):
        assert abs(mp.mpf(float(x)) - y) <= LIMIT * size, (float(x), float(y), float(size))


@each_chart
@pytest.mark.parametrize("seed", range(4))
def test_it_is_the_logarithm_of_the_matrix(name: str, seed: int) -> None:
    group = CHARTED[name]
    p = point(group, Random(seed))
    known = truth(group)
    found = exactly(written.logarithm(name), g=p, nu=vector(Random(seed), group.dim))["log"]
    assert distance(found, known.log(known.matrix(p))) < mp.mpf("1e-60")


@each_chart
@each_shift
@pytest.mark.parametrize("angle", ANGLES, ids=lambda angle: mp.nstr(angle, 3))
def test_log_inverts_exp(name: str, angle: Any, shift: float) -> None:
    """Block by block, of the rotation nearest to what is stored in double."""
    group, known = CHARTED[name], truth(CHARTED[name])
    for seed in range(3):
        x = written.coordinates(name, 0 if name in UNTURNED else angle, shift, seed)
        row = written.stored(group, function.exp(known.hat(x)))
        wanted = known.log(written.onto(name, row))
        found = written.run(name)(g=row, nu=np.zeros(group.dim))["log"]
        assert_near(found, wanted, measures(name, wanted))
        assert distance(wanted, x) <= mp.mpf("1e-9") * norm(x)


def measures(name: str, x: Any) -> list[Any]:
    """The length of its block, or of what ends in it where a series is summed."""
    if name == "Heisenberg":
        return [abs(x[0]), abs(x[1]), abs(x[2]) + abs(x[0] * x[1])]
    if name[0] == "R" and name[1:].isdigit():
        return [abs(a) for a in x]
    return list(scale(name, sizes(name, x)))


AT_PI = [
    (name, shift)
    for name in CHARTED
    for shift in SHIFTS
    if name not in UNTURNED and name != "S3" and (shift <= 1 or name not in REBASED)
]
"""Where a basis mixes a long translation into every coordinate, its rounding turns the element."""


@pytest.mark.parametrize(("name", "shift"), AT_PI)
def test_at_pi_the_exponential_of_the_logarithm_is_the_element(name: str, shift: float) -> None:
    """Either side is right there: what is found leads back to where it came from."""
    group, known = CHARTED[name], truth(CHARTED[name])
    for seed in range(4):
        x = written.coordinates(name, mp.pi, shift, seed)
        row = written.stored(group, function.exp(known.hat(x)))
        found = written.run(name)(g=row, nu=np.zeros(group.dim))["log"]
        back = function.exp(known.hat([float(a) for a in found]))
        errors = np.abs(np.array(back, float) - np.array(known.matrix(row), float))
        assert errors.max() < 1e-14 * written.spread(name) * max(1, shift)
        turn = sizes(name, list(map(mp.mpf, found.tolist())))[0]
        assert abs(turn - mp.pi) < 1e-14 * written.spread(name)


@pytest.mark.parametrize("name", sorted(set(CHARTED) & {"SO2", "SO3", "S3", "SE2", "SE3", "SE23"}))
def test_the_truth_of_the_tests_is_that_of_the_product(name: str) -> None:
    """Two truths, of which one knows a basis and the other the conventions."""
    group, known = CHARTED[name], truth(CHARTED[name])
    assert known.basis == list(matrix_truth.basis(name))
    p, nu = point(group, Random(7)), vector(Random(8), group.dim)
    g = matrix_truth.element(name, p)
    for law in ("log", "skew", "cayley"):
        assert distance(known.law(law, known.matrix(p)), matrix_truth.law(name, law, g)) < 1e-60
        rates = known.rate(law, known.matrix(p), nu), matrix_truth.rate(name, g, nu, law)
        assert distance(*rates) < 1e-60
