"""The route of a closed loop: vehicle -> craft -> loop -> flight and its figures."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from derive import pipeline
from derive.course import course
from derive.demand import backend_of, wide
from derive.simulate import tell
from derive.simulate.craft import Craft, group_of
from derive.simulate.draw import Spread, drawn
from derive.simulate.flight import Flight, recorded
from derive.simulate.invariant import Invariant, crossings, invariants
from derive.simulate.loop import Loop
from derive.simulate.pace import longest
from derive.simulate.reference import Reference
from derive.simulate.runs import Runs, Setting
from derive.simulate.space import Array, space_of
from derive.vehicle import InputError, Vehicle, check_facts, resolve

TURN, SPEED = 0.5, 0.1  # of every coordinate at the start, where the vehicle file says nothing


@dataclass(frozen=True)
class Asked:
    """What a command line says of a run.

    seed:  draw the run as a sweep does; None for the one that the vehicle file states
    given: keys of Experiment that replace those of the vehicle file
    out:   folder for figures and numbers; None for none
    """

    backend: str = "f64"
    seed: int | None = None
    box: float = 1.0
    speed: float = 0.5
    given: Mapping[str, Any] = field(default_factory=dict)
    out: Path | None = None


@dataclass(frozen=True)
class Flown:
    """One run of a vehicle, its flight, and what was watched in it."""

    vehicle: Vehicle
    craft: Craft
    setting: Setting
    asked: Asked
    flight: Flight
    invariants: tuple[Invariant, ...]

    @property
    def ok(self) -> bool:
        """Whether no invariant broke."""
        return all(one.ok for one in self.invariants)

    @property
    def found(self) -> dict[str, float | None]:
        """Its figures by name."""
        turns = space_of(self.craft).turns
        return tell.figures(self.flight, crossings(self.flight.nu_u[:, turns]))

    def table(self) -> str:
        """Figures and invariants as text."""
        rate = self.setting.rate
        pace = "continuous" if rate is None else f"{rate:g} Hz"
        drawn = "" if self.asked.seed is None else f", seed {self.asked.seed}"
        head = (
            f"{self.craft.name}: {self.craft.controller} on {self.craft.group}, "
            f"{self.asked.backend}, {pace}, {self.setting.seconds:g} s{drawn}"
        )
        return tell.table(head, group_of(self.craft), self.found, self.invariants)

    def as_json(self) -> str:
        """Everything, trajectory included."""
        craft = self.craft
        facts = {"vehicle": craft.name, "group": craft.group, "law": craft.law,
                 "controller": craft.controller, "backend": self.asked.backend,
                 "seed": self.asked.seed}  # fmt: skip
        return tell.as_json(facts, self.setting, self.flight, self.found, self.invariants)


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


def simulate(
    vehicle: Vehicle,
    cached: Path | None,
    asked: Asked,
    progress: Callable[[str], None] = lambda _: None,
) -> Flown:
    """One run as the vehicle file states it, or, by a seed, as a sweep draws it.

    Raises InputError.
    """
    backend_of(asked.backend)
    one = overridden(vehicle, asked.given)
    progress("deriving")
    made = craft(one, cached)
    reference, setting = course(one, made).reference(), setting_of(one, made)
    runs = _runs(one, made, reference, asked)
    loop = Loop(made, asked.backend, reference, setting, runs)
    (flight,) = recorded(loop.moments(), lambda t: progress(f"{t:.1f} of {setting.seconds:g} s"))
    progress("invariants")
    return Flown(one, made, setting, asked, flight, tuple(invariants(loop, flight)))


def overridden(vehicle: Vehicle, given: Mapping[str, Any]) -> Vehicle:
    """The vehicle with what a command line says in the place of what its file says."""
    n = len(vehicle.inertia)
    exact: dict[str, Any] = {
        key: tuple(map(Fraction, wide(value, n, option(key)))) if isinstance(value, tuple)
        else Fraction(value)
        for key, value in given.items()
    }  # fmt: skip
    return replace(vehicle, experiment=replace(vehicle.experiment, **exact))


def option(key: str) -> str:
    """The option that says what a key of Experiment says."""
    return "--" + {"seconds": "duration"}.get(key, key).replace("_", "-")


def _runs(vehicle: Vehicle, made: Craft, reference: Reference, asked: Asked) -> Runs:
    if asked.seed is None:
        runs: Runs = stated(vehicle, made, reference)
        return runs
    spread = spread_of(vehicle, asked.box, asked.speed)
    return drawn(made, reference, spread, [asked.seed])


def spread_of(vehicle: Vehicle, box: float, speed: float) -> Spread:
    """What is drawn around the vehicle's [simulate]: its errors are widths. Raises InputError."""
    said = vehicle.experiment
    error = abs(float(said.inertia_error))
    if error >= 1:
        remedy = "give a smaller --inertia-error"
        raise InputError(vehicle.source, "simulate.inertia_error",
                         "less than 1 where it is drawn: an inertia is positive",
                         f"{error:g}", remedy)  # fmt: skip
    widths = (max(map(abs, map(float, one)), default=0.0) for one in (said.disturbance, said.wave))
    return Spread(box, speed, error, *widths)


def setting_of(vehicle: Vehicle, made: Craft) -> Setting:
    """What its [simulate] says of every run. Raises InputError."""
    asked = vehicle.experiment
    rate = None if asked.rate is None else float(asked.rate)
    if rate is None and (asked.noise_g or asked.noise_nu):
        expected, remedy = "a rate in Hz: noise is of samples", "give a rate, or no noise"
        found = "a continuous controller"
        raise InputError(vehicle.source, "simulate.rate", expected, found, remedy)
    if rate is not None and rate * float(asked.seconds) < 1:
        expected, remedy = "at least one period in the duration", "raise the rate, or the duration"
        found = f"{rate:g} Hz over {float(asked.seconds):g} s"
        raise InputError(vehicle.source, "simulate.rate", expected, found, remedy)
    return Setting(
        seconds=float(asked.seconds),
        rate=rate,
        longest=longest(made, rate) if asked.step is None else float(asked.step),
        hertz=float(asked.hertz),
        force_limit=tuple(map(float, asked.force_limit)) or None,
        noise_g=float(asked.noise_g),
        noise_nu=float(asked.noise_nu),
    )


def stated(vehicle: Vehicle, made: Craft, reference: Reference) -> Runs:
    """The one run that the vehicle file states; its noise is of seed 0."""
    asked, space = vehicle.experiment, space_of(made)
    n = space.dim
    turn = _column(asked.turn, n, TURN)
    wave = _column(asked.wave, n)
    return Runs(
        g=space.far(reference.start, turn),
        nu=_column(asked.nu, n, SPEED),
        momentum=_column(asked.momentum, n),
        inertia=(1 + float(asked.inertia_error)) * np.array(made.inertia)[:, None],
        external=_column(asked.external, n),
        disturbance=_column(asked.disturbance, n),
        sine=wave,
        cosine=np.zeros_like(wave),
        seeds=(0,),
    )


def _column(values: Sequence[Fraction], n: int, default: float = 0.0) -> Array:
    return np.array([float(one) for one in values] or [default] * n)[:, None]
