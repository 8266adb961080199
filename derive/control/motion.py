"""Motion on the group as derivations: a step g exp(hat(x)), its chart, and the error on the move.

A closed loop is integrated in the chart g exp(hat(x)) of each step's start, where it cannot
leave the group.
"""

from __future__ import annotations

from fractions import Fraction

import sympy
from sympy import Expr, Matrix, Rational, eye, zeros

from derive.control.morse import Morse, added, heights_of
from derive.lie.cover import Let
from derive.lie.family import MARKS
from derive.lie.group import Group, marked
from derive.routine.derivation import Derivation, Quantity

ORDER = 17
"""Powers of exp's series: what is left out is below 2^-53 for a step of at most 1 rad."""

BERNOULLI = (1, Fraction(1, 2), Fraction(1, 12), 0, Fraction(-1, 720), 0, Fraction(1, 30240))
"""Coefficients of z/(1 - e^-z), whose value at ad_x takes g^-1 g' to x'."""


def advance(group: Group) -> Derivation:
    """(g, x) -> g exp(hat(x)), stored numbers (k, 1): exact to rounding while x turns <= 1 rad."""
    d = Derivation("advance", "g exp(hat(x))", "eq. (ErrKynSO3)")
    g = d.take(_configuration("g", group))
    x = d.take(Quantity("x", group.dim, group.log_unit, "displacement", place="x"))
    moved = _advanced(d.let, group, g, x)
    d.give(_configuration("g_next", group), d.let("g_next", moved, "1", "g exp(hat(x))"))
    return d.pruned()


def compose(group: Group) -> Derivation:
    """(g, g_e) -> g g_e, stored numbers (k, 1): the state that is off g by the error g_e."""
    d = Derivation("compose", "g g_e", "eq. (velErr)")
    g, g_e = d.take(_configuration("g", group)), d.take(_configuration("g_e", group))
    d.give(_configuration("whole", group), d.let("whole", _composed(group, g, g_e), "1", "g g_e"))
    return d.pruned()


def chart_rate(group: Group) -> Derivation:
    """(x, nu) -> x', (n, 1), where g0 exp(hat(x)) moves with the body velocity nu."""
    d = Derivation("chart_rate", "rate of x in g0 exp(hat(x))", "")
    x = d.take(Quantity("x", group.dim, group.log_unit, "displacement", place="x"))
    nu = d.take(Quantity("nu", group.dim, group.unit, "body velocity", place="nu"))
    total, power = zeros(group.dim, 1), nu
    for order, weight in enumerate(BERNOULLI):
        if order:
            power = d.let(f"bracket_{order}", group.bracket(x, power), group.unit, "[x, ...]")
        total += Rational(weight) * power
    value = d.let("x_dot", total, group.unit, "rate of x")
    d.give(Quantity("x_dot", group.dim, group.unit, "rate of x", place="x_dot"), value)
    return d.pruned()


def deviation(group: Group) -> Derivation:
    """(g, nu, g_r, nu_r) -> g_e, nu_e and how far off g_e is, by `measure`; eq. (velErr)."""
    d = Derivation("deviation", "error of a state against its reference", "eq. (velErr)")
    g, nu = d.take(_configuration("g", group)), d.take(_velocity("nu", group))
    g_r, nu_r = d.take(_configuration("g_r", group)), d.take(_velocity("nu_r", group))
    g_e = d.let("g_e", group.error(d.let, g_r, g), "1", "error, g_r^-1 g")
    eta = group.pull(d.let, g_e)("eta", nu_r)
    nu_e = d.let("nu_e", nu - eta, group.unit, "velocity error")
    far = measure(group)
    height = d.let("height", far.write(d.let, group, g_e).value, far.unit, far.doc)
    d.give(_configuration("g_e", group), g_e)
    d.give(_velocity("nu_e", group), nu_e)
    d.give(Quantity("height", 1, far.unit, far.doc, is_scalar=True, place="height"), height)
    return d.pruned()


