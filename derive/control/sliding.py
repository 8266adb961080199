"""Geometric sliding-mode control, exactly as in the paper, and never through I^-1.

What is commanded is the force I f_u: the sharp of the paper's f_u cancels against it.
"""

from __future__ import annotations

from typing import Any

from sympy import Expr, Matrix

from derive.control.kinematic import KinematicLaw, apply
from derive.control.mechanics import (
    Extras,
    MechanicalSystem,
    let_momentum,
    take_extras,
    take_system,
)
from derive.lie.group import Group
from derive.routine.derivation import Derivation, Quantity


def tracking(
    group: Group, law: KinematicLaw, pattern: tuple[bool, ...], options: tuple[str, ...] = ()
) -> Derivation:
    """Force that drives (g, nu) to the reference (g_r, nu_r); eq. (TckCtrl)."""
    d = Derivation("tracking", "force that drives (g, nu) to (g_r, nu_r)", "eq. (TckCtrl)")
    system, rate_gain, reach_gain = _parameters(d, group, pattern)
    g, nu = _state(d, group)
    extras = take_extras(d, group, options)
    g_r = _configuration(d, group, "g_r", "reference configuration", "reference")
    nu_r = _velocity(d, group, "nu_r", "reference velocity, reference body frame", "nu")
    nu_r_dot = _velocity(d, group, "nu_r_dot", "its rate", "nu_dot")

    g_e = group.error(d.let, g_r, g)
    g_e = d.let("g_e", g_e, "1", "error, g_r^-1 g", "eq. (velErr)")
    pull = group.pull(d.let, g_e)
    unit = group.unit
    eta = pull("eta", nu_r)
    eta = d.let("eta", eta, unit, "reference velocity in the body frame", "eq. (velErr)")
    nu_e = d.let("nu_e", nu - eta, unit, "velocity error", "eq. (velErr)")
    eta_rate = pull("eta_dot", nu_r_dot) - group.ad(nu_e) * eta
    eta_dot = d.let("eta_dot", eta_rate, group.acceleration_unit, "exact rate of eta")
    nu_u, nu_u_dot, clearance = apply(law, d, group, g_e, nu_e)
    drive = d.let("drive", rate_gain * nu_u, unit, "lambda nu_u")
    s = d.let("s", nu_e + drive, unit, "sliding variable", "eq. (SurfaceErr)")
    asked = eta_dot - rate_gain * nu_u_dot - reach_gain * s
    wanted = d.let("wanted", asked, group.acceleration_unit, "acceleration asked for")
    turning = d.let("turning", drive - eta, unit, "lambda nu_u - eta")
    return _finish(d, system, extras, nu, turning, wanted, s, nu_u, nu_u_dot, clearance)


def reaching(
    group: Group, law: KinematicLaw, pattern: tuple[bool, ...], options: tuple[str, ...] = ()
) -> Derivation:
    """Force that drives (g, nu) to the sliding subgroup, and so to rest; eq. (Ctrl2)."""
    d = Derivation("reaching", "force that drives (g, nu) to (e, 0)", "eq. (Ctrl2)")
    system, rate_gain, reach_gain = _parameters(d, group, pattern)
    g, nu = _state(d, group)
    extras = take_extras(d, group, options)
    nu_u, nu_u_dot, clearance = apply(law, d, group, g, nu)
    unit = group.unit
    drive = d.let("drive", rate_gain * nu_u, unit, "lambda nu_u")
    s = d.let("s", nu + drive, unit, "sliding variable", "eq. (sldS)")
    asked = -rate_gain * nu_u_dot - reach_gain * s
    wanted = d.let("wanted", asked, group.acceleration_unit, "acceleration asked for")
    return _finish(d, system, extras, nu, drive, wanted, s, nu_u, nu_u_dot, clearance)


def _finish(
    d: Derivation,
    system: MechanicalSystem,
    extras: Extras,
    nu: Matrix,
    turning: Matrix,
    wanted: Matrix,
    s: Matrix,
    nu_u: Matrix,
    nu_u_dot: Matrix,
    clearance: Expr,
) -> Derivation:
    """force = coad(turning) I nu + I wanted, and the outputs every controller has."""
    n, unit, force_unit = system.dim, system.group.unit, system.group.force_unit
    momentum = let_momentum(d, system, nu, extras)
    force = system.group.coad(turning) * momentum + system.flat(wanted) - extras.external
    force = d.let("force", force, force_unit, "control force, I f_u", d.source)
    for name, value, of, doc in (
        ("force", force, force_unit, "control force"),
        ("s", s, unit, "sliding variable"),
        ("nu_u", nu_u, system.group.log_unit, "kinematic law"),
        ("nu_u_dot", nu_u_dot, unit, "its exact rate"),
    ):
        d.give(Quantity(name, n, of, doc, place=f"command.{name}"), value)
    near = "distance from the cut locus of the law"
    d.give(Quantity("clearance", 1, "1", near, is_scalar=True, place="clearance"), clearance)
    return d.pruned()


def _parameters(
    d: Derivation, group: Group, pattern: tuple[bool, ...]
) -> tuple[MechanicalSystem, Any, Any]:
    system = take_system(d, group, pattern)
    lambda_ = Quantity("rate_gain", 1, "1/s", "sliding rate", is_scalar=True, place="params.lambda")
    k_s = Quantity("reach_gain", 1, "1/s", "reaching rate", is_scalar=True, place="params.k_s")
    return system, d.take(lambda_), d.take(k_s)


def _state(d: Derivation, group: Group) -> tuple[Matrix, Matrix]:
    g = _configuration(d, group, "g", "configuration", "state")
    nu = Quantity("nu", group.dim, group.unit, "body velocity", place="state.nu")
    return g, d.take(nu)


def _configuration(d: Derivation, group: Group, name: str, doc: str, holder: str) -> Matrix:
    size = len(group.identity)
    doc = f"{doc}: {group.storage}"
    return d.take(Quantity(name, size, "1", doc, place=f"{holder}.g"))


def _velocity(d: Derivation, group: Group, name: str, doc: str, member: str) -> Matrix:
    unit = group.acceleration_unit if member == "nu_dot" else group.unit
    return d.take(Quantity(name, group.dim, unit, doc, place=f"reference.{member}"))
