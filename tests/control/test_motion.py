"""Motion on every group against matrix functions: a step, its chart, an error and its height."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from random import Random
from typing import Any

import numpy as np
import pytest
import sympy
from numpy.typing import NDArray
from scipy.linalg import expm_frechet
from sympy import Matrix, Rational
from sympy.core.random import rng
from sympy.core.random import seed as seed_of_sympy

from bench.algebra import algebra
from derive.control import motion
from derive.emit.function import Function, compiled
from derive.lie.catalogue import GROUPS
from derive.lie.group import Group
from tests import points
from tests.groups import ALL, OWN

Array = NDArray[np.float64]

COLUMNS = 4
NAMES = (*GROUPS, "Random2", "Heisenberg", "SL2", "SL3", "Lorentz", "SO3 x R3", "S3 x SE2",
         "SE3 x SO3")  # fmt: skip
MOVED = {name: ALL[name] for name in NAMES}
each_group = pytest.mark.parametrize("name", MOVED)
ROUTINES: dict[str, Callable[[Group], Any]] = {
    one.__name__: one
    for one in (motion.advance, motion.compose, motion.chart_rate, motion.deviation)
}


@cache
def function(name: str, routine: str) -> Function:
    return compiled(ROUTINES[routine](MOVED[name]))


def basis(name: str) -> Array:
    """(n, m, m)."""
    return np.array(points.rows(MOVED[name]), dtype=np.float64)


def hat(name: str, x: Array) -> Array:
    """Coordinates (n,) to the matrix (m, m)."""
    return np.asarray(np.tensordot(x, basis(name), 1))


def embedded(name: str, stored: Array) -> Array:
    return np.array(points.embedded(MOVED[name], list(stored)), dtype=np.float64)


def elements(name: str, seed: int = 0) -> Array:
    """Stored numbers (k, COLUMNS) of elements far from the identity."""
    random = Random(seed)
    drawn = [points.point(MOVED[name], random) for _ in range(COLUMNS)]
    return np.array(drawn, dtype=np.float64).T


def displacements(name: str, size: float, shift: float = 0.0) -> Array:
    """x (n, COLUMNS) with |hat(x)| = size, and translations of that length where there are any."""
    random = np.random.default_rng([1, len(name)])
    x = random.normal(size=(MOVED[name].dim, COLUMNS))
    norms = [np.linalg.norm(hat(name, column), 2) for column in x.T]
    far = np.array([unit.startswith("m/s") for unit in MOVED[name].units])
    return np.asarray(np.where(far[:, None], shift * x, 0.0) + size * x / norms)


def exponential(X: Array) -> Array:
    """exp(X) for |X| of about 1, by its series in more digits than a double has."""
    long, unit = X.astype(np.longdouble), np.eye(len(X), dtype=np.longdouble)
    total = unit
    for order in range(40, 0, -1):
        total = unit + long @ total / order
    return np.asarray(total)


@each_group
@pytest.mark.parametrize(("size", "shift"), [(1.0, 1e3), (1e-9, 0.0), (0.0, 0.0)])
def test_advance_is_the_exponential_to_rounding(name: str, size: float, shift: float) -> None:
    g, x = elements(name), displacements(name, size, shift)
    (found,) = function(name, "advance").columns(g=g, x=x)
    for before, by, after in zip(g.T, x.T, found.T, strict=True):
        X = hat(name, by)
        whole, wanted = embedded(name, before), embedded(name, before) @ exponential(X)
        # What a sum of rounded products may be off by; a structural zero has to be one.
        scale = np.abs(whole) @ exponential(np.abs(X))
        assert (np.abs(embedded(name, after) - wanted) <= 1e-15 * scale).all()


def test_a_shear_and_its_opposite_turn_and_alike_stretch() -> None:
    """SL2 has both kinds of eigenvalues, and a chart that is no rotation's."""
    turn, e = 0.9, np.eye(2).reshape(4, 1)
    (found,) = function("SL2", "advance").columns(g=e, x=np.array([[turn], [-turn], [0.0]]))
    cos, sin = np.cos(turn), np.sin(turn)
    np.testing.assert_allclose(found[:, 0], [cos, sin, -sin, cos], rtol=3e-16)
    (found,) = function("SL2", "advance").columns(g=e, x=np.array([[turn], [turn], [0.0]]))
    cosh, sinh = np.cosh(turn), np.sinh(turn)
    np.testing.assert_allclose(found[:, 0], [cosh, sinh, sinh, cosh], rtol=3e-16)


