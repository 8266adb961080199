"""The paper's three experiments as data, and all of them flown by one craft at a time.

Section Simulations. They differ in R_e(0) alone; the reference turns at a constant body rate.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from derive.simulate.craft import Craft
from derive.simulate.flight import Flight, recorded
from derive.simulate.invariant import Watched, watched
from derive.simulate.loop import Loop
from derive.simulate.pace import longest
from derive.simulate.reference import steady
from derive.simulate.runs import Runs, Setting
from derive.simulate.space import Array

GROUP = "SO3"
SECONDS = 30.0  # what the paper draws, and where its energies are compared
FLOWN = 40.0  # what settles about 30 s is seen to stay where it settled
INSTANT = 0.05  # s, between two instants that are looked at, or a part of it for a quick loop


@dataclass(frozen=True)
class Scenario:
    """One start: R_e(0) = R_312(0, turns pi, 0)."""

    number: int
    title: str
    turns: float

    @property
    def spelled(self) -> str:
        """R_e(0) in one line."""
        return f"R_e(0) = R_312(0, {self.turns}π, 0)"


SCENARIOS = {
    one.number: one
    for one in (
        Scenario(1, "intermediate case", -0.428),
        Scenario(2, "starting close to the desired equilibrium", -0.01),
        Scenario(3, "starting close to the undesired equilibrium", -0.99),
    )
}


@dataclass(frozen=True)
class Entrant:
    """A controller of the comparison as the paper has it: its kinematic law and its gains."""

    controller: str
    title: str
    law: str
    gains: tuple[tuple[str, str], ...]


ENTRANTS = {
    one.controller: one
    for one in (
        Entrant("gsmc", "GSMC", "log", (("lambda", "0.5"), ("k_s", "1"))),
        Entrant("lsf_printed", "LSF as printed", "skew", (("k", "1"), ("kappa", "0.5"))),
        Entrant("lsf", "LSF corrected", "skew", (("k", "1"), ("kappa", "0.5"))),
        Entrant("pd_plus", "PD+", "lee", (("k_R", "9.25"), ("k_Omega", "18.5"))),
    )
}
"""Controller -> how it takes part; the order is that of tables and pictures."""

SPELLED = ("3.6046", "-0.0706", "0.1491", "8.6868", "0.0449", "9.3484")
"""The paper's inertia as it stands there, kg m^2: upper triangle, row by row."""

INERTIA = tuple(map(float, SPELLED))
MOMENTS = tuple(SPELLED[i] for i in (0, 3, 5))  # its diagonal, exact

START = tuple(part / (2 * np.sqrt(14.0)) for part in (1.0, 2.0, 3.0))  # Omega(0), rad/s
RATE = (0.0, 0.1, 0.0)  # Omega_r, rad/s


def turned(axis: int, angle: float) -> Array:
    """Shuster's elementary attitude matrix R_axis(angle), (3, 3): passive, axis 1, 2 or 3."""
    i, j = axis % 3, (axis + 1) % 3
    R = np.eye(3)
    R[i, i] = R[j, j] = np.cos(angle)
    R[i, j], R[j, i] = np.sin(angle), -np.sin(angle)
    return R


def R_312(phi: float, theta: float, psi: float) -> Array:
    """The attitude matrix of the sequence 3-1-2, (3, 3): R_2(psi) R_1(theta) R_3(phi)."""
    return np.asarray(turned(2, psi) @ turned(1, theta) @ turned(3, phi))


def starts(numbers: Sequence[int]) -> tuple[Array, Array]:
    """R_r(0), (9, 1), and R(0) = R_r(0) R_e(0) of those scenarios, (9, N)."""
    R_r = R_312(np.pi / 4, -np.pi, np.pi / 4)
    each = [R_r @ R_312(0.0, SCENARIOS[n].turns * np.pi, 0.0) for n in numbers]
    return R_r.reshape(9, 1), np.stack([R.ravel() for R in each], axis=-1)


def fly(
    craft: Craft,
    numbers: Sequence[int],
    backend: str,
    progress: Callable[[float], None] = lambda _: None,
) -> list[tuple[Flight, Watched]]:
    """A Flight of FLOWN seconds for each scenario, and what was watched in it.

    All of one craft, controlled continuously.
    """
    reference, g = starts(numbers)
    still, loops = np.zeros((3, 1)), len(numbers)
    runs = Runs(
        g=g,
        nu=np.repeat(np.array(START)[:, None], loops, axis=1),
        momentum=np.zeros((3, loops)),
        inertia=np.array(craft.inertia)[:, None],
        external=still,
        disturbance=still,
        sine=still,
        cosine=still,
        seeds=tuple(range(loops)),
    )
    rate = np.array(RATE)[:, None]
    setting = Setting(FLOWN, longest=INSTANT / math.ceil(INSTANT / longest(craft, None) - 1e-9))
    loop = Loop(craft, backend, steady(reference, rate), setting, runs)
    flights = recorded(loop.moments(), progress)
    return list(zip(flights, watched(loop, flights), strict=True))


def differences(crafts: Sequence[Craft]) -> list[str]:
    """What of the crafts is not the paper's, in words; nothing for the paper's body and gains."""
    found = {"options": any(one.options for one in crafts)}
    found["inertia"] = any(one.inertia != INERTIA for one in crafts)
    for one in crafts:
        paper = ENTRANTS[one.controller]
        gains = tuple((name, float(value)) for name, value in paper.gains)
        found[f"gains of {one.controller}"] = one.gains != gains
        found[f"law of {one.controller}"] = one.law != paper.law
    return [name for name, is_so in found.items() if is_so]
