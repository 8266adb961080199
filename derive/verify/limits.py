"""The one table of limits. A figure is what was promised, never what was measured."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

EPS = {"f64": 2.0**-52, "f32": 2.0**-23}
"""One unit in the last place of 1, per scalar."""


@dataclass(frozen=True)
class Limit:
    """What may be measured at most: `eps` of the scalar, `relative`, a count, or a cost."""

    name: str
    figure: float
    unit: str
    doc: str

    @property
    def is_promised(self) -> bool:
        """Whether there is a figure at all: some things are measured, published, and no more."""
        return self.figure < inf

    @property
    def text(self) -> str:
        """The figure as reports print it, without its unit."""
        return f"{self.figure:g}" if self.is_promised else "none"


_TABLE = (
    Limit("log", 3, "eps", "law against truth, relative to its length"),
    Limit("rate", 4, "eps", "exact rate of the law against truth, relative to its length"),
    Limit("log_carried", 4, "eps", "law on SE2, SE3, SE23 and their products, block by block"),
    Limit("rate_carried", 4, "eps", "its exact rate, on |v| + |p||omega|"),
    Limit("skew_carried", 9, "eps", "skew there: 4, and nine entries half an eps off the group"),
    Limit("own", 450, "eps", "law and rate on a user's group, relative to their terms: 1e-13"),
    Limit("own_force", 1e-13, "relative", "force, s and plant in double on a user's group"),
    Limit("exp", 450, "eps", "exp(log g) against g, block by block: 1e-13 relative in double"),
    Limit("beyond_pi", 20, "eps", "law and rate on S3 beyond a rotation by pi"),
    Limit("force_f64", 2e-14, "relative", "whole force in double against truth"),
    Limit("force_f32", 1e-5, "relative", "whole force in float against truth"),
    Limit("plant_f64", 30 * 2.0**-52, "relative", "plant in double: what a mutant may move it by"),
    Limit("plant_f32", 1e-5, "relative", "plant in float against truth"),
    Limit("differences", 1e-12, "relative", "6th-order central differences along the flow"),
    Limit("complex_step", 5e-15, "relative", "complex step along the flow"),
    Limit("twin", 1e-12, "relative", "CasADi's derivative of the printed formula, mid angles"),
    Limit("symbolic", 1e-40, "relative", "chain rule against closed form, 50 digits"),
    Limit("rows", 0, "rows", "rows that differ, or are not finite"),
    Limit("attack", 0, "findings", "promises of the emitted code broken, or code never run"),
    Limit("mutant", 30, "eps", "movement from which a mutant must be caught"),
    Limit("mutant_own", 4500, "eps", "the same on a user's group: ten times its promise, as above"),
    Limit("coefficient", 1e-9, "relative", "change of a coefficient that a mutant makes"),
    Limit("seeds", 20, "seeds", "over which the unharmed code must raise no alarm"),
    Limit("either side", 8, "eps", "distance from the cut locus within which both sides count"),
    Limit(
        "cancellation", 20, "times", "terms over their sum, beyond which the terms are the scale"
    ),
    Limit("spare", 32, "eps", "of its diagonal entry, left in each pivot of a rounded inertia"),
    Limit("paper_so3 f64 tracking", 560, "instructions", "the worst call over all angles"),
    Limit("prove", 15, "s", "every statement, for the paper's vehicle"),
    Limit("prove_se3", 60, "s", "every statement, for a vehicle on SE3"),
    Limit("emit, nothing cached", 1.5, "s", "one vehicle, the whole process"),
    Limit("emit, cached", 0.35, "s", "as above, a new inertia of a known pattern"),
    Limit("help", 0.15, "s", "derive --help"),
    Limit("by hand", 1.1, "times", "operations of tracking over a count by hand, SE3 and SE2"),
    Limit(
        "eva, alarms", 0, "alarms", "undefined behaviour that Eva cannot rule out, any input bits"
    ),
    Limit("eva, not proved", 0, "assertions", "finite, within limits, documented, zero when bad"),
    Limit("eva, not reached", 0, "lines", "statements that no input reaches"),
    Limit("eva, overflows", 0, "alarms", "NaN or infinity at any step, inputs within their ranges"),
    Limit("wp, not proved", 0, "goals", "a good force is within its limits, whatever these are"),
    Limit("eva, defects", 0, "missed", "seeded defects that the same runs do not find"),
    Limit("kernel k", 1.5, "eps", "k alone: half of what the log may be off"),
    Limit("kernel h", 4, "eps", "h alone, as much as the rate; it enters that times s^2"),
    Limit("kernel m", 16, "eps", "m alone, whose terms alternate: it enters the rate times s^2"),
    Limit("kernel proof", 1, "times", "an error that was found over the bound that was proved"),
    Limit("findings", 0, "findings", "what a tool may find against the rules, or a rule without"),
    Limit("loop", 1e-8, "relative", "W against W(0) exp(-2 k_s t) over 8 s, every group"),
    Limit("runs", 0, "runs", "of a tool that broke down, or did not end in time"),
    Limit("images", 0, "images", "that could not be built, or did not run to their end"),
    Limit("clock", 0, "instructions", "that a routine of known length is counted wrong by"),
    Limit("painted", 0, "B", "that a painted stack shows beyond the static bound"),
    Limit("mutable", 0, "B", "of .data and .bss"),
    Limit("M4F SO3 tracking", 340, "instructions", "worst call in float, -O2"),
    Limit("M4F S3 tracking", 260, "instructions", "worst call in float, -O2"),
    Limit("M4F spread", 1.1, "times", "most over least instructions of tracking, SO3 and S3"),
    Limit("M4F guard", 60, "%", "instructions of control beyond tracking's, SO3 and S3"),
    Limit("M4F stack", 128, "B", "tracking in float, -O2, SO3 and S3"),
    Limit("M4F stack, guarded", 256, "B", "control in float, -O2, SO3 and S3"),
    Limit("M4F text", 1400, "B", "tracking with all it calls in float, -Os, SO3 and S3"),
    Limit("M4F text, guarded", 2200, "B", "the same and control, SO3 and S3"),
)

LIMITS = {limit.name: limit for limit in _TABLE}
"""Every limit by name."""


def published(unit: str) -> Limit:
    """The limit of what is measured and published, and of which nothing is promised."""
    return Limit(f"published, {unit}", inf, unit, "measured and published; nothing is promised")
