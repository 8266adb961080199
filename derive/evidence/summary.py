"""The promises of a package, one line each: the figure, and the worst that was measured of it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import inf

from derive.verify.check import Check


@dataclass(frozen=True)
class Promise:
    """What is promised in a reviewer's words, and the names of the checks that hold it to that.

    at: part of their subject, where not all of that name are meant
    """

    text: str
    checks: str
    at: str = ""

    def holds(self, check: Check) -> bool:
        """Whether a check is one of those."""
        return bool(re.fullmatch(self.checks, check.name)) and self.at in check.subject


PROMISES = (
    Promise("any input bits: no undefined behaviour, proved", "any bits: alarms"),
    Promise("any input bits: the command finite, the force within its limits, proved",
            "any bits: not proved"),
    Promise("a good force within its limits, whatever these are, proved", "any limits: not proved"),
    Promise("any input bits: every statement can be reached", "any bits: not reached"),
    Promise("inputs in range: no step overflows or is NaN, proved", "in range: alarms"),
    Promise("seeded defects that the proof misses", "seeded defects: missed"),
    Promise("kernel polynomial k: error, proved", "kernel k: proved"),
    Promise("kernel polynomial h: error, proved", "kernel h: proved"),
    Promise("kernel polynomial m: error, proved", "kernel m: proved"),
    Promise("kernel polynomials: largest error of any number, over the proved one",
            "kernel .: largest over proved"),
    Promise("law against truth", "nu_u: (truth|terms)"),
    Promise("exact rate of the law against truth", "nu_u_dot: (truth|terms)"),
    Promise("force in float against truth", "force: truth", "f32"),
    Promise("force in double against truth", "force: truth", "f64"),
    Promise("rows in which control does not give the law's command and the right status",
            "control: the law, and its status"),
    Promise("failures of the self-test, over all machines", "self-test"),
    Promise("rows whose bits are not the same on every machine, at every level", "same bits"),
    Promise("rows of good inputs that raise a floating-point flag", "flags"),
    Promise("tracking on a Cortex-M4F, float", "instructions, tracking", "f32 Cortex-M4F"),
    Promise("control on a Cortex-M4F, float", "instructions, control", "f32 Cortex-M4F"),
    Promise("tracking, most over least on a Cortex-M4F, float", "tracking, most over least",
            "f32 Cortex-M4F"),
    Promise("the guard beyond tracking on a Cortex-M4F, float", "guard", "f32 Cortex-M4F"),
    Promise("stack of tracking on a Cortex-M4F, float", "stack, tracking", "f32 Cortex-M4F"),
    Promise("stack of control on a Cortex-M4F, float", "stack, control", "f32 Cortex-M4F"),
    Promise("code of tracking on a Cortex-M4F, float", r"\.text, tracking", "f32 Cortex-M4F"),
    Promise("code with control on a Cortex-M4F, float", r"\.text, \w+ and control",
            "f32 Cortex-M4F"),
    Promise("fuzzing: promises broken", "fuzz: promises broken"),
    Promise("every bit of every input flipped: promises broken", "bit flips: promises broken"),
    Promise("harmful bit flips of state and reference that one call cannot tell",
            "bit flips: harmful, not found"),
    Promise("lines and branches that the self-test misses",
            "self-test: lines and branches missed"),
    Promise("warnings of gcc, clang and arm-none-eabi-gcc", ".*gcc: warnings|clang: warnings"),
    Promise("clang-tidy: bugprone, cert, analyzer", "clang-tidy: .*"),
    Promise("MISRA C:2012 by cppcheck: findings without a row in DEVIATIONS.md", "cppcheck, .*"),
    Promise("heap, library calls but sqrt, recursion, calls through pointers, data that changes",
            "calls .*|data .*|functions that .*"),
    Promise("documentation: warnings of doxygen", "doxygen: .*"),
)  # fmt: skip
"""In the order of a review: what could harm first."""


@dataclass(frozen=True)
class Line:
    """A promise, its worst check, and how many samples all its checks had together."""

    promise: Promise
    worst: Check
    samples: int


def lines(checks: Sequence[Check]) -> Iterator[Line]:
    """One for every promise and limit of which anything was measured."""
    for promise in PROMISES:
        mine = [check for check in checks if promise.holds(check)]
        for limit in dict.fromkeys(check.limit for check in mine):
            those = [check for check in mine if check.limit == limit]
            yield Line(promise, max(those, key=_badness), sum(one.samples for one in those))


def _badness(check: Check) -> tuple[bool, float]:
    """Larger is worse; what is not a number is worst."""
    return not check.is_ok, check.measured if check.measured == check.measured else inf
