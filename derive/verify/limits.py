"""The one table of limits. A figure is what was promised, never what was measured."""

from __future__ import annotations

from dataclasses import dataclass

EPS = {"f64": 2.0**-52, "f32": 2.0**-23}
"""One unit in the last place of 1, per scalar."""


@dataclass(frozen=True)
class Limit:
    """What may be measured at most: `eps` of the scalar, `relative`, a count, or a cost."""

    name: str
    figure: float
    unit: str
    doc: str


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
    Limit("kernel k", 1.5, "eps", "k alone: half of what the log may be off"),
    Limit("kernel h", 4, "eps", "h alone, as much as the rate; it enters that times s^2"),
    Limit("kernel m", 16, "eps", "m alone, whose terms alternate: it enters the rate times s^2"),
    Limit("kernel proof", 1, "times", "an error that was found over the bound that was proved"),
    Limit("findings", 0, "findings", "what a tool may find against the rules, or a rule without"),
    Limit("loop", 1e-8, "relative", "W against W(0) exp(-2 k_s t) over 8 s, every group"),
)

LIMITS = {limit.name: limit for limit in _TABLE}
"""Every limit by name."""
