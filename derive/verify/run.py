"""One verification run: emitted texts in, a report out. Files live in a folder of their own."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path

from derive.verify.backend import backends
from derive.verify.check import Report
from derive.verify.mutation import mutation, unjudged
from derive.verify.plant import Plant
from derive.verify.subject import Subject
from derive.verify.suite import checks


def run(
    name: str,
    texts: Mapping[str, str],
    vehicle: Plant,
    *,
    each: int = 120,
    seed: int = 0,
    with_mutants: bool = False,
    progress: Callable[[str], None] = lambda _: None,
) -> Report:
    """Verify what stands in texts, {path: text} of an emitted folder, against the vehicle.

    each: samples per rung of the angle ladder; with_mutants: also judge every mutant of the
    derivation. Raises CompileError when the emitted C does not compile.
    """
    with tempfile.TemporaryDirectory(prefix="derive-") as folder:
        progress("compiling")
        found, module, missing = backends(name, texts, Path(folder), vehicle)
        subject = Subject(vehicle, tuple(found), module, each, seed)
        lines = list(checks(subject, progress))
        if with_mutants:
            lines += mutation(vehicle, each, seed, progress)
            missing += unjudged(vehicle)
    return Report(name, tuple(lines), tuple(missing))
