"""Kinematic laws of one factor and their rates, with 130 digits, on either side of the cut.

A rotation is the unit quaternion (w, v) of `truth`, and (-w, -v) across the cut. What it carries
has the logarithm V^-1 T, where exp X = R and V is the mean of exp(t X). Rates are central
differences along the flow.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from derive.verify.oracle import matrix_function as function
from derive.verify.oracle import truth
from derive.verify.oracle.matrix_factor import Factor
from derive.verify.oracle.matrix_function import Matrix, Number, Vector, combine, identity, product
from derive.verify.oracle.matrix_group import LAWS, STEP, moved
from derive.verify.oracle.own_factor import Own
from derive.verify.oracle.precise import Quaternion, mp, negative, quaternion

GROUPING = 9  # 81 terms of either half of the series: the last is below 1e-130
_EVEN, _ODD = ([1 / mp.factorial(2 * k + n) for k in range(GROUPING**2)] for n in (1, 2))


@dataclass(frozen=True)
class Lifted:
    """An element of a factor, (m, m), and the quaternion of its rotation, if it has one."""

    one: Factor | Own
    matrix: Matrix
    q: Quaternion | None


def lifted(one: Factor | Own, a: Matrix, *, flip: bool = False) -> Lifted:
    """The element on the side that the conventions name, or across the cut, where one is."""
    q = _quaternion(one, a) if isinstance(one, Factor) and one.turns else None
    return Lifted(one, a, negative(q) if flip and q and one.sheets == 1 else q)


def _quaternion(one: Factor, a: Matrix) -> Quaternion:
    block, _ = one.parts(a)
    if one.sheets == 2:
        return tuple(row[0] for row in block)
    if one.size == 2:
        block = (*((*row, mp.zero) for row in block), (mp.zero, mp.zero, mp.one))
    return quaternion(block)


def law(at: Lifted, which: str) -> Vector:
    """nu_u, (n,); of R^n the element itself, whatever the law."""
    one = at.one
    if at.q is None:
        return _still(at, which)
    if _is_turn(one, which):
        return _coordinates(one, truth.law(_kind(one), which, at.q))
    return _log(one, at.q, at.matrix) if which == "log" else LAWS[which](one, at.matrix)


def rate(at: Lifted, which: str, nu: Vector) -> Vector:
    """d/dt nu_u along g exp(t hat(nu)) at t = 0, (n,)."""
    one, speed = at.one, max(map(abs, nu))
    if not speed:
        return nu
    if at.q is not None and _is_turn(one, which):
        return _coordinates(one, truth.rate(_kind(one), which, at.q, _spatial(one, nu)))
    step = STEP / speed
    ahead, behind = (law(_flown(at, nu, time), which) for time in (step, -step))
    return tuple((x - y) / (2 * step) for x, y in zip(ahead, behind, strict=True))


def turning(at: Lifted, which: str, nu: Vector) -> tuple[Vector, Vector]:
    """The law of the rotation alone and its rate, in its coordinates; empty where none is."""
    one = at.one
    if at.q is None:
        return (), ()
    speed, kind = _spatial(one, nu), _kind(one)
    value, growth = truth.law(kind, which, at.q), truth.rate(kind, which, at.q, speed)
    return _coordinates(one, value), _coordinates(one, growth)


def _still(at: Lifted, which: str) -> Vector:
    one = at.one
    if isinstance(one, Own):
        return LAWS[which](one, at.matrix)
    return _by_columns(one.parts(at.matrix)[1])


def _flown(at: Lifted, nu: Vector, time: Number) -> Lifted:
    """The same element a time later, its quaternion flowing with it."""
    one, q = at.one, at.q
    if q is not None:
        q = truth.flow(q, _spatial(one, nu[: len(one.turns)]), time)
    return Lifted(one, moved(one, at.matrix, nu, time), q)


def _log(one: Factor | Own, q: Quaternion, a: Matrix) -> Vector:
    """(x, V^-1 T) with x the rotation vector."""
    assert isinstance(one, Factor)
    x = _coordinates(one, truth.law("SO3", "log", q))
    _, columns = one.parts(a)
    turned, _ = function.solve(average(combine(*zip(x, one.turns, strict=True))), columns)
    return (*x, *_by_columns(turned))


def average(X: Matrix) -> Matrix:
    """V, the mean of exp(t X) over t from 0 to 1: the sum of X^k/(k + 1)!, for |X| below 2 pi."""
    square = product(X, X)
    powers = [identity(len(X))]
    for _ in range(GROUPING):
        powers.append(product(powers[-1], square))
    *low, high = powers
    even, odd = (_grouped(low, high, terms) for terms in (_EVEN, _ODD))
    return combine((1, even), (1, product(X, odd)))


def _grouped(low: Sequence[Matrix], high: Matrix, terms: Sequence[Number]) -> Matrix:
    """The sum of terms times powers, the powers in groups: few products instead of many."""
    total: Matrix | None = None
    for start in reversed(range(0, len(terms), GROUPING)):
        share = combine(*zip(terms[start : start + GROUPING], low, strict=True))
        total = share if total is None else combine((1, product(total, high)), (1, share))
    return total or high


def _by_columns(columns: Matrix) -> Vector:
    return tuple(entry for column in function.transpose(columns) for entry in column)


def _kind(one: Factor | Own) -> str:
    return "S3" if one.sheets == 2 else "SO3"


def _coordinates(one: Factor | Own, x: Vector) -> Vector:
    """A rotation vector in the coordinates of the factor: in the plane the third alone."""
    return x[-len(one.turns) :]


def _is_turn(one: Factor | Own, which: str) -> bool:
    """Whether the law is one of quaternions alone."""
    return not one.columns and (_kind(one), which) in truth.LAWS


def _spatial(one: Factor | Own, x: Sequence[Number]) -> Vector:
    """The other way round."""
    return (mp.zero,) * (3 - len(one.turns)) + tuple(x[: len(one.turns)])
