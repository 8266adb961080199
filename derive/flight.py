"""The route of a closed loop: vehicle -> craft -> loop -> flight and its figures."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import numpy as np

from derive import pipeline
from derive.course import course
from derive.simulate.craft import Craft
from derive.simulate.draw import Spread, drawn
from derive.simulate.flight import Flight, recorded
from derive.simulate.invariant import Invariant, invariants
from derive.simulate.loop import Loop
from derive.simulate.reference import Reference
from derive.simulate.runs import Runs, Setting
from derive.simulate.space import Array, space_of
from derive.vehicle import InputError, Vehicle, check_facts, resolve

SAMPLED_STEP = 0.01  # s, the longest where the force is held


@dataclass(frozen=True)
class Flown:
    """One run of a vehicle, its flight, and what was watched in it."""

    vehicle: Vehicle
    craft: Craft
    setting: Setting
    backend: str
    flight: Flight
    invariants: tuple[Invariant, ...]

    @property
    def ok(self) -> bool:
        """Whether no invariant broke."""
        return all(one.ok for one in self.invariants)


def craft(vehicle: Vehicle, cached: Path | None) -> Craft:
    """The vehicle as the simulator takes it, emitted files included. Raises InputError."""
    check_facts(vehicle, resolve(vehicle))
    n, own = len(vehicle.inertia), vehicle.own
    return Craft(
        name=vehicle.name,
        group=vehicle.group,
        law=vehicle.law,
        controller=vehicle.controller,
        inertia=tuple(float(vehicle.inertia[i][j]) for i in range(n) for j in range(i, n)),
        gains=tuple((name, float(value)) for name, value in vehicle.gains),
        files=tuple(sorted(pipeline.texts(vehicle, cached).items())),
        options=vehicle.options,
        own=own.basis if own else None,
        units=own.units if own else (),
    )


def fly(
    vehicle: Vehicle,
    cached: Path | None,
    backend: str,
    spread: Spread | None = None,
    seed: int = 0,
    progress: Callable[[str], None] = lambda _: None,
) -> Flown:
    """One run as the vehicle file states it, or, with a spread, as the sweep draws it by a seed.

    Raises InputError, and CompilerMissing or CompileError where C cannot be built.
    """
    progress("deriving")
    made = craft(vehicle, cached)
    reference, setting = course(vehicle, made).reference(), setting_of(vehicle)
    if spread is None:
        runs = stated(vehicle, made, reference, seed)
    else:
        runs = drawn(made, reference, setting, spread, [seed])
    loop = Loop(made, backend, reference, setting, runs)
    (flight,) = recorded(loop.moments(), lambda t: progress(f"{t:.1f} of {setting.seconds:g} s"))
    progress("invariants")
    return Flown(vehicle, made, setting, backend, flight, tuple(invariants(loop, flight)))


def setting_of(vehicle: Vehicle) -> Setting:
    """What its [simulate] says of every run. Raises InputError."""
    asked = vehicle.experiment
    rate = None if asked.rate is None else float(asked.rate)
    if rate is None and (asked.noise_g or asked.noise_nu):
        raise InputError(vehicle.source, "simulate.rate", "a rate in Hz: noise is of samples",
                         "a continuous controller", "give a rate, or leave out the noise")  # fmt: skip
    if rate is not None and rate * float(asked.seconds) < 1:
        raise InputError(vehicle.source, "simulate.rate", "at least one period in the duration",
                         f"{rate:g} Hz over {float(asked.seconds):g} s",
                         "raise the rate, or the duration")  # fmt: skip
    step = float(asked.step)
    return Setting(
        seconds=float(asked.seconds),
        rate=rate,
        longest=step if rate is None else min(step, SAMPLED_STEP),
        hertz=float(asked.hertz),
        force_limit=tuple(map(float, asked.force_limit)) or None,
        noise_g=float(asked.noise_g),
        noise_nu=float(asked.noise_nu),
    )


def stated(vehicle: Vehicle, made: Craft, reference: Reference, seed: int) -> Runs:
    """The one run that the vehicle file states; the seed is that of its noise."""
    asked, space = vehicle.experiment, space_of(made)
    n = space.dim
    turn = _column(asked.turn, n, 0.5)
    wave = _column(asked.wave, n)
    return Runs(
        g=space.far(reference.start, turn),
        nu=_column(asked.nu, n),
        momentum=_column(asked.momentum, n),
        inertia=(1 + float(asked.inertia_error)) * np.array(made.inertia)[:, None],
        external=_column(asked.external, n),
        disturbance=_column(asked.disturbance, n),
        sine=wave,
        cosine=np.zeros_like(wave),
        seeds=(seed,),
    )


def _column(values: Sequence[Fraction], n: int, default: float = 0.0) -> Array:
    return np.array([float(one) for one in values] or [default] * n)[:, None]
