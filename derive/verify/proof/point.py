"""Exact points of a group, and the formulas of the emitted code evaluated there, exactly.

With phi the angle of rotation, C and S cosine and sine of its half, everything that the code
computes is algebraic in phi^2, C, S/phi and the coordinates, which obey C^2 + S^2 = 1 and no
other relation. So the kernel has rational values at rational points, k = phi/(2 S), h and m from
s^2 h = 1 - w k and s^2 m = k - 3 w h, and so has each step: roots are of squares, cases are
decided, pi is one more free number. An identity that holds at random points of a set of N per
coordinate is wrong with a probability of at most its degree over N (Schwartz and Zippel).
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy
from sympy import Expr, Matrix, Rational, Symbol

from derive.lie.group import Group
from derive.lie.kernel import CONSTANTS
from derive.routine.derivation import Derivation
from derive.verify.proof.dual import NOTHING, Dual, Kernel, Walk, exact
from derive.verify.proof.exponential import STILL, Turn, exponential, square_of_pair
from derive.verify.proof.model import N, element, number, numbers

PI = Rational(random.Random("pi").randrange(N), N) + 3
"""A free number in the place of pi."""


@dataclass(frozen=True)
class Point:
    """An element and, where it is an exponential, its logarithm.

    x:      logarithm, (n, 1); None for an element reached in another way
    stored: its stored numbers, (k, 1)
    turns:  of the matrix hat(x), one for each factor of a product
    halves: of half of phi, whose cosine is w, one for each factor
    kernel: values of the kernel's functions there, by order and w
    """

    stored: Matrix
    x: Matrix | None = None
    turns: tuple[Turn, ...] = ()
    halves: tuple[Turn, ...] = ()
    kernel: Kernel = field(default_factory=dict)


def points(group: Group, count: int, seed: int = 0) -> Iterator[Point]:
    """Random points, exponentials on groups and factors with a chart; ValueError for none.

    Which coordinate is the largest, and how far the element is from the identity, goes round, so
    that they meet every branch of a logarithm.
    """
    rng = random.Random(f"{group.name} {seed}")
    for turn in range(count):
        yield _point(group, rng, turn)


def _point(group: Group, rng: random.Random, place: int) -> Point:
    if group.factors:
        return _joined([_point(factor, rng, place) for factor in group.factors])
    if group.chart is None:
        return Point(group.store(element(group, rng)))
    x = _rational_axis(rng) if group.is_rotation else numbers(group.dim, rng)
    first = place % min(group.dim, 3)
    x[0], x[first] = x[first], 3 * x[0]
    inner = square_of_pair(group.hat(x))
    if not inner:
        return Point(group.store(exponential(group.hat(x))), x, (STILL,), (STILL,))
    outer = square_of_pair(group.ad(x)) or inner
    is_double = inner != outer
    half = _half(outer / 4, rng, is_near=place % 4 == 3, is_beyond=is_double and place % 2 == 1)
    turn = half if is_double else half.double
    stored = group.store(exponential(group.hat(x), turn))
    return Point(stored, x, (turn,), (half,), _kernel(half))


def _rational_axis(rng: random.Random) -> Matrix:
    """A vector of rational length when its first entry is tripled, (3, 1)."""
    a, b = number(rng) / 4, number(rng) / 4
    return number(rng) * Matrix([(1 - a**2 - b**2) / 3, 2 * a, 2 * b]) / (1 + a**2 + b**2)


def _half(square: Rational, rng: random.Random, *, is_near: bool, is_beyond: bool) -> Turn:
    """Of half of phi, square = phi^2/4: its cosine above 1/2, from 0 to 1/2, or below 0."""
    start, width = (
        (Rational(1, 20), Rational(1, 2)) if is_near else (Rational(3, 5), Rational(3, 8))
    )
    slope = (start + width * abs(number(rng))) / _root(square)
    return Turn.at(square, 1 / (square * slope) if is_beyond else slope)


def _root(square: Rational) -> Rational:
    """A rational number near the root, to spread the angles."""
    return Rational(sympy.integer_nthroot(int(square * 2**40), 2)[0] + 1, 2**20)


def _kernel(half: Turn) -> Kernel:
    """k, h and m at w, and at |w|: k(-w) = pi/s - k(w)."""
    w, square = half.cosine, half.square * half.sine**2
    values = _family(w, square, 1 / half.sine)
    if w < 0:
        values |= _family(-w, square, PI / sympy.sqrt(square) - 1 / half.sine)
    return values


def _family(w: Rational, square: Rational, k: Rational) -> dict[tuple[int, Any], Any]:
    h = (1 - w * k) / square
    family = (k, h, (k - 3 * w * h) / square)
    return {(order, exact(w)): exact(value) for order, value in enumerate(family)}


def _joined(parts: Sequence[Point]) -> Point:
    """Of a direct product."""
    logs = [part.x for part in parts]
    x = None if any(one is None for one in logs) else Matrix.vstack(*logs)
    kernel = {place: value for part in parts for place, value in part.kernel.items()}
    turns = tuple(turn for part in parts for turn in part.turns)
    halves = tuple(half for part in parts for half in part.halves)
    return Point(Matrix.vstack(*(part.stored for part in parts)), x, turns, halves, kernel)


def evaluated(
    d: Derivation,
    values: Mapping[Expr, Any],
    point: Point,
    rates: Mapping[Expr, Any] | None = None,
) -> dict[Symbol, Dual]:
    """Value and rate of every symbol; an input without a rate rests."""
    moves = rates or {}
    known = {one: (exact(x), exact(moves.get(one, sympy.S.Zero))) for one, x in values.items()}
    known |= dict.fromkeys(CONSTANTS, (NOTHING, NOTHING))
    walk = Walk(known, point.kernel, exact(PI))
    for symbol, term in d.terms():
        known[symbol] = walk(term)
    return known


def assigned(symbols: Iterable[Symbol], values: Iterable[Any]) -> dict[Expr, Any]:
    """Symbols with their values."""
    return dict(zip(symbols, values, strict=True))
