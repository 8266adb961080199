"""What every command shares: common options, reading vehicle files, giving text, progress."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from derive.pipeline import Written
    from derive.vehicle import Vehicle

FINDING, BAD_INPUT = 1, 2  # exit codes

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

json_option = click.option(
    "--json", "json_file", type=AnyPath, help="Write the report there; - for the screen."
)


def loaded(files: tuple[Path, ...]) -> list[Vehicle]:
    """The vehicles of those files; raises InputError."""
    from derive.vehicle import load

    return [load(file) for file in files]


def everything() -> tuple[Path, ...]:
    """Every vehicle file of the current folder; raises InputError when there is none."""
    from derive.vehicle import InputError

    files = tuple(sorted(Path("vehicles").glob("*.toml")))
    if not files:
        remedy = "name the vehicle files, or change to the folder that holds vehicles/"
        raise InputError("vehicles/*.toml", "", "at least one vehicle file", "none", remedy)
    return files


def cache(no_cache: bool) -> Path | None:
    """The folder of earlier derivations, unless the option says to do without."""
    from derive import pipeline

    return None if no_cache else pipeline.cache_folder()


def probe(path: Path | None, option: str) -> None:
    """Raise InputError now where `give` would later, after the work."""
    from derive import place

    if path is not None and path != Path("-"):
        place.probe(path, option)


def give(path: Path, text: str, option: str) -> None:
    """Write text where an option says; - is the screen. Raises InputError."""
    from derive import place

    if path == Path("-"):
        click.echo(text, nl=not text.endswith("\n"))
    else:
        place.save(path, text if text.endswith("\n") else f"{text}\n", option)


def progress() -> Callable[[str], None]:
    """Shows what is being done on one line of a terminal; silent elsewhere."""
    if not sys.stderr.isatty():
        return lambda doing: None

    def show(doing: str) -> None:
        click.echo(f"\r\x1b[K{doing}", err=True, nl=False)

    return show


def spelled(command: str, files: Sequence[str], out: Path) -> str:
    """The command line that does this to these vehicle files."""
    option = [] if out == GENERATED else ["--out", str(out)]
    return shlex.join(["derive", command, *files, *option])


def stale(vehicles: Sequence[Vehicle], out: Path) -> list[str]:
    """A line for every page of evidence that speaks of other code than is there, or was edited."""
    from derive import dossier

    found = []
    for vehicle in vehicles:
        page = dossier.page_of(out / vehicle.name)
        if fault := dossier.page_fault(out / vehicle.name):
            renewal = spelled("evidence", [vehicle.source], out)
            found.append(f"{fault.word} {page}: {fault.reason}; renew with: {renewal}")
    return found


def unproved(vehicles: Sequence[Vehicle], out: Path) -> str:
    """A line for all packages that have no page of evidence, if there are any."""
    from derive import dossier

    bare = [one for one in vehicles if dossier.is_bare(out / one.name)]
    if not bare:
        return ""
    names = ", ".join(str(dossier.page_of(out / one.name)) for one in bare)
    writing = spelled("evidence", [one.source for one in bare], out)
    return f"note: not written yet: {names}; write with: {writing}"


def warn(written: Sequence[Written]) -> None:
    """Tell what the vehicles' laws lead to, on stderr: each thing once, with all it is true of."""
    told: dict[str, list[str]] = {}
    for one in written:
        for caution in one.cautions:
            told.setdefault(caution, []).append(one.folder.name)
    for caution, names in told.items():
        click.echo(f"warning: {', '.join(names)}: {caution}", err=True)
