"""Functions of small square matrices with 130 digits: product, inverse, exp, square root, log.

A matrix is a tuple of rows of mpf. What is small is kept: 1 + E with entries 1e-300 in E loses
none of them, because no entry is ever added to one it does not belong to.
"""

from collections.abc import Iterable, Sequence
from functools import cache
from typing import Any

from mpmath.libmp import from_man_exp

from derive.verify.oracle.precise import exactly, mp

Number = Any  # an mpf: mpmath has no stubs
Vector = tuple[Number, ...]  # (n,)
Matrix = tuple[Vector, ...]  # (m, m)

# Newton steps double the digits: once two iterates agree to these, the later one is exact.
SAME = mp.mpf(10) ** -70
# Below this a term of a series is no more seen.
NOTHING = mp.mpf(10) ** -140
# A determinant below this is that of a singular matrix, but for rounding.
SINGULAR = mp.mpf(10) ** -200

SCALING = 16  # exp: halvings beyond a norm of one
ROOTS = 3  # log: square roots; then |z| <= tan(pi/16) = 0.2 in the series
GROUPING = 10  # log: the 100 terms of the series, in ten groups of ten


@cache
def identity(size: int) -> Matrix:
    """The unit matrix, (size, size)."""
    return tuple(tuple(mp.mpf(i == j) for j in range(size)) for i in range(size))


def transpose(a: Matrix) -> Matrix:
    """Rows to columns."""
    return tuple(zip(*a, strict=True))


def numbers(values: Iterable[Any]) -> Vector:
    """Stored numbers, exactly; raises ValueError when one is not finite."""
    found = tuple(map(exactly, values))
    if not all(map(mp.isfinite, found)):
        raise ValueError("a number is not finite")
    return found


def dot(a: Sequence[Number], b: Sequence[Number]) -> Number:
    """Inner product of finite mpf, rounded once; a third faster than mp.fdot."""
    terms = []
    for x, y in zip(a, b, strict=True):
        (sign, man, exp2, _), (other_sign, other_man, other_exp2, _) = x._mpf_, y._mpf_
        if man and other_man:
            whole = man * other_man
            terms.append((whole if sign == other_sign else -whole, exp2 + other_exp2))
    low = min((exp2 for _, exp2 in terms), default=0)
    whole = sum(whole << (exp2 - low) for whole, exp2 in terms)
    return mp.make_mpf(from_man_exp(whole, low, mp.prec, "n"))


def times(a: Matrix, x: Sequence[Number]) -> Vector:
    """Matrix times vector."""
    return tuple(dot(row, x) for row in a)


def product(a: Matrix, b: Matrix) -> Matrix:
    """Matrix product a b."""
    columns = transpose(b)
    return tuple(times(columns, row) for row in a)


def combine(*terms: tuple[Any, Matrix]) -> Matrix:
    """Sum of factor times matrix."""
    factors = tuple(mp.mpf(factor) for factor, _ in terms)
    rows = zip(*(matrix for _, matrix in terms), strict=True)
    return tuple(times(tuple(zip(*each, strict=True)), factors) for each in rows)


def size_of(a: Matrix) -> Number:
    """Largest absolute value of an entry."""
    return max((abs(entry) for row in a for entry in row), default=mp.zero)


def distance(a: Matrix, b: Matrix) -> Number:
    """Largest absolute value of an entry of a - b."""
    pairs = zip(a, b, strict=True)
    return max((abs(x - y) for p, q in pairs for x, y in zip(p, q, strict=True)), default=mp.zero)


