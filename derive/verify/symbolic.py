"""The emitted closed form against sympy's chain rule, at random points, in 50 digits.

The chain rule walks back through the steps to the stored numbers, which flow with g hat(nu); of
a rotation only to its unit quaternion (w, v), whose steps choose between cases, and uses its
rates. The closed form is what is emitted. Both are evaluated exactly up to the digits asked for.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import mpmath
import sympy
from sympy import Expr, Matrix, Rational, Symbol

from derive.control.kinematic import apply, laws_of
from derive.lie.cover import Cover
from derive.lie.family import MARKS
from derive.lie.group import Group
from derive.lie.kernel import CONSTANTS, exact
from derive.routine.derivation import Derivation, Quantity
from derive.routine.rate import rate
from derive.verify.derived import lie_group
from derive.verify.oracle import matrix_group
from derive.verify.oracle.precise import mp
from derive.verify.plant import Plant

DIGITS = 50
BITS = 400  # of a point: so near the group that 50 digits do not see the rest


def chain_rule_residual(vehicle: Plant, points: int, seed: int) -> float:
    """Largest |closed form - chain rule| / |closed form| of nu_u_dot over the points."""
    d = _both(lie_group(vehicle), vehicle.law)
    rng = random.Random(seed)
    worst = 0.0
    for _ in range(points):
        outputs = d.evaluate(_point(d, vehicle, rng), DIGITS)
        closed, chained = (sympy.Matrix(outputs[name]) for name in ("closed", "chained"))
        worst = max(worst, float((closed - chained).norm() / closed.norm()))
    return worst


def kernel_residual(points: int, seed: int) -> float:
    """Largest error of k s = u, s^2 h = 1 - w k and s^2 m = k - 3 w h over w in (-1, 1)."""
    rng = random.Random(seed)
    worst = mpmath.mpf(0)
    with mpmath.workdps(DIGITS):
        for _ in range(points):
            w = mpmath.mpf(rng.randint(-999, 999)) / 1000
            k, h, m = (exact(order, w) for order in range(3))
            square = 1 - w * w
            s = mpmath.sqrt(square)
            off = (k * s / mpmath.atan2(s, w) - 1, square * h / (1 - w * k) - 1,
                   square * m / (k - 3 * w * h) - 1)  # fmt: skip
            worst = max(worst, *map(abs, off))
    return float(worst)


def _both(group: Group, law: str) -> Derivation:
    """A derivation that gives nu_u_dot both ways."""
    d = Derivation("both", "closed form and chain rule", "")
    g = d.take(Quantity("g", group.size, "1", "configuration"))
    nu = d.take(Quantity("nu", group.dim, group.unit, "velocity"))
    _, closed, _ = apply(laws_of(group)[law], d, group, g, nu)
    formula = Matrix(d.step("nu_u").formula)
    chained = rate(d, formula, dict(_flow(d, group, g, nu)))
    n, unit = group.dim, group.unit
    d.give(Quantity("closed", n, unit, "closed form"), closed)
    d.give(Quantity("chained", n, unit, "chain rule"), d.let("chained", chained, unit, ""))
    return d


def _flow(d: Derivation, group: Group, g: Matrix, nu: Matrix) -> Iterator[tuple[Symbol, Expr]]:
    """Rates of the stored numbers along g hat(nu), and of the quaternions made of them."""
    if not group.factors:
        yield from _one_flow(d, group, g, nu, "")
        return
    rows = zip(group.factors, group.split_element(g), group.split_velocity(nu), MARKS, strict=False)
    for one, stored, velocity, mark in rows:
        yield from _one_flow(d, one, stored, velocity, f"_{mark}")


def _one_flow(
    d: Derivation, group: Group, g: Matrix, nu: Matrix, mark: str
) -> Iterator[tuple[Symbol, Expr]]:
    element = group.embed(g)
    moved = group.store(element * group.hat(nu))
    yield from zip(g, moved, strict=True)
    known = {step.quantity.name: step.symbols for step in d.steps}
    if f"w{mark}" not in known:
        return
    (w,) = known[f"w{mark}"]
    if f"v{mark}" in known:
        v = Matrix(known[f"v{mark}"])
        let = lambda name, *rest: d.let(f"{name}{mark}", *rest)  # noqa: E731
        rates = Cover(w, v).rate(let, nu[:3, :])
        yield from rates.items()
        (scale,) = known[f"scale{mark}"]
        yield scale, sympy.S.Zero  # the length it is scaled from may be taken as constant
        if f"power{mark}" in known:
            yield from zip(known[f"power{mark}"], (rates[one] / scale for one in v), strict=False)
    else:  # in the plane
        (s,) = known[f"sine{mark}"]
        yield w, -s * nu[0] / 2
        yield s, w * nu[0] / 2


def _point(d: Derivation, vehicle: Plant, rng: random.Random) -> dict[Any, Any]:
    """An element, as near as 120 digits, and an exact velocity; on S3 up to 2 pi."""
    n = matrix_group.dim(vehicle.space)
    x = [Fraction(rng.randint(-90, 90), 100) for _ in range(n)]
    if "S3" in vehicle.factors:
        x = [2 * entry for entry in x]
    stored = matrix_group.store(vehicle.space, matrix_group.exp(vehicle.space, x))
    nu = [Rational(rng.randint(-50, 50), 7) for _ in range(n)]
    symbols = [symbol for quantity in d.inputs for symbol in quantity.symbols()]
    vanished = dict.fromkeys(CONSTANTS, sympy.S.Zero)
    return {**dict(zip(symbols, [*map(_rational, stored), *nu], strict=True)), **vanished}


def _rational(value: Any) -> Rational:
    """A number with 120 digits as a ratio."""
    return Rational(int(mp.floor(mp.ldexp(value, BITS))), 2**BITS)