@pytest.mark.parametrize("name", [*GROUPS, "SL2", "Heisenberg", "SE3 x SO3"])
def test_two_thousand_steps_stay_on_the_group(name: str) -> None:

    def off(g: Any) -> Any:
        if name == "SL2":
            return np.abs(np.linalg.det(g.reshape(-1, 2, 2)) - 1)
        return algebra(name).off(algebra(name).embed(g))

    g = np.array(MOVED[name].identity, dtype=np.float64)[:, None] + np.zeros(COLUMNS)
    # Of both signs, so that what is not compact does not grow without bound.
    steps = [sign * displacements(name, 0.3) for sign in (1, 1, -1, -1)]
    for place in range(2000):
        (g,) = function(name, "advance").columns(g=g, x=steps[place % 4])
    assert off(g.T).max() < 1e-12


@each_group
def test_compose_is_the_product_of_matrices(name: str) -> None:
    g, g_e = elements(name), elements(name, seed=1)
    (found,) = function(name, "compose").columns(g=g, g_e=g_e)
    for a, b, product in zip(g.T, g_e.T, found.T, strict=True):
        wanted = embedded(name, a) @ embedded(name, b)
        np.testing.assert_allclose(embedded(name, product), wanted, rtol=0,
                                   atol=1e-14 * np.abs(wanted).max())  # fmt: skip


def chart_error(name: str, x: Array, nu: Array) -> float:
    """Largest entry of exp(-X) d exp(X)[hat(x')] - hat(nu), where all of it should be 0."""
    (x_dot,) = function(name, "chart_rate").columns(x=x, nu=nu)
    worst = 0.0
    for at, rate, velocity in zip(x.T, x_dot.T, nu.T, strict=True):
        value, slope = expm_frechet(hat(name, at), hat(name, rate))
        off = np.linalg.solve(value, slope) - hat(name, velocity)
        worst = max(worst, float(np.abs(off).max()))
    return worst


def brackets(name: str, x: Array) -> Array:
    """ad_x, (n, n), by the commutators of matrices."""
    X, E = hat(name, x), basis(name)
    dual = np.linalg.pinv(E.reshape(len(E), -1))
    return np.asarray(((X @ E - E @ X).reshape(len(E), -1) @ dual).T)


def by_brackets(name: str, size: float) -> Array:
    """x (n, COLUMNS) with |ad_x| = size in the 2-norm, or |hat(x)| where brackets vanish."""
    x = displacements(name, 1.0)
    norms = np.array([np.linalg.norm(brackets(name, column), 2) for column in x.T])
    return np.asarray(size * x / np.where(norms > 1e-9, norms, 1.0))


def velocities(name: str) -> Array:
    nu = np.random.default_rng(7).normal(size=(MOVED[name].dim, COLUMNS))
    return np.asarray(nu / np.linalg.norm(nu, axis=0))


NILPOTENT = ("SO2", "R3", "Heisenberg")
"""Where a power of every ad_x vanishes, and the series with it."""


@each_group
def test_the_rate_of_the_chart_moves_the_element_with_that_velocity(name: str) -> None:
    """d/dt exp(hat(x)) = exp(hat(x)) hat(nu); the series leaves |ad_x|^8/1209600 out."""
    nu = velocities(name)
    for size in (0.0, 0.1, 0.3):
        left_out = 0.0 if name in NILPOTENT else size**8 / 1209600
        largest = np.abs(basis(name)).sum()
        assert chart_error(name, by_brackets(name, size), nu) <= largest * (2e-15 + left_out)


@pytest.mark.parametrize("name", [name for name in MOVED if name not in NILPOTENT])
def test_what_the_series_leaves_out_falls_with_the_eighth_power(name: str) -> None:
    nu = velocities(name)
    far, near = (chart_error(name, by_brackets(name, size), nu) for size in (0.9, 0.45))
    assert 2**7.5 < far / near < 2**8.5


