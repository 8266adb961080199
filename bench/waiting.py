"""How long a person waits for a command: the whole process, the best of five."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from time import perf_counter

from bench.figure import Figure
from bench.subject import ROOT

REPEATS = 5
SUBJECT = ROOT / "vehicles" / "paper_so3.toml"


def once(arguments: Sequence[str], home: Path) -> float:
    """Wall time of one `derive` command, s; its cache lies below home."""
    environment = {**os.environ, "HOME": str(home), "XDG_CACHE_HOME": str(home / ".cache")}
    command = [str(Path(sys.executable).with_name("derive")), *arguments]
    start = perf_counter()
    subprocess.run(command, env=environment, capture_output=True, check=True, cwd=ROOT)
    return perf_counter() - start


def _with_mass(factor: int, folder: Path) -> Path:
    """The vehicle file with another inertia of the same pattern."""
    text = SUBJECT.read_text(encoding="utf-8").replace("3.6046", f"3.{factor:04}")
    path = folder / f"{SUBJECT.stem}_{factor}" / SUBJECT.name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return path


def measure(folder: Path) -> list[Figure]:
    """Help, emit with nothing cached, and emit of a new inertia when its pattern is known."""
    known = folder / "known"
    once(["emit", str(SUBJECT), "--out", str(folder / "first")], known)
    cold, warm, asked = [], [], []
    for i in range(REPEATS):
        file, out = _with_mass(7000 + i, folder), str(folder / f"out{i}")
        cold.append(once(["emit", str(file), "--out", out], folder / f"home{i}"))
        warm.append(once(["emit", str(file), "--out", out + "_warm"], known))
        asked.append(once(["--help"], known))
    return [
        Figure("emit, nothing cached", min(cold), "s"),
        Figure("emit, cached", min(warm), "s"),
        Figure("help", min(asked), "s"),
    ]
