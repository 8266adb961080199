"""What is found of a kinematic law on a group, property by property of the Definition."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Oddness:
    """Property (ii): exact elements tried, places where it fails or the law is not defined."""

    tried: int
    is_exact: bool
    fails: tuple[str, ...]
    undefined: tuple[str, ...]
    example: str = ""


@dataclass(frozen=True)
class Jump:
    """A cut: its place, the largest jump of nu_u there, and whether the rate has no bound."""

    place: str
    size: float
    is_steep: bool


@dataclass(frozen=True)
class Equilibria:
    """A set on which nu_u vanishes: its place, its dimension, and whether it repels.

    is_every: nu_u vanishes on every element that turns by that angle
    """

    place: str
    dimension: int
    repels: bool
    is_every: bool
    example: str


@dataclass(frozen=True)
class Fall:
    """Properties (iii) and (iv) for one V.

    rises:      least and largest angle, rad, of samples where V does not fall; empty: it does
    low, high:  of y, on the samples, or of the stated y where it fits
    factor:     the stated y, empty where nothing is stated
    misfit:     between measured and stated y, relative to 1 + |y|
    """

    morse: str
    rises: tuple[float, ...]
    low: float
    high: float
    factor: str
    misfit: float
    samples: int
    example: str = ""

    @property
    def holds(self) -> bool:
        """Whether V falls wherever the law is defined and not zero."""
        return not self.rises


@dataclass(frozen=True)
class Verdict:
    """All that was found of one law on one group; see the classes above."""

    group: str
    law: str
    doc: str
    is_zero_at_e: bool
    odd: Oddness
    jumps: tuple[Jump, ...]
    rests: tuple[Equilibria, ...]
    falls: tuple[Fall, ...]
    unwinds: bool
    contradictions: tuple[str, ...]

    @property
    def poles(self) -> tuple[Jump, ...]:
        """Cuts on the way to which the law or its rate has no bound."""
        return tuple(one for one in self.jumps if one.is_steep or math.isinf(one.size))

    @property
    def crowds(self) -> tuple[Equilibria, ...]:
        """Equilibria that are not isolated, against the Definition."""
        return tuple(one for one in self.rests if one.dimension)

    @property
    def rises(self) -> bool:
        """Whether V fails to fall for every V that was tried."""
        return bool(self.falls) and not any(one.holds for one in self.falls)
