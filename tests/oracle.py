"""The truth about any group with 130 digits: functions of its matrices, and no formula of ours.

It is told a basis and how elements are stored, which is what a group is. Logarithms are those of
matrices, rates central differences along g exp(t hat(nu)), the force the paper's with I^-1.
"""

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

from derive.lie.group import Group
from derive.verify.oracle import matrix_function as function
from derive.verify.oracle.matrix_function import Matrix, Vector, combine, numbers, product, times
from derive.verify.oracle.precise import exactly, mp
from tests.points import embedded, exact, rows

STEP = mp.mpf(10) ** -42


def norm(x: Sequence[Any]) -> Any:
    return mp.sqrt(mp.fsum(a * a for a in x))


def distance(a: Sequence[Any], b: Sequence[Any]) -> Any:
    return norm([x - y for x, y in zip(a, b, strict=True)])


def _sum(*terms: tuple[Any, Vector]) -> Vector:
    factors = [exactly(factor) for factor, _ in terms]
    return tuple(
        mp.fsum(f * x for f, x in zip(factors, each, strict=True))
        for each in zip(*(x for _, x in terms), strict=True)
    )


class Truth:
    """Matrices, adjoints, laws and controllers of one group."""

    def __init__(self, group: Group) -> None:
        self.group = group
        self.basis: list[Matrix] = [tuple(map(numbers, e)) for e in rows(group)]
        flat = tuple(tuple(x for row in e for x in row) for e in self.basis)
        gram = product(flat, function.transpose(flat))
        self._vee = product(function.inverse(gram), flat)

    def matrix(self, stored: Sequence[Any]) -> Matrix:
        """Stored numbers, exactly, as a matrix (m, m)."""
        return tuple(map(numbers, embedded(self.group, list(map(exactly, stored)))))

    def hat(self, x: Sequence[Any]) -> Matrix:
        return combine(*zip(map(exactly, x), self.basis, strict=True))

    def vee(self, a: Matrix) -> Vector:
        """The coordinates (n,) nearest to a."""
        return times(self._vee, [x for row in a for x in row])

    def flow(self, g: Matrix, nu: Vector, time: Any) -> Matrix:
        """g exp(t hat(nu))."""
        return product(g, function.exp(self.hat([time * x for x in nu])))

    def Ad(self, g: Matrix, x: Sequence[Any]) -> Vector:
        return self.vee(product(product(g, self.hat(x)), function.inverse(g)))

    def bracket(self, x: Sequence[Any], y: Sequence[Any]) -> Vector:
        a, b = self.hat(x), self.hat(y)
        return self.vee(combine((1, product(a, b)), (-1, product(b, a))))

    def coad(self, x: Sequence[Any], a: Sequence[Any]) -> Vector:
        """<coad(x) a; y> = <a; [x, y]>."""
        unit = function.identity(self.group.dim)
        return tuple(function.dot(a, self.bracket(x, e)) for e in unit)

    def log(self, g: Matrix) -> Vector:
        return self.vee(function.log(g))

    def law(self, name: str, g: Matrix) -> Vector:
        return LAWS[name](self, g)

    def rate(self, name: str, g: Matrix, nu: Sequence[Any]) -> Vector:
        """d/dt of a law along the flow, (n,)."""
        there, back = (self.law(name, self.flow(g, numbers(nu), t)) for t in (STEP, -STEP))
        return tuple((x - y) / (2 * STEP) for x, y in zip(there, back, strict=True))

    def log_rate(self, x: Sequence[Any], nu: Sequence[Any]) -> Vector:
        """f(ad_x) nu, f(z) = z/(1 - e^-z), from the matrix ad_x alone, (n,).

        exp([[-A, 1], [0, 0]]) holds the integral of e^-sA, which is (1 - e^-A)/A.
        """
        n = self.group.dim
        columns = [self.bracket(x, e) for e in function.identity(n)]
        minus = function.transpose(combine((-1, tuple(columns))))
        upper = [(*row, *e) for row, e in zip(minus, function.identity(n), strict=True)]
        whole = function.exp((*upper, *((mp.zero,) * (2 * n) for _ in range(n))))
        integral = tuple(row[n:] for row in whole[:n])
        found, _ = function.solve(integral, tuple((v,) for v in numbers(nu)))
        return tuple(row[0] for row in found)

    def plant(
        self, inertia: Any, nu: Any, force: Any, momentum: Any = None, external: Any = None
    ) -> Vector:
        """I^-1 (coad(nu) (I nu + h) + force + external)."""
        zero = (0,) * self.group.dim
        whole = _sum((1, times(_square(inertia), numbers(nu))), (1, numbers(momentum or zero)))
        total = _sum((1, self.coad(nu, whole)), (1, numbers(force)), (1, numbers(external or zero)))
        return times(function.inverse(_square(inertia)), total)

    def tracking(self, law: str, given: dict[str, Any]) -> dict[str, Vector]:
        """The command, as eq. (TckCtrl) is printed: with the inverse inertia, times the inertia."""
        g_r, g = self.matrix(given["g_r"]), self.matrix(given["g"])
        g_e, back = product(function.inverse(g_r), g), product(function.inverse(g), g_r)
        nu, nu_r = numbers(given["nu"]), numbers(given["nu_r"])
        eta = self.Ad(back, nu_r)
        nu_e = _sum((1, nu), (-1, eta))
        moved = [
            self.Ad(
                function.inverse(self.flow(g_e, nu_e, t)),
                _sum((1, nu_r), (t, numbers(given["nu_r_dot"]))),
            )
            for t in (STEP, -STEP)
        ]
        eta_dot = tuple((x - y) / (2 * STEP) for x, y in zip(*moved, strict=True))
        return self._command(law, given, g_e, nu, nu_e, eta, eta_dot)

    def reaching(self, law: str, given: dict[str, Any]) -> dict[str, Vector]:
        """The command of eq. (Ctrl2)."""
        nu, zero = numbers(given["nu"]), numbers((0,) * self.group.dim)
        return self._command(law, given, self.matrix(given["g"]), nu, nu, zero, zero)

    def _command(
        self, law: str, given: dict[str, Any], g_e: Matrix, nu: Vector, nu_e: Vector, eta: Vector,
        eta_dot: Vector,
    ) -> dict[str, Vector]:  # fmt: skip
        slope, reach, inertia = given["rate_gain"], given["reach_gain"], _square(given["inertia"])
        zero = (0,) * self.group.dim
        nu_u, nu_u_dot = self.law(law, g_e), self.rate(law, g_e, nu_e)
        s = _sum((1, nu_e), (slope, nu_u))
        whole = _sum((1, times(inertia, nu)), (1, numbers(given.get("momentum", zero))))
        carried = self.coad(_sum((slope, nu_u), (-1, eta)), whole)
        asked = _sum((-exactly(slope), nu_u_dot), (1, eta_dot), (-exactly(reach), s))
        f_u = _sum((1, times(function.inverse(inertia), carried)), (1, asked))
        external = numbers(given.get("external", zero))
        force = _sum((1, times(inertia, f_u)), (-1, external))
        return {"force": force, "s": s, "nu_u": nu_u, "nu_u_dot": nu_u_dot}


