"""The commands that doubt: a report on one vehicle, and all evidence as a page in its package."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from derive.terminal import (
    BAD_INPUT,
    FINDING,
    AnyPath,
    cache,
    cache_option,
    everything,
    give,
    json_option,
    loaded,
    out_option,
    probe,
    progress,
    spelled,
)

if TYPE_CHECKING:
    from collections.abc import Callable

    from derive.dossier import Filed
    from derive.vehicle import Vehicle

NOT_WHOLE = "not everything was checked; --allow-missing accepts that"


@click.command()
@click.argument("file", metavar="VEHICLE.toml", type=AnyPath)
@json_option
@click.option("--html", "html_file", type=AnyPath, help="Write it as a page; - for the screen.")
@click.option(
    "--samples",
    default=120,
    show_default=True,
    type=click.IntRange(1, 100_000),
    help="States per rung of the angle ladder.",
)
@click.option(
    "--seed",
    default=0,
    show_default=True,
    type=click.IntRange(0),
    help="Seed of the random states.",
)
@click.option("--mutants", is_flag=True, help="Also show that every mutant of the code is caught.")
@click.option(
    "--target",
    is_flag=True,
    help="Also run the C with gcc and clang, and emulated on Cortex-M4F and M7, RV32 and RV64: "
    "same bits, instructions, stack, size, flags; up to 90 s more.",
)
@click.option(
    "--allow-missing", is_flag=True, help="Exit 0 also where a compiler or an emulator is missing."
)
@cache_option
def verify(
    file: Path,
    json_file: Path | None,
    html_file: Path | None,
    samples: int,
    seed: int,
    mutants: bool,
    target: bool,
    allow_missing: bool,
    no_cache: bool,
) -> int:
    """Check every derivative and property against independent truth; worst figure, limit."""
    from derive import dossier, pipeline

    (vehicle,) = loaded((file,))
    probe(json_file, "--json")
    probe(html_file, "--html")
    if target:
        dossier.refuse_without_c(vehicle)
    cached, show = cache(no_cache), progress()
    try:
        with dossier.compiling(vehicle):
            report = pipeline.verify(
                vehicle, cached, show, each=samples, seed=seed, with_mutants=mutants
            )
        if target:
            report = dossier.on_targets(vehicle, cached, report, show)
    finally:
        show("")
    if Path("-") not in (json_file, html_file):
        click.echo(report.table())
    if json_file:
        give(json_file, report.as_json(), "--json")
    if html_file:
        give(html_file, report.as_html(), "--html")
    is_whole = allow_missing or not report.skipped
    if not is_whole:
        click.echo(NOT_WHOLE, err=True)
    return 0 if report.ok and is_whole else FINDING


@click.command()
@click.argument("files", metavar="[VEHICLE.toml...]", nargs=-1, type=AnyPath)
@out_option
@click.option(
    "--quick",
    is_flag=True,
    help="Without seeded defects, with less fuzzing and fewer numbers; the page says so.",
)
@click.option(
    "--allow-missing",
    is_flag=True,
    help="Exit 0 also where tools are missing, and replace a page that has more.",
)
@cache_option
def evidence(
    files: tuple[Path, ...], out: Path, quick: bool, allow_missing: bool, no_cache: bool
) -> int:
    """Run every proof, attack and measurement on emitted packages; write NAME/EVIDENCE.md.

    Without arguments: every vehicles/*.toml of the current folder. What was emitted has to be what
    the vehicle files give. A page that fits and has everything is not replaced by one that lacks
    something: of a quick run, or where tools are missing. A vehicle that cannot be measured is told
    and left out: exit code 2, and the others get their pages. Some minutes a vehicle.
    """
    from derive.vehicle import InputError

    names = files or everything()
    vehicles = _ready(names, out, cache(no_cache))
    lost = [str(name) for name in names if str(name) not in {one.source for one in vehicles}]
    code = 0
    for vehicle in vehicles:
        try:
            filed = _filed(vehicle, out, progress(), is_quick=quick, may_lose=allow_missing)
        except InputError as fault:
            click.echo(fault, err=True)
            lost.append(vehicle.source)
        else:
            code = max(code, _told(filed, is_accepted=allow_missing))
    if lost and len(names) > 1:
        click.echo(f"no page was written for {', '.join(lost)}: see above", err=True)
    return BAD_INPUT if lost else code


def _ready(files: tuple[Path, ...], out: Path, cached: Path | None) -> list[Vehicle]:
    """The vehicles that can be measured; why another cannot is told, before the work."""
    from derive import dossier
    from derive.vehicle import InputError

    vehicles = []
    for file in files:
        try:
            (vehicle,) = loaded((file,))
            dossier.refuse_unready(vehicle, out, cached, spelled("emit", [vehicle.source], out))
            vehicles.append(vehicle)
        except InputError as fault:
            click.echo(fault, err=True)
    return vehicles


def _filed(
    vehicle: Vehicle, out: Path, show: Callable[[str], None], *, is_quick: bool, may_lose: bool
) -> Filed:
    """Measure one package and write its page. Raises InputError."""
    from derive import dossier

    try:
        found = dossier.measured(vehicle, out, show, is_quick=is_quick)
        return dossier.filed(found, out / vehicle.name, may_lose=may_lose)
    finally:
        show("")


def _told(filed: Filed, *, is_accepted: bool) -> int:
    """Say what came of one package; the exit code."""
    found = filed.evidence
    counts = f"{len(found.all_checks)} checks, {len(found.failed)} failed"
    if filed.is_kept:
        click.echo(f"kept {filed.page}: it has everything, which this run has not ({counts}); "
                   "--allow-missing replaces it")  # fmt: skip
    else:
        click.echo(f"wrote {filed.page} ({counts})")
    for check in found.failed:
        click.echo(f"  FAILED {check.name}, {check.subject}: {check.measured:g} {check.limit.unit}"
                   f"; at most {check.limit.text}; {check.worst}")  # fmt: skip
    for reason in found.missing:
        click.echo(f"  not run: {reason}")
    for words in found.broken:
        click.echo(words, err=True)
    is_whole = is_accepted or not found.missing
    if not is_whole:
        click.echo(NOT_WHOLE, err=True)
    return 0 if is_whole and not found.failed else FINDING
