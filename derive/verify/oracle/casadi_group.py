"""The paper's formulas on any group, from its basis alone, in CasADi and differentiated by it.

Matrix products, inverses by elimination, structure constants by least squares. Nothing is
regularised: as casadi_twin, an oracle between about 0.3 and 2.8 rad of error.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import casadi as ca
import numpy as np

from derive.verify.oracle import casadi_twin, matrix_group
from derive.verify.oracle.casadi_twin import OUTPUTS
from derive.verify.oracle.matrix_factor import Factor

MINORS = 5  # rows


@dataclass(frozen=True)
class _Part:
    """One factor: its generators (n, m, m), which rows of B there are, its kind."""

    basis: tuple[Any, ...]
    size: int
    turns: int
    sheets: int

    def hat(self, x: ca.SX) -> ca.SX:
        """Coordinates to a matrix."""
        return sum((x[i] * e for i, e in enumerate(self.basis)), ca.SX(*self.basis[0].shape))

    def vee(self, a: ca.SX) -> ca.SX:
        """The nearest coordinates."""
        flat = np.array([e.ravel(order="F") for e in self.basis])  # as CasADi counts
        return ca.DM(np.linalg.pinv(flat.T)) @ ca.vec(a)


def _parts(space: Any) -> list[_Part]:
    found = []
    for one in matrix_group.factors(space):
        basis = tuple(np.array([[float(x) for x in row] for row in e]) for e in one.basis)
        size = one.size if isinstance(one, Factor) else one.whole
        found.append(_Part(basis, size, len(one.turns), one.sheets))
    return found


def _inverse(a: ca.SX) -> ca.SX:
    """By minors, which are short for small matrices; by elimination for larger ones."""
    return ca.inv_minor(a) if a.shape[0] <= MINORS else ca.inv(a)


def _skew(part: _Part, g: ca.SX) -> ca.SX:
    return part.vee(g - _inverse(g)) / 2


def _cayley(part: _Part, g: ca.SX) -> ca.SX:
    one = ca.SX.eye(g.shape[0])
    return 2 * part.vee((g - one) @ _inverse(g + one))


def _log(part: _Part, g: ca.SX) -> ca.SX:
    """Of a rotation its angle and axis; of what it carries V^-1 T, V by Rodrigues' formula."""
    if not part.turns:
        return _unipotent(part, g)
    d = part.size
    R = g[:d, :d]
    x = ca.atan2(R[1, 0], R[0, 0]) if d == 2 else casadi_twin.LAWS["SO3", "log"](R)
    phi = ca.fabs(x) if d == 2 else ca.norm_2(x)
    X = part.hat(ca.vertcat(x, ca.SX.zeros(len(part.basis) - part.turns)))[:d, :d]
    V = ca.SX.eye(d) + (1 - ca.cos(phi)) / phi**2 * X + (phi - ca.sin(phi)) / phi**3 * X @ X
    return ca.vertcat(x, ca.vec(_inverse(V) @ g[:d, d:])) if g.shape[0] > d else x


def _unipotent(part: _Part, g: ca.SX) -> ca.SX:
    """(g - 1) - (g - 1)^2/2 + …, which ends."""
    off = g - ca.SX.eye(g.shape[0])
    power = total = off
    for order in range(2, g.shape[0]):
        power = power @ off
        total = total - (-1) ** order * power / order
    return part.vee(total)


_MATRIX: dict[str, Callable[[_Part, ca.SX], ca.SX]] = {
    "log": _log,
    "skew": _skew,
    "cayley": _cayley,
}


def _law(part: _Part, name: str, g: ca.SX) -> ca.SX:
    """A law of a factor: of quaternions and rotations as printed, of R^n always the element."""
    if part.sheets == 2:
        return casadi_twin.LAWS["S3", name](g[:, 0])
    if part.turns == 3 and part.size == g.shape[0]:
        return casadi_twin.LAWS["SO3", name](g)
    if not part.turns and len(part.basis) == part.size == g.shape[0] - 1:
        return _unipotent(part, g)
    return _MATRIX[name](part, g)


def _split(parts: list[_Part], x: ca.SX) -> list[ca.SX]:
    return list(ca.vertsplit(x, [0, *np.cumsum([len(part.basis) for part in parts]).tolist()]))


