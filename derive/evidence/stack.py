"""Worst-case stack: the longest path of the compiler's call graph, against a painted stack."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from derive.evidence.board import Reading
from derive.evidence.promise import promise
from derive.verify.check import Check
from derive.verify.limits import LIMITS, published

_NODE = re.compile(r'node: \{ title: "([^"]+)" label: "([^"]*)"')
_FRAME = re.compile(r"(\d+) bytes \(([\w,]+)\)")
_EDGE = re.compile(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"')


@dataclass(frozen=True)
class Depth:
    """Stack of a function with all it calls, in bytes.

    path: of calls that needs it; unknown: functions outside the file, whose stack is not in it
    """

    size: int
    path: tuple[str, ...]
    unknown: frozenset[str] = frozenset()


class Unbounded(Exception):
    """The stack has no static bound: recursion, or an array whose length is not known."""


@dataclass(frozen=True)
class Graph:
    """What -fcallgraph-info=su says of one file.

    frames: bytes of every function that is in it; calls: of each, those it calls
    """

    frames: Mapping[str, int]
    calls: Mapping[str, tuple[str, ...]]

    def depth(self, function: str, above: tuple[str, ...] = ()) -> Depth:
        """The deepest stack from entry to return; raises Unbounded."""
        if function in above:
            raise Unbounded(f"{' -> '.join((*above, function))}: recursion")
        if function not in self.frames:
            return Depth(0, (_short(function),), frozenset({function}))
        below = [self.depth(one, (*above, function)) for one in self.calls.get(function, ())]
        deepest = max(below, key=lambda one: one.size, default=Depth(0, ()))
        return Depth(
            self.frames[function] + deepest.size,
            (_short(function), *deepest.path),
            frozenset().union(*(one.unknown for one in below)),
        )


def graph(text: str) -> Graph:
    """Read a .ci file; raises Unbounded on a frame whose size is not static."""
    frames: dict[str, int] = {}
    calls: dict[str, list[str]] = {}
    for title, label in _NODE.findall(text):
        if frame := _FRAME.search(label):
            if frame[2] != "static":
                raise Unbounded(f"{_short(title)}: its frame is {frame[2]}")
            frames[title] = int(frame[1])
    for source, target in _EDGE.findall(text):
        calls.setdefault(source, []).append(target)
    return Graph(frames, {source: tuple(dict.fromkeys(those)) for source, those in calls.items()})


def checks(reading: Reading, text: str) -> Iterator[Check]:
    """Stack of every routine of a measured image, static and painted; text: of its .ci file.

    One without a static bound is a measurement that is not a number, and never passes.
    """
    for routine in dict.fromkeys(routine for routine, _ in reading.stack):
        try:
            depth = graph(text).depth(f"{reading.image.emitted.prefix}_{routine}")
        except Unbounded as error:
            title, limit = reading.image.title, published("B")
            yield Check(f"stack, {routine}", title, float("nan"), limit, 1, str(error))
        else:
            yield from _bounded(reading, routine, depth)


def _bounded(reading: Reading, routine: str, depth: Depth) -> Iterator[Check]:
    """The static stack against its limit, the painted one against the static one."""
    image = reading.image
    painted = max(size for (name, _), size in reading.stack.items() if name == routine)
    samples = sum(name == routine for name, _ in reading.stack)
    worst = f"{' -> '.join(depth.path)}; painted {painted} B"
    if depth.unknown:
        worst += f"; outside the file: {', '.join(sorted(depth.unknown))}"
    limit = promise(_WHAT.get(routine, ""), "B", image.emitted, image.machine)
    yield Check(f"stack, {routine}", image.title, depth.size, limit, 1, worst)
    beyond = max(painted - depth.size, 0)
    worst = f"{painted} B painted, {depth.size} B static"
    name = f"painted stack, {routine}"
    yield Check(name, image.title, beyond, LIMITS["painted"], samples, worst)


_WHAT = {"tracking": "stack", "control": "stack, guarded"}


def _short(title: str) -> str:
    """A static function's title is its file, a colon and its name."""
    return title.rpartition(":")[2]
