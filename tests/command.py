"""The command line as a whole process, in a folder and a home of its own."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
FILES = [str(path) for path in sorted((ROOT / "vehicles").glob("*.toml"))]
MESSAGE = ("expected: ", "found:    ", "to do:    ")


def derive(
    place: Path, *arguments: str, home: Path | None = None, flags: tuple[str, ...] = ()
) -> subprocess.CompletedProcess[str]:
    """One command line, run in that folder."""
    environment = {**os.environ, "HOME": str(home or place), "PYTHONPATH": str(ROOT)}
    command = [sys.executable, *flags, "-m", "derive", *arguments]
    return subprocess.run(
        command, check=False, capture_output=True, text=True, cwd=place, env=environment, timeout=60
    )


def refused(place: Path, *arguments: str, home: Path | None = None) -> str:
    """The message of a command line that must end with one, exit code 2, and nothing written."""
    before = tree(place)
    result = derive(place, *arguments, home=home or place)
    assert (result.returncode, result.stdout) == (2, "")
    assert "Traceback" not in result.stderr
    assert all(result.stderr.count(part) == 1 for part in MESSAGE), result.stderr
    assert {path: text for path, text in tree(place).items() if ".cache" not in path} == before
    return result.stderr


def tree(place: Path) -> dict[str, bytes]:
    return {str(path): path.read_bytes() for path in place.rglob("*") if path.is_file()}
