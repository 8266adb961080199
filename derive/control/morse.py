"""Morse functions V: how far an element is from the identity, and how fast that changes.

Written like kinematic laws: a record that writes its steps. On rotations V is a function of the
unit quaternion (w, v) with w' = -v.nu/2; 1 - w is taken as v.v/(1 + w) where that loses nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import sympy
from sympy import Expr, Matrix, Piecewise, eye, sqrt

from derive.lie.catalogue import SO2, SO3
from derive.lie.cover import Let
from derive.lie.family import MARKS
from derive.lie.group import Group, marked
from derive.lie.jacobian import log_rate
from derive.lie.kernel import TINY
from derive.routine.derivation import Derivation, Quantity

Rate = Callable[[Let, Matrix], Expr]
"""(let, nu) -> V' along g' = g hat(nu)."""


@dataclass(frozen=True)
class Height:
    """A Morse function at one element, over the steps that were written for it."""

    value: Expr
    rate: Rate


@dataclass(frozen=True)
class Morse:
    """V: G -> R, zero at the identity and positive elsewhere; def. (KctrLaw).

    write:  (let, group, g) -> V at g, given by its stored numbers (k, 1)
    doc:    the formula in one line
    smooth: where it is smooth, and so, off its other critical points, a Morse function
    """

    name: str
    write: Callable[[Let, Group, Matrix], Height]
    doc: str
    smooth: str
    unit: str = "1"
    source: str = "def. (KctrLaw)"


def gradient(let: Let, group: Group, height: Height) -> Matrix:
    """Gradient in body coordinates, (n, 1): V' = gradient . nu along g' = g hat(nu)."""
    axes = [eye(group.dim)[:, i] for i in range(group.dim)]
    return Matrix([height.rate(marked(let, f"{i}"), axis) for i, axis in enumerate(axes)])


def height(group: Group, morse: Morse) -> Derivation:
    """(g, nu) -> V, its rate along g' = g hat(nu), and its gradient."""
    d = Derivation("height", f"Morse function {morse.name} = {morse.doc}", morse.source)
    g = d.take(Quantity("g", group.size, "1", f"configuration: {group.storage}", place="g"))
    nu = d.take(Quantity("nu", group.dim, group.unit, "body velocity", place="nu"))
    found = morse.write(d.let, group, g)
    slope = gradient(d.let, group, found)
    for name, value, unit, doc in (
        ("V", found.value, morse.unit, morse.name),
        ("V_dot", found.rate(d.let, nu), f"{morse.unit}/s", "its exact rate"),
    ):
        made = d.let(name, value, unit, doc, morse.source)
        d.give(Quantity(name, 1, unit, doc, is_scalar=True, place=name), made)
    rows = d.let("gradient", slope, morse.unit, "gradient in body coordinates")
    d.give(Quantity("gradient", group.dim, morse.unit, "gradient", place="gradient"), rows)
    return d.pruned()


def heights_of(group: Group) -> dict[str, Morse]:
    """The Morse functions of a group by name; the first is what its laws are judged by."""
    if group.factors:
        whole = added([next(iter(heights_of(factor).values())) for factor in group.factors])
        return {whole.name: whole}
    found = _RECORDS.get(group.name, (_SQUARE,) if group.chart else (_OFF,))
    return {one.name: one for one in found}


Profile = Callable[[Let, Expr, Matrix], tuple[Expr, Expr]]
"""(let, w, v) -> V and -dV/dw."""


def _of_quaternion(profile: Profile) -> Callable[[Let, Group, Matrix], Height]:
    """V of the unit quaternion: V' = -dV/dw v.nu/2."""

    def write(let: Let, group: Group, g: Matrix) -> Height:
        w, v = _quaternion(let, group, g)
        value, fall = profile(let, w, v)
        return Height(value, lambda let, nu: fall * v.dot(nu) / 2)

    return write


def _quaternion(let: Let, group: Group, g: Matrix) -> tuple[Expr, Matrix]:
    """(w, v) of a group that turns; in the plane v is the sine alone."""
    if group.cover:
        cover = group.cover(let, g)
        return cover.w, cover.v
    chart = group.chart(let, g) if group.chart else None
    if chart is None or chart.w is None:
        raise ValueError(f"{group.name} has no unit quaternion")
    return chart.w, chart.scaled


def _rise(let: Let, w: Expr, v: Matrix) -> Expr:
    """1 - w, without cancellation."""
    value = Piecewise((v.dot(v) / (1 + w), w >= 0), (1 - w, True), evaluate=False)
    found: Expr = let("rise", value, "1", "1 - w")
    return found


def _fold(let: Let, w: Expr, v: Matrix) -> tuple[Expr, Expr]:
    return 2 * _rise(let, w, v), sympy.Integer(2)


def _psi(let: Let, w: Expr, v: Matrix) -> tuple[Expr, Expr]:
    return 2 * v.dot(v), 4 * w