def measure(group: Group) -> Morse:
    """The Morse function an error is measured by: smooth at the identity; Psi on SO3.

    Of a product that of each factor, added.
    """
    if group.factors:
        return added([measure(factor) for factor in group.factors])
    known = heights_of(group)
    return next((known[name] for name in ("Psi", "1 - q0") if name in known),
                next(iter(known.values())))  # fmt: skip


def _advanced(let: Let, group: Group, g: Matrix, x: Matrix) -> Matrix:
    """Stored numbers (k, 1); factor by factor on a product."""
    if group.factors:
        pieces = (group.split_element(g), group.split_velocity(x))
        rows = zip(group.factors, MARKS, *pieces, strict=False)
        return Matrix.vstack(
            *(_advanced(marked(let, mark), one, at, by) for one, mark, at, by in rows)
        )
    return group.store(group.embed(g) * _exp(let, group.hat(x)))


def _composed(group: Group, g: Matrix, g_e: Matrix) -> Matrix:
    """Stored numbers (k, 1); factor by factor on a product."""
    if group.factors:
        pieces = zip(group.factors, group.split_element(g), group.split_element(g_e), strict=True)
        return Matrix.vstack(*(_composed(*one) for one in pieces))
    return group.store(group.embed(g) * group.embed(g_e))


def _exp(let: Let, X: Matrix) -> Matrix:
    """exp(X) by Horner's scheme on polynomials in X, kept reduced by an equation of X."""
    equation = [let(f"mu_{i}", c, "1", "coefficient of X's equation")
                for i, c in enumerate(_equation(X))]  # fmt: skip
    rows: list[Expr] = [sympy.S.One] + [sympy.S.Zero] * (len(equation) - 1)
    for order in range(ORDER, 0, -1):
        shifted = [sympy.S.Zero, *rows[:-1]]
        reduced = [(a - c * rows[-1]) / order
                   for a, c in zip(shifted, equation, strict=True)]  # fmt: skip
        reduced[0] += 1
        rows = [let(f"series_{order}_{i}", one, "1", "polynomial in X, from its highest power")
                for i, one in enumerate(reduced)]  # fmt: skip
    total, power = rows[0] * eye(X.rows), eye(X.rows)
    for i, row in enumerate(rows[1:], start=1):
        entries = Matrix(list(power * X))
        power = let(f"power_{i}", entries, "1", f"X^{i}").reshape(X.rows, X.cols)
        total += row * power
    return total


def _equation(X: Matrix) -> list[Expr]:
    """c_0 … c_(d-1) of X^d + c_(d-1) X^(d-1) + … = 0, of the least degree d found.

    From the characteristic polynomial: what divides it and vanishes at X is kept, exactly. Its
    square-free parts tell what is repeated; its factors are found by luck, and on SL3 at times not.
    """
    z = sympy.Symbol("z")
    whole = X.charpoly(z).as_expr()
    _, factors = sympy.sqf_list(whole, z, *sorted(X.free_symbols, key=str))
    powers = [[one, power] for one, power in factors if one.has(z)]
    for pair in powers:
        while pair[1] > 1 and _vanishes(X, z, _product(powers) / pair[0]):
            pair[1] -= 1
    monic = sympy.Poly(_product(powers), z).monic()
    return list(reversed(monic.all_coeffs()))[:-1]


def _product(powers: list[list[Expr]]) -> Expr:
    return sympy.prod(one**power for one, power in powers)


def _vanishes(X: Matrix, z: Expr, polynomial: Expr) -> bool:
    total = zeros(X.rows, X.cols)
    for c in sympy.Poly(sympy.cancel(polynomial), z).all_coeffs():
        total = (total * X + c * eye(X.rows)).applyfunc(sympy.expand)
    return not any(total)


def _configuration(name: str, group: Group) -> Quantity:
    return Quantity(name, group.size, "1", f"configuration: {group.storage}", place=name)


def _velocity(name: str, group: Group) -> Quantity:
    return Quantity(name, group.dim, group.unit, "body velocity", place=name)
