"""The commands as a person meets them: whole processes, their messages and exit codes."""

import os
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from derive import cli, pipeline
from derive.vehicle import load
from tests.command import FILES, ROOT, derive, refused

HEAVY = ("sympy", "casadi", "numpy", "mpmath", "scipy")


def test_help_and_version_import_nothing_heavy(tmp_path: Path) -> None:
    for option, said in (("--help", "verify"), ("-h", "emit"), ("--version", "derive ")):
        result = derive(tmp_path, option, flags=("-X", "importtime"))
        assert (result.returncode, said in result.stdout) == (0, True)
        assert not [name for name in (*HEAVY, "jinja2") if f" {name}\n" in result.stderr]


@pytest.mark.parametrize("command", cli.commands.commands)
def test_every_command_explains_itself(tmp_path: Path, command: str) -> None:
    result = derive(tmp_path, command, "--help")
    assert (result.returncode, result.stderr) == (0, "")
    assert "Usage: derive " in result.stdout


@pytest.mark.parametrize("arguments", [["emit"], ["verify"], ["nonsense"], ["emit", "--what"]])
def test_a_wrong_command_line_is_exit_2(tmp_path: Path, arguments: list[str]) -> None:
    result = derive(tmp_path, *arguments)
    assert (result.returncode, result.stdout) == (2, "")
    assert "Usage: derive" in result.stderr


def test_init_writes_a_file_that_emits_and_checks(tmp_path: Path) -> None:
    assert derive(tmp_path, "init", "mine", "--group", "S3", "--law", "mrp").returncode == 0
    vehicle = load(tmp_path / "mine.toml")
    assert (vehicle.name, vehicle.group, vehicle.law) == ("mine", "S3", "mrp")
    emitted = derive(tmp_path, "emit", "mine.toml")
    assert emitted.stdout == "wrote generated/mine (11 files)\n"
    assert emitted.stderr.startswith("warning: mine: law mrp on S3 has no bound towards -i")
    again = derive(tmp_path, "emit", "mine.toml")
    assert again.stdout == "unchanged generated/mine (11 files)\n"
    checked = derive(tmp_path, "check", "mine.toml")
    assert (checked.returncode, checked.stdout) == (0, "same generated/mine\n")


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["body"], "never overwritten"),
        (["two words"], "C identifier"),
        (["../up"], "C identifier"),
        (["fresh", "--group", "SO4"], '"SO3"'),
        (["fresh", "--law", "half_log"], "exists only on S3"),
        (["fresh", "--group", "S3", "--law", "lg"], '"log"'),
    ],
)
def test_init_refuses(body: Path, arguments: list[str], told: str) -> None:
    assert told in refused(body.parent, "init", *arguments)


def test_init_does_not_write_through_a_link(tmp_path: Path) -> None:
    (tmp_path / "body.toml").symlink_to("elsewhere.toml")
    refused(tmp_path, "init", "body")


def test_a_known_pattern_is_emitted_without_heavy_imports(home: Path, tmp_path: Path) -> None:
    text = (ROOT / "vehicles" / "paper_so3.toml").read_text().replace("9.3484", "9.5")
    (tmp_path / "new.toml").write_text(text)
    result = derive(tmp_path, "emit", "new.toml", home=home, flags=("-X", "importtime"))
    assert (result.returncode, result.stdout) == (0, "wrote generated/paper_so3 (11 files)\n")
    assert "9.5F" in "".join(path.read_text() for path in tmp_path.rglob("*_f32.c")).upper()
    assert "derive.pipeline\n" in result.stderr
    assert not [name for name in HEAVY if f" {name}\n" in result.stderr]


@pytest.mark.parametrize("command", ["emit", "check", "verify"])
@pytest.mark.parametrize(
    ("damage", "told"),
    [
        (("body.toml", "absent.toml"), "no such file"),
        (("lambda", "lamda"), "lambda"),
        (("SO3", "SO4"), "group"),
        (('"log"', '"half_log"'), "exists only on S3"),
        (("0.0067", "0.6067"), "principal moments"),
    ],
    ids=lambda value: value[-1] if isinstance(value, tuple) else "",
)
def test_a_bad_vehicle_is_told_by_every_command(
    body: Path, command: str, damage: tuple[str, str], told: str
) -> None:
    text = body.read_text().replace(f'group = "{damage[0]}', f'group = "{damage[1]}')
    body.write_text(text.replace(*damage))
    name = body.name.replace(*damage)
    message = refused(body.parent, command, name)
    assert message.startswith(name)
    assert told in message


