"""What the truth has to know of a vehicle: its group, law, controller, numbers and options."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from derive.control.table import CONTROLLERS

DTYPES = {"f32": np.float32, "f64": np.float64}

Rows = tuple[tuple[Fraction, ...], ...]


@dataclass(frozen=True)
class Plant:
    """The numbers of a vehicle, exact: inertia (n, n), and gains in the order of CONTROLLERS.

    force_limit, saturation: what `control` keeps the force to, n numbers, and whether it keeps
        its "direction" or cuts each "axis"; empty where it keeps to nothing
    max_drift: distance from the group that is fine; None for that of each scalar
    hysteresis: where `control` takes the error q or -q, by how much it keeps to its choice
    own:     n matrices (m, m), the basis of a user's group; None for a group known by its name
    options: of "external" and "momentum", what the state holds besides
    """

    group: str
    law: str
    inertia: Rows
    gains: tuple[Fraction, ...]
    controller: str = "gsmc"
    own: tuple[Rows, ...] | None = None
    options: tuple[str, ...] = ()
    force_limit: tuple[Fraction, ...] = ()
    saturation: str = ""
    max_drift: Fraction | None = None
    hysteresis: Fraction | None = None

    @property
    def space(self) -> str | tuple[Rows, ...]:
        """What says which group it is: its name, or its basis."""
        return self.group if self.own is None else self.own

    @property
    def factors(self) -> tuple[str, ...]:
        """Names of the factors; of a user's group its own."""
        return (self.group,) if self.own is not None else tuple(self.group.split(" x "))

    @property
    def is_attitude(self) -> bool:
        """Whether every truth is one of unit quaternions."""
        return self.own is None and self.group in ("SO3", "S3")

    @property
    def is_baseline(self) -> bool:
        """Whether its controller is one that the paper compares with."""
        return CONTROLLERS[self.controller].is_baseline

    @property
    def routines(self) -> tuple[str, ...]:
        """Its laws by name, the guarded one first."""
        return CONTROLLERS[self.controller].routines

    @property
    def has_reference(self) -> bool:
        """Whether the controller tracks; otherwise only the reaching law is there."""
        return CONTROLLERS[self.controller].has_reference

    def stored(self, scalar: str) -> tuple[list[list[float]], tuple[float, ...]]:
        """Inertia and gains as that scalar keeps them."""

        def kept(value: Fraction) -> float:
            return float(np.asarray(float(value), DTYPES[scalar]))

        inertia = [[kept(value) for value in row] for row in self.inertia]
        return inertia, tuple(map(kept, self.gains))

    def named_gains(self, scalar: str) -> dict[str, float]:
        """Gains as that scalar keeps them, by their names on the target."""
        return dict(zip(CONTROLLERS[self.controller].names, self.stored(scalar)[1], strict=True))
