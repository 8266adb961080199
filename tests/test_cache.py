"""The cache gives back what was kept, whole, or nothing; and its keys cover all that matters."""

import json
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import pytest

from derive import cache

ROOT = Path(__file__).parents[1]
PAYLOAD = {"steps": [["s_0", "a + b"], ["µ", None]], "dim": 3, "is_pole": False}
NAME = "0123abcd"
PARTS: dict[str, object] = {"name": "body", "pattern": (True, False)}


def test_a_payload_is_given_back(tmp_path: Path) -> None:
    assert cache.read(tmp_path / "new", NAME) is None
    cache.write(tmp_path / "new", NAME, PAYLOAD)
    assert cache.read(tmp_path / "new", NAME) == PAYLOAD
    assert cache.read(tmp_path / "new", "another") is None
    assert [path.name for path in (tmp_path / "new").iterdir()] == [f"{NAME}.json"]


def test_an_entry_cut_short_anywhere_is_no_entry(tmp_path: Path) -> None:
    cache.write(tmp_path, NAME, PAYLOAD)
    entry = tmp_path / f"{NAME}.json"
    whole = entry.read_bytes()
    for length in range(len(whole)):
        entry.write_bytes(whole[:length])
        assert cache.read(tmp_path, NAME) is None, length


def test_no_flipped_bit_of_an_entry_changes_a_payload(tmp_path: Path) -> None:
    cache.write(tmp_path, NAME, PAYLOAD)
    entry = tmp_path / f"{NAME}.json"
    whole = entry.read_bytes()
    for place in range(8 * len(whole)):
        damaged = bytearray(whole)
        damaged[place // 8] ^= 1 << place % 8
        entry.write_bytes(damaged)
        assert cache.read(tmp_path, NAME) in (None, PAYLOAD), place


@pytest.mark.parametrize(
    "text",
    ["", "null", "3", "[]", "{}", '{"payload": 3, "sha256": "x"}', '{"payload": "{}"}',
     '{"payload": "\\ud800", "sha256": "x"}', "[" * 100_000],
)  # fmt: skip
def test_another_file_in_the_place_of_an_entry_is_no_entry(tmp_path: Path, text: str) -> None:
    (tmp_path / f"{NAME}.json").write_text(text)
    assert cache.read(tmp_path, NAME) is None
    cache.write(tmp_path, NAME, PAYLOAD)
    assert cache.read(tmp_path, NAME) == PAYLOAD


def test_an_entry_moved_to_another_key_is_no_entry(tmp_path: Path) -> None:
    cache.write(tmp_path, NAME, PAYLOAD)
    (tmp_path / f"{NAME}.json").rename(tmp_path / "other.json")
    assert cache.read(tmp_path, "other") is None


def test_where_nothing_can_be_kept_nothing_is(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    (tmp_path / f"{NAME}.json").mkdir()
    for place in (tmp_path / "file", tmp_path / "file" / "below", tmp_path, Path("/proc/derive")):
        cache.write(place, NAME, PAYLOAD)
        assert cache.read(place, NAME) is None
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"{NAME}.json", "file"]


def test_processes_that_write_one_entry_at_once_never_show_half_of_it(tmp_path: Path) -> None:
    script = (
        "import sys; from pathlib import Path; from derive import cache\n"
        f"for i in range(200): cache.write(Path(sys.argv[1]), {NAME!r}, ['x' * 50_000])"
    )
    command = [sys.executable, "-c", script, str(tmp_path)]
    writers = [subprocess.Popen(command, cwd=ROOT) for _ in range(2)]
    seen = set()
    while any(writer.poll() is None for writer in writers):
        seen.add(json.dumps(cache.read(tmp_path, NAME)))
    assert [writer.returncode for writer in writers] == [0, 0]
    whole = json.dumps(["x" * 50_000])
    assert seen - {"null"} == {whole}
    assert json.dumps(cache.read(tmp_path, NAME)) == whole
    assert len(list(tmp_path.iterdir())) == 1


@pytest.mark.parametrize(
    "change", [{"name": "other"}, {"pattern": (False, True)}, {"pattern": (True,)}, {"more": 1}]
)
def test_the_key_depends_on_every_part(change: dict[str, object]) -> None:
    assert cache.key(**PARTS) == cache.key(**PARTS)
    assert cache.key(**PARTS) != cache.key(**{**PARTS, **change})


@pytest.mark.parametrize("library", cache.LIBRARIES)
def test_the_key_depends_on_the_libraries(library: str, monkeypatch: pytest.MonkeyPatch) -> None:
    before, release = cache.key(**PARTS), cache.release
    assert metadata.version(library) in release(library)
    monkeypatch.setattr(cache, "release", lambda name: release(name) + ".1" * (name == library))
    assert cache.key(**PARTS) != before


def test_the_key_depends_on_our_version(monkeypatch: pytest.MonkeyPatch) -> None:
    before = cache.key(**PARTS)
    monkeypatch.setattr(cache, "__version__", "0")
    assert cache.key(**PARTS) != before


def test_the_key_depends_on_every_source_that_derives(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = ROOT / "derive"
    sources = [
        path
        for part in ("lie", "routine", "control", "emit")
        for path in (root / part).glob("*.py")
    ]
    sources.append(root / "pipeline.py")
    assert len(sources) > 15
    for source in sources:
        copy = tmp_path / source.relative_to(root)
        copy.parent.mkdir(exist_ok=True)
        copy.write_bytes(source.read_bytes())
    monkeypatch.setattr(cache, "__file__", str(tmp_path / "cache.py"))
    keys = {cache.key(**PARTS)}
    for source in sources:
        copy = tmp_path / source.relative_to(root)
        copy.write_bytes(copy.read_bytes()[:-1] + b" ")
        keys.add(cache.key(**PARTS))
    (tmp_path / "lie" / "new.py").touch()
    keys.add(cache.key(**PARTS))
    assert len(keys) == len(sources) + 2