@each_group
def test_the_error_of_a_state_is_that_of_inverse_and_conjugation(name: str) -> None:
    g, g_r, nu, nu_r = elements(name), elements(name, 1), velocities(name), -velocities(name)[::-1]
    given = dict(zip(("g", "nu", "g_r", "nu_r"), (g, nu, g_r, nu_r), strict=True))
    g_e, nu_e, height = function(name, "deviation").columns(**given)
    assert height.shape == (COLUMNS,)
    for i in range(COLUMNS):
        wanted = np.linalg.inv(embedded(name, g_r[:, i])) @ embedded(name, g[:, i])
        size = np.abs(wanted).max() * np.linalg.cond(wanted)
        assert np.abs(embedded(name, g_e[:, i]) - wanted).max() < 1e-14 * size
        moved = np.linalg.inv(wanted) @ hat(name, nu_r[:, i]) @ wanted
        off = hat(name, nu_e[:, i]) - (hat(name, nu[:, i]) - moved)
        assert np.abs(off).max() < 1e-13 * size


def height(name: str, g: Array) -> Array:
    """Of elements (k, N) against the identity."""
    e = np.array(MOVED[name].identity, dtype=np.float64)[:, None] + 0 * g
    still = np.zeros((MOVED[name].dim, g.shape[1]))
    return np.asarray(function(name, "deviation").columns(g=g, nu=still, g_r=e, nu_r=still)[2])


HEIGHTS: dict[str, Callable[[Array], Any]] = {
    "SO3": lambda g: (3 - np.trace(g)) / 2,
    "S3": lambda g: 1 - g[0, 0],
    "SO2": lambda g: 1 - g[0, 0],
    "SE2": lambda g: 2 - np.sqrt(2 + np.trace(g[:2, :2])) + np.sum(g[:2, 2] ** 2) / 2,
    "R3": lambda g: np.sum(g[:-1, -1] ** 2) / 2,
    "Heisenberg": lambda g: (
        np.sum((g[[0, 1], [1, 2]]) ** 2) / 2 + (g[0, 2] - g[0, 1] * g[1, 2] / 2) ** 2 / 2
    ),
    "SL2": lambda g: np.sum((g - np.eye(2)) ** 2) / 2,
    "S3 x SE2": lambda g: HEIGHTS["S3"](g[:4, :4]) + HEIGHTS["SE2"](g[4:, 4:]),
    "SO3 x R3": lambda g: HEIGHTS["SO3"](g[:3, :3]) + HEIGHTS["R3"](g[3:, 3:]),
}
"""Of a matrix; Psi on SO3, added up on a product."""


@pytest.mark.parametrize("name", HEIGHTS)
def test_the_height_is_the_one_that_is_told(name: str) -> None:
    g = elements(name)
    wanted = [HEIGHTS[name](embedded(name, one)) for one in g.T]
    np.testing.assert_allclose(height(name, g), wanted, rtol=1e-12)


@each_group
def test_the_height_is_smooth_at_the_identity_and_positive_elsewhere(name: str) -> None:
    e = np.array(MOVED[name].identity, dtype=np.float64)[:, None] + np.zeros(COLUMNS)
    assert (height(name, e) == 0).all()
    one, two = (height(name, function(name, "advance").columns(g=e, x=displacements(name, r))[0])
                for r in (1e-2, 2e-2))  # fmt: skip
    assert (one > 0).all()
    np.testing.assert_allclose(two / one, 4, rtol=0.1)  # a square, to leading order


DEGREES = {"SO2": 2, "SO3": 3, "S3": 2, "SE2": 3, "SE3": 4, "SE23": 4, "R3": 2,
           "Heisenberg": 3, "SL2": 2, "SL3": 3, "Random2": 3}  # fmt: skip
"""Of the least polynomial that every matrix of the algebra obeys."""


@pytest.mark.parametrize("name", DEGREES)
def test_the_equation_of_a_matrix_vanishes_exactly(name: str) -> None:
    X = MOVED[name].hat(Matrix(sympy.symbols(f"x:{MOVED[name].dim}")))
    found = motion._equation(X)
    assert len(found) == DEGREES[name]
    random = Random(name)
    values = {x: Rational(random.randint(-9, 9), random.randint(1, 9))
              for x in sorted(X.free_symbols, key=str)}  # fmt: skip
    A = np.array([[points.exact(entry) for entry in row] for row in X.subs(values).tolist()])
    total, power = 0 * A, points.eye(len(A))
    for c in (*found, sympy.S.One):
        total, power = total + points.exact(sympy.sympify(c).subs(values)) * power, power @ A
    assert not total.any()


def test_an_equation_is_found_without_drawing_lots() -> None:
    """Factors of many variables are found by random points, now and then never: on SL3."""
    seed_of_sympy(1)
    before = rng.getstate()
    motion._equation(OWN["SL3"].hat(Matrix(sympy.symbols("x:8"))))
    assert rng.getstate() == before
