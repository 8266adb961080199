"""Seeded defects of the emitted source: each one has to be found by the runs that prove it.

A defect is an edit of the text, found by its structure. One that has no place to be made is told
as such: a proof is not shown to have teeth by edits that were never made.
"""

from __future__ import annotations

import re
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from derive.evidence.analysed import places
from derive.evidence.emitted import Emitted
from derive.evidence.eva import FRAMA_C, PREPROCESSOR, is_clean
from derive.evidence.limit import is_limited, unproved
from derive.evidence.tool import need
from derive.verify.check import Check
from derive.verify.limits import LIMITS

RUNS = 2
"""Analyses at a time."""


@dataclass(frozen=True)
class Defect:
    """The first place of a pattern within a routine, replaced.

    within: the name of the routine, without the prefix
    needs: a text without which a source has no such place, and the defect is not for it
    """

    name: str
    within: str
    pattern: str
    instead: str
    needs: str = ""


class DefectNotApplicable(ValueError):
    """A defect has no place in a source, where it should have one."""

    def __init__(self, defect: Defect, emitted: Emitted) -> None:
        super().__init__(
            f"{emitted.source.name}: defect not applicable: {defect.name}: expected "
            f"{defect.pattern!r} in {defect.within}, found none; what is emitted has changed: "
            "change the defect with it"
        )


DEFECTS = (
    Defect("no range of the velocity", "control", r"(fabsf?\(state->nu\[0\]\)) <= \w+",
           r"\1 >= -1"),
    Defect("a range the wrong way round", "control", r"(fabsf?\(state->nu\[1\]\)) <= ", r"\1 >= "),
    Defect("a range too wide", "control", r"(fabsf?\(state->nu\[0\]\)) <= \w+", r"\1 <= HUGE"),
    Defect("no range of the reference", "control", r"(fabsf?\(reference->nu\[0\]\)) <= \w+",
           r"\1 >= -1", "reference->nu[0]"),
    Defect("no range of the error", "control", r"(fabsf?\(g_e_1\)) <= \w+", r"\1 >= -1"),
    Defect("one range is enough", "control", r"(fabsf?\(g_e_0\) <= \w+)\s+&&", r"\1 ||"),
    Defect("the error not computed", "control", r"const (\w+) g_e_0 = [^;]*;", r"\1 g_e_0;",
           "g_e_0 ="),
    Defect("bad input not refused", "control",
           r"return \w+_refuse\([^;]*;(?!\s*\}\s*return)", "(void)0;"),
    Defect("drift not looked at", "control", r"!\((\w+) < params->max_drift\*params->max_drift\)",
           "0", "max_drift"),
    Defect("a refused command left as it is", "refuse", r"\w+_nothing\(command\);",
           "(void)command;"),
    Defect("NaN not looked for", "inspect", r"!isfinite\(numbers\[i\]\)", "0"),
    Defect("a loop one turn too long", "inspect", "i < count", "i <= count"),
    Defect("an output not written", "law", r"command->s\[0\] = [^;]*;", ""),
    Defect("an output past its end", "law", r"command->force\[0\]", "command->force[99]"),
    Defect("an input past its end", "law", r"state->nu\[0\]", "state->nu[99]"),
    Defect("no floor under a quotient", "law", r"/\((square\w*) \+ [\w.-]+\)", r"/\1", "/(square"),
    Defect("no floor under a root", "law", r"(norm_bounded\w*) = [\d.e-]+F?;", r"\1 = 0;",
           "norm_bounded"),
    Defect("a cosine above 1", "law", r"\bw(_\w+)? = 1\.0F?;", r"w\1 = cosine\1;", "cosine"),
    Defect("the force not looked at", "verdict", r"isfinite\(command->force\[0\]\)", "1",
           "isfinite(command->force[0]) && isfinite("),
    Defect("another limit", "cut", r"<= limit\)", "<= 2*limit)", "_cut("),
    Defect("a shrunk force not looked at", "saturate",
           r"(fabsf?\(command->force\[1\]\) <= params->force_limit\[1\])", "1", "_share("),
    Defect("a limit not looked at", "verdict",
           r"fabsf?\(command->force\[0\]\) <= params->force_limit\[0\]", "1", "force_limit"),
    Defect("a status that is not documented", "verdict", r"\w+_OK;", "3;"),
    Defect("a pivot past the end", "check_params", r"pivot\[i\]", "pivot[i + 1]"),
)  # fmt: skip

HUGE = {"f32": "3.0e38F", "f64": "1.0e308"}
"""What HUGE stands for in an edit."""


def applicable(source: str) -> tuple[Defect, ...]:
    """The defects that a source has a place for, by what it holds."""
    return tuple(one for one in DEFECTS if one.needs in source)


def edited(defect: Defect, emitted: Emitted, source: str) -> str:
    """The source with a defect; raises DefectNotApplicable."""
    routine = f"{emitted.prefix}_{defect.within}"
    numbers = [number for number, name in places(source).items() if name == routine]
    if numbers:
        lines = source.splitlines(keepends=True)
        first, last = min(numbers) - 1, max(numbers)
        instead = defect.instead.replace("HUGE", HUGE[emitted.scalar])
        body, count = re.subn(defect.pattern, instead, "".join(lines[first:last]), count=1)
        if count:
            return "".join([*lines[:first], body, *lines[last:]])
    raise DefectNotApplicable(defect, emitted)


def teeth(emitted: Emitted) -> Check:
    """How many defects are missed. Raises DefectNotApplicable, and what `proofs` raises.

    A source that has findings as it is would catch everything: it is refused.
    """
    need(FRAMA_C, PREPROCESSOR)
    source = emitted.source.read_text(encoding="utf-8")
    defects = applicable(source)
    texts = [source, *(edited(one, emitted, source) for one in defects)]
    with ThreadPoolExecutor(RUNS) as pool:
        whole, *clean = pool.map(lambda text: _is_proved(emitted, text), texts)
    if not whole:
        raise ValueError(f"{emitted.source.name}: there are findings in it, without a defect")
    missed = tuple(one.name for one, is_missed in zip(defects, clean, strict=True) if is_missed)
    return Check(
        "seeded defects: missed", f"C {emitted.scalar}", float(len(missed)), LIMITS["eva, defects"],
        len(defects), missed[0] if missed else "", missed,
    )  # fmt: skip


def _is_proved(emitted: Emitted, source: str) -> bool:
    """Whether all that is shown of the emitted source is shown of this one."""
    if not is_clean(emitted, source):
        return False
    return not is_limited(emitted) or not unproved(emitted, source)[0]
