"""What is judged, the states it is judged on, and how a batch of errors becomes a check."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.backend import Backend
from derive.verify.check import Check
from derive.verify.limits import LIMITS
from derive.verify.plant import Plant
from derive.verify.sample import States

Array = NDArray[Any]


@dataclass(frozen=True)
class Subject:
    """A vehicle as emitted: its numbers, its backends, its numpy module (or None).

    each: samples per rung of the angle ladder
    """

    vehicle: Plant
    backends: tuple[Backend, ...]
    module: Any
    each: int = 120
    seed: int = 0

    @property
    def routines(self) -> tuple[str, ...]:
        """The emitted laws: the guarded one first."""
        return self.vehicle.routines

    @property
    def law(self) -> str:
        """The routine whose law and rate are judged."""
        return self.routines[0]


def by_scalar(subject: Subject) -> Iterator[tuple[str, list[Backend]]]:
    """Each scalar that has backends, with them."""
    for scalar in ("f64", "f32"):
        backends = [backend for backend in subject.backends if backend.scalar == scalar]
        if backends:
            yield scalar, backends


def worst(
    name: str, on: str, error: Array, limit: str, states: States, counted: Array | None = None
) -> Check:
    """The largest error against a limit, with the state it was found at."""
    row = int(np.argmax(error))
    count = len(error) if counted is None else int(counted.sum())
    return Check(name, on, float(error[row]), LIMITS[limit], count, states.described(row))


def rows(name: str, on: str, bad: Array, states: States) -> Check:
    """A count of bad rows, none of which is allowed."""
    first = states.described(int(np.argmax(bad))) if bad.any() else ""
    return Check(name, on, float(bad.sum()), LIMITS["rows"], len(bad), first)
