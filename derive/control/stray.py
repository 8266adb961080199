"""Ways off a group from its identity, each along one of the equations that the guard judges.

Where equations depend on each other, what depends on the one comes along.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy
from sympy import Expr, Matrix, Rational

from derive.control.guard import Guarded
from derive.routine.derivation import Derivation

FARTHEST, BENT = Rational(11, 100), Rational(1, 20)
"""How far a way is walked, a tenth more than the largest drift of all, and what it may be off."""

Place = tuple[str, int]
"""Holder of a configuration, and which of its numbers."""


@dataclass(frozen=True)
class Stray:
    """A step of length 1 off the group, to first order, in numbers of one configuration.

    shares: (which number, how much is added to it)
    """

    holder: str
    shares: tuple[tuple[int, float], ...]


def strays(identity: Sequence[Expr], guard: Guarded) -> list[Stray]:
    """One for each equation, the same ones once; none where every number is an element's.

    identity: as it is stored; both configurations are there. The state takes the step, unless
    the equation is of the reference alone. What bends by more than a twentieth on its way, or
    leaves the bounds of an entry, tells nothing of a largest drift and is left out.
    """
    if guard.drift is None:
        return []
    places, rows = _equations(identity, guard, guard.drift)
    start = {symbol: identity[index] for symbol, (_, index) in places.items()}
    slope = rows.jacobian([*places]).xreplace(start)
    found: dict[Stray, None] = {}
    for way in _ways(slope):
        step = _unit(way, slope * way, Matrix([*start.values()]))
        if _is_straight(rows, start, step, guard, places):
            found[_stray(step, list(places.values()))] = None
    return list(found)


def _equations(
    identity: Sequence[Expr], guard: Guarded, drift: Derivation
) -> tuple[dict[sympy.Symbol, Place], Matrix]:
    """What may move, and the equations as functions of it, (m, 1)."""
    sources = [*drift.inputs, *(guard.error.inputs if guard.error else ())]
    configurations = {q.name: q for q in sources if q.member == "g"}.values()
    named = drift.step("off").formula
    direct = Matrix(named).free_symbols
    places: dict[sympy.Symbol, Place] = {}
    known: dict[Expr, Expr] = {}
    for one in configurations:
        for index, symbol in enumerate(one.symbols()):
            if one.holder == "state" or symbol in direct:
                places[symbol] = (one.holder, index)
            else:
                known[symbol] = identity[index]
    for symbol, term in guard.error.terms() if guard.error else ():
        known[symbol] = term.xreplace(known)
    return places, Matrix([row.xreplace(known) for row in named])


def _ways(slope: Matrix) -> Iterator[Matrix]:
    """The shortest step along each row, and along no row that is independent of that one."""
    count = slope.rows
    if slope.rank() == count:
        every = slope.pinv()
        yield from (every[:, i] for i in range(count))
        return
    for i in range(count):
        if slope[i, :].is_zero_matrix:
            continue
        ordered = slope.extract([i, *(j for j in range(count) if j != i)], range(slope.cols))
        kept = ordered.T.rref()[1]
        yield ordered.extract(kept, range(slope.cols)).pinv()[:, 0]


def _unit(step: Matrix, off: Matrix, start: Matrix) -> Matrix:
    """The step by which it is off by 1, no entry of the identity growing by it on the whole."""
    square = off.dot(off)
    sign = -1 if step.dot(start) > 0 else 1
    return step.applyfunc(lambda x: Rational(sign * float(x) / math.sqrt(square)))


def _is_straight(
    rows: Matrix, start: dict[sympy.Symbol, Expr], step: Matrix, guard: Guarded,
    places: dict[sympy.Symbol, Place],
) -> bool:  # fmt: skip
    """Whether its end is as far off as it is long, and no entry there beyond its bound."""
    end = {symbol: x + FARTHEST * s for (symbol, x), s in zip(start.items(), step, strict=True)}
    off = rows.xreplace(end)
    is_within = all(
        abs(end[symbol]) <= 1 for symbol, (_, index) in places.items() if guard.is_bounded[index]
    )
    return is_within and abs(math.sqrt(off.dot(off)) / FARTHEST - 1) < BENT


def _stray(step: Matrix, places: Sequence[Place]) -> Stray:
    """Its numbers; no equation is of both configurations, so that one of them takes it all."""
    moved = [(*place, float(x)) for place, x in zip(places, step, strict=True) if x != 0]
    (holder,) = {holder for holder, _, _ in moved}
    return Stray(holder, tuple((index, share) for _, index, share in moved))
