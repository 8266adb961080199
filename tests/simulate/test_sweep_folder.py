"""A sweep's folder: what is kept there is flown on from, and what is damaged is flown again."""

from __future__ import annotations

import io
import os
import shutil
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive import campaign, folder
from derive.simulate.chunk import fly
from derive.simulate.executor import Alone
from derive.vehicle import InputError
from tests.simulate.sweeps import again, flown, opened, resumed


def test_a_full_disk_is_told_and_what_is_there_stays(
    truth: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain, written = folder.save_bytes, []

    def full(path: Path, data: bytes) -> None:
        if path.suffix == ".chunk":
            written.append(path)
            if len(written) == 3:
                raise OSError(28, os.strerror(28), str(path))
        plain(path, data)

    monkeypatch.setattr(folder, "save_bytes", full)
    with pytest.raises(InputError, match=r"No space left on device") as caught:
        flown(tmp_path / "out", Alone(), 16)
    assert "2 of 5 chunks are kept" in str(caught.value)
    assert "go on with --resume" in str(caught.value).splitlines()[-1]
    monkeypatch.undo()
    kept = sorted(path.name for path in (tmp_path / "out" / "chunks").iterdir())
    assert kept == ["00000.chunk", "00001.chunk"]
    assert resumed(tmp_path / "out", 16) == truth


def archive(**parts: Any) -> bytes:
    """An archive as numpy writes it."""
    buffer = io.BytesIO()
    np.savez(buffer, allow_pickle=False, **parts)
    return buffer.getvalue()


def array(value: Any) -> bytes:
    buffer = io.BytesIO()
    np.save(buffer, value)
    return buffer.getvalue()


def flipped(whole: bytes, place: float) -> bytes:
    """The same with one bit turned over."""
    at = int(place * len(whole))
    return whole[:at] + bytes([whole[at] ^ 4]) + whole[at + 1 :]


DAMAGES: dict[str, Callable[[bytes], bytes]] = {
    "empty": lambda whole: b"",
    "half": lambda whole: whole[: len(whole) // 2],
    "text": lambda whole: b"none",
    "no run": lambda whole: archive(seed=np.arange(16)),
    "run alone": lambda whole: archive(run=np.arange(16, 32)),
    "an array": lambda whole: array(np.arange(16, 32)),
    **{f"a bit at {place}": partial(flipped, place=place)
       for place in (0.0, 0.001, 0.01, 0.05, 0.3, 0.6, 0.9, 0.999)},
}  # fmt: skip


@pytest.fixture(scope="module")
def parts(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A sweep that has all its chunks and no results."""
    out = tmp_path_factory.mktemp("parts") / "out"
    campaign.flown(opened(out, 16), Alone(), len)
    return out


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_chunk_is_flown_again(
    damage: str, parts: Path, truth: bytes, tmp_path: Path
) -> None:
    out = shutil.copytree(parts, tmp_path / "out")
    place = out / "chunks" / "00001.chunk"
    place.write_bytes(DAMAGES[damage](place.read_bytes()))
    assert len(again(out, 16).kept) == 4
    assert resumed(out, 16) == truth


def test_a_chunk_of_other_runs_or_columns_or_a_folder_is_flown_again(
    parts: Path, truth: bytes, tmp_path: Path
) -> None:
    out = shutil.copytree(parts, tmp_path / "out")
    sweep, place = again(out, 16), out / "chunks"
    rows = fly(sweep.plan, *sweep.chunks[1])
    sweep.keep(sweep.chunks[0], rows)
    sweep.keep(sweep.chunks[1], {"run": rows["run"]})
    sweep.keep(sweep.chunks[2], {("cost" if k == "energy" else k): v for k, v in
                                 fly(sweep.plan, *sweep.chunks[2]).items()})  # fmt: skip
    (place / "00003.chunk").unlink()
    (place / "00003.chunk" / "mine").mkdir(parents=True)
    (place / "00004.chunk").unlink()
    (place / "00004.chunk").symlink_to("00000.chunk")
    assert again(out, 16).kept == []
    assert resumed(out, 16) == truth


def test_a_chunk_of_another_sweep_is_flown_again(parts: Path, truth: bytes, tmp_path: Path) -> None:
    other = opened(tmp_path / "other", 16, seed=4)
    other.keep(other.chunks[0], fly(other.plan, *other.chunks[0]))
    out = shutil.copytree(parts, tmp_path / "out")
    shutil.copy(tmp_path / "other" / "chunks" / "00000.chunk", out / "chunks")
    assert resumed(out, 16) == truth


def test_a_chunk_damaged_in_flight_is_no_hole_in_the_results(tmp_path: Path) -> None:
    sweep = opened(tmp_path / "out", 16)
    campaign.flown(sweep, Alone(), len)
    (tmp_path / "out" / "chunks" / "00002.chunk").write_bytes(b"")
    with pytest.raises(InputError, match="1 damaged"):
        sweep.rows()


@pytest.mark.parametrize(
    ("given", "key"),
    [({"settle": 0.5}, "settle"), ({"duration": 2.5}, r"setting.0.seconds"), ({"seed": 4}, "seed"),
     ({"inertia_error": 0.2}, r"spread.inertia")],
    ids=str,
)  # fmt: skip
def test_another_sweep_is_not_resumed(given: dict[str, Any], key: str, tmp_path: Path) -> None:
    opened(tmp_path / "out", 16)
    with pytest.raises(InputError, match=rf"sweep.json: {key}\n") as caught:
        resumed(tmp_path / "out", 16, **given)
    assert "as the sweep there has it" in str(caught.value)
