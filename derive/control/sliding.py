"""Geometric sliding-mode control, exactly as in the paper, and never through I^-1.

What is commanded is the force I f_u: the sharp of the paper's f_u cancels against it.
"""

from __future__ import annotations

from sympy import Expr, Matrix

from derive.control.kinematic import KinematicLaw, apply
from derive.control.mechanics import (
    Extras,
    MechanicalSystem,
    let_momentum,
    take_extras,
    take_system,
)
from derive.control.port import (
    KINEMATIC,
    RATE,
    give_command,
    take_gains,
    take_reference,
    take_state,
)
from derive.lie.group import Group
from derive.routine.derivation import Derivation


def tracking(
    group: Group, law: KinematicLaw, pattern: tuple[bool, ...], options: tuple[str, ...] = ()
) -> Derivation:
    """Force that drives (g, nu) to the reference (g_r, nu_r); eq. (TckCtrl)."""
    d = Derivation("tracking", "force that drives (g, nu) to (g_r, nu_r)", "eq. (TckCtrl)")
    system = take_system(d, group, pattern)
    rate_gain, reach_gain = take_gains(d, "gsmc")
    g, nu = take_state(d, group)
    extras = take_extras(d, group, options)
    g_r, nu_r, nu_r_dot = take_reference(d, group)

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
    system = take_system(d, group, pattern)
    rate_gain, reach_gain = take_gains(d, "reaching")
    g, nu = take_state(d, group)
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
    momentum = let_momentum(d, system, nu, extras)
    force = system.group.coad(turning) * momentum + system.flat(wanted) - extras.external
    force = d.let("force", force, system.group.force_unit, "control force, I f_u", d.source)
    law = (KINEMATIC, nu_u, system.group.log_unit), (RATE, nu_u_dot, system.group.unit)
    return give_command(d, system.group, force, s, law, clearance)
