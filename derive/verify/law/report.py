"""The verdicts on kinematic laws: a table for people, JSON for machines."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from derive.control.kinematic import laws_of
from derive.lie.group import Group
from derive.verify.law.consequence import cautions, consequences, length, span
from derive.verify.law.definition import judge
from derive.verify.law.verdict import Fall, Jump, Verdict

HEAD = ("group", "law", "(i)", "(ii)", "jump", "V", "(iii)", "(iv) y", "from", "to", "equilibria")
LARGE, SMALL = 1e6, 1e-6  # of y: beyond, it has no bound, or comes down to zero


@dataclass(frozen=True)
class LawReport:
    """Verdicts, group by group; chosen: the vehicle's law, which is marked, if there is one."""

    verdicts: tuple[Verdict, ...]
    chosen: str = ""

    @property
    def ok(self) -> bool:
        """Whether nothing that was found contradicts what the records state."""
        return not any(one.contradictions for one in self.verdicts)

    def table(self) -> str:
        """One row for each law and V; then what it means, with a counterexample."""
        rows = [HEAD, *(row for one in self.verdicts for row in self._rows(one))]
        widths = [max(len(row[i]) for row in rows) for i in range(len(HEAD))]
        lines = ["  ".join(f"{cell:{w}}" for cell, w in zip(row, widths, strict=True)).rstrip()
                 for row in rows]  # fmt: skip
        lines.append("")
        lines += [line for one in self.verdicts for line in _told(one)]
        wrong = sum(len(one.contradictions) for one in self.verdicts)
        return "\n".join([*lines, "", f"{len(self.verdicts)} laws, {wrong} contradictions"])

    def as_json(self) -> str:
        """The same for machines; no bound is null."""
        rows = [self._as_data(one) for one in self.verdicts]
        return json.dumps({"ok": self.ok, "chosen": self.chosen, "laws": rows}, indent=2) + "\n"

    def _rows(self, one: Verdict) -> Iterator[tuple[str, ...]]:
        mark = "*" if one.law == self.chosen else ""
        head = (one.group, mark + one.law, "yes" if one.is_zero_at_e else "NO", _odd(one),
                "; ".join(map(_jump, one.jumps)) or "none")  # fmt: skip
        for fall in one.falls:
            yield (*head, fall.morse, _iii(one, fall), fall.factor or "measured",
                   _bound(fall.low), _bound(fall.high), _rests(one))  # fmt: skip
            head = ("",) * 5

    def _as_data(self, one: Verdict) -> dict[str, Any]:
        peers = [other for other in self.verdicts if other.group == one.group]
        data = {**asdict(one), "consequences": consequences(one), "cautions": cautions(one, peers)}
        found: dict[str, Any] = _finite(data)
        return found


def report(
    groups: Sequence[Group], progress: Callable[[str], None] = lambda _: None, chosen: str = ""
) -> LawReport:
    """Judge every law of these groups."""
    verdicts = []
    for group in groups:
        for law in laws_of(group).values():
            progress(f"{group.name} {law.name}")
            verdicts.append(judge(group, law))
    return LawReport(tuple(verdicts), chosen)


def _odd(one: Verdict) -> str:
    off = [*one.odd.fails, *(f"{place} (refused)" for place in one.odd.undefined)]
    return f"off {', '.join(off)}" if off else "everywhere"


def _jump(one: Jump) -> str:
    if math.isinf(one.size):
        return f"no bound at {one.place}"
    return f"{length(one.size)} at {one.place}{', rate without bound' * one.is_steep}"


def _iii(one: Verdict, fall: Fall) -> str:
    if not fall.holds:
        return f"no {span(fall)}"
    return f"off {', '.join(rest.place for rest in one.rests)}" if one.rests else "yes"


def _rests(one: Verdict) -> str:
    """Places where the law vanishes, e left out."""
    kinds = (f"{rest.place}, {_kind(rest.dimension, rest.repels)}" for rest in one.rests)
    return "; ".join(kinds) or "none"


def _kind(dimension: int, repels: bool) -> str:
    alone = f"dimension {dimension}" if dimension else "isolated"
    return alone if repels else f"{alone}, attracts"


def _bound(y: float) -> str:
    if abs(y) < SMALL:
        return "0"
    return "no bound" if y > LARGE else f"{y:.3g}"


def _told(one: Verdict) -> Iterator[str]:
    """The law's lines below the table."""
    yield f"{one.group} {one.law}, {one.doc}: {'; '.join(consequences(one)) or 'no objection'}"
    if one.odd.example:
        yield f"  (ii): {one.odd.example}"
    yield from (f"  (iii) {fall.morse}: {fall.example}" for fall in one.falls if fall.example)
    yield from (f"  equilibrium: {rest.example}" for rest in one.rests)
    yield from (f"  CONTRADICTION: {what}" for what in one.contradictions)


def _finite(data: Any) -> Any:
    """The same without infinities, which JSON lacks."""
    if isinstance(data, dict):
        return {key: _finite(value) for key, value in data.items()}
    if isinstance(data, list | tuple):
        return [_finite(value) for value in data]
    return None if isinstance(data, float) and not math.isfinite(data) else data
