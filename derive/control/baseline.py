"""The controllers the paper compares with, on SO3: LSF, as printed and mended, and PD+.

All have the form force = -(gain) s + F with s = rate error + (gain) attitude error. The attitude
error of LSF is that of R R_r^T seen in the body frame, R^T (R R_r^T - R_r R^T)^vee, which is
(R_e - R_e^T)^vee of R_e = R_r^T R, since R^T x^ R = (R^T x)^.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy
from sympy import Matrix

from derive.control.kinematic import KinematicLaw
from derive.control.mechanics import (
    Extras,
    MechanicalSystem,
    let_momentum,
    take_extras,
    take_system,
)
from derive.control.port import ATTITUDE, give_command, take_gains, take_reference, take_state
from derive.lie.group import Group
from derive.routine.derivation import Derivation

Pattern = tuple[bool, ...]


@dataclass(frozen=True)
class Setting:
    """What the baselines share: the system, its gains, state, reference and error g_e, stored."""

    system: MechanicalSystem
    gains: list[Any]
    nu: Matrix
    extras: Extras
    nu_r: Matrix
    nu_r_dot: Matrix
    g_e: Matrix


def lsf_printed(
    group: Group, law: KinematicLaw, pattern: Pattern, options: tuple[str, ...] = ()
) -> Derivation:
    """Linearisation by state feedback with F_2 to the letter; eq. (Ctrls2)."""
    d = Derivation("tracking", "LSF force that tracks (g_r, nu_r)", "eq. (Ctrls2)")
    at = _setting(d, group, pattern, options, "lsf_printed")
    wanted, s, error = _feedback(d, at)
    wanted = d.let("wanted", wanted, group.acceleration_unit, "acceleration asked for")
    # Its unit is not that of a force: F_2 lacks J here, and has the other sign.
    crossing = d.let("crossing", group.ad(at.nu) * at.nu_r, group.acceleration_unit, "nu x nu_r")
    return _linearised(d, at, wanted, -crossing, s, error)


def lsf(
    group: Group, law: KinematicLaw, pattern: Pattern, options: tuple[str, ...] = ()
) -> Derivation:
    """The same with the F_2 that closes the loop to -k J s_2; eq. (Ctrls2) corrected."""
    source = "eq. (Ctrls2) corrected"
    d = Derivation("tracking", "LSF force that tracks (g_r, nu_r)", source)
    at = _setting(d, group, pattern, options, "lsf")
    wanted, s, error = _feedback(d, at)
    crossing = d.let("crossing", group.ad(at.nu) * at.nu_r, group.acceleration_unit, "nu x nu_r")
    asked = wanted + crossing
    wanted = d.let("wanted", asked, group.acceleration_unit, "acceleration asked for")
    return _linearised(d, at, wanted, sympy.zeros(group.dim, 1), s, error)


def pd_plus(
    group: Group, law: KinematicLaw, pattern: Pattern, options: tuple[str, ...] = ()
) -> Derivation:
    """PD+ on rotation matrices; eq. (Ctrls3). psi(R_e) (R_e - R_e^T)^vee is the law `lee`."""
    d = Derivation("tracking", "PD+ force that tracks (g_r, nu_r)", "eq. (Ctrls3)")
    at = _setting(d, group, pattern, options, "pd_plus")
    k_R, k_Omega = at.gains
    unit, flat = group.unit, at.system.flat
    pull = group.pull(d.let, at.g_e)
    eta = pull("eta", at.nu_r)
    eta = d.let("eta", eta, unit, "reference velocity in the body frame", "eq. (velErr)")
    nu_e = d.let("nu_e", at.nu - eta, unit, "velocity error", "eq. (velErr)")
    given = pull("given", at.nu_r_dot)
    given = d.let("given", given, group.acceleration_unit, "nu_r_dot in the body frame")
    found = law.write(d.let, group, at.g_e)
    error = d.let("nu_u", found.value, group.log_unit, f"attitude error, {law.doc}", "eq. (s3)")
    ratio = d.let("ratio", k_R / k_Omega, "1/s", "k_R/k_Omega")
    s = d.let("s", nu_e + ratio * error, unit, "sliding variable", "eq. (s3)")
    momentum = let_momentum(d, at.system, eta, at.extras, "eta")
    force = flat(given) - group.coad(eta) * momentum - k_Omega * s - at.extras.external
    return _given(d, at, force, s, error, found.clearance)


def _setting(
    d: Derivation, group: Group, pattern: Pattern, options: tuple[str, ...], controller: str
) -> Setting:
    system = take_system(d, group, pattern)
    gains = take_gains(d, controller)
    g, nu = take_state(d, group)
    extras = take_extras(d, group, options)
    g_r, nu_r, nu_r_dot = take_reference(d, group)
    g_e = group.error(d.let, g_r, g)
    g_e = d.let("g_e", g_e, "1", "error, g_r^-1 g", "eq. (velErr)")
    return Setting(system, gains, nu, extras, nu_r, nu_r_dot, g_e)


def _feedback(d: Derivation, at: Setting) -> tuple[Matrix, Matrix, Matrix]:
    """nu_r_dot - k s, s and the attitude error of LSF, (n, 1) each.

    Nothing is divided by sines or normalised: the error is smooth everywhere, and vanishes at
    every rotation by pi too.
    """
    group, (k, kappa) = at.system.group, at.gains
    g_e = group.embed(at.g_e)
    odd = group.vee(g_e - group.inverse(g_e))
    doc = "attitude error, 2 sin(angle) axis"
    error = d.let("nu_u", odd, group.log_unit, doc, "eq. (s2)")
    raw = d.let("raw", at.nu - at.nu_r, group.unit, "nu - nu_r, each in its own body frame")
    ratio = d.let("ratio", kappa / k, "1/s", "kappa/k")
    s = d.let("s", raw + ratio * error, group.unit, "sliding variable", "eq. (s2)")
    return at.nu_r_dot - k * s, s, error


def _linearised(
    d: Derivation, at: Setting, wanted: Matrix, more: Matrix, s: Matrix, error: Matrix
) -> Derivation:
    """force = I wanted - coad(nu) I nu + more: the plant's own turning is cancelled."""
    system = at.system
    momentum = let_momentum(d, system, at.nu, at.extras)
    turning = system.group.coad(at.nu) * momentum
    force = system.flat(wanted) - turning + more - at.extras.external
    return _given(d, at, force, s, error, sympy.S.One)


def _given(
    d: Derivation, at: Setting, force: Matrix, s: Matrix, error: Matrix, clearance: Any
) -> Derivation:
    group = at.system.group
    force = d.let("force", force, group.force_unit, "control force", d.source)
    own = ((ATTITUDE, error, group.log_unit),)
    return give_command(d, group, force, s, own, clearance)
