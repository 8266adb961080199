"""`derive explain` and `derive verify --html` as a person meets them."""

from pathlib import Path
from types import SimpleNamespace

import pytest

from derive import cli, pipeline
from tests.command import derive, refused


def test_explain_prints_the_derivation(body: Path) -> None:
    result = derive(body.parent, "explain", "body.toml", "--equation", "velErr")
    assert (result.returncode, result.stderr) == (0, "")
    assert "    eta = Ad(g_e^-1) nu_r\n" in result.stdout
    assert "const double eta_0 = " in result.stdout
    assert result.stdout.isascii()
    assert result.stdout.endswith("\n")
    assert not result.stdout.endswith("\n\n")


@pytest.mark.parametrize(
    ("name", "options", "begins"),
    [
        ("d.html", (), "<!DOCTYPE html>"),
        ("d.tex", (), "\\documentclass"),
        ("d.txt", (), "body: gsmc on SO3"),
        ("d.txt", ("--format", "html"), "<!DOCTYPE html>"),
    ],
)
def test_the_file_decides_the_format_unless_it_is_said(
    body: Path, name: str, options: tuple[str, ...], begins: str
) -> None:
    out = body.parent / name
    result = derive(body.parent, "explain", "body.toml", "--out", name, *options)
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    assert out.read_text(encoding="utf-8").startswith(begins)


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (("--equation", "TckCtl"), "write --equation TckCtrl, the nearest"),
        (("--equation", "TckCtl"), "one of velErr, TckCtrl, "),
        (("--equation", "polar"), "the nearest"),
        (("--routine", "track"), "write --routine tracking, the nearest"),
        (("--routine", "track"), "one of tracking, reaching, plant"),
        (("--out", "."), "--out"),
        (("--out", "absent/d.html"), "--out"),
    ],
)
def test_explain_refuses(body: Path, options: tuple[str, ...], told: str) -> None:
    assert told in refused(body.parent, "explain", "body.toml", *options)


def test_explain_refuses_a_bad_vehicle(body: Path) -> None:
    assert "no such file" in refused(body.parent, "explain", "absent.toml")
    body.write_text(body.read_text().replace('"log"', '"half_log"'))
    assert "exists only on S3" in refused(body.parent, "explain", "body.toml")


def test_an_unknown_format_is_a_wrong_command_line(body: Path) -> None:
    result = derive(body.parent, "explain", "body.toml", "--format", "pdf")
    assert (result.returncode, result.stdout) == (2, "")
    assert "'text', 'latex', 'html'" in result.stderr


def test_what_is_explained_does_not_depend_on_the_hash_seed(
    body: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pages = []
    for seed in ("1", "2"):
        monkeypatch.setenv("PYTHONHASHSEED", seed)
        pages.append(derive(body.parent, "explain", "body.toml", "--format", "html").stdout)
    assert len(pages[0]) > 10_000
    assert pages[0] == pages[1]


@pytest.mark.parametrize("ok", [True, False])
def test_verify_writes_its_report_as_a_page(
    body: Path, ok: bool, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    report = SimpleNamespace(
        ok=ok, skipped=(), table=lambda: "the table", as_html=lambda: "<p>page</p>\n"
    )
    monkeypatch.setattr(pipeline, "verify", lambda *given, **options: report)
    place = body.parent / "report.html"
    assert cli.run(["verify", str(body), "--html", str(place)]) == (0 if ok else 1)
    assert capsys.readouterr() == ("the table\n", "")
    assert place.read_text() == "<p>page</p>\n"
    assert cli.run(["verify", str(body), "--html", "-"]) == (0 if ok else 1)
    assert capsys.readouterr() == ("<p>page</p>\n", "")
    assert cli.run(["verify", str(body), "--html", str(body.parent)]) == 2
    assert "--html" in capsys.readouterr().err
