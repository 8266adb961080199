"""Folders are read whole, replaced whole or not at all, and never lose a file of someone else."""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from derive import folder

ROOT = Path(__file__).parents[1]
OLD = {
    "a.txt": "old\n",
    "c/b.txt": "old\n",
    "MANIFEST.toml": '[files]\n"a.txt" = 1\n"c/b.txt" = 1\n',
}
NEW = {"a.txt": "new\r\n", "c/d/b.txt": "new µ\n", "MANIFEST.toml": '[files]\n"a.txt" = 1\n'}
BOTH = ("first", "second")


def fill(place: Path, texts: dict[str, str]) -> None:
    for name, text in texts.items():
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        (place / name).write_bytes(text.encode())


def names(place: Path) -> list[str]:
    return sorted(path.name for path in place.iterdir())


def test_a_folder_is_written_found_unchanged_and_replaced(tmp_path: Path) -> None:
    out = tmp_path / "deep" / "out"
    assert folder.replace(out, {"first": OLD}) == {"first": True}
    assert (out / "first" / "c" / "b.txt").read_bytes() == b"old\n"
    before = (out / "first").stat().st_ino
    assert folder.replace(out, {"first": OLD, "second": NEW}) == {"first": False, "second": True}
    assert (out / "first").stat().st_ino == before
    assert folder.replace(out, {"first": NEW}) == {"first": True}
    assert folder.read(out / "first") == NEW == folder.read(out / "second")
    assert names(out) == ["first", "second"]


def test_what_is_written_can_be_read_by_others(tmp_path: Path) -> None:
    (tmp_path / "plain").mkdir()
    (tmp_path / "plain" / "file").touch()
    folder.replace(tmp_path, {"first": OLD})
    folder.save(tmp_path / "saved", "text")
    for ours, plain in (("first", "plain"), ("first/a.txt", "plain/file"), ("saved", "plain/file")):
        assert (tmp_path / ours).stat().st_mode == (tmp_path / plain).stat().st_mode


@pytest.mark.parametrize("failing", range(1, 5))
def test_when_a_rename_fails_all_folders_stay_as_they_were(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, failing: int
) -> None:
    folder.replace(tmp_path, dict.fromkeys(BOTH, OLD))
    rename, calls = Path.rename, [0]

    def fails_once(path: Path, target: Path) -> Path:
        calls[0] += 1
        if calls[0] == failing:
            raise OSError(28, "No space left on device")
        return rename(path, target)

    monkeypatch.setattr(Path, "rename", fails_once)
    with pytest.raises(OSError, match="No space"):
        folder.replace(tmp_path, dict.fromkeys(BOTH, NEW))
    assert [folder.read(tmp_path / name) for name in BOTH] == [OLD, OLD]
    assert names(tmp_path) == [*BOTH]


def test_a_new_folder_does_not_stay_when_a_later_one_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "second").touch()  # a file: nothing can be moved away from below it
    with pytest.raises(OSError, match="second"):
        folder.replace(tmp_path, {"first": NEW, "second/below": NEW})
    assert names(tmp_path) == ["second"]


@pytest.mark.parametrize("last", range(1, 5))
def test_a_writer_killed_between_renames_loses_nothing(tmp_path: Path, last: int) -> None:
    folder.replace(tmp_path, dict.fromkeys(BOTH, OLD))
    script = f"""
import os
from pathlib import Path
from derive import folder
rename, calls = Path.rename, []
def dies(path, target):
    calls.append(path)
    return os._exit(9) if len(calls) == {last} else rename(path, target)
Path.rename = dies
folder.replace(Path({str(tmp_path)!r}), dict.fromkeys({BOTH!r}, {NEW!r}))
"""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-c", script]
    assert subprocess.run(command, check=False, env=environment).returncode == 9
    folder.replace(tmp_path, {"third": OLD})  # whatever is written next puts things right
    assert names(tmp_path) == [*BOTH, "third"]
    assert all(folder.read(tmp_path / name) in (OLD, NEW) for name in BOTH)


