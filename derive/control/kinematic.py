"""Kinematic laws nu_u: which exist on a group, and how they are applied.

On SO3 and S3 a law is a function of the unit quaternion, elsewhere it is made of the matrix or
of its logarithm; on a direct product it is that of each factor.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy
from sympy import Expr, Matrix, Piecewise

from derive.control import matrix_law, quaternion_law
from derive.control.law import KinematicLaw, Written
from derive.lie.catalogue import GROUPS
from derive.lie.cover import Let
from derive.lie.family import MARKS
from derive.lie.group import Group, marked
from derive.routine.derivation import Derivation

__all__ = ["LAWS", "KinematicLaw", "apply", "laws_of", "why_not"]


def laws_of(group: Group) -> dict[str, KinematicLaw]:
    """Every law that exists on a group, by name."""
    if group.factors:
        return _of_product(group)
    if group.name in quaternion_law.LAWS:
        return quaternion_law.LAWS[group.name]
    return matrix_law.laws_of(group)


def why_not(group: Group, name: str) -> str:
    """Why a law that could exist on any group does not exist on this one; empty for the others."""
    reasons = {
        "log": f"no closed form of the logarithm of {group.name} is found from its basis",
        "cayley": f"(g - 1)(g + 1)^-1 leaves the algebra of {group.name}",
    }
    return reasons.get(name, "")


def apply(
    law: KinematicLaw, d: Derivation, group: Group, g_e: Matrix, nu_e: Matrix
) -> tuple[Matrix, Matrix, Expr]:
    """Steps of nu_u(g_e), (n, 1), its exact rate along g_e' = g_e hat(nu_e), and the clearance."""
    found = law.write(d.let, group, g_e)
    nu_u = d.let("nu_u", found.value, group.log_unit, f"kinematic law, {law.doc}", law.source)
    nu_u_dot = d.let("nu_u_dot", found.rate(d.let, nu_e), group.unit, "exact rate of nu_u")
    return nu_u, nu_u_dot, found.clearance


def _of_product(group: Group) -> dict[str, KinematicLaw]:
    """The laws that every factor has; an additive factor, where all of them agree, has any."""
    each = [laws_of(factor) for factor in group.factors]
    names = dict.fromkeys(name for laws in each for name in laws)
    shared = [name for name in names if all(name in laws or _is_additive(laws) for laws in each)]
    return {name: _together(name, [laws.get(name, laws["log"]) for laws in each])
            for name in shared}  # fmt: skip


def _is_additive(laws: dict[str, KinematicLaw]) -> bool:
    return "log" in laws and laws["log"] is matrix_law.IDENTITY


def _together(name: str, laws: Sequence[KinematicLaw]) -> KinematicLaw:
    """One law per factor, side by side."""

    def write(let: Let, group: Group, g_e: Matrix) -> Written:
        pieces = group.split_element(g_e)
        rows = zip(laws, group.factors, MARKS, pieces, strict=False)
        written = [law.write(marked(let, mark), one, g) for law, one, mark, g in rows]

        def rate(let: Let, nu_e: Matrix) -> Matrix:
            rows = zip(written, MARKS, group.split_velocity(nu_e), strict=False)
            return Matrix.vstack(*(one.rate(marked(let, mark), nu) for one, mark, nu in rows))

        clearance = _nearest(let, [one.clearance for one in written])
        return Written(Matrix.vstack(*(one.value for one in written)), rate, clearance)

    doc = " and ".join(dict.fromkeys(law.doc for law in laws))
    return KinematicLaw(name, write, doc, any(law.is_pole for law in laws))


def _nearest(let: Let, clearances: Sequence[Expr]) -> Expr:
    """The smallest of the clearances that can vanish."""
    first, *others = [one for one in clearances if one != 1] or [sympy.S.One]
    for count, other in enumerate(others):
        value = Piecewise((first, first <= other), (other, True), evaluate=False)
        first = let(f"clearance_{count}", value, "1", "the smaller clearance")
    return first


LAWS: dict[tuple[str, str], KinematicLaw] = {
    (group.name, name): law for group in GROUPS.values() for name, law in laws_of(group).items()
}
"""Every law by (group name, law name), over the catalogue."""
