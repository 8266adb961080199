"""What the disk refuses, told: a place that an option names, and what is wrong with it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from derive import folder
from derive.vehicle import InputError

FILE = "a file that can be written to"


def save(path: Path, text: str, option: str) -> None:
    """Write one file that an option of the command line names, whole. Raises InputError."""
    with told(path, FILE, option):
        folder.save(path, text)


def probe(path: Path, option: str) -> None:
    """Raise InputError where `save` would, before the work is done."""
    with told(path, FILE, option):
        folder.probe(path)


def probe_folder(place: Path, option: str = "--out") -> None:
    """Raise InputError where a folder cannot be made or written into; leaves all as it is."""
    missing = [one for one in (place, *place.parents) if not one.exists()]
    with told(place, "a folder that can be written to", option):
        try:
            place.mkdir(parents=True, exist_ok=True)
            folder.probe(place / "probe")
        finally:
            for one in missing:
                with suppress(OSError):
                    one.rmdir()


def strangers(place: Path) -> list[str]:
    """What a vehicle's folder holds that derive did not write. Raises InputError."""
    with told(place, "a folder that derive wrote, or none"):
        return folder.strangers(place)


def refuse_strangers(place: Path) -> None:
    """Raise InputError when replacing a folder would lose a file that derive did not write."""
    foreign = strangers(place)
    if foreign:
        more = f" and {len(foreign) - 5} more" if len(foreign) > 5 else ""
        raise InputError(
            file=str(place),
            key="--out",
            expected=f"a folder whose every file its {folder.MANIFEST} knows",
            found=f"foreign files: {', '.join(foreign[:5])}{more}",
            remedy="move them away, or choose another folder with --out",
        )


@contextmanager
def told(place: Path, expected: str, option: str = "--out", remedy: str = "") -> Iterator[None]:
    """Turn what the system refuses into an InputError on the option that names the place."""
    try:
        yield
    except OSError as fault:
        at = str(fault.filename or "").partition(f"/{folder.PART[0]}")[0]  # no name of our own
        is_taken = isinstance(fault, FileExistsError | NotADirectoryError)
        reason = _obstacle(Path(at)) if is_taken else fault.strerror or str(fault)
        where = f": {at}" if at else ""
        remedy = remedy or f"choose another place with {option}, or mend what is there"
        raise InputError(str(place), option, expected, f"{reason}{where}", remedy) from fault


def _obstacle(path: Path) -> str:
    """What is in the way of a folder, at the path or above it."""
    taken = next((one for one in (path, *path.parents) if one.is_symlink() or one.is_file()), path)
    if taken.is_symlink():
        return "a link where a folder has to be" if taken.exists() else "a link that leads nowhere"
    return "a file where a folder has to be"
