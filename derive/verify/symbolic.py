"""The emitted closed form against sympy's chain rule, at random rational points, in 50 digits.

The chain rule walks back through the steps to (w, v) and uses their rates; the closed form
is what is emitted. Both are evaluated exactly up to the digits asked for.
"""

from __future__ import annotations

import random
from typing import Any

import mpmath
import sympy
from sympy import Matrix, Rational

from derive.control.kinematic import LAWS, apply
from derive.lie.catalogue import GROUPS
from derive.lie.cover import Cover
from derive.lie.kernel import SMALL, TINY, exact
from derive.routine.derivation import Derivation, Quantity
from derive.routine.rate import rate

DIGITS = 50


def chain_rule_residual(group: str, law: str, points: int, seed: int) -> float:
    """Largest |closed form - chain rule| / |closed form| of nu_u_dot over rational points."""
    d = _both(group, law)
    rng = random.Random(seed)
    worst = 0.0
    for _ in range(points):
        outputs = d.evaluate(_point(d, group, rng), DIGITS)
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


def _both(name: str, law: str) -> Derivation:
    """A derivation that gives nu_u_dot both ways."""
    group = GROUPS[name]
    d = Derivation("both", "closed form and chain rule", "")
    g = d.take(Quantity("g", len(group.identity), "1", "configuration"))
    nu = d.take(Quantity("nu", group.dim, "rad/s", "velocity"))
    _, closed, _ = apply(LAWS[name, law], d, group, g, nu)
    w, v = d.step("w").symbols[0], Matrix(d.step("v").symbols)
    formula = Matrix(d.step("nu_u").formula)
    chained = rate(d, formula, Cover(w, v).rate(d.let, nu))
    d.give(Quantity("closed", 3, "rad/s", "closed form"), closed)
    d.give(Quantity("chained", 3, "rad/s", "chain rule"), d.let("chained", chained, "rad/s", ""))
    return d


def _point(d: Derivation, group: str, rng: random.Random) -> dict[Any, Any]:
    """An exact element and an exact velocity; w is negative in half of the points on S3."""
    q = [rng.randint(1, 40) for _ in range(4)]
    signs = [rng.choice((-1, 1)) for _ in range(4)]
    w, x, y, z = (Rational(sign * value) for sign, value in zip(signs, q, strict=True))
    square = w * w + x * x + y * y + z * z
    if group == "S3":
        stored = [value / sympy.sqrt(square) for value in (w, x, y, z)]
    else:
        stored = [
            w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),
            2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
            2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z,
        ]  # fmt: skip
        stored = [value / square for value in stored]
    nu = [Rational(rng.randint(-50, 50), 7) for _ in range(3)]
    symbols = [symbol for quantity in d.inputs for symbol in quantity.symbols()]
    vanished = {TINY: sympy.S.Zero, SMALL: sympy.S.Zero}
    return {**dict(zip(symbols, [*stored, *nu], strict=True)), **vanished}
