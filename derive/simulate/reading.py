"""What is read off a flight: when a value has settled, energy by an instant, swings, gains."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np

from derive.simulate.flight import Flight
from derive.simulate.space import Array

LEAST = 1e-300  # stands for zero under a logarithm
BAND = 1e-6  # of the largest value: what is smaller swings by rounding


def settled_instant(t: Array, values: Array, threshold: float) -> float | None:
    """The first instant of t from which values (T,) stay at or below it, as a sweep counts it.

    None where they do not; a value that is no number is above every threshold.
    """
    above = np.flatnonzero(~(values <= threshold))
    first = int(above[-1]) + 1 if len(above) else 0
    return None if first == len(t) else float(t[first])


def settled_between(t: Array, values: Array, thresholds: Array) -> Array:
    """When values (T,) come to stay at or below each threshold (M,); NaN where they do not.

    Between two instants their logarithm is taken as linear, so that times do not stand in steps.
    """
    if not np.isfinite(values).all():
        return np.full(len(thresholds), np.nan)
    highest = np.maximum.accumulate(values[::-1])[::-1]  # from each instant on
    first = np.searchsorted(-highest, -thresholds)
    at, before = np.minimum(first, len(t) - 1), np.maximum(first - 1, 0)
    logs, wanted = np.log(np.maximum(values, LEAST)), np.log(thresholds)
    fall = np.where(first > 0, logs[before] - logs[at], 1.0)
    part = np.clip((logs[before] - wanted) / np.where(fall > 0, fall, 1.0), 0.0, 1.0)
    found = t[before] + np.where(first > 0, part, 0.0) * (t[at] - t[before])
    return np.asarray(np.where(first < len(t), found, np.nan))


def settling(flight: Flight, values: Array, threshold: float) -> float | None:
    """settled_between for one threshold; None where they do not."""
    found = float(settled_between(flight.t, values, np.array([threshold]))[0])
    return None if np.isnan(found) else found


def until(flight: Flight, seconds: float) -> Flight:
    """The flight up to an instant, that one included."""
    kept = int(np.searchsorted(flight.t, seconds + 1e-9))
    return replace(flight, **{one.name: getattr(flight, one.name)[:kept] for one in fields(flight)})


def energy(flight: Flight, seconds: float) -> float:
    """Square root of the integral of force^2 up to an instant."""
    return float(np.interp(seconds, flight.t, flight.energy))


def swings(values: Array) -> int:
    """How often values (T,) change sign, by more than BAND of the largest on either side."""
    kept = values[np.abs(values) > BAND * np.abs(values).max(initial=0.0)]
    return int(np.count_nonzero(np.diff(np.sign(kept))))


def size(flight: Flight) -> Array:
    """|s|, (T,)."""
    return np.asarray(np.linalg.norm(flight.s, axis=-1))


def total(flight: Flight) -> float:
    """The integral of |s|, by trapezes."""
    return float(np.trapezoid(size(flight), flight.t))


def gamma(flight: Flight, rate_error: Array) -> float:
    """gamma of s = rate_error + gamma (attitude error), by least squares; eq. (si).

    The attitude error is the one the controller itself told, nu_u.
    """
    rest = flight.s - rate_error
    return float((rest * flight.nu_u).sum() / (flight.nu_u**2).sum())
