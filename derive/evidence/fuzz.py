"""libFuzzer, with sanitizers, on `control`: bytes that are chosen to reach every branch."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from derive.emit.status import FIRST_BAD
from derive.evidence import driver
from derive.evidence.emitted import Emitted
from derive.evidence.interface import interface
from derive.evidence.tool import Tool, ToolFailed, ToolMissing, run
from derive.verify.check import Check
from derive.verify.limits import LIMITS
from derive.verify.plant import Plant

CLANG = Tool("clang", "apt install clang libclang-rt-14-dev")
RUNTIME = Tool("libFuzzer", CLANG.install, "beside clang")

SANITIZERS = "fuzzer,address,undefined,float-divide-by-zero"
"""The last is not among `undefined`: IEEE defines it, and flight code has no use for it."""

FLAGS = ("-O1", "-g", f"-fsanitize={SANITIZERS}", "-fno-sanitize-recover=all")
HEAD = 10
RUNS = 5_000_000
RATE = 20_000
"""Runs a second below which a machine counts as hung; it is ten times as many."""

CRASHED = (1, 76, 77)
"""How libFuzzer ends when the target or a sanitizer does."""


@dataclass(frozen=True)
class Fuzzer:
    """A compiled target, and the longest input that makes sense to it."""

    program: Path
    longest: int

    def run(self, runs: int, seconds: float) -> str:
        """What it says of so many runs; the same at every call. Raises ToolFailed."""
        given = [f"-runs={runs}", "-seed=1", f"-max_len={self.longest}", "-len_control=0"]
        # What it learns of comparisons hangs on addresses, and so differs from run to run.
        given += [
            "-use_cmp=0",
            "-detect_leaks=0",
            "-timeout=5",
            "-verbosity=1",
            "-print_final_stats=1",
        ]
        given += [f"-artifact_prefix={self.program.parent.absolute()}/"]
        return run([str(self.program.absolute()), *given], seconds, codes=(0, *CRASHED))

    def numbers(self, artifact: str) -> tuple[str, ...]:
        """The numbers that an input of libFuzzer's stands for."""
        said = run([str(self.program), "--show", artifact], 60, codes=(0, *CRASHED))
        return tuple(re.findall(r"^  \w+\.\w+\[\d+\] = .*$", said, re.MULTILINE))


def built(emitted: Emitted, plant: Plant, folder: Path) -> Fuzzer:
    """Compile the target; raises ToolMissing, ToolFailed."""
    known = interface(emitted)
    source = driver.written("fuzz", known, plant, folder)
    program = folder / f"{emitted.prefix}_fuzz"
    try:
        driver.compiled(CLANG, emitted, [source], FLAGS, program)
    except ToolFailed as failure:
        if "libclang_rt" in failure.said:
            raise ToolMissing(RUNTIME) from None
        raise
    return Fuzzer(program, HEAD + known.size)


def fuzz(
    emitted: Emitted, plant: Plant, folder: Path, runs: int = RUNS, seconds: float = 0.0
) -> tuple[Check, ...]:
    """`runs` inputs, of which none may break a promise; good and refused ones must be among them.

    folder: for the target, and the input that broke it; seconds: bound, 0 for one by `runs`
    """
    return judged(emitted, built(emitted, plant, folder), runs, seconds)


def judged(
    emitted: Emitted, fuzzer: Fuzzer, runs: int, seconds: float = 0.0
) -> tuple[Check, Check]:
    """The same of a target that is compiled."""
    said = fuzzer.run(runs, seconds or 60 + runs / RATE)
    return _findings(emitted, fuzzer, said, runs), _reached(emitted, said)


def _findings(emitted: Emitted, fuzzer: Fuzzer, said: str, runs: int) -> Check:
    artifact = re.search(r"Test unit written to (\S+)", said)
    done = re.search(rf"^Done {runs} runs", said, re.MULTILINE)
    if not artifact and not done:
        raise ToolFailed([str(fuzzer.program)], f"did neither end {runs} runs nor find", said)
    tried = re.search(r"number_of_executed_units: (\d+)", said)
    numbers = fuzzer.numbers(artifact[1]) if artifact else ()
    return Check(
        "fuzz: promises broken", emitted.prefix, float(bool(artifact)), LIMITS["attack"],
        int(tried[1]) if tried else 0, _reason(said) if artifact else "", numbers,
    )  # fmt: skip


def _reason(said: str) -> str:
    """The line that says what went wrong: the target's own, or a sanitizer's."""
    words = r"^(?:WRONG: (.*)|.*runtime error: (.*)|.*ERROR: \w+Sanitizer: (.*))$"
    found = re.search(words, said, re.MULTILINE)
    return next(filter(None, found.groups()), "") if found else "ended without a word"


def _reached(emitted: Emitted, said: str) -> Check:
    """Whether the law was reached, and the refusals; how often each status came."""
    counts = {int(a): int(b) for a, b in re.findall(r"^STATUS (\d+) (\d+)$", said, re.MULTILINE)}
    found = re.search(r"^SPOILT (\d+) (\d+)$", said, re.MULTILINE)
    refused, taken = map(int, found.groups()) if found else (0, 0)
    good = sum(n for status, n in counts.items() if status < FIRST_BAD)
    kinds = {
        "good inputs": good,
        "refused inputs": sum(counts.values()) - good,
        "refused parameters": refused,
        "changed parameters that are good": taken,
    }
    missed = [name for name, n in kinds.items() if not n]
    details = tuple(f"status {status}: {n}" for status, n in sorted(counts.items()))
    details += tuple(f"{name}: {n}" for name, n in kinds.items())
    return Check(
        "fuzz: kinds of input never seen", emitted.prefix, float(len(missed)),
        LIMITS["attack"], sum(counts.values()), ", ".join(missed), details,
    )  # fmt: skip
