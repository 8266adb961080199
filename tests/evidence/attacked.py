"""What the attacks are tested on: committed packages, and copies of them with a planted defect."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from derive.evidence.emitted import Emitted
from derive.evidence.tool import Tool, ToolMissing
from derive.vehicle import load
from derive.verify.plant import Plant
from tests.verify import subjects

ROOT = Path(__file__).parents[2]
NAMES = sorted(path.stem for path in (ROOT / "vehicles").glob("*.toml"))


def need(*tools: Tool) -> None:
    """Skip, on a laptop, what this machine has no tool for."""
    for tool in tools:
        if shutil.which(tool.command) is None:
            assert os.environ.get("CI") != "true", f"CI must have {tool.command}"
            pytest.skip(f"{tool.command} is not installed: {tool.install}")


@contextmanager
def needed() -> Iterator[None]:
    """The same of what turns out to be missing only when it is used."""
    try:
        yield
    except ToolMissing as missing:
        if os.environ.get("CI") == "true":
            raise
        pytest.skip(str(missing))


def package(name: str, scalar: str) -> Emitted:
    """As it is committed."""
    return Emitted(ROOT / "generated" / name, name, scalar)


def plant(name: str) -> Plant:
    return subjects.plant(load(ROOT / "vehicles" / f"{name}.toml"))


def copy(emitted: Emitted, folder: Path) -> Emitted:
    """One that a test may spoil."""
    shutil.copytree(emitted.folder, folder / emitted.name)
    return Emitted(folder / emitted.name, emitted.name, emitted.scalar)


DEFECTS = {
    "status": "if (state->nu[0] > 9) { status = 3; }",
    "infinite": "if (status == 0) { command->s[1] = command->s[1] / 0.0F; }",
    "nan": "if (status == 0) { command->s[1] = (float)NAN; }",
    "unwritten": "if (status == 17) { memset(&command->nu_u[1], 0xff, sizeof(float)); }",
    "command": "if (status == 16) { command->force[2] = 1; }",
    "unseen": "if (status == 18 && isnan(reference->nu_dot[2])) { status = 0; }",
    "limit": "if (status == 0) { command->force[0] = 2 * params->force_limit[0] + 1; }",
    "overrun": "if (status == 2) { command->s[0] = state->nu[3 + (int)(state->nu[0] > 0)]; }",
    "params": "if (params->k_s > 2) { command->force[0] = (float)INFINITY; }",
}
"""What goes wrong after an honest call of control, as C."""

_WRAPPER = """
#include <stdlib.h>
#include <string.h>
PREFIX_status PREFIX_control(const PREFIX_params *params,
        const PREFIX_state *state, const PREFIX_reference *reference, PREFIX_command *command)
{
    const char *const chosen = getenv("DEFECT");
    int status = (int)PREFIX_honest(params, state, reference, command);
    for (int i = 0; status < 16 && i < 3; i++) {
        const float limit = params->force_limit[i] > 0 ? params->force_limit[i] : 0;
        command->force[i] = fminf(fmaxf(command->force[i], -limit), limit);
    }
    CHOICES
    return (PREFIX_status)status;
}
PREFIX_status PREFIX_check_params(const PREFIX_params *params)
{
    for (int i = 0; i < 3; i++) {
        if (!(params->force_limit[i] > 0 && isfinite(params->force_limit[i]))) {
            return (PREFIX_status)19;
        }
    }
    return PREFIX_honest_params(params);
}
"""


def spoilt(emitted: Emitted, folder: Path) -> Emitted:
    """A copy whose control has the defect that the environment names; for a float on SO3.

    It has limits of the force, and keeps to them, whatever the package has.
    """
    made, prefix = copy(emitted, folder), emitted.prefix
    header = made.header.read_text(encoding="utf-8")
    text = made.source.read_text(encoding="utf-8")
    if "force_limit[" not in header:
        header = header.replace(
            f"}} {prefix}_params;", f"    float force_limit[3];\n}} {prefix}_params;"
        )
        text = re.sub(
            r"(_defaults = \{.*?)\n\};", r"\1, {1e30F, 1e30F, 1e30F}\n};", text, flags=re.S
        )
    for name, hidden in (("control", "honest"), ("check_params", "honest_params")):
        routine = f"{prefix}_{name}"
        prototype = re.search(rf"^{prefix}_status {routine}\([^;]*;", header, re.MULTILINE)
        assert prototype
        added = prototype[0].replace(routine, f"{prefix}_{hidden}")
        header = header.replace(prototype[0], f"{prototype[0]}\n{added}")
        text = text.replace(f"{routine}(", f"{prefix}_{hidden}(")
    made.header.write_text(header, encoding="utf-8")
    rows = (
        f'if (chosen && strcmp(chosen, "{name}") == 0) {{ {code} }}'
        for name, code in DEFECTS.items()
    )
    wrapper = _WRAPPER.replace("PREFIX", prefix).replace("CHOICES", "\n    ".join(rows))
    made.source.write_text(text + wrapper, encoding="utf-8")
    return made
