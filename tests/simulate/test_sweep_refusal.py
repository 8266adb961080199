"""What `derive sweep` cannot use: one message that says what, where, and what to do; exit 2."""

from __future__ import annotations

import os
import time
from dataclasses import replace
from errno import ENOSPC
from pathlib import Path
from tempfile import gettempdir
from typing import Any

import pytest

from derive import campaign, cli, sweep_folder
from derive.native.compile import CompileError
from derive.simulate import craft, pilot
from derive.vehicle import InputError, load
from tests.command import MESSAGE, ROOT
from tests.simulate import crafts

VEHICLE = str(ROOT / "vehicles" / "paper_so3.toml")
FLY = ("--runs", "2", "--duration", "0.1", "--rate", "100", "--backend", "numpy", "--workers", "1")

WRONG = [
    (("--runs", "0"), "--runs", "from 1 to 1000000"),
    (("--runs", "1e3"), "--runs", "a whole number"),
    (("--runs", "-5"), "--runs", "-5"),
    (("--duration", "0"), "--duration", "0"),
    (("--duration", "nan"), "--duration", "nan"),
    (("--duration", "long"), "--duration", "long"),
    (("--rate", "inf"), "--rate", "inf"),
    (("--rate", "-1"), "--rate", "-1"),
    (("--rate", "0.5"), "--rate", "at least one period"),
    (("--wave", "0.1"), "--wave", "a frequency"),
    (("--hertz", "0", "--wave", "0.1"), "--hertz", "a frequency"),
    (("--step", "1e-6", "--rate", "0.1", "--duration", "90"), "--duration", "1000000 steps"),
    (("--noise-g", "-0.1"), "--noise-g", "-0.1"),
    (("--noise-g", "nan"), "--noise-g", "nan"),
    (("--noise-nu", "x"), "--noise-nu", "x"),
    (("--seed", "-1"), "--seed", "a whole number"),
    (("--seed", "9" * 30), "--seed", "9" * 30),
    (("--seed", "0.5"), "--seed", "0.5"),
    (("--chunk", "0"), "--chunk", "0"),
    (("--workers", "0"), "--workers", "0"),
    (("--workers", "many"), "--workers", "many"),
    (("--hertz", "3"), "--hertz", "a wave of that frequency"),
    (("--settle", "0"), "--settle", "above 0"),
    (("--box", "-1"), "--box", "-1"),
    (("--speed", "nan"), "--speed", "nan"),
    (("--inertia-error", "1"), "--inertia-error", "less than 1"),
    (("--disturbance", "1,2"), "--disturbance", "2 numbers"),
    (("--force-limit", "0"), "--force-limit", "above 0"),
    (("--backend", "f16"), "--backend", "f16"),
    (("--format", "xlsx"), "--format", "xlsx"),
    (("--resume",), "--resume", "no such file"),
    (("--cluster", "tcp://127.0.0.1:9"), "--cluster", "tcp://127.0.0.1:9"),
    (("--cluster", "nowhere"), "--cluster", "nowhere"),
    (("--cluster", "carrier://pigeon"), "--cluster", "carrier"),
    (("--cluster", "http://foo:bar"), "--cluster", "not tcp://HOST:PORT"),
    (("--cluster", "tcp://:8786"), "--cluster", "names no host"),
    (("--cluster", ""), "--cluster", "''"),
]


