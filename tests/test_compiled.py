"""Compiled templates are kept whole or not at all, and never change what is rendered."""

from __future__ import annotations

from pathlib import Path

import jinja2
import pytest

from derive import cache
from derive.compiled import Compiled

TEXT = "{% for i in range(3) %}{{ i }}{% endfor %}"


def rendered(folder: Path, text: str = TEXT) -> str:
    loader = jinja2.DictLoader({"one": text})
    return (
        jinja2.Environment(loader=loader, bytecode_cache=Compiled(folder))
        .get_template("one")
        .render()
    )


def entry(folder: Path) -> Path:
    (found,) = folder.iterdir()
    return found


def test_what_is_kept_is_compiled_no_more(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert rendered(tmp_path) == "012"
    assert entry(tmp_path).name.startswith("template-")
    monkeypatch.setattr(jinja2.Environment, "_generate", None)
    assert rendered(tmp_path) == "012"


def test_another_text_is_compiled_anew(tmp_path: Path) -> None:
    rendered(tmp_path)
    assert rendered(tmp_path, "another") == "another"
    assert rendered(tmp_path) == "012"
    assert len(list(tmp_path.iterdir())) == 1


def test_another_jinja_has_entries_of_its_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rendered(tmp_path)
    monkeypatch.setattr(cache, "release", lambda library: f"{library} 99")
    rendered(tmp_path)
    assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.parametrize("share", [0.0, 0.3, 0.9])
def test_a_damaged_entry_is_none(tmp_path: Path, share: float) -> None:
    rendered(tmp_path)
    whole = entry(tmp_path).read_bytes()
    place = int(share * len(whole))
    entry(tmp_path).write_bytes(whole[:place] + bytes([whole[place] ^ 1]) + whole[place + 1 :])
    assert rendered(tmp_path) == "012"
    assert entry(tmp_path).read_bytes() == whole


def test_where_nothing_can_be_kept_nothing_is(tmp_path: Path) -> None:
    place = tmp_path / "file"
    place.write_text("", encoding="utf-8")
    assert rendered(place) == "012"
    assert place.read_text(encoding="utf-8") == ""
