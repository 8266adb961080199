"""The one table of limits. A figure is what was promised, never what was measured."""

from __future__ import annotations

from dataclasses import dataclass

EPS = {"f64": 2.0**-52, "f32": 2.0**-23}
"""One unit in the last place of 1, per scalar."""


@dataclass(frozen=True)
class Limit:
    """What a check may measure at most: `eps` of the scalar, `relative`, or a count of `rows`."""

    name: str
    figure: float
    unit: str
    doc: str


_TABLE = (
    Limit("log", 3, "eps", "law against truth, relative to its length"),
    Limit("rate", 4, "eps", "exact rate of the law against truth, relative to its length"),
    Limit("beyond_pi", 20, "eps", "law and rate on S3 beyond a rotation by pi"),
    Limit("force_f64", 2e-14, "relative", "whole force in double against truth"),
    Limit("force_f32", 1e-5, "relative", "whole force in float against truth"),
    Limit("differences", 1e-12, "relative", "6th-order central differences along the flow"),
    Limit("complex_step", 5e-15, "relative", "complex step along the flow"),
    Limit("twin", 1e-12, "relative", "CasADi's derivative of the printed formula, mid angles"),
    Limit("symbolic", 1e-40, "relative", "chain rule against closed form, 50 digits"),
    Limit("rows", 0, "rows", "rows that differ, or are not finite"),
    Limit("mutant", 30, "eps", "movement from which a mutant must be caught"),
)

LIMITS = {limit.name: limit for limit in _TABLE}
"""Every limit by name."""

COEFFICIENT = 1e-9
"""Relative change of a coefficient that a mutant makes."""

SEEDS = 20
"""Seeds over which the unharmed code must raise no alarm."""
