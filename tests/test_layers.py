"""Imports go one way: the layer table, held by reading every import, lazy and typing ones too."""

import ast
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "derive"
MODULES = {
    ".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts).removesuffix(".__init__"): path
    for path in sorted(PACKAGE.rglob("*.py"))
}
FILE_LINES, FUNCTION_LINES = 250, 60

LAYER = {
    "derive.cache": "derive.pipeline",
    "derive.folder": "derive.pipeline",
    "derive.bundle": "derive.pipeline",
    "derive.compiled": "derive.pipeline",
    "derive.explanation": "derive.pipeline",
    "derive.campaign": "derive.pipeline",
    "derive.course": "derive.pipeline",
    "derive.crew": "derive.pipeline",
    "derive.demand": "derive.pipeline",
    "derive.dossier": "derive.pipeline",
    "derive.flight": "derive.pipeline",
    "derive.comparison": "derive.pipeline",
    "derive.simulation": "derive.pipeline",
    "derive.sweep_folder": "derive.pipeline",
    "derive.selftest": "derive.pipeline",
    "derive.theory": "derive.pipeline",
    "derive.cli_evidence": "derive.cli",
    "derive.cli_loop": "derive.cli",
    "derive.cli_simulate": "derive.cli",
    "derive.cli_sweep": "derive.cli",
    "derive.cli_theory": "derive.cli",
    "derive.terminal": "derive.cli",
    "derive.place": "derive.pipeline",
}
"""Top-level modules that belong to the layer of another."""

OWN = {
    "derive": (
        *("derive.vehicle", "derive.lie", "derive.control", "derive.routine", "derive.bundle"),
    ),
    "derive.__main__": ("derive.cli",),
    "derive.lie": (),
    "derive.routine": (),
    "derive.control": ("derive.lie", "derive.routine"),
    "derive.emit": ("derive.routine", "derive.lie.kernel"),
    "derive.explain": ("derive.routine", "derive.emit", "derive.lie.kernel"),
    "derive.vehicle": ("derive.lie", "derive.control"),
    "derive.native": (),
    "derive.verify": (
        *("derive.lie", "derive.routine", "derive.control", "derive.emit", "derive.native"),
    ),
    "derive.simulate": (
        *("derive.lie", "derive.routine", "derive.control", "derive.emit", "derive.native"),
    ),
    "derive.evidence": (
        *("derive.lie.kernel", "derive.routine", "derive.emit", "derive.native"),
        "derive.verify",
    ),
    "derive.pipeline": (
        *("derive.lie", "derive.routine", "derive.control", "derive.emit", "derive.native"),
        *("derive.verify", "derive.explain", "derive.simulate", "derive.evidence"),
        "derive.vehicle",
    ),
    "derive.cli": (
        *("derive.pipeline", "derive.explanation", "derive.place", "derive.theory"),
        *("derive.campaign", "derive.comparison", "derive.crew", "derive.demand", "derive.flight"),
        *("derive.dossier", "derive.simulation", "derive.sweep_folder"),
        "derive.vehicle",
    ),
}
"""What of ours each layer may import besides itself. A layer that is not here is refused."""

ORACLES = "derive.verify.oracle"
"""What judges: its modules import nothing of ours but each other."""

THIRD_PARTY = {
    "derive.lie": ("sympy",),
    "derive.lie.kernel": ("sympy", "mpmath"),
    "derive.lie.minimax": ("mpmath",),
    "derive.lie.basis": (),
    "derive.routine": ("sympy",),
    "derive.control": ("sympy",),
    "derive.control.table": (),
    "derive.control.caution": (),
    "derive.bundle": ("numpy",),
    "derive.course": ("numpy",),
    "derive.flight": ("numpy",),
    "derive.emit": ("sympy",),
    "derive.emit.function": ("sympy", "numpy"),
    "derive.emit.render": ("sympy", "jinja2"),
    "derive.explain": ("sympy",),
    "derive.vehicle": ("numpy",),
    "derive.native": ("cffi", "numpy"),
    "derive.verify.combined": (),
    "derive.verify.sized": (),
    "derive.verify": ("mpmath", "numpy", "sympy"),
    "derive.verify.oracle.casadi_twin": ("casadi", "numpy"),
    "derive.verify.oracle.casadi_group": ("casadi", "numpy"),
    "derive.evidence": ("numpy",),
    "derive.evidence.truncation": ("flint",),
    "derive.simulate": ("numpy", "scipy"),
    "derive.simulate.picture": ("matplotlib", "numpy"),
    "derive.simulate.sphere": ("matplotlib", "numpy"),
    "derive.simulate.style": ("matplotlib",),
    "derive.simulate.cluster": ("distributed",),
    "derive.simulate.table": ("numpy", "pyarrow"),
    "derive.compiled": ("jinja2",),
    "derive.cli": ("click",),
}
"""What of others a module or layer may import; the longest name that fits decides."""


def layer_of(module: str) -> str:
    """The layer's name: the first two parts of the module's, or where LAYER puts it."""
    top = ".".join(module.split(".")[:2])
    return LAYER.get(top, top)


def within(name: str, places: tuple[str, ...]) -> bool:
    return any(name == place or name.startswith(place + ".") for place in places)


def is_dynamic(call: ast.Call) -> bool:
    """Whether a call is import_module(…) or __import__(…)."""
    return ast.unparse(call.func).split(".")[-1] in ("import_module", "__import__")


