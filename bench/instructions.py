"""Instructions of one call, counted by callgrind, the least and the most over many states."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

from bench.figure import Figure
from bench.subject import MEASURED, Array, place, states, vehicle
from derive.native.compile import FLAGS, Compiler

_CALL = {
    "tracking": "tracking(&{p}_defaults, &states[i], &references[i], &command)",
    "reaching": "reaching(&{p}_defaults, &states[i], &command)",
    "control": "control(&{p}_defaults, &states[i], &references[i], &command)",
    "plant": "plant(&{p}_defaults, &states[i], force, nu_dot)",
}


def is_possible() -> bool:
    """Whether valgrind and gcc are here."""
    return bool(shutil.which("valgrind") and shutil.which("gcc"))


def _braced(*rows: Array) -> str:
    inner = ", ".join("{" + ", ".join(float(x).hex() for x in row) + "}" for row in rows)
    return f"{{{inner}}}"


def program(name: str, group: str, scalar: str) -> str:
    """C that calls every routine that is counted once per state."""
    prefix, kind = f"{name}_{scalar}", {"f32": "float", "f64": "double"}[scalar]
    rows = list(states(group))
    plants = ",\n".join(_braced(row["g"], row["nu"]) for row in rows)
    n = len(rows[0]["nu"])
    force = ", ".join(str(i + 1) for i in range(n))
    references = ",\n".join(_braced(row["g_r"], row["nu_r"], row["nu_r_dot"]) for row in rows)
    calls = "\n".join(f"        {prefix}_{_CALL[one].format(p=prefix)};" for one in MEASURED[name])
    return f"""#include "{prefix}.h"
static const {prefix}_state states[] = {{
{plants}
}};
static const {prefix}_reference references[] = {{
{references}
}};
int main(void)
{{
    {prefix}_command command;
    const {kind} force[{n}] = {{{force}}};
    {kind} nu_dot[{n}];
    int i;
    for (i = 0; i < {len(rows)}; i++) {{
{calls}
    }}
    return 0;
}}
"""


def count(program: Path, symbol: str) -> list[int]:
    """Instructions of each call of a function, with all it calls: one dump per call."""
    out = program.with_suffix(f".{symbol}")
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}"]
    command += [f"--toggle-collect={symbol}", f"--dump-after={symbol}", str(program)]
    subprocess.run(command, capture_output=True, check=True)
    dumps = sorted(out.parent.glob(f"{out.name}.*"))
    totals = (re.search(r"^totals: (\d+)", dump.read_text(), re.MULTILINE) for dump in dumps)
    return [int(total[1]) for total in totals if total]


def calls(name: str, scalar: str, routine: str, folder: Path) -> list[int]:
    """Instructions of every call of one routine: gcc -O2 -fno-math-errno -ffp-contract=off."""
    root, prefix = place(name, folder), f"{name}_{scalar}"
    source = folder / f"{prefix}.c"
    source.write_text(program(name, vehicle(name).group, scalar), encoding="utf-8")
    sources = [str(source), str(root / f"c/src/{prefix}.c")]
    flags = [*FLAGS, f"-I{root / 'c/include'}", *sources, "-lm"]
    built = Compiler.find(["gcc"]).run(flags, folder / f"{prefix}_calls")
    return count(built, f"{prefix}_{routine}")


def measure(folder: Path) -> list[Figure]:
    """Every routine, vehicle and scalar."""
    figures = []
    for name, routines in MEASURED.items():
        for scalar in ("f64", "f32"):
            for routine in routines:
                counts = calls(name, scalar, routine, folder)
                label = f"{name} {scalar} {routine}"
                figures.append(Figure(label, max(counts), "instructions", min(counts)))
    return figures
