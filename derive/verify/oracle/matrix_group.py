"""Any group by its name or basis: exp, log, adjoints and rates with 130 digits.

An element is a tuple with one matrix per factor; a user's group is one factor. Nothing is
differentiated by hand: a rate is a central difference along g exp(t hat(nu)), and a logarithm is
that of the matrix.
"""

from collections.abc import Callable, Sequence
from functools import cache
from itertools import accumulate, pairwise
from typing import Any

from derive.verify.oracle import matrix_function as function
from derive.verify.oracle.matrix_factor import Factor
from derive.verify.oracle.matrix_factor import factors as named
from derive.verify.oracle.matrix_function import (
    Matrix,
    Number,
    Vector,
    combine,
    identity,
    numbers,
    product,
)
from derive.verify.oracle.own_factor import Own
from derive.verify.oracle.precise import exactly, mp

Element = tuple[Matrix, ...]
Law = Callable[[Factor | Own, Matrix], Vector]
Basis = tuple[tuple[tuple[Any, ...], ...], ...]  # n matrices (m, m), exact and hashable
Name = str | Basis

# A step h costs h^2 in truncation and 1e-130 / h in rounding: here 1e-84 and 1e-88.
STEP = mp.mpf(10) ** -42


def split(values: Sequence[Any], sizes: Sequence[int]) -> list[Vector]:
    """Numbers, taken exactly, in consecutive pieces of these sizes."""
    if len(values) != sum(sizes):
        raise ValueError(f"{sum(sizes)} numbers are expected, not {len(values)}")
    exact = numbers(values)
    return [exact[a:b] for a, b in pairwise(accumulate(sizes, initial=0))]


@cache
def factors(name: Name) -> tuple[Factor | Own, ...]:
    """The factors of a group: of a user's, given by its basis, the one there is."""
    if isinstance(name, str):
        return named(name)
    return (Own(tuple(tuple(tuple(map(exactly, row)) for row in e) for e in name)),)


def coordinates(name: Name, x: Sequence[Any]) -> list[tuple[Factor | Own, Vector]]:
    """Each factor with its part of the coordinates (n,)."""
    parts = factors(name)
    return list(zip(parts, split(x, [one.dim for one in parts]), strict=True))


def _joined(pieces: Any) -> Vector:
    return tuple(entry for piece in pieces for entry in piece)


def dim(name: Name) -> int:
    """n, dimension of the algebra."""
    return sum(one.dim for one in factors(name))


def whole(g: Element) -> Matrix:
    """The block-diagonal matrix of all factors, (m, m)."""
    width, before, rows = sum(map(len, g)), 0, []
    for block in g:
        after = width - before - len(block)
        rows += [(mp.zero,) * before + row + (mp.zero,) * after for row in block]
        before += len(block)
    return tuple(rows)


def basis(name: Name) -> tuple[Matrix, ...]:
    """The n generators of the algebra, block-diagonal, (m, m) each."""
    n = dim(name)
    return tuple(whole(hat(name, [int(i == j) for j in range(n)])) for i in range(n))


def hat(name: Name, x: Sequence[Any]) -> Element:
    """Coordinates (n,) to the matrices of the algebra."""
    return tuple(one.hat(part) for one, part in coordinates(name, x))


def vee(name: Name, a: Element) -> Vector:
    """Matrices of the algebra to coordinates (n,)."""
    return _joined(one.vee(block) for one, block in zip(factors(name), a, strict=True))


def element(name: Name, stored: Sequence[Any]) -> Element:
    """Stored numbers to the element, every rotation block put on the group first."""
    parts = factors(name)
    pieces = split(stored, [one.stored for one in parts])
    return tuple(one.element(piece) for one, piece in zip(parts, pieces, strict=True))


def store(name: Name, g: Element) -> Vector:
    """The numbers kept of an element."""
    return _joined(one.keep(a) for one, a in zip(factors(name), g, strict=True))


def error(name: Name, g_r: Element, g: Element) -> Element:
    """g_e = g_r^-1 g; where both turn alike its rotation is exactly 1."""
    return tuple(
        one.onto(product(one.inverse(a), b))
        for one, a, b in zip(factors(name), g_r, g, strict=True)
    )


def inverse(name: Name, g: Element) -> Element:
    """g^-1."""
    return tuple(one.inverse(a) for one, a in zip(factors(name), g, strict=True))


def times(g: Element, h: Element) -> Element:
    """g h."""
    return tuple(map(product, g, h))


def exp(name: Name, x: Sequence[Any]) -> Element:
    """exp(hat(x))."""
    return tuple(map(function.exp, hat(name, x)))


def log(name: Name, g: Element) -> Vector:
    """Coordinates of the principal logarithm, (n,); ValueError at a rotation by pi (S3: 2 pi)."""
    return law(name, "log", g)