def imported(tree: ast.AST) -> Iterator[str]:
    """Every imported name in full, wherever in the file: `from a.b import c` is a.b.c."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            start = "." * node.level + (node.module or "")
            yield from (f"{start}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Call) and is_dynamic(node):
            yield from (str(one.value) for one in node.args[:1] if isinstance(one, ast.Constant))


def is_allowed(module: str, name: str) -> bool:
    """Whether `module` may import `name`."""
    top = name.partition(".")[0]
    if top in sys.stdlib_module_names or name == "derive.__version__":
        return True
    if top == "derive":
        if within(module, (ORACLES,)):
            return within(name, (ORACLES,))
        layer = layer_of(module)
        # The package itself is a layer of one file: all of ours lies below it.
        same = layer != "derive" and layer == layer_of(name)
        return same or within(name, OWN[layer])
    fits = [place for place in THIRD_PARTY if within(module, (place,))]
    place = max(fits, key=len, default=layer_of(module))
    return top in THIRD_PARTY.get(place, ())


def offences(module: str, source: str) -> list[str]:
    """What `source` imports against the table, and what in it is too long."""
    if layer_of(module) not in OWN:
        return [f"{module}: its layer is not in the table"]
    tree = ast.parse(source)
    found = [
        f"{module} imports {name}"
        for name in sorted(set(imported(tree)))
        if not is_allowed(module, name)
    ]
    if (length := len(source.splitlines())) > FILE_LINES:
        found.append(f"{module}: {length} lines, {FILE_LINES} at most")
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            length = (node.end_lineno or node.lineno) - node.lineno + 1
            if length > FUNCTION_LINES:
                found.append(f"{module}.{node.name}: {length} lines, {FUNCTION_LINES} at most")
    return found


@pytest.mark.parametrize("module", MODULES)
def test_module_keeps_to_its_layer(module: str) -> None:
    assert offences(module, MODULES[module].read_text(encoding="utf-8")) == []


def test_the_table_speaks_of_modules_that_exist() -> None:
    assert MODULES
    named = {*OWN, *THIRD_PARTY, *LAYER, ORACLES}
    assert sorted(named - set(MODULES)) == []


@pytest.mark.parametrize(
    ("module", "source", "reported"),
    [
        ("derive.lie.group", "import derive.control.sliding", "derive.control.sliding"),
        ("derive.lie.group", "from derive import control", "derive.control"),
        ("derive.lie.group", "from derive.routine.cost import count", "derive.routine.cost.count"),
        ("derive.lie.group", "from . import kernel", "..kernel"),
        ("derive.lie.group", "import numpy as np", "numpy"),
        ("derive.lie.group", "import mpmath", "mpmath"),
        ("derive.routine.cost", "def f():\n    import derive.lie.group", "derive.lie.group"),
        (
            "derive.routine.cost",
            "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from derive.lie import group",
            "derive.lie.group",
        ),
        ("derive.emit.printer", "from derive.lie import group", "derive.lie.group"),
        ("derive.emit.printer", "from derive.lie.kernel_x import K", "derive.lie.kernel_x.K"),
        ("derive.emit.printer", "import jinja2", "jinja2"),
        ("derive.control.table", "import sympy", "sympy"),
        ("derive.native.load", "import derive", "derive"),
        ("derive.verify.numeric", "import casadi", "casadi"),
        ("derive.verify.oracle.truth", "from derive.lie.kernel import K", "derive.lie.kernel.K"),
        ("derive.verify.check", "from derive.pipeline import run", "derive.pipeline.run"),
        ("derive.vehicle.check", "from derive.emit import render", "derive.emit.render"),
        ("derive.cli", "from importlib import import_module\nimport_module('sympy')", "sympy"),
        ("derive.cli", "from derive.emit.render import render", "derive.emit.render.render"),
        ("derive", "from derive.cli import main", "derive.cli.main"),
    ],
)
def test_a_forbidden_import_is_reported(module: str, source: str, reported: str) -> None:
    assert offences(module, source) == [f"{module} imports {reported}"]


@pytest.mark.parametrize(
    ("module", "source"),
    [
        ("derive.lie.group", "import sympy\nfrom derive.lie.kernel import K"),
        ("derive.lie.kernel", "import mpmath"),
        ("derive.emit.printer", "from derive.lie.kernel import K\nfrom derive.lie import kernel"),
        ("derive.vehicle", "from derive.vehicle.check import check\nfrom derive.lie import group"),
        ("derive.vehicle.check", "from derive.vehicle import InputError"),
        ("derive.pipeline", "from derive import __version__\nimport derive.emit.render"),
        (
            "derive.cli",
            "import click\nfrom derive.vehicle import InputError\nimport derive.vehicle.starter",
        ),
        (
            "derive.verify.oracle.casadi_twin",
            "import casadi\nfrom derive.verify.oracle.truth import LAWS",
        ),
    ],
)
def test_an_allowed_import_is_not_reported(module: str, source: str) -> None:
    assert offences(module, source) == []


def test_a_new_layer_must_be_put_in_the_table() -> None:
    assert offences("derive.helpers.many", "") == [
        "derive.helpers.many: its layer is not in the table"
    ]


def test_long_files_and_functions_are_reported() -> None:
    function = "def long():\n" + "    pass\n" * FUNCTION_LINES
    assert offences("derive.cli", function) == ["derive.cli.long: 61 lines, 60 at most"]
    assert offences("derive.cli", "\n" * 251) == ["derive.cli: 251 lines, 250 at most"]