def _brackets(parts: list[_Part]) -> list[Any]:
    """ad of each unit vector, (n, n)."""
    n, start, found = sum(len(part.basis) for part in parts), 0, []
    for part in parts:
        for a in part.basis:
            whole = np.zeros((n, n))
            columns = [
                np.array(ca.evalf(part.vee(ca.SX(a @ b - b @ a)))).ravel() for b in part.basis
            ]
            end = start + len(part.basis)
            whole[start:end, start:end] = np.array(columns).T
            found.append(ca.DM(whole))
        start += len(part.basis)
    return found


@cache
def twin(space: Any, law: str) -> ca.Function:
    """The tracking law of eq. (TckCtrl), I^-1 included, of a group by its name or basis.

    Inputs: g_0, g_1, … and g_r_0, …, one matrix for each factor, then those of casadi_twin.
    Outputs, as named in OUTPUTS, (n,) each.
    """
    parts = _parts(space)
    n, sizes = sum(len(part.basis) for part in parts), [part.basis[0].shape[0] for part in parts]
    g, g_r = (
        [ca.SX.sym(f"{name}_{i}", m, m) for i, m in enumerate(sizes)] for name in ("g", "g_r")
    )
    names = ("nu", "nu_r", "nu_r_dot", "momentum", "external")
    nu, nu_r, nu_r_dot, momentum, external = vectors = [ca.SX.sym(name, n) for name in names]
    inertia, slope, reach = numbers = [
        ca.SX.sym("inertia", n, n), ca.SX.sym("lambda"), ca.SX.sym("k_s"),
    ]  # fmt: skip
    g_e = [_inverse(a) @ b for a, b in zip(g_r, g, strict=True)]
    eta = _rates(space, law)(*g_e, nu, nu_r, nu_r_dot)[2]
    nu_u, nu_u_dot, _, eta_dot = _rates(space, law)(*g_e, nu - eta, nu_r, nu_r_dot)
    s = nu - eta + slope * nu_u
    turning = slope * nu_u - eta
    ad = sum((turning[i] * e for i, e in enumerate(_brackets(parts))), ca.SX(n, n))
    carried = ca.solve(inertia, ad.T @ (inertia @ nu + momentum))
    wanted = carried - slope * nu_u_dot + eta_dot - reach * s
    outputs = [nu_u, nu_u_dot, eta_dot, inertia @ wanted - external]
    elements = [f"{name}_{i}" for name in ("g", "g_r") for i in range(len(parts))]
    labels = [*elements, *names, "inertia", "lambda", "k_s"]
    inputs = [*g, *g_r, *vectors, *numbers]
    return ca.Function("twin", inputs, outputs, labels, list(OUTPUTS))


@cache
def _rates(space: Any, law: str) -> ca.Function:
    """(g_e …, nu_e, nu_r, nu_r_dot) -> (nu_u, nu_u_dot, eta, eta_dot), by forward AD sweeps."""
    parts = _parts(space)
    n = sum(len(part.basis) for part in parts)
    sizes = [part.basis[0].shape[0] for part in parts]
    g_e = [ca.SX.sym(f"g_e_{i}", m, m) for i, m in enumerate(sizes)]
    nu_e, nu_r, nu_r_dot = (ca.SX.sym(name, n) for name in ("nu_e", "nu_r", "nu_r_dot"))
    pairs = list(zip(parts, g_e, strict=True))
    velocities, references = _split(parts, nu_e), _split(parts, nu_r)
    rows = zip(pairs, velocities, strict=True)
    flow = ca.vertcat(*(ca.vec(g @ part.hat(x)) for (part, g), x in rows))
    nu_u = ca.vertcat(*(_law(part, law, g) for part, g in pairs))
    rows = zip(pairs, references, strict=True)
    eta = ca.vertcat(*(part.vee(_inverse(g) @ part.hat(x) @ g) for (part, g), x in rows))
    stored = ca.vertcat(*map(ca.vec, g_e))
    nu_u_dot = ca.jtimes(nu_u, stored, flow)
    eta_dot = ca.jtimes(eta, ca.vertcat(stored, nu_r), ca.vertcat(flow, nu_r_dot))
    return ca.Function("rates", [*g_e, nu_e, nu_r, nu_r_dot], [nu_u, nu_u_dot, eta, eta_dot])
