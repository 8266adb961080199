"""`derive laws` as a command, its page in docs/, and what `derive emit` warns of."""

import json
from pathlib import Path
from types import SimpleNamespace

import pytest

from derive import cli, theory
from derive.vehicle.starter import starter
from tests.command import ROOT, derive, refused
from tests.verdicts import catalogue, verdict

HEAVY = ("sympy", "numpy", "mpmath")
OWN = """\
name = "spiral"
law = "skew"
inertia = [[1.0, 0.0], [0.0, 1.0]]
[gains]
lambda = 0.5
k_s = 1.0
[group]
name = "Spiral"
basis = [[[1, 0, 0], [0, 2, 0], [0, 0, 0]], [[0, 0, 0], [0, 0, 1], [0, 0, 0]]]
"""


def vehicle(place: Path, name: str, group: str, law: str) -> str:
    (place / f"{name}.toml").write_text(starter(name, group, law))
    return f"{name}.toml"


def test_the_page_shows_what_the_command_shows() -> None:
    page = (ROOT / "docs" / "laws.md").read_text(encoding="utf-8")
    shown = page.partition("$ derive laws\n")[2].partition("```")[0]
    assert shown.splitlines() == catalogue().table().splitlines()


def test_the_page_has_a_sentence_for_every_law() -> None:
    page = (ROOT / "docs" / "laws.md").read_text(encoding="utf-8")
    rows = [line for line in page.partition("## Law by law")[2].splitlines() if "|" in line]
    for one in catalogue().verdicts:
        assert any(one.group in row and f"`{one.law}`" in row for row in rows), one.law


def test_a_group_is_judged_by_name(tmp_path: Path) -> None:
    result = derive(tmp_path, "laws", "--group", "SO2", "--json", "report.json")
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.endswith("3 laws, 0 contradictions\n")
    assert "SO2 skew, vee(g - g^-1)/2: vanishes at rotations by pi, an isolated" in result.stdout
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["ok"]
    assert [one["law"] for one in report["laws"]] == ["log", "skew", "cayley"]
    assert report["laws"][2]["jumps"][0]["size"] is None
    assert report["laws"][2]["cautions"][0].startswith("has no bound towards rotations by pi")


def test_a_vehicle_has_its_law_marked(tmp_path: Path) -> None:
    result = derive(tmp_path, "laws", vehicle(tmp_path, "one", "S3", "vec"))
    assert result.returncode == 0
    assert "*vec" in result.stdout
    assert "*log" not in result.stdout
    assert "6 laws, 0 contradictions" in result.stdout


def test_a_group_of_ones_own_is_judged_too(tmp_path: Path) -> None:
    (tmp_path / "spiral.toml").write_text(OWN)
    result = derive(tmp_path, "laws", "spiral.toml")
    assert result.returncode == 0
    assert "Spiral  *skew" in result.stdout


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--group", "SO4"), 'give --group "SO3", the nearest'),
        (("--group", "SO3 x"), "one of SO2, SO3"),
        (("one.toml", "--group", "SO3"), "leave one out: one.toml is on SO3"),
        (("absent.toml",), "no such file"),
    ],
)
def test_what_cannot_be_judged_is_told(
    tmp_path: Path, arguments: tuple[str, ...], told: str
) -> None:
    vehicle(tmp_path, "one", "SO3", "log")
    assert told in refused(tmp_path, "laws", *arguments)


def test_a_contradiction_is_exit_1(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for ok in (True, False):
        report = SimpleNamespace(ok=ok, table=lambda: "the table", as_json=lambda: "{}")
        monkeypatch.setattr(theory, "laws", lambda *given, report=report: report)
        assert cli.run(["laws"]) == (0 if ok else 1)
        assert cli.run(["laws", "--json", "-"]) == (0 if ok else 1)
        assert capsys.readouterr().out == "the table\n{}\n"


@pytest.mark.parametrize(
    ("group", "law", "told"),
    [
        ("SO3", "skew", "vanishes at every rotation by pi: a vehicle at rest there stays"),
        ("S3", "sign_vec", "lets V = V_2 rise for q0 < 0, where it drives to -i"),
        ("SO3", "gibbs", "has no bound towards rotations by pi: control refuses it there, and the "
         "force is zero; not so with log"),
        ("S3", "half_log", "has a rate without bound towards -i, the attitude of the identity: "
         "control refuses it there, and the force is zero; not so with vec"),
        ("SO3", "log", ""),
        ("S3", "vec", ""),
    ],
)  # fmt: skip
def test_emit_warns_in_one_line(tmp_path: Path, group: str, law: str, told: str) -> None:
    name = vehicle(tmp_path, "one", group, law)
    line = f"warning: one: law {law} on {group} {told}; see derive laws --group {group}\n"
    for word in ("wrote", "unchanged"):  # derived, and from the cache
        result = derive(tmp_path, "emit", name)
        assert (result.returncode, result.stderr) == (0, line if told else "")
        assert result.stdout == f"{word} generated/one (16 files)\n"


def test_the_same_warning_is_given_once(tmp_path: Path) -> None:
    names = [vehicle(tmp_path, name, "SO3", "skew") for name in ("one", "two")]
    result = derive(tmp_path, "emit", *names)
    assert result.stderr.startswith("warning: one, two: law skew on SO3 vanishes")
    assert result.stderr.count("\n") == 1
    checked = derive(tmp_path, "check", *names).stderr
    assert checked.startswith("note: not written yet: ")  # pages of evidence
    assert checked.count("\n") == 1


def test_a_warning_from_the_cache_imports_nothing_heavy(tmp_path: Path) -> None:
    name = vehicle(tmp_path, "one", "SO3", "skew")
    derive(tmp_path, "emit", name)
    result = derive(tmp_path, "emit", name, flags=("-X", "importtime"))
    assert "warning: one: law skew on SO3 vanishes" in result.stderr
    assert not [one for one in HEAVY if f" {one}\n" in result.stderr]


def test_a_group_of_ones_own_is_warned_of(tmp_path: Path) -> None:
    (tmp_path / "spiral.toml").write_text(OWN)
    for _ in range(2):
        lines = derive(tmp_path, "emit", "spiral.toml").stderr.splitlines()
        assert len(lines) == 2
        assert "law skew on Spiral is g - g^-1 only as far as the algebra reaches" in lines[0]
        assert "cannot see whether g has left Spiral in one direction" in lines[1]


def test_the_texts_of_warnings_are_those_of_the_table() -> None:
    assert "every rotation by pi" in " ".join(
        line for line in catalogue().table().splitlines() if line.startswith("SO3 skew,")
    )
    assert verdict("SO3", "skew").rests[0].is_every
