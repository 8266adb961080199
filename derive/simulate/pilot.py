"""The controller as emitted: numpy, C in double, or C in single precision, over columns."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from derive.emit.status import FIRST_BAD
from derive.native.load import Library, load_module
from derive.native.rows import Rows, build_rows, column
from derive.simulate.craft import Craft, group_of, unpacked
from derive.simulate.space import Array

BACKENDS = ("numpy", "f64", "f32")
REFUSED = FIRST_BAD
"""From this status on the controller has refused its input: the whole command is zero."""


class Command(NamedTuple):
    """What `control` says: force, s and nu_u, (n, N) each, and status (N,).

    side: sign of the error that it drives to the identity, (N,), where it takes q or -q
    """

    force: Array
    s: Array
    nu_u: Array
    status: NDArray[np.int_]
    side: Array | None = None


@dataclass(frozen=True)
class Pilot:
    """The guarded entry of one backend, for a fixed number of loops, whose sides it keeps.

    run: columns by name (g, nu, g_r, nu_r, nu_r_dot and the options') -> Command
    """

    backend: str
    run: Callable[[Mapping[str, Array]], Command]


def pilot(craft: Craft, backend: str, loops: int) -> Pilot:
    """The craft's controller; raises CompilerMissing or CompileError where C cannot be built."""
    if backend == "numpy":
        return Pilot(backend, _numpy(craft))
    return Pilot(backend, _native(craft, backend, loops))


def _numpy(craft: Craft) -> Callable[[Mapping[str, Array]], Command]:
    module, shape = _module(craft), group_of(craft).shape
    kept = {"side": 0.0} if hasattr(module, "HYSTERESIS") else {}

    def run(given: Mapping[str, Array]) -> Command:
        rows = {name: np.moveaxis(one, 0, -1) for name, one in given.items()}
        for name in ("g", "g_r"):
            if name in rows:
                rows[name] = rows[name].reshape(-1, *shape)
        found = module.control(**rows, **kept)
        force, s, nu_u = (np.moveaxis(one, -1, 0) for one in (found.force, found.s, found.nu_u))
        if not kept:
            return Command(force, s, nu_u, found.status)
        kept["side"] = found.side
        return Command(force, s, nu_u, found.status, found.side)

    return run


HOMES = {
    "g": ("state", "g"),
    "nu": ("state", "nu"),
    "momentum": ("state", "momentum"),
    "external": ("state", "external"),
    "g_r": ("reference", "g"),
    "nu_r": ("reference", "nu"),
    "nu_r_dot": ("reference", "nu_dot"),
}
"""Argument of the controller -> the struct and the field that hold it in C."""


def _native(craft: Craft, scalar: str, loops: int) -> Callable[[Mapping[str, Array]], Command]:
    rows = Rows(_library(craft, scalar), "control", loops)
    command = rows.outputs["command"]
    places: dict[str, Array] = {}
    told = [column(command, name) for name in ("force", "s", "nu_u")]
    kept = column(rows.outputs["side"], "sign") if "side" in rows.outputs else None

    def run(given: Mapping[str, Array]) -> Command:
        for name, values in given.items():
            if name not in places:
                struct, field = HOMES[name]
                places[name] = column(rows.inputs[struct], field)
            places[name][...] = values
        rows.run()
        force, s, nu_u = (one.astype(np.float64, order="C") for one in told)
        side = None if kept is None else kept.astype(np.float64)
        return Command(force, s, nu_u, rows.results.astype(np.int_), side)

    return run


@cache
def _module(craft: Craft) -> Any:
    with unpacked(craft) as root:
        return load_module(root / "numpy" / f"{craft.name}.py")


@cache
def _library(craft: Craft, scalar: str) -> Library:
    prefix = f"{craft.name}_{scalar}"
    with unpacked(craft) as root:
        header = root / "c" / "include" / f"{prefix}.h"
        source = root / "c" / "src" / f"{prefix}.c"
        return Library(header, build_rows(header, source, root / "build"), prefix)