def solve(a: Matrix, b: Matrix) -> tuple[Matrix, Number]:
    """a^-1 b and det a, by elimination with pivots; raises ValueError when a is singular."""
    rows = [[*left, *right] for left, right in zip(a, b, strict=True)]
    determinant = mp.one
    for k in range(len(rows)):
        best = max(range(k, len(rows)), key=lambda i: abs(rows[i][k]))
        determinant *= rows[best][k] if best == k else -rows[best][k]
        if not abs(determinant) > SINGULAR:
            raise ValueError(f"the matrix is singular: determinant {mp.nstr(determinant, 3)}")
        rows[k], rows[best] = rows[best], rows[k]
        pivot = rows[k][k]
        rows[k] = [entry / pivot if entry else entry for entry in rows[k]]
        for i in range(len(rows)):
            if i != k and (factor := rows[i][k]):
                rows[i] = [
                    x - factor * y if y else x for x, y in zip(rows[i], rows[k], strict=True)
                ]
    return tuple(tuple(row[len(a) :]) for row in rows), determinant


def inverse(a: Matrix) -> Matrix:
    """a^-1; raises ValueError when a is singular."""
    return solve(a, identity(len(a)))[0]


def exp(a: Matrix) -> Matrix:
    """e^a, by scaling, Taylor's series and squaring."""
    length = size_of(a)
    halvings = max(0, mp.mag(length) + SCALING) if length else 0
    scaled = combine((mp.ldexp(1, -halvings), a))
    seen = size_of(scaled) * NOTHING
    total, term, order = identity(len(a)), identity(len(a)), 0
    while size_of(term) > seen:
        order += 1
        term = combine((mp.one / order, product(term, scaled)))
        total = combine((1, total), (1, term))
    for _ in range(halvings):
        total = product(total, total)
    return total


def square_root(a: Matrix) -> Matrix:
    """The root with eigenvalues in the right half plane, by Newton's x <- (x + a x^-1)/2.

    Each step is scaled by a power of two near |det x|^(-1/m), or an eigenvalue near -1 would
    cost a step per digit. Raises ValueError when one is -1: no root is principal.
    """
    x, half = combine((mp.mpf(0.5), identity(len(a))), (mp.mpf(0.5), a)), mp.mpf(0.5)
    for _ in range(100):
        y, determinant = solve(x, a)
        scale = mp.ldexp(1, -int(mp.nint((mp.mag(determinant) - half) / len(a))))
        new = combine((half * scale, x), (half / scale, y))
        if distance(new, x) < SAME * size_of(x):
            return new
        x = new
    raise ValueError("the square root does not converge")


def log(a: Matrix) -> Matrix:
    """The principal logarithm: square roots r, then 2 atanh((r - 1)(r + 1)^-1), doubled back.

    Raises ValueError when an eigenvalue is -1.
    """
    one = identity(len(a))
    for _ in range(ROOTS):
        a = square_root(a)
    z, _ = solve(combine((1, a), (1, one)), combine((1, a), (-1, one)))
    return combine((2 ** (ROOTS + 1), _atanh(z)))


def _atanh(z: Matrix) -> Matrix:
    """z + z^3/3 + z^5/5 + …, the powers of z^2 in groups: 20 products instead of 100."""
    square = product(z, z)
    powers = [identity(len(z))]
    for _ in range(GROUPING):
        powers.append(product(powers[-1], square))
    *low, high = powers
    total = combine((0, z))
    for group in reversed(range(GROUPING)):
        orders = range(group * GROUPING, (group + 1) * GROUPING)
        share = combine(
            *((mp.one / (2 * k + 1), power) for k, power in zip(orders, low, strict=True))
        )
        total = combine((1, product(total, high)), (1, share))
    return product(z, total)


def orthogonal_nearest(a: Matrix) -> Matrix:
    """Orthogonal polar factor by x <- (x + x^-T)/2; raises ValueError when det a <= 0.

    So near 1 that its square is nothing it is 1 plus the skew part, which may be exactly zero:
    the rounding of steps would take a hair of the symmetric part for a rotation.
    """
    half, one = mp.mpf(0.5), identity(len(a))
    if distance(a, one) < SAME:
        return combine((1, one), (half, a), (-half, transpose(a)))
    if not solve(a, one)[1] > 0:
        raise ValueError("no rotation is nearest: the determinant is not positive")
    moved = mp.inf
    while moved > SAME:
        new = combine((half, a), (half, transpose(inverse(a))))
        moved, a = distance(new, a), new
    return a
