"""The one-way route: vehicle -> derivation -> printed data -> {path: text} -> folder.

sympy is imported only where something has to be derived: a new inertia of a known pattern
finds its printed data in the cache.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from derive import __version__, cache, folder
from derive.emit.drift import Drift, compare
from derive.emit.render import manifest, render, targets, trace
from derive.vehicle import Facts, InputError, Vehicle, check_facts, resolve

if TYPE_CHECKING:
    from derive.verify.check import Report

Printed = dict[str, Any]


@dataclass(frozen=True)
class Written:
    """What became of one vehicle's folder; is_changed is False when it held the same bytes."""

    folder: Path
    files: int
    is_changed: bool


def cache_folder() -> Path | None:
    """Where this user's derivations are kept; None for a user without a home."""
    try:
        return Path.home() / ".cache" / "derive"
    except RuntimeError:
        return None


def derived(vehicle: Vehicle) -> Printed:
    """Derive and print everything that does not depend on the vehicle's numbers."""
    from derive.control.controller import routines
    from derive.control.kinematic import LAWS
    from derive.emit.package import package
    from derive.lie.catalogue import GROUPS

    facts = resolve(vehicle)
    check_facts(vehicle, facts)
    group, law = GROUPS[vehicle.group], LAWS[vehicle.group, vehicle.law]
    parts = routines(group, law, vehicle.controller, vehicle.pattern)
    described = {
        "group": group.name,
        "law": f"{law.name} ({law.doc})",
        "controller": vehicle.controller,
        "storage": group.storage,
        "dim": group.dim,
        "stored": len(group.identity),
        "element_shape": list(group.shape),
        "is_pole": law.is_pole,
        "zeros": [i for i, present in enumerate(vehicle.pattern) if not present],
    }
    data = package(vehicle.name, parts.main, parts.public, parts.inner, described)
    return {"facts": {"dim": facts.dim, "is_rotation": facts.is_rotation}, "targets": data}


def printed(vehicle: Vehicle, cached: Path | None) -> Printed:
    """Printed data of a vehicle, from the cache folder when it is there; None for no cache."""
    if cached is None:
        return derived(vehicle)
    parts = (vehicle.name, vehicle.group, vehicle.law, vehicle.controller, vehicle.pattern)
    name = cache.key(vehicle=parts)
    data: Printed | None = cache.read(cached, name)
    if data is None:
        data = derived(vehicle)
        cache.write(cached, name, data)
    check_facts(vehicle, Facts(**data["facts"]))
    return data


def texts(vehicle: Vehicle, cached: Path | None = None) -> dict[str, str]:
    """Every file of the vehicle's folder, by path below it."""
    data = printed(vehicle, cached)["targets"]
    values = _values(vehicle)
    files: dict[str, str] = {}
    used: Printed = {}
    for target in targets(vehicle.targets):
        scalars = {s: p for s, p in data[target.name].items() if s in vehicle.scalars}
        scalars = scalars or data[target.name]
        used[target.name] = scalars
        files |= render(target, scalars, values)
    first = next(iter(next(iter(used.values())).values()))
    files["trace.csv"] = trace(first, files)
    files[folder.MANIFEST] = manifest(__version__, values, first["routines"], files)
    return dict(sorted(files.items()))


def emit(vehicles: Sequence[Vehicle], out: Path, cached: Path | None = None) -> list[Written]:
    """Write out/NAME of every vehicle whole, or nothing at all. Raises InputError."""
    _refuse_twins(vehicles)
    with _told(out, "a folder that can be written to"):
        for vehicle in vehicles:
            _refuse_strangers(out / vehicle.name)
    folders = {vehicle.name: texts(vehicle, cached) for vehicle in vehicles}
    with _told(out, "a folder that can be written to"):
        changed = folder.replace(out, folders)
    return [Written(out / name, len(folders[name]), changed[name]) for name in folders]


def check(
    vehicles: Sequence[Vehicle], out: Path, cached: Path | None = None
) -> list[tuple[Vehicle, list[Drift]]]:
    """Where each out/NAME is not, byte for byte, what the vehicle file gives."""
    _refuse_twins(vehicles)
    drifts = []
    for vehicle in vehicles:
        expected = texts(vehicle, cached)
        with _told(out, "a folder that can be read"):
            drifts.append((vehicle, compare(expected, folder.read(out / vehicle.name))))
    return drifts


def verify(
    vehicle: Vehicle,
    cached: Path | None,
    progress: Callable[[str], None],
    *,
    each: int = 120,
    seed: int = 0,
    with_mutants: bool = False,
) -> Report:
    """Compile, run and doubt what `emit` would write; see derive.verify.run."""
    from derive.verify.reference import Plant
    from derive.verify.run import run

    gains = dict(vehicle.gains)
    judged = Plant(vehicle.group, vehicle.law, vehicle.inertia, gains["lambda"], gains["k_s"])
    files = texts(vehicle, cached)
    return run(
        vehicle.name,
        files,
        judged,
        controller=vehicle.controller,
        each=each,
        seed=seed,
        with_mutants=with_mutants,
        progress=progress,
    )


def save(path: Path, text: str, option: str) -> None:
    """Write one file that an option of the command line names, whole. Raises InputError."""
    with _told(path, "a file that can be written to", option):
        folder.save(path, text)


def _refuse_twins(vehicles: Sequence[Vehicle]) -> None:
    """Raise InputError when two would share a folder, or macros in C, which are upper case."""
    sources: dict[str, str] = {}
    for vehicle in vehicles:
        other = sources.get(vehicle.name.upper())
        sources[vehicle.name.upper()] = vehicle.source
        if other is not None:
            raise InputError(
                file=vehicle.source,
                key="name",
                expected="names that differ in more than capitals, one for each vehicle",
                found=f"{vehicle.name!r} here, and in {other}",
                remedy="rename one of the two, or leave it out of this call",
            )


def _refuse_strangers(place: Path) -> None:
    """Raise InputError when replacing a folder would lose a file that derive did not write."""
    foreign = folder.strangers(place)
    if foreign:
        more = f" and {len(foreign) - 5} more" if len(foreign) > 5 else ""
        raise InputError(
            file=str(place),
            key="--out",
            expected=f"a folder whose every file its {folder.MANIFEST} knows",
            found=f"foreign files: {', '.join(foreign[:5])}{more}",
            remedy="move them away, or choose another folder with --out",
        )


@contextmanager
def _told(place: Path, expected: str, option: str = "--out") -> Iterator[None]:
    """Turn what the system refuses into an InputError on the option that names the place."""
    try:
        yield
    except OSError as fault:
        taken = isinstance(fault, FileExistsError | NotADirectoryError)
        reason = "a file where a folder has to be" if taken else fault.strerror or str(fault)
        where = f": {fault.filename}" if fault.filename else ""
        remedy = f"choose another place with {option}, or mend what is there"
        raise InputError(str(place), option, expected, f"{reason}{where}", remedy) from fault


def _values(vehicle: Vehicle) -> dict[str, Any]:
    n = len(vehicle.inertia)
    upper = [vehicle.inertia[i][j] for i in range(n) for j in range(i, n)]
    return {
        "name": vehicle.name,
        "group": vehicle.group,
        "law": vehicle.law,
        "controller": vehicle.controller,
        "inertia": upper,
        "gains": vehicle.gains,
    }
