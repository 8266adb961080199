"""What a vehicle is flown with: its craft, and what its file and a command line say of a run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from derive import pipeline
from derive.demand import PLACE, wide
from derive.simulate.craft import Craft, NoRoom
from derive.simulate.draw import Spread
from derive.simulate.pace import longest, swiftness
from derive.simulate.reference import Reference
from derive.simulate.runs import Runs, Setting
from derive.simulate.space import Array, space_of
from derive.vehicle import InputError, Vehicle, check_facts, resolve

ROOM = "make room there, or let the variable TMPDIR name another folder"
LARGEST_TURN = 32  # rad, of the first error: five times around
MOST_STEPS = 10**6  # of one run: what it records takes 1 GB, and hours
COARSEST = 10  # steps in the time in which a reference changes, at the least
TURN, SPEED = 0.5, 0.1  # of every coordinate at the start, where the vehicle file says nothing


@contextmanager
def roomy() -> Iterator[None]:
    """Turn a temporary folder that takes no more into an InputError; a decorator as well."""
    try:
        yield
    except NoRoom as fault:
        expected = "a folder for temporary files that takes some megabytes"
        raise InputError("TMPDIR", "", expected, str(fault), ROOM) from fault


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
    return "--" + key.replace("_", "-")


def blamed(vehicle: Vehicle, given: Mapping[str, Any], *keys: str) -> tuple[str, str]:
    """Place and name of what is wrong: the first of these that a command line gives, or the file's.

    keys: of Experiment, whose values together cannot be used; the first is the file's to blame
    """
    key = next((key for key in keys if key in given), None)
    return (PLACE, option(key)) if key else (vehicle.source, f"simulate.{keys[0]}")


def spread_of(vehicle: Vehicle, given: Mapping[str, Any], box: float, speed: float) -> Spread:
    """What is drawn around the vehicle's [simulate]: its errors are widths. Raises InputError."""
    said = vehicle.experiment
    error = abs(float(said.inertia_error))
    if error >= 1:
        expected = "less than 1 where it is drawn: an inertia is positive"
        raise InputError(*blamed(vehicle, given, "inertia_error"), expected, f"{error:g}",
                         "give a smaller --inertia-error")  # fmt: skip
    widths = (tuple(abs(float(x)) for x in one) for one in (said.disturbance, said.wave))
    known = (tuple(map(float, one)) for one in (said.momentum, said.external))
    return Spread(box, speed, error, *widths, *known)


def setting_of(
    vehicle: Vehicle, given: Mapping[str, Any], made: Craft, reference: Reference
) -> Setting:
    """What its [simulate] says of every run; given is what a command line has put there.

    Raises InputError.
    """
    asked = vehicle.experiment
    rate = None if asked.rate is None else float(asked.rate)
    _check_together(vehicle, given, rate)
    setting = Setting(
        seconds=float(asked.duration),
        rate=rate,
        longest=_step(vehicle, given, made, reference, rate),
        hertz=float(asked.hertz),
        force_limit=tuple(map(float, asked.force_limit)) or None,
        noise_g=float(asked.noise_g),
        noise_nu=float(asked.noise_nu),
    )
    steps = setting.periods * setting.parts
    if steps > MOST_STEPS:
        found = f"{steps} of {setting.period / setting.parts:.3g} s"
        remedy = "fly for a shorter time or at a lower rate; a --step replaces the one chosen here"
        expected = f"at most {MOST_STEPS} steps of the integration"
        where = blamed(vehicle, given, "duration", "rate", "step", "hertz")
        raise InputError(*where, expected, found, remedy)
    return setting


def _check_together(vehicle: Vehicle, given: Mapping[str, Any], rate: float | None) -> None:
    """Raise InputError for values that cannot be used together."""
    asked = vehicle.experiment
    if rate is None and (asked.noise_g or asked.noise_nu):
        keys = ("rate", "noise_g", "noise_nu")
        expected, remedy = "a rate in Hz: noise is of samples", "give a rate, or no noise"
        found = "a continuous controller"
        raise InputError(*blamed(vehicle, given, *keys), expected, found, remedy)
    if rate is not None and rate * float(asked.duration) < 1:
        expected, remedy = "at least one period in the duration", "raise the rate, or the duration"
        found = f"{rate:g} Hz over {float(asked.duration):g} s"
        raise InputError(*blamed(vehicle, given, "rate", "duration"), expected, found, remedy)
    if "hertz" in given and "wave" not in given and not any(asked.wave):
        expected, found = "a wave of that frequency", "no --wave, and none in the vehicle file"
        remedy = "give its amplitude with --wave, or leave --hertz out"
        raise InputError(PLACE, option("hertz"), expected, found, remedy)
    if any(asked.wave) and not asked.hertz:
        expected, found = "a frequency above 0 where there is a wave", "0 Hz: no force at all"
        remedy = "give its frequency; a constant force is a disturbance"
        raise InputError(*blamed(vehicle, given, "hertz", "wave"), expected, found, remedy)


def _step(
    vehicle: Vehicle,
    given: Mapping[str, Any],
    made: Craft,
    reference: Reference,
    rate: float | None,
) -> float:
    """The one that is given, or one that resolves what is known to be fast. Raises InputError."""
    asked = vehicle.experiment
    if asked.step is not None:
        most = reference.brief / COARSEST
        if float(asked.step) > most:
            expected = f"at most {most:g} s: the reference changes within {reference.brief:g} s"
            found = f"{float(asked.step):g} s"
            remedy = "shorten it, or leave it out for one that fits"
            raise InputError(*blamed(vehicle, given, "step"), expected, found, remedy)
        return float(asked.step)
    hertz = float(asked.hertz) if any(asked.wave) else 0.0
    nu = _column(asked.nu, space_of(made).dim, SPEED)
    swift = swiftness(made, reference, nu, hertz, float(asked.duration))
    return longest(made, rate, swift, reference.brief)


def stated(vehicle: Vehicle, made: Craft, reference: Reference) -> Runs:
    """The one run that the vehicle file states; its noise is of seed 0."""
    asked, space = vehicle.experiment, space_of(made)
    n = space.dim
    turn = _column(asked.turn, n, TURN)
    if np.abs(turn[space.turns]).max(initial=0.0) > LARGEST_TURN:
        expected = f"at most {LARGEST_TURN} in a coordinate that turns"
        found = ", ".join(f"{one:g}" for one in turn[:, 0])
        raise InputError(vehicle.source, "simulate.turn", expected, found, "give it in rad")
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
