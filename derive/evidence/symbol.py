"""What an emitted source is as an object file: whom it calls, what it keeps, what it is called.

Besides sqrt a bare target has to bring memcpy and memset: gcc and clang make calls of them out of
plain assignments of structs, and require both of every environment. The compiler's own arithmetic,
where a machine has none, comes with the compiler.
"""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from derive.evidence.diagnostic import COMPILERS, MACHINE
from derive.evidence.emitted import FLAGS, Emitted
from derive.evidence.tool import Tool, absent, need, run
from derive.verify.check import Check
from derive.verify.limits import LIMITS

NM = Tool("nm", "apt install binutils")
LEVELS = ("-O0", "-O2", "-Os")
SECONDS = 60

NEEDED = frozenset({"sqrt", "sqrtf", "memcpy", "memset"})
"""All that the emitted code may need of others."""

_OWN = re.compile(r"__aeabi_\w+|__\w+[sd]f[23]\b")  # of the compiler: arithmetic in software
_CALL = re.compile(r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', re.MULTILINE)

KEPT = "dDbBcC"  # nm's letters of what can be written to: initialised, zeroed, common
SHOWN = "TRDBCVW"  # of what other files see


@dataclass(frozen=True)
class Object:
    """An object file's symbols: name and nm's letter; how: compiler and level."""

    how: str
    symbols: tuple[tuple[str, str], ...]

    def named(self, letters: str) -> list[str]:
        """The symbols of these kinds."""
        return [name for name, letter in self.symbols if letter in letters]


def symbols(one: Emitted) -> Iterator[Check]:
    """Calls, kept data, names, loops of calls, by the compilers that are here.

    Raises ToolMissing for the others in the end, or at once where there is nothing to go by;
    ToolFailed.
    """
    lost = tuple(absent(tuple(COMPILERS.values())))
    need(NM, COMPILERS["gcc"])  # which draws the graph of calls
    with tempfile.TemporaryDirectory() as scratch:
        objects = [*_objects(one, Path(scratch))]
        calls = _calls(one, Path(scratch))
    needs = {(name, o.how) for o in objects for name in o.named("U") if not _OWN.fullmatch(name)}
    strange = sorted(f"{name}, {how}" for name, how in needs if name not in NEEDED)
    used = ", ".join(sorted({name for name, _ in needs}))
    yield _none("calls other than sqrt, memcpy, memset", one, strange, len(objects), used)
    kept = sorted({f"{name}, {o.how}" for o in objects for name in o.named(KEPT)})
    yield _none("data that can be written to", one, kept, len(objects))
    shown = sorted({name for o in objects for name in o.named(SHOWN)})
    foreign = [name for name in shown if not name.startswith(f"{one.prefix}_")]
    yield _none("names without the prefix", one, foreign, len(shown))
    yield _none("functions that call themselves", one, recursive(calls), len(calls))
    through = sorted(name for name, called in calls.items() if "__indirect_call" in called)
    yield _none("calls through a pointer", one, through, len(calls))
    need(*lost)


def _objects(one: Emitted, scratch: Path) -> Iterator[Object]:
    here = {name: tool for name, tool in COMPILERS.items() if not [*absent([tool])]}
    for name, tool in here.items():
        for level in LEVELS:
            place = scratch / "it.o"
            flags = (*FLAGS, level, *MACHINE[name], f"-I{one.include}")
            run([tool.path, *flags, "-c", str(one.source), "-o", str(place)], SECONDS)
            lines = run([NM.path, "--format=posix", str(place)], SECONDS).splitlines()
            pairs = [line.split()[:2] for line in lines]
            mapped = (
                pair for pair in pairs if not pair[0].startswith("$")
            )  # marks of code and data
            yield Object(f"{name} {level}", tuple((symbol, kind) for symbol, kind in mapped))


def _calls(one: Emitted, scratch: Path) -> dict[str, set[str]]:
    """Each function that calls, and what it calls, as gcc writes it without optimisation."""
    place = scratch / "graph.o"
    flags = (*FLAGS, "-O0", "-fcallgraph-info", f"-I{one.include}")
    run([COMPILERS["gcc"].path, *flags, "-c", str(one.source), "-o", str(place)], SECONDS)
    text = place.with_suffix(".ci").read_text(encoding="utf-8")
    found: dict[str, set[str]] = {}
    for caller, called in _CALL.findall(text):
        found.setdefault(_bare(caller), set()).add(_bare(called))
    return found


def _bare(title: str) -> str:
    """The function's name of a node's title, which has the file before those of its own."""
    return title.rpartition(":")[2]


def recursive(calls: Mapping[str, set[str]]) -> list[str]:
    """The functions from which calls lead back to themselves."""

    def reached(start: str) -> set[str]:
        seen: set[str] = set()
        ahead = set(calls.get(start, ()))
        while ahead:
            seen |= ahead
            ahead = {n for name in ahead for n in calls.get(name, ())} - seen
        return seen

    return sorted(name for name in calls if name in reached(name))


def _none(name: str, one: Emitted, bad: list[str], samples: int, told: str = "") -> Check:
    first, details = bad[0] if bad else "", (told,) if told else ()
    return Check(name, one.scalar, len(bad), LIMITS["findings"], samples, first, details)
