"""How a command ends before it is done: by a key, by a signal, or for want of a compiler."""

import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from derive import cli, pipeline
from tests.command import ROOT, derive

ENDINGS = (signal.SIGINT, signal.SIGTERM)
either_signal = pytest.mark.parametrize("number", ENDINGS, ids=lambda one: signal.Signals(one).name)


def run_as(script: str, place: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """`derive` after some lines of Python, with temporary files in a folder of its own."""
    (place / "tmp").mkdir()
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "HOME": str(place)}
    environment |= {"TMPDIR": str(place / "tmp")}
    code = f"{script}\nfrom derive.__main__ import main\nmain()"
    command = [sys.executable, "-c", code, *arguments]
    return subprocess.run(
        command, check=False, capture_output=True, text=True, cwd=place, env=environment, timeout=60
    )


@either_signal
def test_a_signal_in_the_midst_of_a_run_leaves_nothing(body: Path, number: int) -> None:
    script = f"""
import os, subprocess, time
from pathlib import Path
from derive.native import compile
def endless(compiler, arguments, output):
    assert [path.name[:7] for path in Path(os.environ["TMPDIR"]).iterdir()] == ["derive-"]
    os.kill(os.getpid(), {int(number)})
    time.sleep(50)
compile.Compiler.run = endless
"""
    result = run_as(script, body.parent, "verify", body.name)
    assert (result.returncode, result.stdout, result.stderr) == (130, "", "interrupted\n")
    assert list((body.parent / "tmp").iterdir()) == []


@either_signal
@pytest.mark.parametrize("module", ["click", "derive.cli", "derive.vehicle.text"])
def test_a_signal_during_the_first_imports_is_quiet(
    tmp_path: Path, module: str, number: int
) -> None:
    script = f"""
import os, sys, time
class Slow:
    def find_spec(self, name, *rest):
        if name == {module!r}:
            os.kill(os.getpid(), {int(number)})
            time.sleep(50)
sys.meta_path.insert(0, Slow())
"""
    result = run_as(script, tmp_path, "check")
    assert (result.returncode, result.stdout, result.stderr) == (130, "", "interrupted\n")


def test_the_installed_command_is_the_one_that_takes_signals() -> None:
    assert 'derive = "derive.__main__:main"' in (ROOT / "pyproject.toml").read_text()


@pytest.mark.parametrize("ok", [True, False])
def test_what_was_not_checked_is_no_success(
    body: Path, ok: bool, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    report = SimpleNamespace(ok=ok, table=lambda: "the table", skipped=("C f64: no compiler",))
    monkeypatch.setattr(pipeline, "verify", lambda *given, **options: report)
    assert cli.run(["verify", str(body)]) == 1
    assert "--allow-missing" in capsys.readouterr().err
    assert cli.run(["verify", str(body), "--allow-missing"]) == (0 if ok else 1)
    assert capsys.readouterr().err == ""


def test_without_a_compiler_it_is_said_what_was_not_checked(
    body: Path, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(body.parent))
    assert shutil.which("cc") is None
    asked = ("verify", body.name, "--samples", "1")
    strict = derive(body.parent, *asked, home=home)
    assert strict.returncode == 1
    told = [line for line in strict.stdout.splitlines() if line.startswith("not checked: ")]
    assert [line.partition(";")[0] for line in told] == [
        "not checked: C f64 and f32: no C compiler found: looked on PATH for cc, gcc, clang"
    ]
    assert "install one: `apt install gcc`" in told[0]
    assert strict.stderr == "not everything was checked; --allow-missing accepts that\n"
    relaxed = derive(body.parent, *asked, "--allow-missing", home=home)
    assert (relaxed.returncode, relaxed.stderr) == (0, "")
    assert relaxed.stdout == strict.stdout
