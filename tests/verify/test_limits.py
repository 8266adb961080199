"""The table of limits says what was promised, and nothing else may move it."""

from __future__ import annotations

from derive.verify.limits import LIMITS

PROMISED = {
    "log": (3, "eps"),
    "rate": (4, "eps"),
    "log_carried": (4, "eps"),
    "rate_carried": (4, "eps"),
    "skew_carried": (9, "eps"),
    "own": (450, "eps"),
    "own_force": (1e-13, "relative"),
    "exp": (450, "eps"),
    "plant_f64": (30 * 2.0**-52, "relative"),
    "plant_f32": (1e-5, "relative"),
    "mutant_own": (4500, "eps"),
    "beyond_pi": (20, "eps"),
    "force_f64": (2e-14, "relative"),
    "force_f32": (1e-5, "relative"),
    "differences": (1e-12, "relative"),
    "complex_step": (5e-15, "relative"),
    "twin": (1e-12, "relative"),
    "symbolic": (1e-40, "relative"),
    "rows": (0, "rows"),
    "mutant": (30, "eps"),
    "coefficient": (1e-9, "relative"),
    "seeds": (20, "seeds"),
    "either side": (8, "eps"),
    "cancellation": (20, "times"),
    "spare": (32, "eps"),
    "paper_so3 f64 tracking": (560, "instructions"),
    "emit, nothing cached": (1.5, "s"),
    "emit, cached": (0.35, "s"),
    "help": (0.15, "s"),
    "prove": (15, "s"),
    "prove_se3": (60, "s"),
    "by hand": (1.1, "times"),
    "kernel k": (1.5, "eps"),
    "kernel h": (4, "eps"),
    "kernel m": (16, "eps"),
    "kernel proof": (1, "times"),
    "attack": (0, "findings"),
    "findings": (0, "findings"),
    "loop": (1e-8, "relative"),
    "images": (0, "images"),
    "clock": (0, "instructions"),
    "painted": (0, "B"),
    "mutable": (0, "B"),
    "M4F SO3 tracking": (340, "instructions"),
    "M4F S3 tracking": (260, "instructions"),
    "M4F spread": (1.1, "times"),
    "M4F guard": (60, "%"),
    "M4F stack": (128, "B"),
    "M4F stack, guarded": (256, "B"),
    "M4F text": (1400, "B"),
    "M4F text, guarded": (2200, "B"),
}


def test_every_limit_is_the_promised_one() -> None:
    assert {limit.name: (limit.figure, limit.unit) for limit in LIMITS.values()} == PROMISED
