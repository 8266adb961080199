"""What holds of every algebra and every inertia: connection, closed loops, right invariance.

Equations stand multiplied by I, so that no inverse inertia is needed; I is invertible, so
nothing is lost. Signs, brackets and factors are the paper's.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from derive.verify.proof.algebra import Algebra, Scalar, Setting, Vector
from derive.verify.proof.statement import Fact, Statement, vanish

Bilinear = Callable[[Algebra, Vector, Vector], Vector]


def gyroscopic(a: Algebra, x: Vector, y: Vector) -> Vector:
    """ad*_x I y."""
    return a.coad(x, a.flat(y))


def connection(a: Algebra, x: Vector, y: Vector) -> Vector:
    """2 I nabla_x y = I [x, y] - ad*_x I y - ad*_y I x; eq. (Rest)."""
    return a.flat(a.bracket(x, y)) - gyroscopic(a, x, y) - gyroscopic(a, y, x)


def _is_passive(setting: Setting, term: Bilinear) -> Iterator[Fact]:
    a, (x, y) = setting.with_vectors("x y")
    yield vanish("I(x, I^sharp ad*_x I y) = 0", [term(a, x, y) @ x])


def _is_levi_civita(setting: Setting, nabla: Bilinear) -> Iterator[Fact]:
    a, (x, y, z) = setting.with_vectors("x y z")
    twisted = nabla(a, x, y) - nabla(a, y, x) - a.flat(a.bracket(x, y) + a.bracket(x, y))
    yield vanish("nabla_x y - nabla_y x = [x, y]", twisted.entries)
    yield vanish("I(nabla_z x, y) + I(x, nabla_z y) = 0", [nabla(a, z, x) @ y + nabla(a, z, y) @ x])


def _is_euler_poincare(setting: Setting, nabla: Bilinear) -> Iterator[Fact]:
    a, (nu,) = setting.with_vectors("nu")
    inertial = nabla(a, nu, nu)
    gyration = gyroscopic(a, nu, nu)
    yield vanish("I nabla_nu nu = -ad*_nu I nu", (inertial + gyration + gyration).entries)


@dataclass(frozen=True)
class Loop:
    """Symbols of a motion: velocities, their rates, and the gains lambda and k_s."""

    nu: Vector
    nu_u: Vector
    nu_u_dot: Vector
    eta: Vector
    eta_dot: Vector
    rate_gain: Scalar
    reach_gain: Scalar

    @property
    def s(self) -> Vector:
        """nu - eta + lambda nu_u; eq. (SurfaceErr)."""
        driven: Vector = self.rate_gain * self.nu_u
        return self.nu - self.eta + driven

    @property
    def mirrored(self) -> Loop:
        """The motion of g^-1: every velocity with the opposite sign."""
        velocities = ("nu", "nu_u", "nu_u_dot", "eta", "eta_dot")
        return replace(self, **{name: -getattr(self, name) for name in velocities})

    def slide(self, a: Algebra, turning: Vector, force: Vector) -> Vector:
        """I s' where I nu' = turning + force."""
        driven: Vector = self.rate_gain * self.nu_u_dot
        return turning + force + a.flat(driven - self.eta_dot)


Force = Callable[[Algebra, Loop], Vector]


def law(a: Algebra, loop: Loop) -> Vector:
    """I f_u; eq. (TckCtrl), and eq. (Ctrl2) where eta = 0."""
    turning = gyroscopic(a, loop.rate_gain * loop.nu_u - loop.eta, loop.nu)
    rates = loop.eta_dot - loop.rate_gain * loop.nu_u_dot
    return turning + a.flat(rates - loop.reach_gain * loop.s)


def _loop(setting: Setting, *, moves: bool) -> tuple[Algebra, Loop]:
    names = "nu nu_u nu_u_dot" + " eta eta_dot" * moves
    a, (*vectors, rate_gain, reach_gain) = setting.with_vectors(names, "rate_gain reach_gain")
    rest = Vector((a.zero,) * setting.dim)
    nu, nu_u, nu_u_dot, eta, eta_dot = (*vectors, rest, rest)[:5]
    return a, Loop(nu, nu_u, nu_u_dot, eta, eta_dot, rate_gain, reach_gain)


def _decay(a: Algebra, loop: Loop, turning: Vector, force: Vector) -> Fact:
    """W' = I(s', s) and W = I(s, s)/2."""
    rate = loop.slide(a, turning, force) @ loop.s
    return vanish("W' = -2 k_s W", [rate + loop.reach_gain * a.energy(loop.s, loop.s)])


def _reaches(setting: Setting, force: Force) -> Iterator[Fact]:
    a, loop = _loop(setting, moves=False)
    yield _decay(a, loop, gyroscopic(a, loop.nu, loop.nu), force(a, loop))


def _tracks(setting: Setting, force: Force) -> Iterator[Fact]:
    """The covariant rate of s, 2 I nabla_s s = 2 I s' + 2 I nabla_s s of the restriction."""
    a, loop = _loop(setting, moves=True)
    turning, given, s = gyroscopic(a, loop.nu, loop.nu), force(a, loop), loop.s
    yield _decay(a, loop, turning, given)
    slide, own = loop.slide(a, turning, given), gyroscopic(a, s, s)
    closed = gyroscopic(a, s, loop.nu) - loop.reach_gain * a.flat(s)
    found = connection(a, s, s) + own + own + slide + slide - closed - closed
    yield vanish("closed loop of (ELerrDyn) and (TckCtrl)", found.entries)


