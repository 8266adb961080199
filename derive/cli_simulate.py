"""The command that flies one vehicle: as its file says, by a seed, or as in the paper."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from derive.cli_loop import LARGEST_SEED, Count, Number, Numbers
from derive.terminal import FINDING, AnyPath, cache, cache_option, loaded, progress

_OF_THE_FILE = (
    click.option("--duration", "seconds", type=Number(1e-3, 1e6, "s"), help="Seconds to fly."),
    click.option(
        "--rate", type=Number(1e-3, 1e6, "Hz"),
        help="Of the controller, its force held between; continuous when left out.",
    ),
    click.option("--step", type=Number(1e-6, 1.0, "s"), help="Longest step of the integration."),
    click.option(
        "--inertia-error", type=Number(-0.9, 10.0),
        help="Of the plant against the controller, relative; with --seed +-.",
    ),
    click.option(
        "--disturbance", type=Numbers(-1e9, 1e9, "N m or N"), metavar="F[,F...]",
        help="Constant force that the controller is not told; with --seed +-.",
    ),
    click.option(
        "--wave", type=Numbers(-1e9, 1e9, "N m or N"), metavar="F[,F...]",
        help="Amplitude of a periodic one; with --seed +-.",
    ),
    click.option("--hertz", type=Number(0.0, 1e6, "Hz"), help="Its frequency."),
    click.option(
        "--noise-g", type=Number(0.0, 0.1, "rad or m"),
        help="Standard deviation of a measured configuration.",
    ),
    click.option(
        "--noise-nu", type=Number(0.0, 1e9, "rad/s or m/s"),
        help="Standard deviation of a measured velocity.",
    ),
    click.option(
        "--force-limit", type=Numbers(0.0, 1e9, "N m or N", is_open=True), metavar="F[,F...]",
        help="What the actuators can give; one for all coordinates, or one for each.",
    ),
)  # fmt: skip


def _experiment_options(command: Any) -> Any:
    """What the [simulate] table of a vehicle file says as well."""
    for option in reversed(_OF_THE_FILE):
        command = option(command)
    return command


@click.command()
@click.argument("file", metavar="VEHICLE.toml", type=AnyPath)
@click.option(
    "--scenario", metavar="1|2|3|all", help="The paper's, with every controller it compares."
)
@click.option(
    "--backend", default="f64", show_default=True, metavar="f64|f32|numpy",
    help="Which emitted controller flies: C in double or single precision, or numpy.",
)  # fmt: skip
@click.option(
    "--seed", type=Count(0, LARGEST_SEED), help="Draw start and errors, as `derive sweep` does."
)
@click.option(
    "--box",
    default=1.0,
    show_default=True,
    type=Number(0.0, 1e6, "rad or m"),
    help="With --seed: of the error, where the group is not compact.",
)
@click.option(
    "--speed", default=0.5, show_default=True, type=Number(0.0, 1e6, "rad/s or m/s"),
    help="With --seed: of the velocity error.",
)  # fmt: skip
@_experiment_options
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