def angle(name: Name, g: Element) -> Number:
    """The largest rotation angle of a factor, rad: 0 to pi, on S3 to 2 pi."""
    return max(one.angle(a) for one, a in zip(factors(name), g, strict=True))


def _cayley(one: Factor | Own, a: Matrix) -> Vector:
    unit = identity(one.whole)
    quotient, _ = function.solve(combine((1, a), (1, unit)), combine((2, a), (-2, unit)))
    return one.vee(quotient)


def _skew(one: Factor | Own, a: Matrix) -> Vector:
    half = mp.mpf(0.5)
    return one.vee(combine((half, a), (-half, one.inverse(a))))


LAWS: dict[str, Law] = {
    "log": lambda one, a: one.vee(function.log(a)),
    "skew": _skew,
    "cayley": _cayley,
}
"""nu_u by name: log g, vee(g - g^-1)/2, 2 vee((g - 1)(g + 1)^-1)."""


def law(name: Name, which: str, g: Element) -> Vector:
    """nu_u(g), (n,)."""
    return _joined(LAWS[which](one, a) for one, a in zip(factors(name), g, strict=True))


def rate(name: Name, g: Element, nu: Sequence[Any], which: str = "log") -> Vector:
    """d/dt nu_u along g exp(t hat(nu)) at t = 0, (n,)."""
    pairs = zip(coordinates(name, nu), g, strict=True)
    return _joined(_rate(one, LAWS[which], a, x) for (one, x), a in pairs)


def _rate(one: Factor | Own, value: Law, a: Matrix, nu: Vector) -> Vector:
    speed = max(map(abs, nu))
    if not speed:
        return nu
    step = STEP / speed  # in the units of the coordinates, whatever the length of nu
    ahead, behind = (value(one, moved(one, a, nu, time)) for time in (step, -step))
    return tuple((x - y) / (2 * step) for x, y in zip(ahead, behind, strict=True))


def moved(one: Factor | Own, a: Matrix, nu: Vector, time: Number) -> Matrix:
    """a exp(time hat(nu))."""
    return product(a, function.exp(one.hat([time * x for x in nu])))


def Ad(name: Name, g: Element) -> Matrix:
    """Ad_g, (n, n): hat(Ad_g x) = g hat(x) g^-1."""
    return _columns(name, lambda x: pull(name, inverse(name, g), x))


def ad(name: Name, x: Sequence[Any]) -> Matrix:
    """ad_x, (n, n): ad_x y = [x, y]."""
    return _columns(name, lambda y: bracket(name, x, y))


def _columns(name: Name, linear: Callable[[Vector], Vector]) -> Matrix:
    return function.transpose(tuple(map(linear, identity(dim(name)))))


def bracket(name: Name, x: Sequence[Any], y: Sequence[Any]) -> Vector:
    """[x, y], (n,): hat([x, y]) = hat(x) hat(y) - hat(y) hat(x)."""
    pairs = zip(hat(name, x), hat(name, y), strict=True)
    return vee(name, tuple(combine((1, product(a, b)), (-1, product(b, a))) for a, b in pairs))


def pull(name: Name, g: Element, x: Sequence[Any]) -> Vector:
    """Ad(g^-1) x, (n,): velocity of the outer frame seen in the inner."""
    pairs = zip(coordinates(name, x), g, strict=True)
    return _joined(_pull(one, a, part) for (one, part), a in pairs)


def _pull(one: Factor | Own, a: Matrix, x: Sequence[Number]) -> Vector:
    return one.vee(product(one.inverse(a), product(one.hat(x), a)))


def pull_rate(
    name: Name, g: Element, nu: Sequence[Any], x: Sequence[Any], x_dot: Sequence[Any]
) -> Vector:
    """d/dt Ad(g^-1) x while g flows with nu and x grows with x_dot, (n,)."""
    velocities, starts, growths = (coordinates(name, each) for each in (nu, x, x_dot))
    rows = zip(g, velocities, starts, growths, strict=True)
    return _joined(_pull_rate(one, a, v, s, d) for a, (one, v), (_, s), (_, d) in rows)


def _pull_rate(one: Factor | Own, a: Matrix, nu: Vector, start: Vector, growth: Vector) -> Vector:
    size = max(map(abs, start))
    # The step is small on the scale of what moves, which may be tiny or huge.
    scale = max(map(abs, nu)) + (max(map(abs, growth)) / size if size else 0)
    step = STEP / (scale or 1)
    ahead, behind = (
        _pull(one, moved(one, a, nu, t), [x + t * y for x, y in zip(start, growth, strict=True)])
        for t in (step, -step)
    )
    return tuple((x - y) / (2 * step) for x, y in zip(ahead, behind, strict=True))