def _root(let: Let, w: Expr, v: Matrix) -> tuple[Expr, Expr]:
    """At the identity the slope of this branch is put to zero with v."""
    root = let("root", sqrt(_rise(let, w, v)), "1", "sqrt(1 - w)")
    return root, 1 / (2 * (root + TINY))


def _near(let: Let, w: Expr, v: Matrix) -> tuple[Expr, Expr]:
    return _rise(let, w, v), sympy.S.One


def _square(let: Let, group: Group, g: Matrix) -> Height:
    """Half the square of the logarithm, by its exact rate."""
    if group.chart is None:
        raise ValueError(f"{group.name} has no closed-form logarithm")
    chart = group.chart(let, g)
    log = chart.log

    def rate(let: Let, nu: Matrix) -> Expr:
        moved = let("log_rate", log_rate(let, group, chart, nu), group.unit, "rate of log g")
        found: Expr = log.dot(moved)
        return found

    return Height(log.dot(log) / 2, rate)


def _off(let: Let, group: Group, g: Matrix) -> Height:
    """Half the square of the entries of g - 1."""
    element = group.embed(g)
    off = Matrix(list(element - eye(element.rows)))
    return Height(off.dot(off) / 2, lambda let, nu: off.dot(Matrix(list(element * group.hat(nu)))))


def _carried(base: Group, profile: Profile) -> Callable[[Let, Group, Matrix], Height]:
    """V of the rotation, and half the square of every translation p, which moves with p' = M v."""
    size = base.basis[0].rows

    def write(let: Let, group: Group, g: Matrix) -> Height:
        element = group.embed(g)
        M, moves = element[:size, :size], element[:size, size:]
        turned = _of_quaternion(profile)(let, base, base.store(M))

        def rate(let: Let, nu: Matrix) -> Expr:
            steps = nu[base.dim :, :].reshape(moves.cols, size).T
            moved = sum(p * q for p, q in zip(moves, M * steps, strict=True))
            return turned.rate(let, nu[: base.dim, :]) + moved

        return Height(turned.value + sum(p * p for p in moves) / 2, rate)

    return write


def added(each: Sequence[Morse]) -> Morse:
    """Of a product: one function of each factor, added."""

    def write(let: Let, whole: Group, g: Matrix) -> Height:
        rows = zip(each, whole.factors, MARKS, whole.split_element(g), strict=False)
        found = [one.write(marked(let, mark), factor, part) for one, factor, mark, part in rows]

        def rate(let: Let, nu: Matrix) -> Expr:
            parts = zip(found, MARKS, whole.split_velocity(nu), strict=False)
            return sum((one.rate(marked(let, mark), part) for one, mark, part in parts),
                       sympy.S.Zero)  # fmt: skip

        return Height(sum((one.value for one in found), sympy.S.Zero), rate)

    name = " + ".join(one.name for one in each)
    doc = " + ".join(one.doc for one in each)
    smooth = "; ".join(dict.fromkeys(one.smooth for one in each))
    return Morse(name, write, doc, smooth, _units(each))


def _units(each: Sequence[Morse]) -> str:
    return ", ".join(dict.fromkeys(unit for one in each for unit in one.unit.split(", ")))


_AT_PI, _EVERYWHERE = "off rotations by pi", "everywhere"
_SQUARE = Morse("|log|^2/2", _square, "|log g|^2/2", "where log is", "square of log")
_OFF = Morse("|g - 1|^2/2", _off, "sum of (g - 1)_ij^2/2", _EVERYWHERE, "square of g")
_V_1 = Morse("V_1", _of_quaternion(_fold), "2 - sqrt(1 + tr R)", _AT_PI, source="eq. (ErrKynSO3)")
_PSI = Morse("Psi", _of_quaternion(_psi), "tr(1 - R)/2", _EVERYWHERE, source="sec. (simulations)")
_V_2 = Morse("V_2", _of_quaternion(_root), "sqrt(1 - q0)", "off the identity",
             source="eq. (KinCtrlLawS3)")  # fmt: skip
_NEAR = Morse("1 - q0", _of_quaternion(_near), "1 - q0", _EVERYWHERE)
_PLANE = Morse("V_1", _of_quaternion(_fold), "2 - sqrt(2 + tr R)", _AT_PI)


def _with_moves(base: Group, unit: str) -> tuple[Morse, Morse]:
    """V_1 of the rotation with its translations, and the square of the logarithm."""
    write = _carried(base, _fold)
    return Morse("V_1 + |p|^2/2", write, "V_1 + |p|^2/2", _AT_PI, unit), _SQUARE


_RECORDS: dict[str, tuple[Morse, ...]] = {
    "SO2": (_PLANE, _PSI, _SQUARE),
    "SO3": (_V_1, _PSI, _SQUARE),
    "S3": (_V_2, _NEAR, _SQUARE),
    "SE2": _with_moves(SO2, "1, m^2"),
    "SE3": _with_moves(SO3, "1, m^2"),
    "SE23": _with_moves(SO3, "1, m^2/s^2, m^2"),
}
"""Group name -> its functions, first the one its laws are judged by."""
