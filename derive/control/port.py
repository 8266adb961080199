"""What goes into every controller and what comes out of it, by name, place and unit."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sympy import Expr, Matrix

from derive.control.table import CONTROLLERS
from derive.lie.group import Group
from derive.routine.derivation import Derivation, Quantity

ERROR = "g_e"
"""The error, as a step of every law with a reference: what the guard judges."""

KINEMATIC = ("nu_u", "kinematic law")
RATE = ("nu_u_dot", "its exact rate")
ATTITUDE = ("nu_u", "attitude error")
"""What a command holds besides force and s: name, and what it is."""


def take_gains(d: Derivation, controller: str) -> list[Any]:
    """Declare the gains of a controller as inputs of d; their symbols, in the table's order."""
    gains = CONTROLLERS[controller].gains
    return [
        d.take(Quantity(one.symbol, 1, one.unit, one.doc, "", True, f"params.{one.name}"))
        for one in gains
    ]


def take_state(d: Derivation, group: Group) -> tuple[Matrix, Matrix]:
    """Configuration g (k, 1) and body velocity nu (n, 1)."""
    g = _configuration(d, group, "g", "configuration", "state")
    nu = Quantity("nu", group.dim, group.unit, "body velocity", place="state.nu")
    return g, d.take(nu)


def take_reference(d: Derivation, group: Group) -> tuple[Matrix, Matrix, Matrix]:
    """g_r (k, 1), nu_r and nu_r_dot (n, 1)."""
    g_r = _configuration(d, group, "g_r", "reference configuration", "reference")
    nu_r = _velocity(d, group, "nu_r", "reference velocity, reference body frame", "nu")
    return g_r, nu_r, _velocity(d, group, "nu_r_dot", "its rate", "nu_dot")


def give_command(
    d: Derivation,
    group: Group,
    force: Matrix,
    s: Matrix,
    others: Sequence[tuple[tuple[str, str], Matrix, str]],
    clearance: Expr,
) -> Derivation:
    """Declare the outputs, and leave out what neither they nor the guard needs.

    others: what the command holds besides, (name, doc), (n, 1) and unit
    clearance: of the law, zero at its cut locus
    """
    shared = (("force", "control force"), force, group.force_unit)
    sliding = (("s", "sliding variable"), s, group.unit)
    for (name, doc), value, unit in (shared, sliding, *others):
        d.give(Quantity(name, group.dim, unit, doc, place=f"command.{name}"), value)
    near = "distance from the cut locus of the law"
    d.give(Quantity("clearance", 1, "1", near, is_scalar=True, place="clearance"), clearance)
    return d.pruned(keep=ERROR)


def _configuration(d: Derivation, group: Group, name: str, doc: str, holder: str) -> Matrix:
    doc = f"{doc}: {group.storage}"
    return d.take(Quantity(name, group.size, "1", doc, place=f"{holder}.g"))


def _velocity(d: Derivation, group: Group, name: str, doc: str, member: str) -> Matrix:
    unit = group.acceleration_unit if member == "nu_dot" else group.unit
    return d.take(Quantity(name, group.dim, unit, doc, place=f"reference.{member}"))
