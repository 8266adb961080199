"""The emitted code as something to call: numpy, C double, C float, with one interface."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from derive.native.compile import CompilerMissing, build
from derive.native.load import Library, load_module
from derive.verify.sample import States

Outputs = dict[str, NDArray[Any]]
COMMAND = ("force", "s", "nu_u", "nu_u_dot")


@dataclass(frozen=True)
class Backend:
    """Emitted routines by name: tracking and reaching of States, plant of States and a force.

    Each gives its outputs by name, (N, n).
    """

    name: str
    scalar: str
    run: Callable[..., Outputs]


def numpy_backend(module: Any) -> Backend:
    """The emitted numpy module, in double precision."""

    def run(routine: str, states: States, force: Any = None) -> Outputs:
        if routine == "plant":
            return {"nu_dot": module.plant(states.nu, force)}
        g, g_r = (_shaped(module, x) for x in (states.g, states.g_r))
        if routine == "reaching":
            command = module.reaching(g, states.nu)
        else:
            command = module.tracking(g, states.nu, g_r, states.nu_r, states.nu_r_dot)
        return {name: getattr(command, name) for name in COMMAND}

    return Backend("numpy f64", "f64", run)


def c_backend(library: Library, scalar: str) -> Backend:
    """Emitted C in one precision, compiled for this machine."""

    def run(routine: str, states: States, force: Any = None) -> Outputs:
        if routine == "plant":
            return {"nu_dot": library.plant(states.g, states.nu, force)}
        if routine == "reaching":
            return library.reaching(states.g, states.nu)
        return library.tracking(states.g, states.nu, states.g_r, states.nu_r, states.nu_r_dot)

    return Backend(f"C {scalar}", scalar, run)


def backends(
    name: str, texts: Mapping[str, str], folder: Path
) -> tuple[list[Backend], Any, list[str]]:
    """Write, compile and load a vehicle's files in folder.

    Returns the backends, the numpy module (None when it was not emitted), and why any is missing.
    """
    for path, text in texts.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")
    found: list[Backend] = []
    missing: list[str] = []
    module = None
    if f"numpy/{name}.py" in texts:
        module = load_module(folder / "numpy" / f"{name}.py")
        found.append(numpy_backend(module))
    for scalar in ("f64", "f32"):
        prefix = f"{name}_{scalar}"
        source = folder / "c" / "src" / f"{prefix}.c"
        if not source.is_file():
            continue
        try:
            shared = build([source], folder / "c" / "include", folder)
        except CompilerMissing as error:
            missing.append(f"C {scalar}: {error}")
            continue
        header = folder / "c" / "include" / f"{prefix}.h"
        found.append(c_backend(Library(header, shared, prefix), scalar))
    return found, module, missing


def _shaped(module: Any, stored: NDArray[Any]) -> NDArray[Any]:
    """Stored numbers (N, k) in the shape the numpy module takes: matrices as matrices."""
    return stored.reshape(-1, 3, 3) if stored.shape[-1] == 9 else stored
