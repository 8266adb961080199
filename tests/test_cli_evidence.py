"""derive evidence, and what emit, check and verify know of it: messages, exit codes, files."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from derive import cli, dossier, folder, pipeline
from derive.evidence import target, version
from derive.evidence.emitted import Emitted
from derive.evidence.gather import Evidence
from derive.vehicle import InputError
from derive.verify.check import Check, Report
from derive.verify.limits import LIMITS
from tests.command import derive, refused
from tests.evidence import made

PAGE = "EVIDENCE.md"


@pytest.fixture
def package(
    body: Path, home: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Path:
    """The emitted folder of body.toml, in the current folder; tools are not asked for versions."""
    monkeypatch.chdir(body.parent)
    monkeypatch.setenv("HOME", str(home))
    monkeypatch.setattr(version, "COMMANDS", ())
    assert cli.run(["emit", body.name]) == 0
    capsys.readouterr()
    return Path("generated") / "body"


def change(package: Path, path: str) -> None:
    """Make what stands in a package another text."""
    place = package / path
    place.write_text(place.read_text() + "\n", encoding="utf-8")


def test_a_page_is_written_and_renewed(
    package: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    made.gathered(monkeypatch, made.GOOD)
    assert cli.run(["evidence", "body.toml"]) == 0
    assert capsys.readouterr() == ("wrote generated/body/EVIDENCE.md (4 checks, 0 failed)\n", "")
    text = (package / PAGE).read_text(encoding="utf-8")
    assert text.startswith("# Evidence on body\n")
    assert cli.run(["check", "body.toml"]) == 0
    assert capsys.readouterr() == ("same generated/body\n", "")
    assert cli.run(["evidence", "body.toml"]) == 0
    assert (package / PAGE).read_text(encoding="utf-8") == text
    assert not [path for path in package.rglob("*") if path.name.startswith(".derive")]


def test_a_finding_is_exit_1_and_the_page_says_so(
    package: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    made.gathered(monkeypatch, made.BAD, made.HUNG)
    assert cli.run(["evidence", "body.toml"]) == 1
    said = capsys.readouterr()
    assert said.out.splitlines() == [
        "wrote generated/body/EVIDENCE.md (5 checks, 3 failed)",
        "  FAILED same bits, C f32: 3 rows; at most 0; worst | one",
        "  FAILED same bits, C f64: 3 rows; at most 0; worst | one",
        "  FAILED hung: broke down, f32 f64: 1 runs; at most 0; emulator did not end within 10 s",
    ]
    assert "its words" in said.err
    assert "**3 of 5 checks failed.**" in (package / PAGE).read_text(encoding="utf-8")


def test_a_missing_tool_is_exit_1_unless_allowed(
    package: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    made.gathered(monkeypatch, made.LACKING)
    assert cli.run(["evidence", "body.toml"]) == 1
    said = capsys.readouterr()
    words = "no-such-tool is not on PATH; get it with: apt install it"
    assert said.out.splitlines()[1:] == [
        "  not run: RV32: it is not here",
        f"  not run: lacking, f32 and f64, in part: {words}",
    ]
    assert (package / PAGE).read_text().splitlines()[2].startswith("**This page is partial**: ")
    assert "--allow-missing accepts that" in said.err
    assert cli.run(["evidence", "body.toml", "--allow-missing"]) == 0
    assert capsys.readouterr().err == ""


def test_a_package_without_a_page_is_told_and_is_no_finding(
    package: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    other = Path("other.toml")
    other.write_text(Path("body.toml").read_text().replace('"body"', '"other"'), encoding="utf-8")
    assert cli.run(["check", "body.toml", "other.toml"]) == 1  # for what was never emitted
    said = capsys.readouterr()
    writing = "write with: derive evidence body.toml"
    assert said.err == f"note: not written yet: generated/body/EVIDENCE.md; {writing}\n"
    assert cli.run(["check", "body.toml"]) == 0
    assert capsys.readouterr() == ("same generated/body\n", said.err)
    made.gathered(monkeypatch, made.GOOD)
    assert cli.run(["evidence", "body.toml"]) == cli.run(["check", "body.toml"]) == 0
    assert "note" not in capsys.readouterr().err


def test_a_page_that_was_edited_is_told_and_not_worth_keeping(
    package: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    made.gathered(monkeypatch, made.GOOD)
    cli.run(["evidence", "body.toml"])
    page = package / PAGE
    page.write_text(page.read_text().replace("1234 B", "1233 B", 1), encoding="utf-8")
    capsys.readouterr()
    assert cli.run(["check", "body.toml"]) == 1
    assert capsys.readouterr() == (
        "same generated/body\n"
        "edited generated/body/EVIDENCE.md: its last line gives another digest; "
        "renew with: derive evidence body.toml\n",
        "",
    )
    assert cli.run(["evidence", "body.toml", "--quick"]) == 0
    assert capsys.readouterr().out.startswith("wrote ")
    assert cli.run(["check", "body.toml"]) == 0


def test_a_vehicle_that_cannot_be_measured_costs_the_others_nothing(
    package: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    made.gathered(monkeypatch, made.GOOD)
    Path("bad.toml").write_text("group = 3", encoding="utf-8")
    text = Path("body.toml").read_text()
    for name in ("third", "fourth"):
        Path(f"{name}.toml").write_text(text.replace('"body"', f'"{name}"'), encoding="utf-8")
    cli.run(["emit", "fourth.toml"])
    capsys.readouterr()
    filed = dossier.filed

    def full(found: Evidence, place: Path, **options: bool) -> dossier.Filed:
        if place.name == "fourth":
            raise InputError(str(place), "--out", "room", "none", "make some")
        return filed(found, place, **options)

    monkeypatch.setattr(dossier, "filed", full)
    files = ("bad.toml", "third.toml", "fourth.toml", "body.toml")
    assert cli.run(["evidence", *files]) == 2
    said = capsys.readouterr()
    assert said.out == "wrote generated/body/EVIDENCE.md (4 checks, 0 failed)\n"
    heads = [line for line in said.err.splitlines() if line[0] != " "]
    assert [line.partition(":")[0] for line in heads] == [
        "bad.toml", "generated/third", "generated/fourth",
        "no page was written for bad.toml, third.toml, fourth.toml",
    ]  # fmt: skip
    assert "found:    no such folder\n" in said.err


@pytest.mark.parametrize("less", ["missing", "quick"])
def test_a_page_that_has_everything_is_not_replaced_by_less(
    package: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], less: str
) -> None:
    with monkeypatch.context() as patch:
        made.gathered(patch, made.GOOD)
        assert cli.run(["evidence", "body.toml"]) == 0
        whole = (package / PAGE).read_text(encoding="utf-8")
    made.gathered(monkeypatch, made.GOOD if less == "quick" else made.LACKING)
    option = ["--quick"] if less == "quick" else []
    capsys.readouterr()
    assert cli.run(["evidence", "body.toml", *option]) == (0 if less == "quick" else 1)
    assert capsys.readouterr().out.startswith("kept generated/body/EVIDENCE.md: ")
    assert (package / PAGE).read_text(encoding="utf-8") == whole
    assert cli.run(["evidence", "body.toml", *option, "--allow-missing"]) == 0
    assert (package / PAGE).read_text(encoding="utf-8") != whole


def test_a_stale_page_is_told_kept_and_renewed(
    package: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    made.gathered(monkeypatch, made.GOOD)
    cli.run(["evidence", "body.toml"])
    body = Path("body.toml")
    before = (package / PAGE).read_text(encoding="utf-8")
    body.write_text(body.read_text().replace("0.0067", "0.0068"), encoding="utf-8")
    capsys.readouterr()
    line = (
        "stale generated/body/EVIDENCE.md: it measured another body_f32.c; "
        "renew with: derive evidence body.toml\n"
    )
    assert cli.run(["emit", "body.toml"]) == 0
    said = capsys.readouterr()
    assert (said.out.split(" (")[0], said.err) == ("wrote generated/body", line)
    assert (package / PAGE).read_text(encoding="utf-8") == before
    assert cli.run(["check", "body.toml"]) == 1
    assert capsys.readouterr() == (f"same generated/body\n{line}", "")
    assert cli.run(["evidence", "body.toml", "--quick"]) == 0  # what is stale has nothing to lose
    assert (package / PAGE).read_text(encoding="utf-8") != before
    assert cli.run(["check", "body.toml"]) == 0


def test_evidence_is_asked_for_of_what_was_emitted(
    package: Path, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = Path.cwd()
    change(package, "c/src/body_f32.c")
    told = refused(place, "evidence", "body.toml", home=home)
    assert told.startswith("generated/body\n")
    assert "1 files that differ, the first c/src/body_f32.c\n" in told
    assert "run first: derive emit body.toml\n" in told
    told = refused(place, "evidence", "body.toml", "--out", "my out", home=home)
    assert "found:    no such folder\n" in told
    assert "run first: derive emit body.toml --out 'my out'\n" in told


def test_a_package_that_cannot_be_written_into_is_told_before_the_work(
    package: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def read_only(path: Path) -> None:
        raise PermissionError(13, os.strerror(13), str(path))

    monkeypatch.setattr(folder, "probe", read_only)
    monkeypatch.setattr(dossier, "measured", None)  # the work
    assert cli.run(["evidence", "body.toml"]) == 2
    said = capsys.readouterr().err
    assert said.startswith("generated/body/EVIDENCE.md: --out\n")
    assert "Permission denied" in said


def made_folder(page: Path) -> None:
    page.mkdir()
    (page / "x").touch()


MAKE: dict[str, Callable[[Path], None]] = {
    "link": lambda page: page.symlink_to("trace.csv"),
    "pipe": os.mkfifo,
    "folder": made_folder,
}


@pytest.mark.parametrize("kind", MAKE)
def test_what_only_has_the_name_of_a_page_is_foreign(
    package: Path, home: Path, kind: str, capsys: pytest.CaptureFixture[str]
) -> None:
    page = package / PAGE
    MAKE[kind](page)
    assert cli.run(["check", "body.toml"]) == 1
    assert "derive did not write it: generated/body/EVIDENCE.md" in capsys.readouterr().out
    change(package, "trace.csv")
    assert "foreign files: EVIDENCE.md" in refused(Path.cwd(), "emit", "body.toml", home=home)


def test_a_page_without_a_package_is_foreign(package: Path, home: Path) -> None:
    shutil.rmtree(package)
    package.mkdir()
    (package / PAGE).write_text("mine", encoding="utf-8")
    assert "foreign files: EVIDENCE.md" in refused(Path.cwd(), "emit", "body.toml", home=home)


def test_verify_runs_targets_when_asked(
    body: Path, home: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    usual = Check("usual", "C f32", 0, LIMITS["rows"], 1)
    monkeypatch.setattr(pipeline, "verify", lambda *_, **options: Report("body", (usual,)))
    ran: list[str] = []

    def targets(packages: list[Emitted], _: object) -> list[Check]:
        ran.extend(one.prefix for one in packages if one.source.is_file())
        return [Check("same bits", "f32 RV32", len(ran), LIMITS["rows"], 1)]

    monkeypatch.setattr(target, "targets", targets)
    monkeypatch.setattr(target, "missing", tuple)
    monkeypatch.setenv("HOME", str(home))
    assert cli.run(["verify", str(body)]) == 0
    assert ran == []
    assert cli.run(["verify", str(body), "--target", "--json", "-"]) == 1
    assert ran == ["body_f32", "body_f64"]
    assert '"same bits"' in capsys.readouterr().out
    monkeypatch.setattr(target, "targets", lambda *_: [])
    monkeypatch.setattr(target, "missing", lambda: ("RV32 was not run: get it with: apt",))
    assert cli.run(["verify", str(body), "--target"]) == 1
    assert "not checked: RV32 was not run: get it with: apt\n" in capsys.readouterr().out
    assert cli.run(["verify", str(body), "--target", "--allow-missing"]) == 0


def test_a_compiler_that_fails_is_told_with_its_words(
    body: Path, home: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    broken = tmp_path / "bin"
    broken.mkdir()
    (broken / "cc").write_text("#!/bin/sh\necho out of luck >&2\nexit 1\n", encoding="utf-8")
    (broken / "cc").chmod(0o755)
    monkeypatch.setenv("PATH", f"{broken}:{os.environ['PATH']}")
    told = refused(body.parent, "verify", body.name, "--target", "--samples", "1", home=home)
    assert told.startswith("body.toml\n  expected: a C compiler that takes what is emitted\n")
    assert f"command: {broken}/cc -std=c99" in told
    assert "out of luck\n" in told


def test_a_vehicle_without_c_has_no_targets(body: Path, home: Path) -> None:
    text = body.read_text().replace('targets = ["c99", "numpy"]', 'targets = ["numpy"]')
    body.write_text(text, encoding="utf-8")
    told = refused(body.parent, "verify", body.name, "--target", home=home)
    assert told.startswith("body.toml: emit.targets\n")
    assert derive(body.parent, "check", body.name, home=home).returncode == 1
