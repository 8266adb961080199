"""The commands: what a person types, and the exit code they get. No maths.

Exit 0 when all is well, 1 for a finding (drift, a failed check), 2 for an input that cannot be
used, 130 for Ctrl-C. Whatever a command needs is imported inside it, so that help is instant.
"""

from __future__ import annotations

import io
import os
import shlex
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from derive import __version__

if TYPE_CHECKING:
    from derive.vehicle import Vehicle

FINDING, BAD_INPUT, INTERRUPTED, NO_READER = 1, 2, 130, 141
GENERATED = Path("generated")

AnyPath = click.Path(path_type=Path)
out_option = click.option(
    "--out",
    type=AnyPath,
    default=GENERATED,
    show_default=True,
    help="Folder that holds one folder per vehicle.",
)
cache_option = click.option(
    "--no-cache", is_flag=True, help="Derive anew, whatever earlier calls have kept."
)


@click.group(no_args_is_help=True, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="derive", message="%(prog)s %(version)s")
def commands() -> None:
    """Geometric sliding-mode controllers, from a vehicle file to verified C99 and numpy."""


@commands.command()
@click.argument("name")
@click.option("--group", default="SO3", show_default=True, help="Where the vehicle moves.")
@click.option("--law", help="Kinematic law; the group's usual one when left out.")
def init(name: str, group: str, law: str | None) -> None:
    """Write a commented vehicle file, ./NAME.toml; never overwrites."""
    from derive.starter import write

    path = write(name, group, law)
    click.echo(f"wrote {path}; next: derive emit {path}")


@commands.command()
@click.argument("files", metavar="VEHICLE.toml...", nargs=-1, required=True, type=AnyPath)
@out_option
@cache_option
def emit(files: tuple[Path, ...], out: Path, no_cache: bool) -> None:
    """Derive, and write a package of C and numpy per vehicle."""
    from derive import pipeline

    for one in pipeline.emit(_loaded(files), out, _cache(no_cache)):
        click.echo(f"{'wrote' if one.is_changed else 'unchanged'} {one.folder} ({one.files} files)")


@commands.command()
@click.argument("files", metavar="[VEHICLE.toml...]", nargs=-1, type=AnyPath)
@out_option
@cache_option
def check(files: tuple[Path, ...], out: Path, no_cache: bool) -> int:
    """Compare what is generated with what the vehicle files give, byte for byte.

    Without arguments: every vehicles/*.toml of the current folder.
    """
    from derive import pipeline

    drifted = []
    for vehicle, drifts in pipeline.check(_loaded(files or _all()), out, _cache(no_cache)):
        place = out / vehicle.name
        for drift in drifts:
            line = f":{drift.line}" if drift.line else ""
            click.echo(f"{place / drift.path}{line}")
            click.echo(f"  expected: {drift.expected}\n  found:    {drift.found}")
        if drifts:
            drifted.append(vehicle.source)
        else:
            click.echo(f"same {place}")
    if drifted:
        option = [] if out == GENERATED else ["--out", str(out)]
        click.echo(f"update with: {shlex.join(['derive', 'emit', *drifted, *option])}")
    return FINDING if drifted else 0


@commands.command()
@click.argument("file", metavar="VEHICLE.toml", type=AnyPath)
@click.option("--json", "json_file", type=AnyPath, help="Write the report there; - for the screen.")
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
@cache_option
def verify(
    file: Path, json_file: Path | None, samples: int, seed: int, mutants: bool, no_cache: bool
) -> int:
    """Check every derivative and property against independent truth; worst figure, limit."""
    from derive import pipeline

    (vehicle,) = _loaded((file,))
    show = _progress()
    try:
        report = pipeline.verify(
            vehicle, _cache(no_cache), show, each=samples, seed=seed, with_mutants=mutants
        )
    finally:
        show("")
    if json_file != Path("-"):
        click.echo(report.table())
    if json_file:
        _give(json_file, report.as_json())
    return 0 if report.ok else FINDING


def main() -> None:
    """Run the command line; always ends in SystemExit."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # a poor locale must not end a command
    sys.exit(run(sys.argv[1:]))


def run(arguments: list[str]) -> int:
    """Exit code of one command line; messages have gone to stderr."""
    from derive.vehicle import InputError

    try:
        with commands.make_context("derive", arguments) as context:
            code = commands.invoke(context) or 0
        sys.stdout.flush()
    except click.exceptions.Exit as end:
        return end.exit_code
    except click.ClickException as fault:
        fault.show()
        return fault.exit_code
    except InputError as fault:
        click.echo(fault, err=True)
        return BAD_INPUT
    except (KeyboardInterrupt, click.Abort):
        click.echo("interrupted", err=True)
        return INTERRUPTED
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return NO_READER
    return int(code)


def _loaded(files: tuple[Path, ...]) -> list[Vehicle]:
    from derive.vehicle import load

    return [load(file) for file in files]


def _all() -> tuple[Path, ...]:
    """Every vehicle file of the current folder; raises InputError when there is none."""
    from derive.vehicle import InputError

    files = tuple(sorted(Path("vehicles").glob("*.toml")))
    if not files:
        remedy = "name the vehicle files, or change to the folder that holds vehicles/"
        raise InputError("vehicles/*.toml", "", "at least one vehicle file", "none", remedy)
    return files


def _cache(no_cache: bool) -> Path | None:
    from derive import pipeline

    return None if no_cache else pipeline.cache_folder()


def _give(path: Path, text: str) -> None:
    from derive import pipeline

    if path == Path("-"):
        click.echo(text)
    else:
        pipeline.save(path, text if text.endswith("\n") else f"{text}\n", "--json")


def _progress() -> Callable[[str], None]:
    """Shows what is being done on one line of a terminal; silent elsewhere."""
    if not sys.stderr.isatty():
        return lambda doing: None

    def show(doing: str) -> None:
        click.echo(f"\r\x1b[K{doing}", err=True, nl=False)

    return show
