"""Every numeric statement of the paper's section Simulations, and how each is measured.

The paper's three controllers are judged twice: with LSF as printed, as its figures have it, and
with LSF corrected.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np

from derive.simulate.flight import Flight
from derive.simulate.judge import (
    BEGUN,
    PSI,
    RATE,
    THREE,
    Finding,
    Flights,
    Judge,
    measured,
    order,
    search,
)
from derive.simulate.reading import energy, gamma, settling, size, swings, total, until
from derive.simulate.scenario import SECONDS
from derive.simulate.space import Array

EQUAL = 1e-4  # relative: energies that count as the same
WHOLE, HALF = 1.0, 0.25  # s, for all numbers of a statement: in whole seconds, with a half in it
REACHED = 1e-6  # of |s(0)|: the reaching phase is over
CLOSE = 0.05  # of |s(0)|: s = 0 is followed closely, once LAG s have passed
LAG = 2.0
SWINGS = 3  # a component that crosses zero as often oscillates


@dataclass(frozen=True)
class Claim:
    """A statement, where it stands, and its judge."""

    name: str
    scenario: int
    place: str
    says: str
    judge: Judge


@dataclass(frozen=True)
class Judged:
    """A claim with both findings: LSF as printed, and corrected."""

    claim: Claim
    printed: Finding
    corrected: Finding

    @property
    def differs(self) -> bool:
        """Whether the two forms of LSF lead to different verdicts."""
        return self.printed.verdict != self.corrected.verdict


def judged(flown: Mapping[int, Mapping[str, Flight]]) -> list[Judged]:
    """Every claim on the scenarios that were flown: number -> controller -> flight."""
    return [
        Judged(claim, *(claim.judge(_three(flown[claim.scenario], form))
                        for form in ("lsf_printed", "lsf")))
        for claim in CLAIMS
        if claim.scenario in flown
    ]  # fmt: skip


def _three(flights: Mapping[str, Flight], form: str) -> Flights:
    return {"gsmc": flights["gsmc"], "lsf": flights[form], "pd_plus": flights["pd_plus"]}


def _gammas(flights: Flights) -> tuple[bool, str, tuple[float, ...]]:
    raw = {name: flights[name].nu_e for name in THREE}
    raw["lsf"] = flights["lsf"].nu - flights["lsf"].nu_r  # eq. (s2): no change of frame
    found = tuple(gamma(flights[name], raw[name]) for name in THREE)
    return max(abs(x - 0.5) for x in found) < 1e-6, _listed(found, ".6f", "1/s"), found


def _energies(flights: Flights) -> tuple[float, ...]:
    return tuple(energy(flights[name], SECONDS) for name in THREE)


def _equal(flights: Flights) -> tuple[bool, str, tuple[float, ...]]:
    found = _energies(flights)
    spread = (max(found) - min(found)) / max(found)
    return spread <= EQUAL, f"{_listed(found, '.4f', '')}, apart by {spread:.1e}", found


def _cheapest(flights: Flights, *, is_least: bool) -> tuple[bool, str, tuple[float, ...]]:
    """Whether gsmc uses the least energy, or the most."""
    found = _energies(flights)
    holds = found[0] < min(found[1:]) if is_least else found[0] > max(found[1:])
    return holds, _listed(found, ".4f", ""), found


def _reaches(flights: Flights) -> tuple[bool, str, tuple[float, ...]]:
    own = until(flights["gsmc"], SECONDS)
    far = size(own) / size(own)[0]
    falls = bool((np.diff(far) <= REACHED).all())
    when = settling(own, far, REACHED)
    if when is None:
        return False, f"|s_1| does not stay below {REACHED:g} of its start", ()
    how = "falls" if falls else "rises too before it falls"
    return falls, f"|s_1| {how} to {REACHED:g} of its start in {when:.2f} s", (when,)


def _oscillates(flights: Flights) -> tuple[bool, str, tuple[float, ...]]:
    count = {name: [swings(s) for s in until(flights[name], SECONDS).s.T] for name in THREE}
    least, others = min(count["lsf"]), max(*count["gsmc"], *count["pd_plus"])
    told = "sign changes of the components: " + ", ".join(
        f"{'/'.join(map(str, count[name]))} ({name})" for name in THREE
    )
    return (
        least >= SWINGS and least > others,
        told,
        tuple(float(x) for name in THREE for x in count[name]),
    )


def _follows(flights: Flights) -> tuple[bool, str, tuple[float, ...]]:
    own = until(flights["pd_plus"], SECONDS)
    share = float(size(own)[own.t >= LAG].max() / size(own)[0])
    sums = tuple(total(until(flights[name], SECONDS)) for name in THREE)
    told = (
        f"∫|s| {_listed(sums, '.3f', 'rad')}; |s_3| below {share:.1%} of its start after {LAG:g} s"
    )
    return share <= CLOSE and sums[2] == min(sums), told, (*sums, share)


def _listed(numbers: tuple[float, ...], form: str, unit: str) -> str:
    return f"{' / '.join(format(x, form) for x in numbers)} {unit}".rstrip()


def _gaps(times: Array) -> Array:
    """How much later the third is than the first, and than the second; (2, M)."""
    return np.stack([times[2] - times[0], times[2] - times[1]])


def _apart(times: Array) -> Array:
    return np.asarray(times[1] - times[0])[None, :]


_BEFORE = "before scenario 1"
_1, _2, _3 = "scenario 1", "scenario 2", "scenario 3"

CLAIMS = (
    Claim("gamma", 1, _BEFORE, "γ_i = 0.5 for all three", measured(_gammas)),
    Claim("equal energy", 1, _1, "all controllers consume the same amount of energy",
          measured(_equal)),
    Claim("convergence 1", 1, _1, "R_e → I in 17 / 17 / 30 s", search(PSI, (17, 17, 30), WHOLE)),
    Claim("10 s longer", 1, _1, "PD+ takes 10 s longer than the others to reach Ω_e → 0",
          search(RATE, (10, 10), WHOLE, _gaps)),
    Claim("last 1", 1, _1, "PD+ converges last (R_e)", order(PSI, ("pd_plus",))),
    Claim("reaching", 1, _1, "s_1 → 0 completes the reaching phase", measured(_reaches)),
    Claim("oscillation", 1, _1, "LSF oscillates around s_2 = 0", measured(_oscillates)),
    Claim("following", 1, _1, "PD+ follows s_3 = 0 closely", measured(_follows)),
    Claim("convergence 2", 2, _2, "R_e → I in 20 / 20 / 25 s", search(PSI, (20, 20, 25), WHOLE)),
    Claim("rate 2", 2, _2, "Ω_e → 0 in 20 / 20 / 25 s", search(RATE, (20, 20, 25), WHOLE)),
    Claim("together", 2, _2, "GSMC and LSF reach R_e = I at the same time",
          search(PSI, (0,), WHOLE, _apart)),
    Claim("5 s longer", 2, _2, "PD+ takes 5 s longer (R_e)", search(PSI, (5, 5), WHOLE, _gaps)),
    Claim("5 s longer, rate", 2, _2, "PD+ takes 5 s longer (Ω_e)",
          search(RATE, (5, 5), WHOLE, _gaps)),
    Claim("last 2", 2, _2, "PD+ last, as in scenario 1 (R_e)", order(PSI, ("pd_plus",))),
    Claim("less energy", 2, _2, "GSMC uses less energy than the others",
          measured(partial(_cheapest, is_least=True))),
    Claim("delays", 3, _3, "a delay of 1 / 2.5 / 1 s before R_e begins to converge",
          search(BEGUN, (1, 2.5, 1), HALF)),
    Claim("longest delay", 3, _3, "LSF has the longest delay", order(BEGUN, ("lsf",))),
    Claim("faster", 3, _3, "GSMC converges faster (R_e)", order(PSI, ("lsf", "pd_plus"))),
    Claim("faster, rate", 3, _3, "GSMC converges faster (Ω_e)", order(RATE, ("lsf", "pd_plus"))),
    Claim("more energy", 3, _3, "at a cost of more energy",
          measured(partial(_cheapest, is_least=False))),
)  # fmt: skip
"""The paper's statements, in its order."""
