"""What the closed loop is flown with: a case, a moving reference, a disturbance, a first state."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from bench.algebra import Array, algebra, exp

ROWS = 2
"""Motions integrated together, each with an inertia of its own."""


@dataclass(frozen=True)
class Case:
    """A group, a law, and the options of a vehicle file."""

    group: str
    law: str = "log"
    options: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """As the table says it."""
        law = "" if self.law == "log" else f", {self.law}"
        return f"loop {self.group}{law}{''.join(f' + {one}' for one in self.options)}"


@dataclass(frozen=True)
class Wave:
    """A smooth motion: two sines in every coordinate of every row; amplitudes (2, rows, n)."""

    amplitude: Array
    pace: Array
    phase: Array

    def at(self, t: float) -> Array:
        """Value, (rows, n)."""
        return np.asarray((self.amplitude * np.sin(self.pace * t + self.phase)).sum(0))

    def rate(self, t: float) -> Array:
        """Its exact rate, (rows, n)."""
        swing = self.amplitude * self.pace * np.cos(self.pace * t + self.phase)
        return np.asarray(swing.sum(0))


def wave(random: np.random.Generator, n: int, size: float) -> Wave:
    """One at random, slow enough for 8 s to show a few of its turns."""
    shape = (2, ROWS, n)
    uniform = random.uniform
    return Wave(*(uniform(low, high, shape) for low, high in ((-size, size), (0.3, 1.5), (0, 6))))


@dataclass(frozen=True)
class Start:
    """Inertia (rows, n, n), all its entries at work, reference, disturbance and first state."""

    inertia: Array
    reference: Wave
    external: Wave
    g: Array
    nu: Array
    g_r: Array
    momentum: Array


def start(case: Case, seed: int = 0) -> Start:
    """Errors of 1.5 rad and metres taken together, far from any cut."""
    space, n = algebra(case.group), algebra(case.group).dim
    random = np.random.default_rng([seed, *case.name.encode()])
    half = random.normal(size=(ROWS, n, n))
    reference, apart = (random.normal(size=(ROWS, n)) for _ in range(2))
    apart *= 1.5 / np.linalg.norm(apart, axis=-1, keepdims=True)
    g_r = exp(space.hat(reference))
    return Start(
        inertia=half @ np.swapaxes(half, -1, -2) / n + np.eye(n),
        reference=wave(random, n, 0.4),
        external=wave(random, n, 1.0),
        g=space.store(g_r @ exp(space.hat(apart))),
        nu=0.5 * random.normal(size=(ROWS, n)),
        g_r=space.store(g_r),
        momentum=random.normal(size=(ROWS, n)),
    )
