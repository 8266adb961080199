"""Places a command is told to read or write: each that cannot be used is named as it was given."""

import os
from pathlib import Path

import pytest

from derive import cli, folder, pipeline
from tests.command import derive, refused


def test_a_report_that_cannot_be_written_is_told_before_the_work(
    body: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def too_late(*given: object, **options: object) -> None:
        raise AssertionError

    monkeypatch.setattr(pipeline, "verify", too_late)
    monkeypatch.chdir(body.parent)
    (body.parent / "taken").mkdir()
    for option in ("--json", "--html"):
        for place in ("none/report", "body.toml/report", "taken", "x" * 300, "/proc/report"):
            assert cli.run(["verify", "body.toml", option, place]) == 2
            message = capsys.readouterr().err
            assert message.startswith(f"{place}: {option}\n")
            assert folder.PART[0] not in message
    assert sorted(path.name for path in body.parent.iterdir()) == ["body.toml", "taken"]


def test_probing_leaves_files_devices_and_links_as_they_are(tmp_path: Path) -> None:
    (tmp_path / "old").write_text("kept")
    (tmp_path / "link").symlink_to("new")
    os.mkfifo(tmp_path / "pipe")
    before = sorted(path.name for path in tmp_path.iterdir())
    for name in ("old", "link", "new", "pipe"):
        folder.probe(tmp_path / name)
    folder.probe(Path("/dev/null"))
    assert sorted(path.name for path in tmp_path.iterdir()) == before
    assert (tmp_path / "old").read_text() == "kept"


def test_links_in_the_place_of_folders_are_told_as_links(body: Path, home: Path) -> None:
    place = body.parent
    (place / "dangling").symlink_to("nowhere")
    (place / "out").mkdir()
    (place / "elsewhere").mkdir()
    (place / "out" / "body").symlink_to(place / "elsewhere")
    message = refused(place, "emit", body.name, "--out", "dangling", home=home)
    assert "found:    a link that leads nowhere: dangling\n" in message
    message = refused(place, "emit", body.name, "--out", "out", home=home)
    assert message.startswith("out/body: --out\n")
    assert "found:    a link where a folder has to be: out/body\n" in message
    message = refused(place, "emit", body.name, "--out", "body.toml", home=home)
    assert "found:    a file where a folder has to be: body.toml\n" in message


@pytest.mark.parametrize("again", ["body.toml", "./body.toml", "same.toml"])
@pytest.mark.parametrize("command", ["emit", "check"])
def test_one_file_given_twice_is_told_as_that(
    body: Path, home: Path, command: str, again: str
) -> None:
    (body.parent / "same.toml").symlink_to(body)
    message = refused(body.parent, command, body.name, again, home=home)
    assert "found:    the same file twice, the first time as body.toml\n" in message
    assert "rename" not in message


def test_two_files_of_one_name_are_told_to_differ(body: Path, home: Path) -> None:
    (body.parent / "copy.toml").write_bytes(body.read_bytes())
    message = refused(body.parent, "emit", body.name, "copy.toml", home=home)
    assert message.startswith("copy.toml: name\n")
    assert "rename one of the two" in message


def test_an_empty_folder_of_someone_else_is_left_alone(body: Path, home: Path) -> None:
    place = body.parent
    derive(place, "emit", body.name, home=home)
    (place / "generated" / "body" / ".git" / "refs").mkdir(parents=True)
    body.write_text(body.read_text().replace("0.0067", "0.0068"))
    assert "foreign files: .git/refs/\n" in refused(place, "emit", body.name, home=home)
    assert (place / "generated" / "body" / ".git" / "refs").is_dir()


def test_check_says_what_emit_would_refuse(body: Path, home: Path) -> None:
    place = body.parent
    derive(place, "emit", body.name, home=home)
    (place / "generated" / "body" / "my notes").write_text("mine")
    (place / "generated" / "body" / "trace.csv").unlink()
    lines = derive(place, "check", body.name, home=home).stdout.splitlines()
    assert lines[-2:] == [
        "move away first, derive did not write it: 'generated/body/my notes'",
        "update with: derive emit body.toml",
    ]
    (place / "generated" / "body" / "my notes").unlink()
    result = derive(place, "check", body.name, home=home)
    assert (result.returncode, "move away" in result.stdout) == (1, False)


@pytest.mark.parametrize("name", ["f32", "f64", "F64"])
def test_a_vehicle_is_not_called_like_a_scalar(tmp_path: Path, name: str) -> None:
    assert "is the name of a scalar" in refused(tmp_path, "init", name)
