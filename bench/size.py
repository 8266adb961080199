"""Bytes of machine code at -Os, routine by routine; operations and temporaries as emitted."""

from __future__ import annotations

import subprocess
import tomllib
from pathlib import Path

from bench.figure import Figure
from bench.subject import MEASURED, place
from derive.native.compile import FLAGS, Compiler, build_object


def measure(folder: Path) -> list[Figure]:
    """Code bytes of every function, their sum, and what MANIFEST.toml says of each routine."""
    figures = []
    for name in MEASURED:
        root = place(name, folder)
        for scalar in ("f64", "f32"):
            figures += _bytes(root, f"{name}_{scalar}", folder)
        manifest = tomllib.loads((root / "MANIFEST.toml").read_text(encoding="utf-8"))
        for routine, cost in manifest["routines"].items():
            for unit in ("operations", "temporaries"):
                figures.append(Figure(f"{name} {routine}", cost[unit], unit))
    return figures


def _bytes(root: Path, prefix: str, folder: Path) -> list[Figure]:
    flags = [flag if flag != "-O2" else "-Os" for flag in FLAGS]
    source = root / f"c/src/{prefix}.c"
    item = build_object(source, root / "c/include", folder, flags, Compiler.find(["gcc", "cc"]))
    command = ["nm", "--print-size", "--defined-only", str(item)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    columns = (line.split() for line in done.stdout.splitlines())
    sizes = {column[3]: int(column[1], 16) for column in columns if column[2] in "Tt"}
    label = " ".join(prefix.rsplit("_", 1))
    total = Figure(f"{label}, all code", sum(sizes.values()), "bytes")
    short = ((symbol.removeprefix(f"{prefix}_"), size) for symbol, size in sizes.items())
    return [total, *(Figure(f"{label} {symbol}", size, "bytes") for symbol, size in short)]
