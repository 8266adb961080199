"""The one table of what a measured cost may be. A figure is what was promised, never measured."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Limit:
    """The most a figure of that name may be."""

    name: str
    figure: float
    unit: str
    what: str


_TABLE = (
    Limit("paper_so3 f64 tracking", 560, "instructions", "the worst call over all angles"),
    Limit("emit, nothing cached", 1.5, "s", "one vehicle, the whole process"),
    Limit("emit, cached", 0.35, "s", "as above, a new inertia of a known pattern"),
    Limit("help", 0.15, "s", "derive --help"),
)

LIMITS = {limit.name: limit for limit in _TABLE}
"""Every limit by the name of the figure it holds."""


@dataclass(frozen=True)
class Figure:
    """One measured cost: the most, and where it varies from case to case the least."""

    name: str
    value: float
    unit: str
    least: float | None = None

    @property
    def limit(self) -> Limit | None:
        """What it may be at most, where something was promised."""
        limit = LIMITS.get(self.name)
        return limit if limit and limit.unit == self.unit else None

    @property
    def is_within(self) -> bool:
        """Whether it keeps to its limit, or has none."""
        return self.limit is None or self.value <= self.limit.figure
