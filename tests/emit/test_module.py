"""The text of the emitted numpy module: clean, self-contained, nothing in it for nothing."""

from __future__ import annotations

import ast
import py_compile
import subprocess
import sys
from pathlib import Path

import pytest

from derive.vehicle import Vehicle
from tests.emit import subjects
from tests.emit.subjects import EACH, FILES, GUARDED


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("module")


@pytest.mark.parametrize("vehicle", GUARDED, ids=lambda v: v.name)
def test_the_module_is_clean_python(folder: Path, vehicle: Vehicle) -> None:
    path = subjects.place(vehicle, folder) / f"numpy/{vehicle.name}.py"
    py_compile.compile(str(path), cfile=str(folder / "compiled.pyc"), doraise=True)
    assert max(map(len, path.read_text(encoding="utf-8").splitlines())) <= 100


def test_ruff_finds_no_fault_in_any_module(folder: Path) -> None:
    paths = [subjects.place(v, folder) / f"numpy/{v.name}.py" for v in GUARDED]
    command = [sys.executable, "-m", "ruff", "check", "--isolated", "--select", "F,E9,E501"]
    command += ["--line-length", "100", *map(str, paths)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_the_module_needs_numpy_and_the_standard_library_only(folder: Path) -> None:
    path = subjects.place(FILES[0], folder) / f"numpy/{FILES[0].name}.py"
    code = f"""
import sys, runpy
runpy.run_path({str(path)!r})
third = {{name.partition('.')[0] for name in sys.modules}} - set(sys.stdlib_module_names)
print(sorted(name for name in third if not name.startswith('_')))
"""
    done = subprocess.run(
        [sys.executable, "-I", "-W", "error", "-c", code],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert "numpy" in done.stdout
    assert "derive" not in done.stdout
    assert "scipy" not in done.stdout


@pytest.mark.parametrize("vehicle", EACH, ids=lambda v: v.name)
def test_nothing_is_computed_or_unpacked_in_vain(vehicle: Vehicle) -> None:
    """What C compilers warn of, held for Python too: every local name is read."""
    tree = ast.parse(subjects.texts(vehicle)[f"numpy/{vehicle.name}.py"])
    for function in (node for node in tree.body if isinstance(node, ast.FunctionDef)):
        names = [node for node in ast.walk(function) if isinstance(node, ast.Name)]
        written = {node.id for node in names if isinstance(node.ctx, ast.Store)}
        read = {node.id for node in names if isinstance(node.ctx, ast.Load)}
        assert written <= read, function.name
