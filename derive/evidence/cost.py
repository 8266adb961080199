"""Instructions of a call on the target: the least and the most over the self-test's good cases.

They hold the ladder of angles. What control needs to refuse the others is counted in its most.
"""

from __future__ import annotations

from collections.abc import Iterator

from derive.evidence.bits import FIRST_BAD
from derive.evidence.board import Reading
from derive.evidence.promise import promise
from derive.verify.check import Check
from derive.verify.limits import LIMITS

UNIT = "instructions"


def checks(reading: Reading) -> Iterator[Check]:
    """What one measured image says of instructions."""
    emitted, machine = reading.image.emitted, reading.image.machine
    subject = reading.image.title
    yield clock(reading)
    yield repeated(reading)
    for routine in dict.fromkeys(routine for routine, _ in reading.cost):
        counts = _counts(reading, routine)
        good = _good(reading, routine)
        most = max(counts, key=lambda case: counts[case])
        worst = f"case {most}; {min(good.values())} to {max(good.values())} in good cases"
        limit = promise(routine, UNIT, emitted, machine)
        yield Check(f"{UNIT}, {routine}", subject, counts[most], limit, len(counts), worst)
    if _good(reading, "tracking"):
        yield spread(reading)
        yield guard(reading)


def clock(reading: Reading) -> Check:
    """A routine of known length is counted right, through the same code as all others."""
    expected, found = reading.known
    worst = "" if found == expected else f"{found} for {expected}"
    wrong = abs(found - expected) if expected else float("nan")
    return Check("clock", reading.image.title, wrong, LIMITS["clock"], 1, worst)


def repeated(reading: Reading) -> Check:
    """Every call was counted twice; the counts that were not the same."""
    unlike = [key for key, (once, again) in reading.cost.items() if once != again]
    worst = f"{unlike[0][0]}, case {unlike[0][1]}" if unlike else ""
    samples = len(reading.cost)
    return Check("counted twice", reading.image.title, len(unlike), LIMITS["rows"], samples, worst)


def spread(reading: Reading) -> Check:
    """Most over least instructions of tracking, over all good cases."""
    counts = _good(reading, "tracking").values()
    limit = promise("spread", "times", reading.image.emitted, reading.image.machine)
    return Check(
        "tracking, most over least", reading.image.title, max(counts) / min(counts), limit,
        len(counts), f"{min(counts)} to {max(counts)}",
    )  # fmt: skip


def guard(reading: Reading) -> Check:
    """What control costs beyond tracking, in percent, case by case."""
    bare, guarded = _good(reading, "tracking"), _good(reading, "control")
    added = {case: 100 * (guarded[case] / bare[case] - 1) for case in bare}
    worst = max(added, key=lambda case: added[case])
    limit = promise("guard", "%", reading.image.emitted, reading.image.machine)
    return Check(
        "guard", reading.image.title, added[worst], limit, len(added),
        f"case {worst}: {guarded[worst]} for {bare[worst]}",
    )  # fmt: skip


def _counts(reading: Reading, routine: str) -> dict[int, int]:
    """The larger of both counts of every case."""
    return {case: max(both) for (name, case), both in reading.cost.items() if name == routine}


def _good(reading: Reading, routine: str) -> dict[int, int]:
    counts = _counts(reading, routine)
    return {case: n for case, n in counts.items() if reading.golden[case].status < FIRST_BAD}
