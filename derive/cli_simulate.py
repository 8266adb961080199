"""The command that flies one vehicle: as its file says, by a seed, or as in the paper."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from derive.cli_loop import (
    LARGEST_SEED,
    PLACE,
    Count,
    backend_option,
    experiment_options,
    rate_option,
    said,
    settle_option,
    start_options,
)
from derive.terminal import FINDING, AnyPath, cache, cache_option, loaded, progress

SCENARIOS = {"1": (1,), "2": (2,), "3": (3,), "all": (1, 2, 3)}


@click.command()
@click.argument("file", metavar="VEHICLE.toml", type=AnyPath)
@click.option(
    "--scenario", metavar="1|2|3|all", help="The paper's, with every controller it compares."
)
@backend_option
@click.option(
    "--seed", type=Count(0, LARGEST_SEED), help="Draw start and errors, as `derive sweep` does."
)
@start_options
@rate_option
@experiment_options
@settle_option
@click.option(
    "--out", type=AnyPath, metavar="DIR",
    help="Folder for pictures and numbers; simulated/NAME if left out.",
)  # fmt: skip
@cache_option
def simulate(
    file: Path,
    scenario: str | None,
    backend: str,
    seed: int | None,
    box: float,
    speed: float,
    settle: float,
    out: Path | None,
    no_cache: bool,
    **written: Any,
) -> int:
    """Close the loop through the emitted code: pictures, numbers, and what must not break."""
    from derive import comparison, place, simulation

    (vehicle,) = loaded((file,))
    given = {key: value for key, value in written.items() if value is not None}
    _check_together(scenario, seed, [*given])
    home = out or Path("simulated") / vehicle.name
    place.probe_folder(home)
    show = progress()
    try:
        if scenario is not None:
            numbers = SCENARIOS[scenario]
            compared = comparison.scenarios(vehicle, cache(no_cache), numbers, backend, show)
            is_good, table = compared.ok, compared.table()
            files = comparison.documents(compared, show)
        else:
            asked = simulation.Asked(backend, seed, box, speed, settle, given)
            flown = simulation.simulate(vehicle, cache(no_cache), asked, show)
            is_good, table = flown.ok, flown.table()
            files = simulation.documents(flown)
        paths = simulation.write(files, home)
    finally:
        show("")
    click.echo(f"{table}\n\nwrote {len(paths)} files to {home}")
    if not any(path.suffix == ".png" for path in paths):
        click.echo("no pictures: they need pip install 'gsmc-derive[plot]'", err=True)
    return 0 if is_good else FINDING


def _check_together(scenario: str | None, seed: int | None, given: list[str]) -> None:
    """Raise InputError for options that the others leave no room for."""
    if scenario is not None:
        _check_scenario(scenario, [*given, *said("seed", "box", "speed", "settle")])
    elif seed is None:
        _check_start(said("box", "speed"))


def _check_scenario(scenario: str, given: list[str]) -> None:
    """Raise InputError for another number, or for options that a scenario leaves no room for."""
    from derive.vehicle import InputError

    if scenario not in SCENARIOS:
        known = ", ".join(SCENARIOS)
        remedy = "give one of them, or leave --scenario out to fly the vehicle file's own run"
        raise InputError(PLACE, "--scenario", f"one of {known}", repr(scenario), remedy)
    if given:
        from derive.flight import option

        found = ", ".join(map(option, given))
        remedy = "leave it out, or fly the vehicle file's own run without --scenario"
        expected = "no option of a run of one's own: the paper states its scenarios"
        raise InputError(PLACE, "--scenario", expected, found, remedy)


def _check_start(given: list[str]) -> None:
    """Raise InputError for options of a drawn start, where none is drawn."""
    from derive.flight import option
    from derive.vehicle import InputError

    if given:
        found = f"{', '.join(map(option, given))} without --seed"
        remedy = "give a --seed; or leave it out, and write turn and nu below [simulate]"
        expected = "a start that is drawn, from a --seed: this is what it lies in"
        raise InputError(PLACE, option(given[0]), expected, found, remedy)