def _is_mirrored(setting: Setting, force: Force) -> Iterator[Fact]:
    """On a right-invariant system I nu' = -ad*_nu I nu + force, as brackets change sign."""
    a, loop = _loop(setting, moves=True)
    given, mirror = force(a, loop), loop.mirrored
    turning = -gyroscopic(a, loop.nu, loop.nu)
    left = gyroscopic(a, mirror.nu, mirror.nu) - given
    yield vanish("nu' is that of g^-1 with the opposite sign", (turning + given + left).entries)
    yield _decay(a, loop, turning, given)


Lowered = Callable[[Algebra, Vector, Vector], tuple[Vector, Vector]]


def lowered(a: Algebra, turning: Vector, wanted: Vector) -> tuple[Vector, Vector]:
    """det(I) f_u as the paper has it, with I^sharp, and the force without it."""
    acceleration = a.scaled_sharp(turning) + a.determinant * wanted
    return acceleration, turning + a.flat(wanted)


def _is_lowered(setting: Setting, pair: Lowered) -> Iterator[Fact]:
    """With any covector in the place of ad*_x I nu."""
    a, (turning, wanted) = setting.with_vectors("turning wanted")
    acceleration, force = pair(a, turning, wanted)
    yield vanish("I f_u = force", (a.flat(acceleration) - a.determinant * force).entries)


def _swapped(a: Algebra, loop: Loop) -> Vector:
    turning = loop.rate_gain * loop.nu_u - loop.eta
    return law(a, loop) - gyroscopic(a, turning, loop.nu) + gyroscopic(a, loop.nu, turning)


def _turned(a: Algebra, loop: Loop) -> Vector:
    turning = gyroscopic(a, loop.rate_gain * loop.nu_u - loop.eta, loop.nu)
    return law(a, loop) - turning - turning


_HARMED_LAWS: dict[str, Force] = {
    "the sign of ad*": _turned,
    "the sign of nu_u'": lambda a, m: law(a, replace(m, nu_u_dot=-m.nu_u_dot)),
    "ad*_nu I x for ad*_x I nu": _swapped,
}

_POLYNOMIAL = "polynomials"

STATEMENTS = (
    Statement(
        "passivity", "lem. (skysym)", _POLYNOMIAL, "algebra", _is_passive, gyroscopic,
        {
            "ad*_y I x": lambda a, x, y: gyroscopic(a, y, x),
            "I ad_x y": lambda a, x, y: a.flat(a.bracket(x, y)),
        },
    ),
    Statement(
        "Levi-Civita: torsion-free, metric", "eq. (Rest)", _POLYNOMIAL, "algebra",
        _is_levi_civita, connection,
        {
            "the sign of ad*": lambda a, x, y: connection(a, x, y)
            + 2 * (gyroscopic(a, x, y) + gyroscopic(a, y, x)),
            "without the bracket": lambda a, x, y: -gyroscopic(a, x, y) - gyroscopic(a, y, x),
            "not symmetrised": lambda a, x, y: a.flat(a.bracket(x, y)) - gyroscopic(a, x, y),
        },
    ),
    Statement(
        "Euler-Poincare from the restriction", "eq. (EulerP)", _POLYNOMIAL, "algebra",
        _is_euler_poincare, connection,
        {
            "the sign of ad*": lambda a, x, y: -connection(a, x, y),
            "not symmetrised": lambda a, x, y: a.flat(a.bracket(x, y)) - gyroscopic(a, x, y),
        },
    ),
    Statement(
        "Theorem 1: W' = -2 k_s W", "thm. (Ctrl2)", _POLYNOMIAL, "algebra", _reaches, law,
        _HARMED_LAWS,
    ),
    Statement(
        "Theorem 2: closed loop", "thm. (TckCtrl)", _POLYNOMIAL, "algebra", _tracks, law,
        _HARMED_LAWS
        | {"the sign of eta'": lambda a, m: law(a, replace(m, eta_dot=-m.eta_dot))},
    ),
    Statement(
        "right invariance: force_R(g, nu) = -force_L(g^-1, -nu)", "sec. 2",
        _POLYNOMIAL, "algebra", _is_mirrored, lambda a, m: -law(a, m.mirrored),
        {
            "force_L(g, nu) as it is": law,
            "force_L(g^-1, -nu), its sign kept": lambda a, m: law(a, m.mirrored),
        },
    ),
    Statement(
        "force = I f_u without the inverse inertia", "eq. (TckCtrl)", _POLYNOMIAL, "inverse",
        _is_lowered, lowered,
        {
            "I^sharp left out": lambda a, x, y: (a.determinant * (x + y), lowered(a, x, y)[1]),
            "I on both terms": lambda a, x, y: (lowered(a, x, y)[0], a.flat(x + y)),
        },
    ),
)  # fmt: skip
"""Statements about an algebra with an inertia."""
