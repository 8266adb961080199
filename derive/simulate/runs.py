"""What differs between loops that are flown together: where each starts and what it meets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from derive.simulate.space import Array

BLOCK = 128  # instants whose noise is drawn at a time


@dataclass(frozen=True)
class Setting:
    """What all loops share.

    seconds:     duration
    rate:        of the controller, Hz, its force held between; None for a continuous one
    longest:     largest step of the integration, s
    hertz:       frequency of the periodic disturbance
    force_limit: of the actuators, per coordinate, (n,); None for none
    noise_g:     standard deviation of a measured configuration, in algebra coordinates
    noise_nu:    standard deviation of a measured velocity
    """

    seconds: float
    rate: float | None = None
    longest: float = 0.05
    hertz: float = 0.0
    force_limit: tuple[float, ...] | None = None
    noise_g: float = 0.0
    noise_nu: float = 0.0

    @property
    def is_noisy(self) -> bool:
        """Whether anything is measured with noise."""
        return self.noise_g > 0 or self.noise_nu > 0

    @property
    def period(self) -> float:
        """Seconds between two calls of the controller that are looked at."""
        if self.rate:
            return 1 / self.rate
        return self.seconds / max(1, int(np.ceil(self.seconds / self.longest - 1e-9)))

    @property
    def periods(self) -> int:
        """How many of them fit into the duration: the last may end before it."""
        exact = self.seconds / self.period
        nearest = round(exact)
        is_whole = abs(exact - nearest) <= 1e-9 * max(1.0, exact)
        return max(1, nearest if is_whole else int(exact))

    @property
    def parts(self) -> int:
        """Steps of the integration in one period."""
        return max(1, int(np.ceil(self.period / self.longest - 1e-9)))


@dataclass(frozen=True)
class Runs:
    """N loops: columns (size, N), or (size, 1) where all share a value.

    g, nu:       first configuration and velocity
    momentum:    first internal momentum, of wheels
    inertia:     of the plant, upper triangle by rows; the controller has the vehicle's
    external:    known force, which the controller is told
    disturbance: constant force it is not told
    sine, cosine: amplitudes of the periodic one
    seeds:       one per loop, for its noise
    """

    g: Array
    nu: Array
    momentum: Array
    inertia: Array
    external: Array
    disturbance: Array
    sine: Array
    cosine: Array
    seeds: tuple[int, ...]

    def __len__(self) -> int:
        return len(self.seeds)


class Noise:
    """Normal numbers (2 n, N) for every instant, each loop's from its own seed."""

    def __init__(self, seeds: Sequence[int], dim: int) -> None:
        # A stream apart from the one a loop's start is drawn from.
        self._sources = [np.random.default_rng([seed, 1]) for seed in seeds]
        self._dim = dim
        self._block = np.empty((0, 2 * dim, len(seeds)))

    def at(self, instant: int) -> Array:
        """The numbers of an instant; instants are asked for in order."""
        place = instant % BLOCK
        if place == 0:
            size = (BLOCK, 2 * self._dim)
            self._block = np.stack([one.standard_normal(size) for one in self._sources], -1)
        return np.asarray(self._block[place])
