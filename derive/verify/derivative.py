"""Derivatives of the emitted code, by three ways of differentiating, against what it says."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify import rates, sample
from derive.verify.backend import call
from derive.verify.check import Check
from derive.verify.sample import States
from derive.verify.shape import space
from derive.verify.subject import Subject, worst

Array = NDArray[Any]
SAMPLES = 500
LENGTHS = (0.1, 1.0, 3.0)
"""Of translations, m: differences lose the digits that larger ones have more than velocities."""


def derivatives(subject: Subject) -> Iterator[Check]:
    """d/dt nu_u, d/dt eta and the whole force, by three ways of differentiating."""
    if subject.module is None:
        return
    vehicle, rng = subject.vehicle, np.random.default_rng(subject.seed)
    angle = sample.smooth_angles(vehicle, SAMPLES, rng)
    moving = subject.vehicle.has_reference
    states = sample.states(vehicle, angle, "f64", rng, is_moving=moving, lengths=LENGTHS)
    whole, still = (_law(subject, at_rest) for at_rest in (False, True))
    eta = rates.body_reference(vehicle, states)
    nu_e, found, at_rest = states.nu - eta, whole(states), still(states)
    for what, limit, differentiate in (
        ("6th-order differences", "differences", rates.differences),
        ("complex step", "complex_step", rates.complex_step),
    ):
        nu_u_dot = differentiate(vehicle, whole, states, nu_e)["nu_u"]
        eta_dot = differentiate(vehicle, still, states, nu_e)["eta"] if moving else 0 * eta
        force = rates.whole_force(vehicle, states, eta, found["nu_u"], eta_dot, nu_u_dot)
        theirs = {"nu_u_dot": nu_u_dot, "eta_dot": eta_dot, "force": force}
        yield from _compared(subject, states, {**at_rest, **found}, theirs, what, limit)
    theirs = rates.twin(vehicle, states)
    yield from _compared(subject, states, {**at_rest, **found}, theirs, "CasADi", "twin")


def _compared(
    subject: Subject, states: States, mine: Any, theirs: Any, what: str, limit: str
) -> Iterator[Check]:
    """Each rate relative to its length, or to that of its terms where they cancel."""
    vehicle = subject.vehicle
    scales = rates.term_scales(vehicle, states)
    if limit == "differences":
        scales = rates.step_scales(vehicle, states, np.asarray(mine["nu_u"]))
    for name, expected in theirs.items():
        if name != "eta_dot" or vehicle.has_reference:
            error = rates.relative(vehicle, mine[name], expected, scales.get(name, 0.0))
            yield worst(f"{name}: {what}", "numpy f64", error, limit, states)


def _law(subject: Subject, at_rest: bool) -> rates.Law:
    """The numpy module as States -> outputs; at rest: unit inertia, no gains, eta and its rate.

    With I = 1 and lambda = k_s = 0, s = nu - eta and force = eta' - coad(eta) nu; momentum and
    external force are left out.
    """
    vehicle, group = subject.vehicle, space(subject.vehicle.space)
    upper = np.eye(group.dim)[np.triu_indices(group.dim)]
    unit = subject.module.Params(tuple(upper), 0.0, 0.0)

    def law(states: States) -> dict[str, Array]:
        if at_rest:
            zero = np.zeros_like(states.nu)
            states = replace(states, momentum=zero, external=zero)
        params = unit if at_rest else subject.module.DEFAULTS
        command = call(subject.module, vehicle, subject.law, states, params)
        outputs = {name: getattr(command, name) for name in ("force", "s", "nu_u", "nu_u_dot")}
        if at_rest:
            eta = states.nu - outputs["s"]
            outputs |= {"eta": eta, "eta_dot": outputs["force"] + group.coad(eta, states.nu)}
        return outputs

    return law