def refused(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    """The message of a command line that must end with one."""
    start = time.monotonic()
    code = cli.run(["sweep", VEHICLE, "--no-cache", *FLY, *arguments])
    said = capsys.readouterr()
    assert (code, said.out) == (2, "")
    assert all(said.err.count(part) == 1 for part in MESSAGE), said.err
    assert time.monotonic() - start < 20
    return said.err


@pytest.mark.parametrize(("given", "key", "found"), WRONG, ids=lambda one: str(one)[:40])
def test_it_is_told(
    given: tuple[str, ...], key: str, found: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    said = refused(capsys, "--out", str(tmp_path / "out"), *given)
    assert said.splitlines()[0].endswith(f": {key}")
    assert said.startswith("command line: ") or key == "--resume"
    assert found in said
    assert not list(tmp_path.iterdir())


FILED = [
    ("inertia_error = 1.5", "simulate.inertia_error"),
    ("rate = 0.5\nduration = 1", "simulate.rate"),
    ("noise_g = 0.01", "simulate.rate"),
    ("wave = [1, 1, 1]", "simulate.hertz"),
]


@pytest.mark.parametrize(("written", "key"), FILED)
def test_what_a_file_says_is_told_of_the_file(written: str, key: str, tmp_path: Path) -> None:
    file = tmp_path / "body.toml"
    file.write_text(f"{Path(VEHICLE).read_text()}\n[simulate]\n{written}\n")
    with pytest.raises(InputError) as caught:
        campaign.plan(load(file), None, replace(crafts.asked(rates=()), given={}))
    assert str(caught.value).splitlines()[0] == f"{file}: {key}"


def test_a_full_temporary_folder_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = Path.write_text

    def full(path: Path, *given: Any, **more: Any) -> int:
        if "derive-" in str(path):
            raise OSError(ENOSPC, os.strerror(ENOSPC), str(path))
        return plain(path, *given, **more)

    craft.folder_of.cache_clear()
    pilot._module.cache_clear()
    monkeypatch.setattr(Path, "write_text", full)
    said = refused(capsys, "--out", str(tmp_path / "out"), "--seed", "9")
    assert f"No space left on device: {gettempdir()}" in said
    assert "TMPDIR" in said
    assert "0 of 1 chunks are kept" in said
    line = ["simulate", VEHICLE, "--no-cache", "--duration", "0.1", "--backend", "numpy"]
    assert cli.run([*line, "--out", str(tmp_path / "one")]) == 2
    assert capsys.readouterr().err.startswith("TMPDIR")


def test_a_compiler_that_finds_no_room_is_no_broken_compiler() -> None:
    one = crafts.craft("SO3")
    for told, kind in ((f"x.o: {os.strerror(ENOSPC)}", craft.NoRoom), ("x.c:1", CompileError)):
        with pytest.raises(kind), craft.unpacked(one):
            raise CompileError(["cc"], told)


def test_a_folder_that_holds_something_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "mine").write_text("mine")
    assert "other files" in refused(capsys, "--out", str(tmp_path))
    (tmp_path / "sweep.json").write_text("{}")
    assert "--resume" in refused(capsys, "--out", str(tmp_path))
    assert (tmp_path / "mine").read_text() == "mine"


def test_a_file_in_the_place_of_the_folder_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "out").write_text("mine")
    refused(capsys, "--out", str(tmp_path / "out"))
    refused(capsys, "--out", str(tmp_path / "out" / "below"))


def test_a_definition_that_cannot_be_read_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "sweep.json").write_text("[")
    assert "not readable" in refused(capsys, "--out", str(tmp_path), "--resume")


def test_without_a_compiler_numpy_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    said = refused(capsys, "--out", str(tmp_path / "out"), "--backend", "f64")
    assert "--backend numpy" in said


def test_a_whole_sweep_is_not_flown_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    line = ["sweep", VEHICLE, "--no-cache", *FLY, "--format", "csv", "--out", str(tmp_path / "out")]
    assert cli.run(line) == 0
    before = stamps(tmp_path / "out")
    assert cli.run([*line, "--resume"]) == 0
    assert "whole already" in capsys.readouterr().out
    without = [word for word in line if word not in ("--format", "csv")]
    assert cli.run([*without, "--resume"]) == 0
    assert "results.csv is whole already" in capsys.readouterr().out
    assert stamps(tmp_path / "out") == before


def test_a_whole_sweep_is_written_in_another_format(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    line = ["sweep", VEHICLE, "--no-cache", *FLY, "--out"]
    for out, form in (("first", "csv"), ("second", "parquet")):
        assert cli.run([*line, str(tmp_path / out), "--format", form]) == 0
    for out, form in (("first", "parquet"), ("second", "csv")):
        assert cli.run([*line, str(tmp_path / out), "--format", form, "--resume"]) == 0
        assert f"results.{form} from " in capsys.readouterr().out
    for form in ("csv", "parquet"):
        same = [(tmp_path / out / f"results.{form}").read_bytes() for out in ("first", "second")]
        assert same[0] == same[1]


@pytest.mark.parametrize("rows", [b"", b"run,seed\n1\n", b"run\n0\n1\n", b"\xff"], ids=str)
def test_results_that_cannot_be_read_are_not_written_in_another_format(
    rows: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    assert (
        cli.run(["sweep", VEHICLE, "--no-cache", *FLY, "--out", str(out), "--format", "csv"]) == 0
    )
    capsys.readouterr()
    (out / "results.csv").write_bytes(rows)
    assert "results.csv" in refused(capsys, "--out", str(out), "--resume", "--format", "parquet")
    assert not (out / "results.parquet").exists()


def test_a_folder_that_another_call_flies_into_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    with sweep_folder.alone(out):
        assert "no other call" in refused(capsys, "--out", str(out))
        assert not list(out.iterdir())
    assert cli.run(["sweep", VEHICLE, "--no-cache", *FLY, "--out", str(out)]) == 0


def stamps(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mtime_ns for path in folder.iterdir()}
