"""`python -m bench`: measure everything, print one table, exit 1 where a limit is exceeded."""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path

from bench import accuracy, instructions, loop, operations, size, throughput, waiting
from bench.figure import Figure

Measure = Callable[[Path], list[Figure]]

PARTS: dict[str, Measure] = {
    "accuracy": accuracy.measure,
    "instructions": instructions.measure,
    "loop": loop.measure,
    "operations": operations.measure,
    "size": size.measure,
    "throughput": throughput.measure,
    "waiting": waiting.measure,
}


def shown(figure: Figure) -> str:
    """One line of the table."""
    value = f"{figure.value:,.0f}" if figure.value >= 100 else f"{figure.value:.3g}"
    spread = "" if figure.least in (None, figure.value) else f" (least {figure.least:,.0f})"
    aside = f" ({figure.aside})" if figure.aside else ""
    line = f"{figure.name:42} {value:>10} {figure.unit + spread + aside:26}"
    if figure.limit is None:
        return line.rstrip()
    verdict = "ok" if figure.is_within else "EXCEEDED"
    return f"{line} at most {figure.limit.figure:g}: {verdict}"


def as_data(figure: Figure) -> dict[str, object]:
    """What a machine reads of a figure."""
    limit = figure.limit.figure if figure.limit else None
    said = asdict(replace(figure, bound=None))
    del said["bound"]
    return {**said, "limit": limit}


def main() -> int:
    """Measure the parts asked for; 0 when every limit is kept, 1 when not."""
    parser = argparse.ArgumentParser(prog="python -m bench", description=__doc__)
    parser.add_argument("parts", nargs="*", help=f"any of: {', '.join(PARTS)}; all when left out")
    parser.add_argument("--json", type=Path, metavar="F", help="also write the figures to F")
    given = parser.parse_args()
    if unknown := set(given.parts) - set(PARTS):
        parser.error(f"no such part: {', '.join(sorted(unknown))}; there are {', '.join(PARTS)}")
    figures: list[Figure] = []
    for name in given.parts or PARTS:
        if name == "instructions" and not instructions.is_possible():
            print("instructions: skipped, valgrind and gcc are needed", file=sys.stderr)
            continue
        with tempfile.TemporaryDirectory() as folder:
            part = PARTS[name](Path(folder))
        print("\n".join(map(shown, part)), flush=True)
        figures += part
    if given.json:
        given.json.write_text(json.dumps([as_data(f) for f in figures], indent=1) + "\n")
    return 0 if all(figure.is_within for figure in figures) else 1


if __name__ == "__main__":
    sys.exit(main())
