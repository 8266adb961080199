"""What a loop is asked to be, checked: settings, backends, numbers per coordinate."""

from __future__ import annotations

from derive.native.compile import Compiler, CompilerMissing
from derive.simulate.pilot import BACKENDS
from derive.simulate.runs import Setting
from derive.vehicle import InputError

PLACE = "command line"
MOST_INSTANTS = 10**8  # of one run


def wide(values: tuple[float, ...], n: int, option: str) -> tuple[float, ...]:
    """One number per coordinate; raises InputError where there are neither 1 nor n."""
    if len(values) not in (1, n):
        expected = f"one number, or {n} with commas between them"
        remedy = f"give one per coordinate, or leave {option} out"
        raise InputError(PLACE, option, expected, f"{len(values)} numbers", remedy)
    return values * n if len(values) == 1 else values


def setting_of(
    duration: float,
    rate: float | None,
    hertz: float,
    noise: tuple[float, float],
    force_limit: tuple[float, ...] | None,
    n: int,
) -> Setting:
    """What all loops share; noise is that of g and of nu. Raises InputError."""
    if rate is not None and not 1 <= duration * rate <= MOST_INSTANTS:
        raise InputError(
            PLACE,
            "--rate",
            f"1 to {MOST_INSTANTS} instants in a run of {duration:g} s",
            f"{rate:g} Hz, {duration * rate:g} instants",
            "change --rate or --duration",
        )
    limit = None if force_limit is None else wide(force_limit, n, "--force-limit")
    return Setting(
        duration,
        rate,
        hertz=hertz,
        force_limit=limit,
        noise_g=noise[0],
        noise_nu=noise[1],
    )


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
