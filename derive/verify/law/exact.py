"""Exact values of a derivation, and exact elements of a group: nothing is rounded.

Elements in general position come from Cayley's map. Those that turn by exactly pi, or by 2 pi on
S3, come from exp(t X) = 1 + sin(c t)/c X + (1 - cos(c t))/c^2 X^2, which holds where
X^3 = -c^2 X.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache

import sympy
from sympy import Expr, Matrix, Rational

from derive.control.matrix_law import keeps_odd_powers
from derive.lie.group import Group
from derive.lie.kernel import CONSTANTS, Arc, K
from derive.routine.derivation import Derivation
from derive.verify.law.space import turning

AXES = ((1, 0, 0), (0, 1, 0), (Rational(3, 5), Rational(-4, 5), 0),
        (Rational(2, 3), Rational(-1, 3), Rational(2, 3)))  # fmt: skip
SCALES = (Rational(1, 3), 1, 3, 12)  # of the argument of Cayley's map: near e, and far beyond


@dataclass(frozen=True)
class Point:
    """An exact element (m, m), and where it is: `` in general position, pi, 2 pi."""

    g: Matrix
    where: str


def outputs(d: Derivation, given: Mapping[str, Matrix | Expr]) -> dict[str, list[Expr]]:
    """Outputs by name; kernel functions stay symbols, but for s^2 h = 1 - w k."""
    known: dict[Expr, Expr] = dict.fromkeys(CONSTANTS, sympy.S.Zero)
    for quantity in d.inputs:
        value = given[quantity.name]
        row = [value] if quantity.is_scalar else list(value)
        known |= zip(quantity.symbols(), map(sympy.sympify, row), strict=True)
    for symbol, term in d.terms():
        known[symbol] = _known(term, known)
    return {
        quantity.name: [_reduced(_known(entry, known)) for entry in entries]
        for quantity, entries in d.outputs
    }


def _known(term: Expr, known: Mapping[Expr, Expr]) -> Expr:
    """A term with its symbols replaced; of a choice, only the case that holds."""
    if isinstance(term, sympy.Piecewise):
        for value, condition in term.args:
            if condition.xreplace(known) == sympy.true:
                return _known(value, known)
    found: Expr = term.xreplace(known)
    return found


def _reduced(value: Expr) -> Expr:
    """h in terms of k, both 1 at the identity."""
    calls = [call for call in value.atoms(Arc) if call.args[0] == 1]
    swap = {call: _h(call.args[1]) for call in calls}
    found: Expr = value.xreplace(swap).xreplace({K(sympy.S.One): sympy.S.One})
    return found


def _h(w: Expr) -> Expr:
    return Rational(1, 3) if w == 1 else (1 - w * K(w)) / (1 - w**2)


def vanishes(values: list[Expr]) -> bool:
    """Whether all are zero, decided exactly."""
    return all(value == 0 or sympy.simplify(sympy.expand(value)) == 0 for value in values)


@cache
def general(group: Group, count: int = 4, seed: int = 0) -> tuple[Point, ...]:
    """Elements in general position, of small and large angles; none where Cayley's map fails."""
    rng = random.Random(seed)
    scales = [SCALES[i % len(SCALES)] for i in range(count)]
    found = (_cayley(group, scale, rng) for scale in scales)
    return tuple(Point(g, "") for g in found if g is not None)


def _cayley(group: Group, scale: Rational, rng: random.Random) -> Matrix | None:
    """(1 - X/2)^-1 (1 + X/2), an odd series in X for its logarithm; None where that leaves it."""
    x = Matrix([Rational(rng.randint(-9, 9), 7) for _ in range(group.dim)])
    half = group.hat(scale * x) / 2
    one = half**0
    if not keeps_odd_powers(group) or (one - half).det() == 0:
        return None
    return Matrix((one - half).inv() * (one + half))


@cache
def turned(group: Group) -> tuple[Point, ...]:
    """Elements one factor of which turns by pi, or by 2 pi where that is not the identity."""
    return tuple(_turned(group))


def _turned(group: Group) -> Iterator[Point]:
    for X in _generators(group):
        square = _rate_squared(X)
        one = X**0
        c = sympy.sqrt(square)
        for angle, where in ((sympy.pi, "pi"), (2 * sympy.pi, "2 pi")):
            g = one + sympy.sin(c * angle) / c * X + (1 - sympy.cos(c * angle)) / square * X**2
            if g != one:
                yield Point(Matrix(g), where)


def _generators(group: Group) -> Iterator[Matrix]:
    """hat of unit rotations about rational axes, translations across the axis along."""
    first = 0
    for factor in group.factors or (group,):
        count = turning(factor)
        for axis in AXES if count == 3 else AXES[:count]:
            turn = [sympy.sympify(a) for a in axis[:count]]
            for shift in (0, 2) if factor.dim > count else (0,):
                moves = _across(turn, factor.dim - count, shift)
                x = [sympy.S.Zero] * group.dim
                x[first : first + factor.dim] = [*turn, *moves]
                X = group.hat(Matrix(x))
                if -_rate_squared(X) * X == X**3 and any(X):
                    yield X
        first += factor.dim


def _across(turn: list[Expr], count: int, shift: int) -> list[Expr]:
    """Translations at right angles to the axis, shift long but for the length of the axis."""
    if not shift:
        return [sympy.S.Zero] * count
    if len(turn) < 3:
        return [sympy.Integer(shift)] * count
    across = Matrix(turn).cross(Matrix([1, 2, -1]))
    return list(shift * across) * (count // 3) + [sympy.S.Zero] * (count % 3)


def _rate_squared(X: Matrix) -> Expr:
    """c^2 of X^3 = -c^2 X, from the traces."""
    square, fourth = (X**2).trace(), (X**4).trace()
    return -fourth / square if square else sympy.S.Zero
