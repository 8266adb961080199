"""A measured cost, and the limit it has to keep where one was promised."""

from __future__ import annotations

from dataclasses import dataclass

from derive.verify.limits import LIMITS, Limit


@dataclass(frozen=True)
class Figure:
    """One measured cost: the most, and where it varies from case to case the least.

    bound: its limit, where that has not the name of the figure; aside: a remark behind the unit
    """

    name: str
    value: float
    unit: str
    least: float | None = None
    bound: Limit | None = None
    aside: str = ""

    @property
    def limit(self) -> Limit | None:
        """What it may be at most, where something was promised."""
        limit = self.bound or LIMITS.get(self.name)
        return limit if limit and limit.unit == self.unit else None

    @property
    def is_within(self) -> bool:
        """Whether it keeps to its limit, or has none."""
        return self.limit is None or self.value <= self.limit.figure
