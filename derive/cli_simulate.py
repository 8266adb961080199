"""The command that flies one vehicle: as its file says, by a seed, or as in the paper."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from derive.cli_loop import (
    LARGEST_SEED,
    Count,
    backend_option,
    experiment_options,
    rate_option,
    start_options,
)
from derive.terminal import FINDING, AnyPath, cache, cache_option, loaded, progress


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
@click.option("--out", type=AnyPath, metavar="DIR", help="Folder for figures and numbers.")
@cache_option
def simulate(
    file: Path,
    scenario: str | None,
    backend: str,
    seed: int | None,
    box: float,
    speed: float,
    out: Path | None,
    no_cache: bool,
    **said: Any,
) -> int:
    """Close the loop through the emitted code: figures, numbers, and what must not break."""
    from derive import flight

    (vehicle,) = loaded((file,))
    given = {key: value for key, value in said.items() if value is not None}
    show = progress()
    try:
        asked = flight.Asked(backend, seed, box, speed, given, out)
        report = flight.simulate(vehicle, cache(no_cache), asked, show)
    finally:
        show("")
    click.echo(report.table())
    return 0 if report.ok else FINDING
