"""The commands: what a person types, and the exit code they get. No maths.

Exit 0 when all is well, 1 for a finding (drift, a failed check), 2 for an input that cannot be
used, 130 for Ctrl-C. Whatever a command needs is imported inside it, so that help is instant.
"""

from __future__ import annotations

import io
import os
import shlex
import sys
from pathlib import Path

import click

from derive import __version__
from derive.cli_evidence import evidence, verify
from derive.cli_simulate import simulate
from derive.cli_sweep import sweep
from derive.cli_theory import laws, prove
from derive.terminal import (
    BAD_INPUT,
    FINDING,
    AnyPath,
    cache,
    cache_option,
    everything,
    give,
    loaded,
    out_option,
    probe,
    spelled,
    stale,
    unproved,
    warn,
)

INTERRUPTED, NO_READER = 130, 141


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
    from derive.vehicle.starter import write

    path = write(name, group, law)
    click.echo(f"wrote {path}; next: derive emit {path}")


@commands.command()
@click.argument("files", metavar="VEHICLE.toml...", nargs=-1, required=True, type=AnyPath)
@out_option
@cache_option
def emit(files: tuple[Path, ...], out: Path, no_cache: bool) -> None:
    """Derive, and write a package of C and numpy per vehicle.

    A page of evidence that lies there is kept, and told when it speaks of other code.
    """
    from derive import pipeline

    vehicles = loaded(files)
    written = pipeline.emit(vehicles, out, cache(no_cache))
    for one in written:
        click.echo(f"{'wrote' if one.is_changed else 'unchanged'} {one.folder} ({one.files} files)")
    warn(written)
    for line in stale(vehicles, out):
        click.echo(line, err=True)


@commands.command()
@click.argument("files", metavar="[VEHICLE.toml...]", nargs=-1, type=AnyPath)
@out_option
@cache_option
def check(files: tuple[Path, ...], out: Path, no_cache: bool) -> int:
    """Compare what is generated with what the vehicle files give, byte for byte.

    A page of evidence has to speak of the code that it lies beside, and be as it was written. Where
    there is none, that is told, and is no finding.
    Without arguments: every vehicles/*.toml of the current folder.
    """
    from derive import pipeline
    from derive.place import strangers

    vehicles = loaded(files or everything())
    drifted, foreign = [], []
    for vehicle, drifts in pipeline.check(vehicles, out, cache(no_cache)):
        place = out / vehicle.name
        for drift in drifts:
            line = f":{drift.line}" if drift.line else ""
            click.echo(f"{place / drift.path}{line}")
            click.echo(f"  expected: {drift.expected}\n  found:    {drift.found}")
        if drifts:
            drifted.append(vehicle.source)
            foreign += [str(place / path) for path in strangers(place)]
        else:
            click.echo(f"same {place}")
    if foreign:
        click.echo(f"move away first, derive did not write it: {shlex.join(foreign)}")
    if drifted:
        click.echo(f"update with: {spelled('emit', drifted, out)}")
    old = stale(vehicles, out)
    for line in old:
        click.echo(line)
    if note := unproved([one for one in vehicles if one.source not in drifted], out):
        click.echo(note, err=True)
    return FINDING if drifted or old else 0


@commands.command()
@click.argument("file", metavar="VEHICLE.toml", type=AnyPath)
@click.option("--equation", metavar="LABEL", help="Only the steps of this equation of the paper.")
@click.option("--routine", metavar="NAME", help="Only this one: tracking, reaching or plant.")
@click.option(
    "--format",
    "form",
    type=click.Choice(["text", "latex", "html"]),
    help="Where it is left out, by the ending of FILE: .tex, .html, or text.",
)
@click.option("--out", type=AnyPath, metavar="FILE", help="Write it there; the screen if left out.")
@cache_option
def explain(
    file: Path,
    equation: str | None,
    routine: str | None,
    form: str | None,
    out: Path | None,
    no_cache: bool,
) -> None:
    """The derivation step by step: equation, formula, unit, and the lines of C it became."""
    from derive import explanation

    (vehicle,) = loaded((file,))
    probe(out, "--out")
    place = out or Path("-")
    form = form or {".tex": "latex", ".html": "html"}.get(place.suffix, "text")
    text = explanation.explain(vehicle, cache(no_cache), form, routine=routine, equation=equation)
    give(place, text, "--out")


commands.add_command(verify)
commands.add_command(evidence)
commands.add_command(prove)
commands.add_command(laws)
commands.add_command(sweep)
commands.add_command(simulate)


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
