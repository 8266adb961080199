"""Unit quaternions in boxes that leave out none: on each, intervals are good for the law.

Near -i the law divides by |v| and multiplies with v. Taken over all v at once, the first is as
small as it gets while the second is as large; where v is of one scale, the two belong together.
"""

from __future__ import annotations

from itertools import pairwise

from derive.evidence.interface import Interface

STORED = "unit quaternion"
RATIO = 100.0
SCALES = {"f32": 4, "f64": 31}
"""Steps of RATIO from the greatest |v| to below CUT, the least that a law divides by."""

BOUND = 1.01
"""Of an entry: MAX_ENTRY of the guard."""

Box = tuple[tuple[float, float], ...]


def is_sliced(face: Interface) -> bool:
    """Whether configurations are single unit quaternions, by what the header says of them."""
    (g,) = (one for one in face.structs["state"] if one.name == "g")
    return g.count == 4 and f"configuration: {STORED}" in face.emitted.header.read_text("utf-8")


def boxes(scalar: str) -> tuple[str, ...]:
    """The bounds of each box, low and high of every entry, as arguments in C."""
    suffix = "F" if scalar == "f32" else ""
    return tuple(
        ", ".join(f"{bound!r}{suffix}" for pair in box for bound in pair) for box in _boxes(scalar)
    )


def _boxes(scalar: str) -> list[Box]:
    """One entry of v between two sizes, the others up to the greater; then all below the last."""
    sizes = [BOUND / RATIO**k for k in range(SCALES[scalar] + 1)]
    found: list[Box] = []
    for size, less in pairwise(sizes):
        for place in range(3):
            for low, high in ((less, size), (-size, -less)):
                v = [(-size, size)] * 3
                v[place] = (low, high)
                found.append(((-BOUND, BOUND), *v))
    last = sizes[-1]
    return [*found, ((-BOUND, BOUND), *([(-last, last)] * 3))]
