"""What a loop is asked to be, checked: settings, backends, numbers per coordinate."""

from __future__ import annotations

from derive.native.compile import Compiler, CompilerMissing
from derive.simulate.pilot import BACKENDS
from derive.vehicle import InputError

PLACE = "command line"


def wide(values: tuple[float, ...], n: int, option: str) -> tuple[float, ...]:
    """One number per coordinate; raises InputError where there are neither 1 nor n."""
    if len(values) not in (1, n):
        expected = f"one number, or {n} with commas between them"
        remedy = f"give one per coordinate, or leave {option} out"
        raise InputError(PLACE, option, expected, f"{len(values)} numbers", remedy)
    return values * n if len(values) == 1 else values


def backend_of(name: str) -> str:
    """A backend that can run here; raises InputError for an unknown one, or without a compiler."""
    if name not in BACKENDS:
        expected = f"one of {', '.join(sorted(BACKENDS))}"
        raise InputError(PLACE, "--backend", expected, name, "choose one of them")
    if name == "numpy":
        return name
    try:
        Compiler.find()
    except CompilerMissing as fault:
        found = str(fault).splitlines()[0]
        remedy = "install gcc or clang, or fly the numpy controller: --backend numpy"
        raise InputError(PLACE, "--backend", f"a C compiler, for {name}", found, remedy) from fault
    return name
