"""The command that flies thousands of runs of one vehicle, here or on a cluster."""

from __future__ import annotations

import os
import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from derive.cli_loop import (
    LARGEST_SEED,
    Count,
    Number,
    backend_option,
    experiment_options,
    settle_option,
    start_options,
)
from derive.terminal import AnyPath, cache, cache_option, loaded, progress

if TYPE_CHECKING:
    from derive.sweep_folder import Sweep

MOST_RUNS, MOST_WORKERS = 10**6, 1024
OWN = ("runs", "seed", "backend", "box", "speed", "settle", "rates", "chunk")
"""Options that no vehicle file speaks of."""

REPLAYED = ("backend", "box", "speed", "settle", "duration", "step", "inertia_error",
            "disturbance", "wave", "hertz", "noise_g", "noise_nu", "force_limit")  # fmt: skip
"""Options that `derive simulate` needs to fly a run again."""


@click.command()
@click.argument("file", metavar="VEHICLE.toml", type=AnyPath)
@click.option("--runs", default=1000, show_default=True, type=Count(1, MOST_RUNS), help="How many.")
@click.option("--out", required=True, type=AnyPath, metavar="DIR", help="A new folder for results.")
@click.option("--resume", is_flag=True, help="Go on with the sweep that --out holds.")
@click.option(
    "--seed", default=0, show_default=True, type=Count(0, LARGEST_SEED),
    help="What the seeds of the runs are made from.",
)  # fmt: skip
@backend_option
@start_options
@click.option(
    "--rate", "rates", multiple=True, type=Number(1e-3, 1e6, "Hz"),
    help="Of the controller; given several times, each run takes one of them.",
)  # fmt: skip
@experiment_options
@settle_option
@click.option(
    "--workers", type=Count(1, MOST_WORKERS), help="Processes; one per core when left out."
)
@click.option(
    "--chunk", default=500, show_default=True, type=Count(1, MOST_RUNS),
    help="Runs that fly together.",
)  # fmt: skip
@click.option("--cluster", metavar="ADDRESS", help="Scheduler of a Dask cluster to fly on.")
@click.option(
    "--format",
    "form",
    metavar="csv|parquet",
    help="Of the results; left out, parquet if it can.",
)
@cache_option
def sweep(
    file: Path,
    out: Path,
    resume: bool,
    workers: int | None,
    cluster: str | None,
    form: str | None,
    no_cache: bool,
    **said: Any,
) -> int:
    """Monte Carlo: many runs from drawn starts with drawn errors; figures of each and of all."""
    from derive import campaign, crew, sweep_folder

    wanted = crew.form_of(form)
    (vehicle,) = loaded((file,))
    given = {key: said[key] for key in said if key not in OWN and said[key] is not None}
    asked = campaign.Asked(**{key: said[key] for key in OWN}, given=given)
    show = progress()
    try:
        show("deriving")
        plan = campaign.plan(vehicle, cache(no_cache), asked)
        hands = crew.hired(cluster, workers or _cores())
        with crew.let_go(hands), campaign.held(plan, asked, out, wanted, resume) as opened:
            if opened.whole:
                return _again(opened, opened.whole, is_asked=form is not None)
            rows = campaign.flown(opened, hands, show)
            show("results")
            found, text = campaign.told(rows, opened)
            lacking = crew.drawn(rows, opened)
            opened.finish(rows)
    except KeyboardInterrupt:
        show("")
        if (out / sweep_folder.DEFINITION).exists():
            click.echo(f"finished chunks are kept in {out}; go on with --resume", err=True)
        raise
    finally:
        show("")
    click.echo("\n".join([text, *_replays(file, found, said), "", f"wrote {opened.results}"]))
    if lacking:
        click.echo(lacking, err=True)
    return 0


def _again(opened: Sweep, there: Path, is_asked: bool) -> int:
    """A sweep that an earlier call has flown: nothing is to do but a format that is asked for."""
    if there == opened.results or not is_asked:
        click.echo(f"{there} is whole already")
    else:
        opened.rewrite(there)
        click.echo(f"wrote {opened.results} from {there}")
    return 0


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _replays(file: Path, found: dict[str, Any], said: dict[str, Any]) -> list[str]:
    """The command lines of the slowest run and of the first few that failed."""
    from derive.flight import option

    named = [("slowest", found["slowest"]), *(("failed", one) for one in found["failed"])]
    options = [word for key in REPLAYED if said[key] is not None
               for word in (option(key), _word(said[key]))]  # fmt: skip
    lines = []
    for kind, one in named:
        if one is None:
            continue
        rate = [] if one["rate"] is None else ["--rate", _word(one["rate"])]
        words = ["derive", "simulate", str(file), "--seed", str(one["seed"]), *rate, *options]
        lines.append(f"{kind:8} run {one['run']}: {shlex.join(words)}")
    return ["", *lines]


def _word(value: Any) -> str:
    if isinstance(value, tuple):
        return ",".join(map(_word, value))
    return f"{value:.0f}" if isinstance(value, float) and value.is_integer() else str(value)
