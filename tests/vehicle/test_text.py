"""Files that cannot be read at all, names that cannot be used, and errors that travel."""

import os
import pickle
from pathlib import Path

import pytest

from derive.vehicle import InputError, load
from derive.vehicle.check import C_WORDS, check_name


def refusal(path: Path) -> InputError:
    with pytest.raises(InputError) as caught:
        load(path)
    return caught.value


def test_missing_file_and_directory_are_refused(tmp_path: Path) -> None:
    missing, directory = refusal(tmp_path / "none.toml"), refusal(tmp_path)
    assert (missing.found, directory.found) == ("no such file", "a directory")
    assert "derive init" in missing.remedy
    assert "cannot be read" in refusal(tmp_path / "a\0b").found
    assert "cannot be read" in refusal(tmp_path / ("a" * 300)).found


def test_pipe_is_refused_without_waiting_for_a_writer(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    assert "not a regular file" in refusal(tmp_path / "pipe").found


def test_unreadable_file_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def denied(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    path = tmp_path / "body.toml"
    path.touch()
    monkeypatch.setattr(Path, "open", denied)
    assert "Permission denied" in refusal(path).found


def test_errors_survive_pickling(tmp_path: Path) -> None:
    error = refusal(tmp_path / "none.toml")
    assert str(pickle.loads(pickle.dumps(error))) == str(error)


def test_suggested_names_are_accepted() -> None:
    for name in [*sorted(C_WORDS), "", "_", "a_f32_F64", "9" * 60, "aux", "é", "x__", "os"]:
        with pytest.raises(InputError) as caught:
            check_name("body.toml", name)
        suggestion = caught.value.remedy.partition('name = "')[2].rstrip('"')
        assert suggestion
        check_name("body.toml", suggestion)
