"""The largest error of the emitted kernel polynomials in float, over every number there is."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path

from derive.emit.render import environment
from derive.evidence.emitted import FLAGS, Emitted
from derive.evidence.tool import Tool, run

GCC = Tool("gcc", "apt install gcc")
SECONDS = 120


@dataclass(frozen=True)
class Largest:
    """relative error; at: w; evaluations: two for each z that several w share."""

    error: float
    at: float
    evaluations: int


def largest(one: Emitted, orders: dict[str, int], beyond: int, step: int = 1) -> dict[str, Largest]:
    """Per kernel function its largest error against a series in double, for 0 <= w <= 1 and a bit.

    orders: of the derivative of k that a function is; beyond: units of 2^-24 beyond w = 1
    step: 1 for every number, else one in so many
    Raises ToolMissing, ToolFailed.
    """
    template = environment().get_template("evidence/kernel.c.jinja")
    context = {"prefix": one.prefix, "source": one.source.name, "beyond": beyond}
    with tempfile.TemporaryDirectory() as scratch:
        driver, program = Path(scratch) / "kernel.c", Path(scratch) / "kernel"
        driver.write_text(template.render(**context, orders=orders.items()), encoding="utf-8")
        places = (f"-I{one.include}", f"-I{one.source.parent}")
        words = [GCC.path, *FLAGS, "-O2", *places, str(driver), "-o", str(program), "-lm"]
        run(words, SECONDS)
        said = run([str(program), str(step)], SECONDS)
    rows = (line.split() for line in said.splitlines())
    return {name: Largest(float(e), float(at), int(seen)) for name, e, at, seen in rows}
