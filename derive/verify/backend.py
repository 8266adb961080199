"""The emitted code as something to call: numpy, C double, C float, with one interface."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from derive.emit.literal import python_name
from derive.native.compile import CompilerMissing, build
from derive.native.load import Library, load_module
from derive.verify.sample import States

Outputs = dict[str, NDArray[Any]]
COMMAND = ("force", "s", "nu_u", "nu_u_dot")


@dataclass(frozen=True)
class Backend:
    """Emitted routines by name: tracking, reaching and control of States, plant with a force.

    run gives the outputs by name, (N, n), and of control the status (N,) besides;
    check_params the status of parameters given by their names in C, the others being defaults.
    """

    name: str
    scalar: str
    run: Callable[..., Outputs]
    check_params: Callable[[Mapping[str, Any]], int]


def numpy_backend(module: Any, has_reference: bool) -> Backend:
    """The emitted numpy module, in double precision."""

    def run(routine: str, states: States, force: Any = None) -> Outputs:
        if routine == "plant":
            return {"nu_dot": module.plant(states.nu, force)}
        g, g_r = (_shaped(x) for x in (states.g, states.g_r))
        call = getattr(module, routine)
        if routine == "reaching" or not has_reference:
            command = call(g, states.nu)
        else:
            command = call(g, states.nu, g_r, states.nu_r, states.nu_r_dot)
        return command._asdict() if routine == "control" else _without_status(command._asdict())

    def check_params(given: Mapping[str, Any]) -> int:
        renamed = {python_name(name): value for name, value in given.items()}
        return int(module.check_params(module.DEFAULTS._replace(**renamed)))

    return Backend("numpy f64", "f64", run, check_params)


def c_backend(library: Library, scalar: str, has_reference: bool) -> Backend:
    """Emitted C in one precision, compiled for this machine."""

    def run(routine: str, states: States, force: Any = None) -> Outputs:
        if routine == "plant":
            return {"nu_dot": library.plant(states.g, states.nu, force)}
        if routine == "reaching":
            return library.reaching(states.g, states.nu)
        references = (states.g_r, states.nu_r, states.nu_r_dot) if has_reference else ()
        call = library.control if routine == "control" else library.tracking
        return call(states.g, states.nu, *references)

    def check_params(given: Mapping[str, Any]) -> int:
        return int(library.check_params(given))

    return Backend(f"C {scalar}", scalar, run, check_params)


def backends(
    name: str, texts: Mapping[str, str], folder: Path, has_reference: bool
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
        found.append(numpy_backend(module, has_reference))
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
        found.append(c_backend(Library(header, shared, prefix), scalar, has_reference))
    return found, module, missing


def _shaped(stored: NDArray[Any]) -> NDArray[Any]:
    """Stored numbers (N, k) in the shape the numpy module takes: matrices as matrices."""
    return stored.reshape(-1, 3, 3) if stored.shape[-1] == 9 else stored


def _without_status(command: Outputs) -> Outputs:
    """A bare law judges nothing."""
    return {name: command[name] for name in COMMAND}