def test_writers_at_once_take_turns(tmp_path: Path) -> None:
    script = (
        "import sys; from pathlib import Path; from derive import folder\n"
        "for i in range(150):\n"
        "    folder.replace(Path(sys.argv[1]), {'first': {'a': sys.argv[2] + str(i)}})"
    )
    command = [sys.executable, "-c", script, str(tmp_path)]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    writers = [subprocess.Popen([*command, word], env=environment) for word in BOTH]
    assert [writer.wait(60) for writer in writers] == [0, 0]
    assert (tmp_path / "first" / "a").read_text() in [f"{word}149" for word in BOTH]
    assert names(tmp_path) == ["first"]


def test_caches_of_python_are_no_part_of_a_folder(tmp_path: Path) -> None:
    fill(tmp_path / "first", {**OLD, "numpy/__pycache__/x.pyc": "bytes"})
    assert folder.read(tmp_path / "first") == OLD
    assert folder.strangers(tmp_path / "first") == []
    fill(tmp_path / "__pycache__", OLD)
    assert folder.read(tmp_path / "__pycache__") == OLD


def test_bytes_that_are_not_text_are_told_apart(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"\xff\n")
    (tmp_path / "b").write_bytes(b"\xfe\n")
    assert len(set(folder.read(tmp_path).values())) == 2


@pytest.mark.parametrize(
    ("extra", "add"),
    [
        ("note", lambda path: path.touch()),
        ("link", lambda path: path.symlink_to("nowhere")),
        ("linked", lambda path: path.symlink_to("c")),
        ("pipe", os.mkfifo),
        ("empty/", Path.mkdir),
    ],
)
def test_what_the_manifest_does_not_know_is_a_stranger(
    tmp_path: Path, extra: str, add: Callable[[Path], None]
) -> None:
    fill(tmp_path, OLD)
    assert folder.strangers(tmp_path) == []
    add(tmp_path / "c" / extra)
    assert folder.strangers(tmp_path) == [f"c/{extra}"]


@pytest.mark.parametrize("manifest", ["", "[files", "files = 3", "files = []", "\udcff", "a=" * 3])
def test_with_a_useless_manifest_all_files_are_strangers(tmp_path: Path, manifest: str) -> None:
    fill(tmp_path, {"a.txt": ""})
    (tmp_path / "MANIFEST.toml").write_bytes(manifest.encode("utf-8", "surrogateescape"))
    assert set(folder.strangers(tmp_path)) >= {"a.txt"}


def test_a_known_folder_that_lost_its_files_is_no_stranger(tmp_path: Path) -> None:
    fill(tmp_path, OLD)
    (tmp_path / "c" / "b.txt").unlink()
    assert folder.strangers(tmp_path) == []


def test_no_folder_and_an_empty_one_have_no_strangers(tmp_path: Path) -> None:
    assert folder.strangers(tmp_path) == []
    assert folder.strangers(tmp_path / "none") == []


def test_a_place_taken_by_something_else_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    (tmp_path / "link").symlink_to(tmp_path)
    (tmp_path / "dangling").symlink_to("nowhere")
    for taken in ("file", "link", "dangling"):
        with pytest.raises(NotADirectoryError, match=taken):
            folder.strangers(tmp_path / taken)


def test_a_saved_file_is_whole_or_as_before(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place, link = tmp_path / "report.json", tmp_path / "link"
    folder.save(place, "before")
    link.symlink_to(place)
    folder.save(link, "after")
    assert (place.read_text(), link.is_symlink()) == ("after", True)

    def refuses(path: Path, target: Path) -> Path:
        raise KeyboardInterrupt

    monkeypatch.setattr(Path, "replace", refuses)
    with pytest.raises(KeyboardInterrupt):
        folder.save(place, "half")
    assert (place.read_text(), names(tmp_path)) == ("after", ["link", "report.json"])


def test_a_device_is_written_to_and_not_replaced(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = subprocess.Popen(["cat", str(pipe)], stdout=subprocess.PIPE, text=True)
    folder.save(pipe, "through")
    assert reader.communicate(timeout=10)[0] == "through"
    assert pipe.is_fifo()
