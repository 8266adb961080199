"""The logarithm of a group and its exact rate, written as a derivation of their own."""

from functools import cache
from typing import Any

import numpy as np

from derive.lie.group import Group
from derive.lie.jacobian import log_rate
from derive.routine.derivation import Derivation, Quantity
from derive.verify.oracle import matrix_function as function
from derive.verify.oracle.precise import exactly, mp
from tests import points
from tests.evaluation import in_double
from tests.groups import ALL, REBASED, TURNED
from tests.oracle import norm, truth
from tests.points import exact

CHARTED = {name: group for name, group in ALL.items() if group.chart}
"""Groups with a logarithm of their own; that of a product is those of its factors."""

ANGLES = (0, 1e-300, 1e-8, 1e-3, 1, mp.pi - mp.mpf("1e-6"))
SHIFTS = (1e-6, 1, 1e6)

UNTURNED = {"R1", "R3", "R6", "Heisenberg"}
"""Groups whose elements have no rotation."""


def quantity(name: str, size: int) -> Quantity:
    return Quantity(name, size, "1", name, place=name)


@cache
def logarithm(name: str) -> Derivation:
    """(g, nu) -> log g and its rate along g' = g hat(nu)."""
    group = CHARTED[name]
    assert group.chart is not None
    d = Derivation("logarithm", "", "")
    g, nu = d.take(quantity("g", group.size)), d.take(quantity("nu", group.dim))
    chart = group.chart(d.let, g)
    d.give(quantity("log", group.dim), d.let("x", chart.log, "1", ""))
    d.give(quantity("rate", group.dim), d.let("x_dot", log_rate(d.let, group, chart, nu), "1", ""))
    return d.pruned()


@cache
def run(name: str) -> Any:
    """The same in double."""
    return in_double(logarithm(name))


def split(name: str, x: Any) -> list[Any]:
    """The blocks of coordinates in the group's first basis: what turns, then each translation."""
    turn = TURNED.get(name, 3 if name == "S3" else 0)
    size, width, x = 1 if turn == 2 else turn, turn or 1, list(x)
    return [x[:size], *(x[i : i + width] for i in range(size, len(x), width))]


def first(name: str, x: Any) -> Any:
    """Coordinates in the basis before the random one."""
    return _mixed(REBASED[name], x) if name in REBASED else list(x)


def rebased(name: str, x: Any) -> Any:
    """And back."""
    return _mixed(REBASED[name].inv(), x) if name in REBASED else list(x)


def _mixed(basis: Any, x: Any) -> list[Any]:
    """An exact matrix times numbers of 130 digits."""
    row, rows = list(x), basis.tolist()
    return [mp.fsum(exactly(exact(b)) * a for b, a in zip(one, row, strict=True)) for one in rows]


def scale(name: str, sizes: list[Any]) -> list[Any]:
    """What a coordinate is measured by, from a size of each block of the first basis."""
    blocks = split(name, range(CHARTED[name].dim))
    each: list[Any] = [size for size, part in zip(sizes, blocks, strict=True) for _ in part]
    if name not in REBASED:
        return each
    return _mixed(REBASED[name].inv().applyfunc(abs), each)


def coordinates(name: str, angle: Any, shift: Any, seed: int) -> list[Any]:
    """A rotation by that angle about some axis, and translations of about that length."""
    random = np.random.default_rng(seed)
    turn, *shifts = split(name, random.normal(size=CHARTED[name].dim))
    lengths = [angle, *(shift for _ in shifts)]
    parts = zip((turn, *shifts), lengths, strict=True)
    x = [
        exactly(a) * length / norm(list(map(exactly, part))) for part, length in parts for a in part
    ]
    return list(rebased(name, x))


def onto(name: str, stored: Any) -> Any:
    """Stored doubles, exactly, with the rotation put on the group."""
    g = truth(CHARTED[name]).matrix(stored)
    size = 4 if name == "S3" else TURNED.get(name, 0)
    if not size:
        return g
    corner = function.orthogonal_nearest(tuple(row[:size] for row in g[:size]))
    return (*((*a, *b[size:]) for a, b in zip(corner, g, strict=False)), *g[size:])


def stored(group: Group, g: Any) -> Any:
    """An element of 130 digits, as doubles."""
    return np.array([float(x) for x in points.stored(group, np.array(g, object))])


def spread(name: str) -> float:
    """By how much rounding in the random basis is larger than in the first: |B| |B^-1|."""
    if name not in REBASED:
        return 1.0
    basis = np.array(REBASED[name].tolist(), float)
    return float((np.abs(basis) @ np.abs(np.linalg.inv(basis))).sum(1).max())
