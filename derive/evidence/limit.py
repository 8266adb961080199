"""Proof by weakest preconditions: a good command is within its limits, whatever these are.

Eva carries intervals, and of `|force| <= limit` with both unknown an interval keeps nothing. What
is to be shown needs no numbers: a force leaves `control` only after a comparison with its limit
has held, or as that limit itself. Frama-C's WP decides it with its own simplifier, without a
prover besides: the comparison is a predicate of which nothing is known but its answer.
"""

from __future__ import annotations

import re
import tempfile
from pathlib import Path

from derive.emit.render import environment
from derive.emit.status import FIRST_BAD, STATUSES
from derive.evidence.emitted import Emitted
from derive.evidence.eva import FRAMA_C, PREPROCESSOR, SECONDS
from derive.evidence.interface import interface
from derive.evidence.tool import need, run
from derive.verify.check import Check
from derive.verify.limits import LIMITS

PARTS = ("nothing", "worse", "refuse", "cut", "saturate", "verdict")
ENTRY = "control"
"""Routines with a contract, where there are such; each is proved from those it calls."""

RUNS = 2
"""With goals split at every branch, and of the entry without."""

OPTIONS = ("-wp", "-wp-prover", "qed", "-wp-model", "Typed+ref")
"""Pointers lead to objects apart, as in the loop of a target."""

_LIMIT = r"(params->force_limit\[\d+\]|limit\b(?!_))"
_HELD = re.compile(rf"\bfabsf?\(((?:[^()]|\([^()]*\))*)\)\s*<=\s*{_LIMIT}")
_ONE = re.compile(rf"{_LIMIT} >= 0\.0F?")
_DONE = re.compile(r"Proved goals:\s+(\d+) / (\d+)")
_FAILED = re.compile(r"\[(?!Qed)\w+\] Goal typed_ref_(\w+)")


def is_limited(emitted: Emitted) -> bool:
    """Whether there are limits at all."""
    params = interface(emitted).structs["params"]
    return any(one.name == "force_limit" for one in params)


def limits(emitted: Emitted) -> Check:
    """The record of the run; raises ToolMissing, ToolFailed, OSError, ValueError."""
    need(FRAMA_C, PREPROCESSOR)
    failed, goals = unproved(emitted, emitted.source.read_text(encoding="utf-8"))
    return Check(
        "any limits: not proved", f"C {emitted.scalar}", float(len(failed)),
        LIMITS["wp, not proved"], goals, failed[0] if failed else "", failed,
    )  # fmt: skip


def unproved(emitted: Emitted, source: str) -> tuple[tuple[str, ...], int]:
    """Goals that are left of a source in the place of the emitted one, and of how many."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "source.c").write_text(compared(source), encoding="utf-8")
        (folder / "driver.c").write_text(driver_of(emitted, source), encoding="utf-8")
        include = f"-cpp-extra-args=-I{emitted.include.absolute()}"
        command = [FRAMA_C.path, include, str(folder / "driver.c"), *OPTIONS, "-wp-fct"]
        parts = [f"{emitted.prefix}_{part}" for part in _prototypes(emitted, source)]
        entry = parts.pop()  # of many branches, none of which matters
        said = run([*command, ",".join(parts), "-wp-split"], SECONDS, folder)
        said += run([*command, entry], SECONDS, folder)
    done = _DONE.findall(said)
    if len(done) != RUNS:
        raise ValueError(f"{emitted.source.name}: expected {RUNS} counts of goals, found {done}")
    proved, goals = (sum(int(pair[i]) for pair in done) for i in (0, 1))
    failed = tuple(dict.fromkeys(_FAILED.findall(said)))
    return (failed or ("a goal without a name",)) if proved < goals else (), goals


def compared(source: str) -> str:
    """The same lines; comparisons with a limit are calls, whose contract stands in the driver."""
    return _ONE.sub(r"limit_is_one(\1)", _HELD.sub(r"limit_holds(\1, \2)", source))


def driver_of(emitted: Emitted, source: str) -> str:
    """C text of the driver, which includes source.c."""
    face = interface(emitted)
    value = {name: number for name, number, _ in STATUSES}
    return environment().get_template("evidence/limit.c.jinja").render(
        prefix=emitted.prefix,
        real=face.real,
        source="source.c",
        prototypes=list(_prototypes(emitted, source).items()),
        written=["side", "command"] if "side" in face.structs else ["command"],
        limit=next(one for one in face.structs["params"] if one.name == "force_limit"),
        first_bad=FIRST_BAD,
        nonfinite=value["NONFINITE_INPUT"],
    )  # fmt: skip


def _prototypes(emitted: Emitted, source: str) -> dict[str, str]:
    """The heads of the routines with a contract, by name."""
    heads = {
        part: re.search(rf"(?m)^[\w *]+\b{emitted.prefix}_{part}\([^;{{]*\)(?=\s*\{{)", source)
        for part in (*PARTS, ENTRY)
    }
    return {part: head[0] for part, head in heads.items() if head}
