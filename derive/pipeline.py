"""The one-way route: vehicle -> derivation -> printed data -> {path: text} -> folder.

sympy is imported only where something has to be derived: a new inertia of a known pattern
finds its printed data in the cache.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from derive import __version__, cache, folder, place, selftest
from derive.compiled import Compiled
from derive.control.table import CONTROLLERS
from derive.emit.around import around
from derive.emit.drift import Drift, compare
from derive.emit.literal import nearest
from derive.emit.render import environment, manifest, render, targets, trace
from derive.vehicle import Facts, InputError, Vehicle, check_facts, resolve
from derive.vehicle.check import pivots
from derive.vehicle.group import group_of
from derive.vehicle.twin import refuse_twins
from derive.verify.limits import EPS, LIMITS

if TYPE_CHECKING:
    from derive.control.controller import Routines
    from derive.verify.check import Report
    from derive.verify.proof.report import ProofReport

Printed = dict[str, Any]

THEOREMS = "the theorems are of gsmc, and stand here for it on this group and inertia"


@dataclass(frozen=True)
class Written:
    """What became of one vehicle's folder; is_changed is False when it held the same bytes.

    cautions: what its kinematic law leads to, a line each
    """

    folder: Path
    files: int
    is_changed: bool
    cautions: tuple[str, ...] = ()


def cache_folder() -> Path | None:
    """Where this user's derivations are kept; None for a user without a home."""
    try:
        return Path.home() / ".cache" / "derive"
    except RuntimeError:
        return None


def derivations(vehicle: Vehicle) -> Routines:
    """Derive everything a vehicle whose group and law are known is emitted with."""
    from derive.control.controller import routines
    from derive.control.kinematic import laws_of

    group = group_of(vehicle)
    law = laws_of(group)[vehicle.law]
    return routines(group, law, vehicle.controller, vehicle.pattern, vehicle.options)


def derived(vehicle: Vehicle) -> Printed:
    """Derive and print everything that does not depend on the vehicle's numbers."""
    from derive.control.border import border
    from derive.control.kinematic import laws_of
    from derive.control.stray import strays
    from derive.emit.package import Parts, package
    from derive.theory import cautions

    facts = resolve(vehicle)
    check_facts(vehicle, facts)
    group = group_of(vehicle)
    law = laws_of(group)[vehicle.law]
    parts = derivations(vehicle)
    described: Printed = {
        "group": group.name,
        "law": f"{law.name} ({law.doc})",
        "controller": vehicle.controller,
        "storage": group.storage,
        "dim": group.dim,
        "stored": len(group.identity),
        "identity": [int(number) for number in group.identity],
        "element_shape": list(group.shape),
        "is_pole": law.is_pole and vehicle.hysteresis is None,
        "has_side": vehicle.hysteresis is not None,
        "zeros": [i for i, present in enumerate(vehicle.pattern) if not present],
        "is_bounded": list(parts.guard.is_bounded),
        "strays": [asdict(one) for one in strays(group.identity, parts.guard)],
        "saturation": vehicle.limits.saturation,
    }
    guard = parts.guard
    whole = Parts(parts.main, parts.public, guard.error, guard.seen, guard.law, guard.drift,
                  guard.apart, parts.inner, border(group))  # fmt: skip
    data = package(vehicle.name, whole, described)
    return {
        "selftest": selftest.kept(vehicle, data, is_pole=described["is_pole"]),
        "facts": {"dim": facts.dim, "is_rotation": facts.is_rotation},
        "cautions": [] if vehicle.hysteresis else cautions(vehicle, group),
        "targets": data,
    }


def printed(vehicle: Vehicle, cached: Path | None) -> Printed:
    """Printed data of a vehicle, from the cache folder when it is there; None for no cache."""
    if cached is None:
        return derived(vehicle)
    kept = ("name", "group", "own", "law", "controller", "pattern", "options")
    said = [getattr(vehicle, field) for field in kept]
    name = cache.key(vehicle=[*said, vehicle.limits.saturation, vehicle.hysteresis])
    data: Printed | None = cache.read(cached, name)
    if data is None:
        data = derived(vehicle)
        cache.write(cached, name, data)
    check_facts(vehicle, Facts(**data["facts"]))
    return data


def texts(vehicle: Vehicle, cached: Path | None = None) -> dict[str, str]:
    """Every file of the vehicle's folder, by path below it."""
    _refuse_lost(vehicle)
    return _rendered(vehicle, printed(vehicle, cached), cached)


