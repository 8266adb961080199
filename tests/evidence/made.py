"""Kinds of evidence that cost nothing, in the place of those that take minutes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import pytest

from derive.evidence import gather
from derive.evidence.emitted import Emitted
from derive.evidence.kind import Kind, Step, Work
from derive.evidence.lack import Lack
from derive.evidence.tool import Tool, ToolFailed, ToolMissing
from derive.verify.check import Check
from derive.verify.limits import LIMITS, published

ABSENT = Tool("no-such-tool", "apt install it")


def check(name: str, scalar: str, measured: float = 0, limit: str = "findings") -> Check:
    return Check(name, f"C {scalar}", measured, LIMITS[limit], 10, "worst | one")


def good(_: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    for one in packages:
        assert one.source.is_file()
        yield check("any bits: alarms", one.scalar)
        yield Check("size", one.prefix, 1234, published("B"), 1, "", ("first", "second"))


def bad(_: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    yield from (check("same bits", one.scalar, 3, "rows") for one in packages)


def absent() -> Iterator[Check | Lack]:
    yield Lack("nothing", ("it",), "it is not here")


def lacking(_: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    yield from (check("doxygen: warnings", one.scalar) for one in packages)
    yield Lack("RV32", ("RV32's tools",), "it is not here")
    raise ToolMissing(ABSENT)


def hung(_: Work, packages: Sequence[Emitted]) -> Iterator[Check | Lack]:
    yield from (check("flags", one.scalar, 0, "rows") for one in packages)
    raise ToolFailed(
        ["/usr/bin/emulator", "/tmp/image.elf"], "did not end within 10 s", "its words"
    )


def odd(_: Work, __: Sequence[Emitted]) -> Iterator[Check | Lack]:
    yield from ()
    raise RuntimeError("what nobody foresaw")


GOOD = Kind("proof", (Step("good", good, quick="the other half"),))
BAD = Kind("target", (Step("bad", bad, is_crew=True),))
LACKING = Kind("rule", (Step("lacking", lacking),))
HUNG = Kind("attack", (Step("hung", hung, is_crew=True),))


def gathered(monkeypatch: pytest.MonkeyPatch, *kinds: Kind) -> None:
    """Make these all the kinds that there are."""
    real = gather.gather
    monkeypatch.setattr(gather, "gather", lambda work: real(work, kinds))