def _square(upper: Sequence[Any]) -> Matrix:
    """An upper triangle, row by row, as a symmetric matrix."""
    n = next(n for n in range(1, 30) if n * (n + 1) // 2 == len(upper))
    entries = iter(map(exactly, upper))
    found = {(i, j): next(entries) for i in range(n) for j in range(i, n)}
    return tuple(tuple(found[min(i, j), max(i, j)] for j in range(n)) for i in range(n))


def _skew(truth: Truth, g: Matrix) -> Vector:
    half = mp.mpf(0.5)
    return truth.vee(combine((half, g), (-half, function.inverse(g))))


def _cayley(truth: Truth, g: Matrix) -> Vector:
    unit = function.identity(len(g))
    found, _ = function.solve(combine((1, g), (1, unit)), combine((2, g), (-2, unit)))
    return truth.vee(found)


def _bent(shape: Callable[[Any], Any]) -> Callable[[Truth, Matrix], Vector]:
    """shape(angle) times the axis of each rotation; what does not turn is its own logarithm."""

    def law(truth: Truth, g: Matrix) -> Vector:
        x, found, start = truth.log(g), [], 0
        for one in truth.group.factors or (truth.group,):
            part = x[start : start + one.dim]
            angle = norm(part)
            factor = shape(angle) / angle if one.is_rotation and angle else 1
            found += [factor * a for a in part]
            start += one.dim
        return tuple(found)

    return law


LAWS: dict[str, Callable[[Truth, Matrix], Vector]] = {
    "log": Truth.log,
    "skew": _skew,
    "cayley": _cayley,
    "half_log": _bent(lambda angle: angle / 2),
    "lee": _bent(lambda angle: mp.sin(angle / 2)),
    "gibbs": _bent(lambda angle: 2 * mp.tan(angle / 2)),
    "mrp": _bent(lambda angle: 4 * mp.tan(angle / 4)),
    "vec": _bent(lambda angle: 2 * mp.sin(angle / 2)),
    "sign_vec": _bent(lambda angle: mp.sign(mp.cos(angle / 2)) * mp.sin(angle / 2)),
}
"""Every law by the table of the laws: of the matrix, or of angle and axis."""


@cache
def truth(group: Group) -> Truth:
    return Truth(group)


def fractions(x: Sequence[Any]) -> list[Any]:
    """Rational numbers of sympy as fractions."""
    return [exact(a) for a in x]