def _rendered(vehicle: Vehicle, kept: Printed, cached: Path | None) -> dict[str, str]:
    environment().bytecode_cache = Compiled(cached) if cached else None
    data, values = kept["targets"], _values(vehicle)
    files: dict[str, str] = {}
    used: Printed = {}
    tests: Printed = {}
    for target in targets(vehicle.targets):
        scalars = {s: p for s, p in data[target.name].items() if s in vehicle.scalars}
        used[target.name] = scalars or data[target.name]
        if target.name == selftest.CODE:
            tests = selftest.tables(vehicle, kept["selftest"], used[target.name], values)
        files |= render(target, used[target.name], values, tests)
    first = next(iter(next(iter(used.values())).values()))
    files["trace.csv"] = trace(first, files)
    for target in targets(vehicle.targets):
        files |= around(target, used[target.name], values, files, has_test=bool(tests))
    files[folder.MANIFEST] = manifest(__version__, values, first["routines"], files)
    return dict(sorted(files.items()))


def _refuse_lost(vehicle: Vehicle) -> None:
    """Raise InputError when rounding to a scalar costs the inertia its definiteness."""
    for scalar in vehicle.scalars:
        kept = tuple(tuple(nearest(x, scalar) for x in row) for row in vehicle.inertia)
        spare = Fraction(LIMITS["spare"].figure * EPS[scalar])
        short = [i for i, pivot in enumerate(pivots(kept)) if pivot <= spare * kept[i][i]]
        if not short:
            continue
        others = [f'"{other}"' for other in vehicle.scalars if other != scalar]
        raise InputError(
            file=vehicle.source,
            key="inertia",
            expected=f"positive definite even after rounding to {scalar}, with some ulps to spare",
            found=f"row {short[0] + 1} then depends on the rows above it",
            remedy=f"write scalars = [{', '.join(others)}] below [emit]"
            if others and scalar == "f32"
            else "give an inertia that is farther from singular",
        )


def emit(vehicles: Sequence[Vehicle], out: Path, cached: Path | None = None) -> list[Written]:
    """Write out/NAME of every vehicle whole, or nothing at all. Raises InputError."""
    refuse_twins(vehicles)
    for vehicle in vehicles:
        place.refuse_strangers(out / vehicle.name)
        _refuse_lost(vehicle)
    kept = {vehicle.name: printed(vehicle, cached) for vehicle in vehicles}
    folders = {vehicle.name: _rendered(vehicle, kept[vehicle.name], cached) for vehicle in vehicles}
    with place.told(out, "a folder that can be written to"):
        changed = folder.replace(out, folders)
    return [
        Written(out / name, len(files), changed[name], tuple(kept[name]["cautions"]))
        for name, files in folders.items()
    ]


def check(
    vehicles: Sequence[Vehicle], out: Path, cached: Path | None = None
) -> list[tuple[Vehicle, list[Drift]]]:
    """Where each out/NAME is not, byte for byte, what the vehicle file gives."""
    refuse_twins(vehicles)
    drifts = []
    for vehicle in vehicles:
        expected = texts(vehicle, cached)
        with place.told(out, "a folder that can be read"):
            drifts.append((vehicle, compare(expected, folder.derived(out / vehicle.name))))
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
    from derive.verify.run import run

    files = texts(vehicle, cached)
    plant = selftest.plant_of(vehicle)
    return run(vehicle.name, files, plant, each=each, seed=seed, with_mutants=with_mutants,
               progress=progress)  # fmt: skip


def prove(vehicle: Vehicle | None, progress: Callable[[str], None]) -> ProofReport:
    """Decide the paper's statements exactly; see derive.verify.proof. Raises InputError."""
    from derive.verify.proof import run

    if vehicle is None:
        return run.prove(None, progress=progress)
    check_facts(vehicle, resolve(vehicle))
    group = group_of(vehicle)
    if not CONTROLLERS[vehicle.controller].is_baseline:
        law, options = vehicle.law, vehicle.options
        return run.prove(group, vehicle.inertia, progress, law=law, options=options)
    report = run.prove(group, vehicle.inertia, progress)
    of_others = f"the loop of {vehicle.controller}: {THEOREMS}"
    return replace(report, skipped=(*report.skipped, of_others))


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
        "force_limit": vehicle.limits.force,
        "saturation": vehicle.limits.saturation,
        "max_drift": vehicle.limits.drift,
        "hysteresis": vehicle.hysteresis,
        "is_own": vehicle.own is not None,
        "has_reference": CONTROLLERS[vehicle.controller].has_reference,
    }
