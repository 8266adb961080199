"""Derivatives of the emitted code, by three ways of differentiating, against what it says."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify import rates, sample
from derive.verify.check import Check
from derive.verify.sample import States
from derive.verify.subject import Subject, worst

Array = NDArray[Any]
SAMPLES = 500


def derivatives(subject: Subject) -> Iterator[Check]:
    """d/dt nu_u, d/dt eta and the whole force, by three ways of differentiating."""
    if subject.module is None:
        return
    group, law = subject.vehicle.group, subject.vehicle.law
    rng = np.random.default_rng(subject.seed)
    angle = sample.smooth_angles(group, law, SAMPLES, rng)
    states = sample.states(group, angle, "f64", rng, is_moving=subject.has_reference)
    whole, still = (_law(subject, at_rest) for at_rest in (False, True))
    eta = rates.body_reference(states)
    nu_e, found, at_rest = states.nu - eta, whole(states), still(states)
    for what, limit, differentiate in (
        ("6th-order differences", "differences", rates.differences),
        ("complex step", "complex_step", rates.complex_step),
    ):
        nu_u_dot = differentiate(whole, states, nu_e)["nu_u"]
        eta_dot = differentiate(still, states, nu_e)["eta"] if subject.has_reference else 0 * eta
        force = rates.whole_force(subject.vehicle, states.nu, eta, found["nu_u"], eta_dot, nu_u_dot)
        theirs = {"nu_u_dot": nu_u_dot, "eta_dot": eta_dot, "force": force}
        yield from _compared(subject, states, {**at_rest, **found}, theirs, what, limit)
    theirs = rates.twin(subject.vehicle, states)
    yield from _compared(subject, states, {**at_rest, **found}, theirs, "CasADi", "twin")


def _compared(
    subject: Subject, states: States, mine: Any, theirs: Any, what: str, limit: str
) -> Iterator[Check]:
    """Each rate relative to its length, or to that of its terms where they cancel."""
    scales = rates.term_scales(subject.vehicle, states)
    for name, expected in theirs.items():
        if name != "eta_dot" or subject.has_reference:
            error = rates.relative(mine[name], expected, scales.get(name, 0.0))
            yield worst(f"{name}: {what}", "numpy f64", error, limit, states)


def _law(subject: Subject, at_rest: bool) -> rates.Law:
    """The numpy module as States -> outputs; at rest: unit inertia, no gains, eta and its rate.

    With I = 1 and lambda = k_s = 0, s = nu - eta and force = eta' - nu x eta.
    """
    module = subject.module
    unit = module.Params((1.0, 0.0, 0.0, 1.0, 0.0, 1.0), 0.0, 0.0)
    side = (-1, 3, 3) if subject.vehicle.group == "SO3" else (-1, 4)

    def law(states: States) -> dict[str, Array]:
        params = unit if at_rest else module.DEFAULTS
        g, g_r = states.g.reshape(side), states.g_r.reshape(side)
        if not subject.has_reference:
            command = module.reaching(g, states.nu, params)
        else:
            command = module.tracking(g, states.nu, g_r, states.nu_r, states.nu_r_dot, params)
        outputs = {name: getattr(command, name) for name in ("force", "s", "nu_u", "nu_u_dot")}
        if at_rest:
            eta = states.nu - outputs["s"]
            outputs |= {"eta": eta, "eta_dot": outputs["force"] + np.cross(states.nu, eta)}
        return outputs

    return law
