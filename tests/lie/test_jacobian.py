"""The exact differential of the logarithm, on every group that has one, by three other ways."""

from random import Random
from typing import Any

import numpy as np
import pytest

from derive.lie.group import Group
from derive.lie.jacobian import spectrum
from derive.verify.oracle import matrix_function as function
from derive.verify.oracle.precise import mp
from tests import points
from tests.evaluation import exactly
from tests.groups import ALL
from tests.lie import written
from tests.lie.written import ANGLES, CHARTED, SHIFTS, UNTURNED, scale, split
from tests.oracle import distance, norm, truth
from tests.points import point, vector

LIMIT = mp.mpf("1e-60")
each_chart = pytest.mark.parametrize("name", CHARTED)


@each_chart
@pytest.mark.parametrize("seed", range(3))
def test_the_rate_is_that_of_matrices_along_the_flow(name: str, seed: int) -> None:
    """By central differences of 130 digits, and as f(ad_x) nu from the matrix ad_x alone."""
    group, known, rng = CHARTED[name], truth(CHARTED[name]), Random(seed)
    p, nu = point(group, rng), vector(rng, group.dim)
    out = exactly(written.logarithm(name), g=p, nu=nu)
    size = 1 + norm(out["rate"])
    assert distance(out["rate"], known.rate("log", known.matrix(p), nu)) < LIMIT * size
    assert distance(out["rate"], known.log_rate(out["log"], nu)) < LIMIT * size


@each_chart
@pytest.mark.parametrize("shift", SHIFTS)
@pytest.mark.parametrize("angle", ANGLES, ids=lambda angle: mp.nstr(angle, 3))
def test_in_double_it_keeps_its_digits(name: str, angle: Any, shift: float) -> None:
    """On the natural scale |v| + |p||omega| of each block, from what is stored in double."""
    group, known = CHARTED[name], truth(CHARTED[name])
    x = written.coordinates(name, 0 if name in UNTURNED else angle, shift, 5)
    row = written.stored(group, function.exp(known.hat(x)))
    lengths = [norm(part) for part in split(name, written.first(name, x))]
    for nu in np.random.default_rng(6).normal(size=(2, group.dim)):
        wanted = known.rate("log", written.onto(name, row), nu.tolist())
        found = written.run(name)(g=row, nu=nu)["rate"]
        turn, *moves = (norm(part) for part in split(name, written.first(name, map(mp.mpf, nu))))
        measures = [turn, *(v + p * turn for v, p in zip(moves, lengths[1:], strict=True))]
        sizes = scale(name, measures)
        if name == "Heisenberg":
            sizes = [1, 1, 1 + norm(x) * norm(nu.tolist())]
        for a, b, size in zip(found, wanted, sizes, strict=True):
            assert abs(mp.mpf(float(a)) - b) <= mp.mpf("1e-13") * size


KINDS = {
    "SO2": (1, 0), "SO3": (1, 1), "S3": (1, 1), "SE2": (1, 1), "SE3": (1, 2), "SE23": (1, 2),
    "R1": (1, 0), "R3": (1, 0), "R6": (1, 0), "Heisenberg": (2, 0),
    "Random0": (1, 1), "Random1": (1, 2), "Random2": (1, 1), "Random3": (1, 2),
}  # fmt: skip
"""The powers of x and of x^2 + phi^2 in the minimal polynomial of ad."""


def test_the_table_knows_every_group_with_a_logarithm() -> None:
    assert set(KINDS) == set(CHARTED)


@each_chart
def test_the_spectrum_is_that_of_the_table(name: str) -> None:
    kind = spectrum(CHARTED[name])
    assert (kind.zeros, kind.turns) == KINDS[name]


@each_chart
@pytest.mark.parametrize("seed", range(3))
def test_it_is_a_polynomial_that_ad_obeys_and_no_shorter_one(name: str, seed: int) -> None:
    """Exactly, at another point than the one it was found at."""
    group = CHARTED[name]
    A = adjoint(group, vector(Random(seed), group.dim))
    zeros, turns = KINDS[name]
    square = -(A @ A).trace() / np.linalg.matrix_rank(A.astype(float)) if turns else 0
    assert not value(A, square, zeros, turns).any()
    assert value(A, square, zeros - 1, turns).any()
    assert not turns or value(A, square, zeros, turns - 1).any()
    still = spectrum(group).still
    once = value(A, square, 1, 1)
    assert not any(once[i].any() for i in still)


def adjoint(group: Group, x: Any) -> Any:
    """ad_x of fractions, by commutators."""
    X = points.hat(group, x)
    return np.stack([points.vee(group, X @ e - e @ X) for e in points.rows(group)], axis=1)


def value(A: Any, square: Any, zeros: int, turns: int) -> Any:
    """A^zeros (A^2 + square)^turns."""
    found = points.eye(len(A))
    for factor in [A] * zeros + [A @ A + square * points.eye(len(A))] * turns:
        found = found @ factor
    return found


@pytest.mark.parametrize("name", ["SL2", "SO4", "Sim2", "GL2", "Aff1", "SL3", "Lorentz"])
def test_where_ad_has_other_eigenvalues_it_is_refused(name: str) -> None:
    with pytest.raises(ValueError, match=f"^{name}: ad has "):
        spectrum(ALL[name])
