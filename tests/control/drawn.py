"""What the tests of control run over and with: every law of every group, and exact numbers."""

from collections.abc import Sequence
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest

from derive.control.kinematic import KinematicLaw, laws_of
from derive.lie.group import Group
from tests import points
from tests.groups import ALL, REBASED
from tests.points import point, vector

LAWS: dict[tuple[str, str], KinematicLaw] = {
    (name, law): found for name, group in ALL.items() for law, found in laws_of(group).items()
}
"""Every law of every group that the tests run over."""

each_law = pytest.mark.parametrize(("group", "name"), LAWS, ids=map("-".join, LAWS))

Pattern = tuple[bool, ...]


def diagonal(size: int) -> list[int]:
    """Places of the diagonal in an upper triangle kept row by row."""
    return [i * size - i * (i - 1) // 2 for i in range(size)]


def full(group: Group) -> Pattern:
    return (True,) * (group.dim * (group.dim + 1) // 2)


def sparse(group: Group, seed: int = 1) -> Pattern:
    """The diagonal and about half of what is beside it."""
    rng, on = Random(seed), diagonal(group.dim)
    return tuple(place in on or rng.random() < 0.5 for place in range(len(full(group))))


def definite(group: Group, rng: Random, pattern: Pattern) -> list[Fraction]:
    """Upper triangle of an exact inertia of that pattern, its diagonal larger than the rest."""
    upper = [Fraction(rng.randint(-9, 9), 20) * there for there in pattern]
    for place in diagonal(group.dim):
        upper[place] = group.dim + Fraction(rng.randint(0, 20), 10)
    return upper


def square(upper: Sequence[Any]) -> Any:
    n = next(n for n in range(1, 30) if n * (n + 1) // 2 == len(upper))
    matrix = np.zeros((n, n), object)
    matrix[np.triu_indices(n)] = upper
    return np.triu(matrix) + np.triu(matrix, 1).T


def numbers(group: Group, seed: int, pattern: Pattern = ()) -> dict[str, Any]:
    """Exact inputs by name: gains, inertia, a state, a reference, and extras."""
    rng, n = Random(seed), group.dim
    named = ("nu", "nu_r", "nu_r_dot", "momentum", "external", "force")
    given: dict[str, Any] = {name: vector(rng, n) for name in named}
    given |= {name: point(group, rng) for name in ("g", "g_r")}
    gains = dict(
        zip(("rate_gain", "reach_gain"), (abs(x) + 1 for x in vector(rng, 2)), strict=True)
    )
    return {"inertia": definite(group, rng, pattern or full(group)), **gains, **given}


HALF_TURNS: dict[str, tuple[int, ...]] = {
    "SO2": (1,), "SO3": (2, 3, 6), "S3": (4, 6, 12), "SE2": (1, 0, 0), "SE3": (2, 3, 6, 0, 0, 0),
    "SE23": (2, 3, 6, 0, 0, 0, 0, 0, 0), "SL2": (1, -1, 0), "GL2": (0, 1, -1, 0),
    "SO4": (1, 0, 0, 0, 0, 0), "Sim2": (1, 0, 0, 0), "Lorentz": (0, 0, 1),
    "Random0": (1, 0, 0, 0, 0), "Random1": (2, 3, 6, 0, 0, 0), "Random2": (1, 0, 0),
    "Random3": (2, 3, 6, 0, 0, 0),
}  # fmt: skip
"""Coordinates, in the first basis, of a generator that turns: up to a factor, X^3 = -X."""


def turning(group: Group, tangent: Fraction | None) -> Any:
    """(1 + t X)(1 - t X)^-1: a turn by 2 atan t of the matrices; None for its end, 1 + 2 X^2.

    In a product the first factor that can turns, the others stay.
    """
    one = next((f for f in group.factors or (group,) if f.name in HALF_TURNS), None)
    if one is None:
        raise KeyError(group.name)
    x: Any = np.array([Fraction(a) for a in HALF_TURNS[one.name]])
    if one.name in REBASED:
        basis = REBASED[one.name].inv().tolist()
        x = np.array([[points.exact(b) for b in row] for row in basis]) @ x
    X = points.hat(one, list(x))
    length = {49: 7, 1: 1}[int(-(X @ X).trace() / np.linalg.matrix_rank(X.astype(float)))]
    X, unit = X / length, points.eye(len(X))
    g = unit + 2 * X @ X
    if tangent is not None:
        g = points.solve(unit - tangent * X, unit + tangent * X)
    pieces = ((f, points.stored(f, g) if f is one else map(Fraction, f.identity))
              for f in group.factors or (group,))  # fmt: skip
    return [x for _, piece in pieces for x in piece]


def beside(group: Group, stored: Sequence[Any], seed: int) -> list[Any]:
    """The same turn, carried elsewhere: h g h^-1."""
    h = points.element(group, Random(seed), far=False)
    g = points.embedded(group, stored)
    return points.stored(group, h @ g @ points.inverse(h))
