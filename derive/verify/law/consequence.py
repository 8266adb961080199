"""What a verdict means for a vehicle, in sentences that follow `law … on …`.

Which of them a vehicle is warned of: states in which it stays, is driven away, or gets no force,
where another law of the group does better. That a law jumps is told in the table alone: on
rotations a law has to jump or to vanish somewhere.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from derive.verify.law.verdict import Equilibria, Fall, Jump, Verdict

UNWINDS = "turns q and -q, one attitude, different ways round"

ATTITUDE = {"-i": "-i, the attitude of the identity"}


def consequences(verdict: Verdict) -> list[str]:
    """Every sentence, the gravest first; empty where nothing is to be said."""
    found = [*map(_crowded, verdict.crowds), *_risen(verdict), *map(_refused, verdict.poles)]
    found += [_jumped(one) for one in verdict.jumps if one not in verdict.poles]
    found += [f"vanishes at {one.place}, an isolated state that any disturbance leaves"
              for one in verdict.rests if not one.dimension and one.repels]  # fmt: skip
    return found + [UNWINDS] * verdict.unwinds


def cautions(verdict: Verdict, peers: Sequence[Verdict]) -> list[str]:
    """What `derive emit` warns of; peers are the verdicts of all laws of the group."""
    found = [*map(_crowded, verdict.crowds), *_risen(verdict)]
    if verdict.poles and (better := _without_pole(peers)):
        found += [f"{_refused(one)}; not so with {better}" for one in verdict.poles]
    return found


def _without_pole(peers: Sequence[Verdict]) -> str:
    """The first law that is bounded and meets the rest of the Definition, if there is one."""
    good = (one.law for one in peers if not (one.poles or one.crowds or one.rises))
    return next(good, "")


def _crowded(one: Equilibria) -> str:
    where = f"{one.place}, on a set of dimension {one.dimension}"
    if one.is_every:
        where = f"every {one.place.replace('rotations', 'rotation')}"
    return f"vanishes at {where}: a vehicle at rest there stays"


def _risen(verdict: Verdict) -> Iterator[str]:
    """Where V rises, and where that leads."""
    if not verdict.rises:
        return
    ends = [one.place for one in verdict.rests if not one.repels]
    leads = f", where it drives to {' and '.join(ends)}" if ends else ""
    first = verdict.falls[0]
    yield f"lets V = {first.morse} rise {span(first)}{leads}"


def _refused(one: Jump) -> str:
    what = "has no bound" if np.isinf(one.size) else "has a rate without bound"
    place = ATTITUDE.get(one.place, one.place)
    return f"{what} towards {place}: control refuses it there, and the force is zero"


def _jumped(one: Jump) -> str:
    return f"jumps by {length(one.size)} at {one.place}: the force changes side there"


def length(size: float) -> str:
    """A size, as a multiple of pi where it is one."""
    for count in (1, 2, 4):
        if abs(size - count * np.pi) < 1e-6:
            return f"{count} pi".removeprefix("1 ")
    return f"{size:.6g}"


def span(one: Fall) -> str:
    """The angles at which V rises, in words."""
    low, high = min(one.rises, default=0.0), max(one.rises, default=0.0)
    if np.pi < low < np.pi + 0.05 and high > 2 * np.pi - 0.05:
        return "for q0 < 0"
    low_text, high_text = f"{low:.2g}", f"{high:.2g}"
    span = f"near {low_text}" if low_text == high_text else f"{low_text} to {high_text}"
    return f"at some elements of angle or size {span}"
