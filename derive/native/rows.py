"""Decides how thousands of rows run in C at a time: a loop beside each routine, over structs.

The loop is C of our own around the emitted routine, which is called once per row and never
changed; its buffers are filled and read in place.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from derive.native.compile import SHARED, Compiler, build
from derive.native.header import Routine, parse
from derive.native.layout import Array
from derive.native.load import Library

SUFFIX = "_rows"


class Rows:
    """One routine over a fixed number of rows.

    `inputs[struct][field]` and `outputs[struct][field]` are arrays (rows, …) to write to and to
    read from; `results` (rows,) is what the routine returned. An input `params` starts as the
    defaults.
    """

    def __init__(self, library: Library, routine: str, rows: int) -> None:
        declared = library.routines[routine]
        layouts = {one.name: library.argument(one) for one in declared.parameters}
        buffers = {name: np.zeros(rows, dtype=layout) for name, layout in layouts.items()}
        names = [one.name for one in declared.parameters if one.is_input]
        self.inputs = {name: buffers[name] for name in names}
        self.outputs = {name: buffer for name, buffer in buffers.items() if name not in names}
        self.results = np.zeros(rows, dtype=np.int32)
        for name, value in library.defaults.items() if "params" in names else ():
            self.inputs["params"][name] = value
        self._buffers = buffers  # whose addresses are called with
        arguments = (rows, *buffers.values(), self.results)
        self._call = library.bound(_prototype(declared), declared.symbol + SUFFIX, *arguments)

    def run(self) -> None:
        """Call the routine on every row."""
        self._call()


def build_rows(header: Path, source: Path, folder: Path, compiler: Compiler | None = None) -> Path:
    """Compile an emitted source with a loop beside each of its routines; raises as `build`."""
    routines = parse(header.read_text(encoding="utf-8")).routines.values()
    loops = folder / f"{source.stem}{SUFFIX}.c"
    folder.mkdir(parents=True, exist_ok=True)
    loops.write_text(text(header.name, list(routines)), encoding="utf-8")
    return build([source, loops], header.parent, folder, SHARED, compiler)


def text(header: str, routines: Sequence[Routine]) -> str:
    """C source of the loops."""
    lines = [f'#include "{header}"']
    for one in routines:
        given = (f"{p.name} + i" + (f" * {p.size}" if p.size else "") for p in one.parameters)
        call = f"{one.symbol}({', '.join(given)});"
        # The cast is of a variable: of a call, clang would warn.
        kept = [f"const {one.result} found = {call}", "results[i] = (int)found;"]
        lines += [
            "",
            _prototype(one) + ";",
            _prototype(one),
            "{",
            "    (void)results;",
            "    for (long i = 0; i < rows; ++i) {",
            *(f"        {line}" for line in ([call] if one.result == "void" else kept)),
            "    }",
            "}",
        ]
    return "\n".join([*lines, ""])


def _prototype(routine: Routine) -> str:
    pointers = (f"{'const ' * p.is_input}{p.type} *{p.name}" for p in routine.parameters)
    return f"void {routine.symbol}{SUFFIX}(long rows, {', '.join(pointers)}, int *results)"


def column(buffer: Array, name: str) -> Array:
    """One field of all rows as (k, rows) or (rows,), to be read or written in place."""
    return np.moveaxis(buffer[name], 0, -1)
