"""The one-way route: vehicle -> derivation -> printed data -> {path: text} -> folder.

sympy is imported only where something has to be derived: a new inertia of a known pattern
finds its printed data in the cache.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from derive import __version__, cache, folder
from derive.emit.drift import Drift, compare
from derive.emit.render import manifest, render, targets, trace
from derive.vehicle import Facts, InputError, Vehicle, check_facts, resolve

Printed = dict[str, Any]


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


def emit(vehicle: Vehicle, out: Path, cached: Path | None = None) -> bool:
    """Write out/NAME whole; False when it held the same bytes. Raises InputError."""
    place = out / vehicle.name
    foreign = folder.strangers(place)
    if foreign:
        raise InputError(
            file=str(place),
            key="--out",
            expected="a folder whose every file its MANIFEST.toml knows",
            found=f"foreign files: {', '.join(foreign[:5])}",
            remedy="move them away, or choose another folder with --out",
        )
    files = texts(vehicle, cached)
    try:
        return folder.replace(place, files)
    except OSError as error:
        raise InputError(
            file=str(place),
            key="--out",
            expected="a folder that can be written to",
            found=error.strerror or str(error),
            remedy="choose another folder with --out, or mend its permissions",
        ) from error


def check(vehicle: Vehicle, out: Path, cached: Path | None = None) -> list[Drift]:
    """Where out/NAME is not, byte for byte, what the vehicle file gives."""
    return compare(texts(vehicle, cached), folder.read(out / vehicle.name))


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