def test_one_bad_vehicle_stops_all(body: Path, home: Path) -> None:
    assert "absent" in refused(body.parent, "emit", *FILES, "absent.toml", home=home)
    assert "name" in refused(body.parent, "emit", *FILES, FILES[0], home=home)
    assert "name" in refused(body.parent, "check", *FILES, FILES[0], home=home)


def test_a_place_that_cannot_be_written_to_is_told(body: Path, home: Path) -> None:
    place = body.parent
    (place / "file").write_text("mine")
    (place / "taken").mkdir()
    (place / "taken" / "body").write_text("mine")
    for out in ("file", "file/below", "taken", "/proc/derive", "x" * 300):
        assert "--out" in refused(place, "emit", body.name, "--out", out, home=home)


def test_a_folder_with_foreign_files_is_left_alone(body: Path, home: Path) -> None:
    place = body.parent
    derive(place, "emit", body.name, home=home)
    (place / "generated" / "body" / "notes.txt").write_text("mine")
    body.write_text(body.read_text().replace("0.0067", "0.0068"))
    assert "notes.txt" in refused(place, "emit", body.name, home=home)
    (place / "generated" / "body" / "notes.txt").unlink()
    assert derive(place, "emit", body.name, home=home).stdout.startswith("wrote")
    (place / "generated" / "body" / "MANIFEST.toml").unlink()
    assert "and 5 more" in refused(place, "emit", body.name, home=home)


def test_a_missing_parent_of_out_is_made(body: Path, home: Path) -> None:
    result = derive(body.parent, "emit", body.name, "--out", "a/b", home=home)
    assert result.stdout == "wrote a/b/body (11 files)\n"
    assert [path.name for path in (body.parent / "a" / "b").iterdir()] == ["body"]


@pytest.mark.parametrize("ok", [True, False])
def test_verify_gives_table_report_and_exit_code(
    body: Path, ok: bool, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    report = SimpleNamespace(
        ok=ok, skipped=(), table=lambda: "the table", as_json=lambda: '{"ok": 1}'
    )
    monkeypatch.setattr(pipeline, "verify", lambda *given, **options: report)
    place = body.parent / "report.json"
    assert cli.run(["verify", str(body)]) == (0 if ok else 1)
    assert capsys.readouterr() == ("the table\n", "")
    assert cli.run(["verify", str(body), "--json", "-"]) == (0 if ok else 1)
    assert capsys.readouterr() == ('{"ok": 1}\n', "")
    assert cli.run(["verify", str(body), "--json", str(place)]) == (0 if ok else 1)
    assert capsys.readouterr().out == "the table\n"
    assert place.read_text() == '{"ok": 1}\n'
    assert cli.run(["verify", str(body), "--json", str(body.parent)]) == 2
    assert "--json" in capsys.readouterr().err
    assert sorted(path.name for path in body.parent.iterdir()) == ["body.toml", "report.json"]


def test_an_interrupt_is_exit_130_without_a_traceback(body: Path) -> None:
    script = (
        "import os, time; from derive import cli, pipeline\n"
        "def long_work(*given):\n"
        f"    os.kill(os.getpid(), {int(signal.SIGINT)})\n"
        "    time.sleep(60)\n"
        "pipeline.emit = long_work\n"
        "cli.main()"
    )
    command = [sys.executable, "-c", script, "emit", str(body)]
    result = subprocess.run(command, check=False, capture_output=True, text=True, cwd=ROOT)
    assert (result.returncode, result.stdout, result.stderr) == (130, "", "interrupted\n")


def test_a_reader_that_went_away_is_harmless(body: Path, home: Path) -> None:
    read, write = os.pipe()
    os.close(read)
    environment = {**os.environ, "HOME": str(home), "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-m", "derive", "check", str(body)]
    result = subprocess.run(
        command, check=False, stdout=write, stderr=subprocess.PIPE, env=environment, cwd=body.parent
    )
    os.close(write)
    assert (result.returncode, result.stderr) == (141, b"")


def test_a_poor_locale_ends_no_command(body: Path, home: Path) -> None:
    place = body.parent / "Ω"
    place.mkdir()
    body.rename(place / body.name)
    environment = {**os.environ, "HOME": str(home), "PYTHONPATH": str(ROOT)}
    environment |= {"PYTHONIOENCODING": "latin-1"}
    command = [sys.executable, "-m", "derive", "emit", "Ω/body.toml", "--out", "Ω/out"]
    result = subprocess.run(
        command, check=False, capture_output=True, text=True, env=environment, cwd=body.parent
    )
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout == "wrote \\u03a9/out/body (11 files)\n"
