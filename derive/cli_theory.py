"""The commands on theory: the paper's statements proved, and kinematic laws judged."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

import click

from derive.terminal import FINDING, AnyPath, give, json_option, loaded, progress


class Report(Protocol):
    """What both commands have to tell."""

    @property
    def ok(self) -> bool:
        """Whether nothing was found."""

    def table(self) -> str:
        """For people."""

    def as_json(self) -> str:
        """For machines."""


@click.command()
@click.argument("file", metavar="[VEHICLE.toml]", required=False, type=AnyPath)
@json_option
def prove(file: Path | None, json_file: Path | None) -> int:
    """Prove the paper's statements for any group, and for the vehicle's group and inertia."""
    from derive import pipeline

    vehicle = loaded((file,))[0] if file else None
    show = progress()
    try:
        report = pipeline.prove(vehicle, show)
    finally:
        show("")
    return _told(report, json_file)


@click.command()
@click.argument("file", metavar="[VEHICLE.toml]", required=False, type=AnyPath)
@click.option("--group", metavar="NAME", help='Judge its laws: SE3, "SO3 x R3", ...')
@json_option
def laws(file: Path | None, group: str | None, json_file: Path | None) -> int:
    """Which kinematic laws meet the paper's Definition, where they fail, and what follows."""
    from derive import theory

    vehicle = loaded((file,))[0] if file else None
    theory.refuse_both(vehicle, group)
    show = progress()
    try:
        report = theory.laws(vehicle, group, show)
    finally:
        show("")
    return _told(report, json_file)


def _told(report: Report, json_file: Path | None) -> int:
    """Give the report; the exit code."""
    if json_file != Path("-"):
        click.echo(report.table())
    if json_file:
        give(json_file, report.as_json(), "--json")
    return 0 if report.ok else FINDING
