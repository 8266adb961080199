"""A user's group from its basis alone: what its elements look like follows from the algebra.

g - 1 lies in the span of all products of the E_i, which fixes entries that are the same for
every element; a bilinear form B with E^T B + B E = 0 for all E is kept, g^T B g = B, and gives
the inverse B^-1 g^T B; where all traces vanish, det g = 1. Where the last row is fixed, that of
g = [[M, p], [0, 1]] is [[M^-1, -M^-1 p], [0, 1]]. These are also what the guard checks, and forms
on the dual space, g B g^T = B, where no regular form is kept.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction

import sympy
from sympy import ImmutableMatrix, Matrix, Rational, eye

from derive.lie import chart
from derive.lie.group import Group

Rows = Sequence[Sequence[Fraction]]


def of_basis(name: str, basis: Sequence[Rows], units: Sequence[str]) -> Group:
    """The group of matrices (m, m) with that basis of its algebra, which is a valid one.

    Elements are stored whole, m m numbers row by row. A logarithm is there where every g - 1 is
    nilpotent. Raises ValueError where no inverse without a division of large matrices is known.
    """
    made = [Matrix([[Rational(x.numerator, x.denominator) for x in r] for r in e]) for e in basis]
    return of_matrices(name, made, tuple(units))


def of_matrices(name: str, made: Sequence[Matrix], units: tuple[str, ...]) -> Group:
    """As of_basis, from sympy matrices."""
    m = made[0].rows
    envelope = _envelope(made)
    embed = _pattern(envelope, m)
    is_unipotent = not any(_generic(envelope) ** m)
    forms = [] if is_unipotent else _forms(made)
    duals = [] if is_unipotent or _regular(forms) else _forms([e.T for e in made])
    has_unit_det = not is_unipotent and all(e.trace() == 0 for e in made)
    group = Group(
        name=name,
        basis=tuple(ImmutableMatrix(e) for e in made),
        units=units,
        identity=tuple(eye(m)),
        embed=embed,
        store=lambda g: Matrix(list(g)),
        inverse=_inverse(name, made),
        residual=_residual(envelope, embed, forms, duals, has_unit_det),
        storage=f"matrix of {m} rows, row by row",
        shape=(m, m),
    )
    return replace(group, chart=chart.of_unipotent(embed, group.vee)) if is_unipotent else group


def unseen(group: Group) -> int:
    """Directions off the group, at the identity, that its residual does not see: 0 at best."""
    numbers = Matrix(sympy.symbols(f"g:{group.size}"))
    at = dict(zip(numbers, group.identity, strict=True))
    values = group.residual(numbers)
    seen = values.reshape(len(values), 1).jacobian(numbers).xreplace(at).rank() if values else 0
    return int(group.size - seen - group.dim)


def _envelope(made: Sequence[Matrix]) -> list[Matrix]:
    """A basis of the span of all products of the E_i, one factor or more."""
    found: list[Matrix] = []
    rows = Matrix(0, len(made[0]), [])
    waiting = list(made)
    while waiting:
        one = waiting.pop(0)
        longer = rows.col_join(Matrix(1, len(one), list(one)))
        if longer.rank() > rows.rows:
            rows, found = longer, [*found, one]
            waiting += [one * e for e in made]
    return found


def _generic(envelope: Sequence[Matrix]) -> Matrix:
    """A sum of the envelope in general position."""
    return sum((Rational(3 + i * i, 2 + i) * e for i, e in enumerate(envelope)), 0 * envelope[0])


def _pattern(envelope: Sequence[Matrix], m: int) -> Callable[[Matrix], Matrix]:
    """Stored numbers to the matrix, with those entries exact that no element changes."""
    moves = [any(e[i] for e in envelope) for i in range(m * m)]

    def embed(stored: Matrix) -> Matrix:
        one = eye(m)
        return Matrix(m, m, [stored[i] if moves[i] else one[i] for i in range(m * m)])

    return embed


def _forms(made: Sequence[Matrix]) -> list[Matrix]:
    """A basis of the bilinear forms B with E^T B + B E = 0 for every E of the algebra."""
    m = made[0].rows
    unknown = Matrix(m, m, sympy.symbols(f"b:{m * m}"))
    equations = [entry for e in made for entry in e.T * unknown + unknown * e]
    kept = Matrix(equations).jacobian(list(unknown)).nullspace()
    return [Matrix(m, m, list(one)) for one in kept]


def _regular(forms: Sequence[Matrix]) -> Matrix | None:
    """One of the forms, or a sum of them, that has an inverse."""
    sums = [_generic(forms)] if forms else []
    return next((b for b in (*forms, *sums) if b.det() != 0), None)


def _inverse(name: str, made: Sequence[Matrix]) -> Callable[[Matrix], Matrix]:
    """The shortest inverse that holds on the whole group of that basis, or of its span."""
    m = made[0].rows
    if not any(_generic(_envelope(made)) ** m):
        return _finite_inverse
    form = _regular(_forms(made))
    if form is not None:
        back = form.inv()
        return lambda g: back * g.T * form
    if m > 1 and not any(any(e[-1, :]) for e in made):
        return _affine_inverse(_inverse(name, [e[:-1, :-1] for e in made]))
    if m > LARGEST_ADJUGATE:
        raise ValueError(f"{name}: no bilinear form gives the inverse of matrices of {m} rows")
    if all(e.trace() == 0 for e in made):
        return lambda g: g.adjugate()
    return lambda g: g.adjugate() / g.det()


def _affine_inverse(inner: Callable[[Matrix], Matrix]) -> Callable[[Matrix], Matrix]:
    """[[M^-1, -M^-1 p], [0, 1]] of [[M, p], [0, 1]]; inner inverts M."""

    def inverse(g: Matrix) -> Matrix:
        back = inner(g[:-1, :-1])
        above = Matrix.hstack(back, -back * g[:-1, -1])
        return Matrix.vstack(above, Matrix(1, g.cols, [*g[-1, :]]))

    return inverse


LARGEST_ADJUGATE = 4
"""Rows up to which an inverse by cofactors is of bearable size."""


def _finite_inverse(g: Matrix) -> Matrix:
    """1 - N + N^2 - …, N = g - 1 nilpotent."""
    off = eye(g.rows) - g
    power = total = eye(g.rows)
    for _ in range(g.rows - 1):
        power = (power * off).expand()
        total = total + power
    return total


def _residual(
    envelope: Sequence[Matrix],
    embed: Callable[[Matrix], Matrix],
    forms: Sequence[Matrix],
    duals: Sequence[Matrix],
    has_unit_det: bool,
) -> Callable[[Matrix], Matrix]:
    """What vanishes on the group: linear equations, kept forms, the determinant."""
    m = envelope[0].rows
    span = Matrix([list(e) for e in envelope])
    linear = Matrix([list(x) for x in span.nullspace()]) if span.rank() < m * m else None

    def residual(stored: Matrix) -> Matrix:
        g = embed(stored)
        values = [] if linear is None else list(linear * (stored - Matrix(list(eye(m)))))
        for form in forms:
            values += _different((g.T * form * g - form).expand(), form)
        for form in duals:
            values += _different((g * form * g.T - form).expand(), form)
        if has_unit_det:
            values.append(g.det() - 1)
        return Matrix(values)

    return residual


def _different(off: Matrix, form: Matrix) -> list[sympy.Expr]:
    """The entries that say something new: half of them where the form has a symmetry."""
    m, is_odd = off.rows, form == -form.T
    if form != form.T and not is_odd:
        return [x for x in off if x != 0]
    return [off[i, j] for i in range(m) for j in range(i + is_odd, m) if off[i, j] != 0]
