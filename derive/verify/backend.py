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
from derive.verify.plant import Plant
from derive.verify.sample import States
from derive.verify.shape import space

Outputs = dict[str, NDArray[Any]]

KEPT = ("side", "sign")
"""What is kept from call to call, as numpy and C name it."""


@dataclass(frozen=True)
class Backend:
    """Emitted routines by name: tracking, reaching and control of States, plant with a force.

    run gives the outputs by name, (N, n), and of control the status (N,) besides, of no side
    chosen before;
    check_params the status of parameters given by their names in C, the others being defaults;
    has_drift whether a distance from the group is one of them.
    """

    name: str
    scalar: str
    run: Callable[..., Outputs]
    check_params: Callable[[Mapping[str, Any]], int]
    has_drift: bool = False


def numpy_backend(module: Any, vehicle: Plant) -> Backend:
    """The emitted numpy module, in double precision."""

    def run(routine: str, states: States, force: Any = None) -> Outputs:
        if routine == "plant":
            return {"nu_dot": module.plant(states.nu, *extras(vehicle, states), force)}
        command = call(module, vehicle, routine, states)
        unsaid = KEPT if routine == "control" else (*KEPT, "status")
        return _without(command._asdict(), *unsaid)

    def check_params(given: Mapping[str, Any]) -> int:
        renamed = {python_name(name): value for name, value in given.items()}
        return int(module.check_params(module.DEFAULTS._replace(**renamed)))

    return Backend("numpy f64", "f64", run, check_params, "max_drift" in module.Params._fields)


def call(
    module: Any,
    vehicle: Plant,
    routine: str,
    states: States,
    params: Any = None,
) -> Any:
    """The command of a law of the numpy module."""
    shape = space(vehicle.space).element
    g, g_r = (x.reshape(-1, *shape) for x in (states.g, states.g_r))
    given = [g, states.nu, *extras(vehicle, states)]
    if routine != "reaching" and vehicle.has_reference:
        given += [g_r, states.nu_r, states.nu_r_dot]
    return getattr(module, routine)(*given, *(() if params is None else (params,)))


def extras(vehicle: Plant, states: States) -> list[NDArray[Any]]:
    """What a state holds besides, in the order of the emitted arguments."""
    return [getattr(states, name) for name in ("momentum", "external") if name in vehicle.options]


def c_backend(library: Library, scalar: str, vehicle: Plant) -> Backend:
    """Emitted C in one precision, compiled for this machine."""

    def run(routine: str, states: States, force: Any = None) -> Outputs:
        also = {name: getattr(states, name) for name in vehicle.options}
        if routine == "plant":
            return {"nu_dot": library.plant(states.g, states.nu, force, **also)}
        if routine == "reaching":
            return library.reaching(states.g, states.nu, **also)
        references = (states.g_r, states.nu_r, states.nu_r_dot) if vehicle.has_reference else ()
        law = library.control if routine == "control" else library.tracking
        return _without(law(states.g, states.nu, *references, **also), *KEPT)

    def check_params(given: Mapping[str, Any]) -> int:
        return int(library.check_params(given))

    return Backend(f"C {scalar}", scalar, run, check_params, "max_drift" in library.defaults)


def backends(
    name: str, texts: Mapping[str, str], folder: Path, vehicle: Plant
) -> tuple[list[Backend], Any, list[str]]:
    """Write, compile and load a vehicle's files in folder.

    Returns the backends, the numpy module (None when it was not emitted), and why any is missing.
    """
    for path, text in texts.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")
    found: list[Backend] = []
    lost: dict[str, list[str]] = {}
    module = None
    if f"numpy/{name}.py" in texts:
        module = load_module(folder / "numpy" / f"{name}.py")
        found.append(numpy_backend(module, vehicle))
    for scalar in ("f64", "f32"):
        prefix = f"{name}_{scalar}"
        source = folder / "c" / "src" / f"{prefix}.c"
        if not source.is_file():
            continue
        try:
            shared = build([source], folder / "c" / "include", folder)
        except CompilerMissing as error:
            lost.setdefault(str(error), []).append(scalar)
            continue
        header = folder / "c" / "include" / f"{prefix}.h"
        found.append(c_backend(Library(header, shared, prefix), scalar, vehicle))
    missing = [f"C {' and '.join(scalars)}: {reason}" for reason, scalars in lost.items()]
    return found, module, missing


def _without(command: Outputs, *names: str) -> Outputs:
    """A bare law judges nothing, and what a caller keeps is no part of a command."""
    return {name: value for name, value in command.items() if name not in names}
