"""The same bits everywhere: every row of every image against the bits committed in the package."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from derive.evidence.board import Reading, Row
from derive.verify.check import Check
from derive.verify.limits import LIMITS

FIRST_BAD = 16
"""From this status on control refuses: the bare routines are not meant for the case."""

_FLAGS = ((1, "invalid"), (2, "division by zero"), (4, "overflow"))


def golden(reading: Reading) -> dict[tuple[str, int], Row]:
    """What control must give, as the package has it."""
    return {("control", case): row for case, row in reading.golden.items()}


def tests(subject: str, readings: Sequence[Reading]) -> Check:
    """The package's own self-test passes in every image of a machine."""
    failed = {one.image.level: one.failures for one in readings if one.failures}
    samples = sum(len(one.golden) for one in readings)
    worst = ", ".join(f"{level}: {count}" for level, count in failed.items())
    return Check("self-test", subject, sum(failed.values()), LIMITS["rows"], samples, worst)


def bits(subject: str, readings: Sequence[Reading], model: Reading) -> Check:
    """Rows of a machine's images whose status or bits differ.

    control is held to the committed bits, the bare routines to what the model gave; a row that
    only one of the two has differs.
    """
    told = {**model.rows, **golden(model)}
    wrong, samples = [], 0
    for reading in readings:
        keys = sorted(told.keys() | reading.rows.keys())
        samples += len(keys)
        wrong += [
            f"{reading.image.level} {_named(key)}: {_shown(found)} for {_shown(expected)}"
            for key in keys
            if not _is_same(found := reading.rows.get(key), expected := told.get(key))
        ]
    worst = wrong[0] if wrong else ""
    return Check("same bits", subject, len(wrong), LIMITS["rows"], samples, worst, tuple(wrong))


def flags(subject: str, readings: Sequence[Reading]) -> Check:
    """Good rows in which a floating-point flag was raised: invalid, division by zero, overflow."""
    good = [
        (reading, key, row)
        for reading in readings
        for key, row in sorted(reading.rows.items())
        if reading.golden[key[1]].status < FIRST_BAD
    ]
    raised = [
        f"{reading.image.level} {_named(key)}: {_words(row.flags)}"
        for reading, key, row in good
        if row.flags
    ]
    worst = raised[0] if raised else ""
    return Check("flags", subject, len(raised), LIMITS["rows"], len(good), worst, tuple(raised))


def checks(readings: Sequence[Reading], model: Reading) -> Iterator[Check]:
    """All of one machine in one scalar, over its levels."""
    image = readings[0].image
    levels = " ".join(one.image.level for one in readings)
    subject = f"{image.emitted.scalar} {image.machine.name} {levels}"
    yield tests(subject, readings)
    yield bits(subject, readings, model)
    if image.emitted.scalar in image.machine.raises:
        yield flags(subject, readings)


def _is_same(found: Row | None, expected: Row | None) -> bool:
    if found is None or expected is None:
        return False
    return (found.status, found.bits) == (expected.status, expected.bits)


def _named(key: tuple[str, int]) -> str:
    return f"{key[0]}, case {key[1]}"


def _shown(row: Row | None) -> str:
    return f"status {row.status} bits {row.bits:08x}" if row else "nothing"


def _words(flags: int) -> str:
    return ", ".join(word for bit, word in _FLAGS if flags & bit)
