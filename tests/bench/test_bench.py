"""The table of `python -m bench`: figures keep their limits, and what exceeds one is said."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from bench import __main__ as bench
from bench import size, throughput
from bench.figure import Figure


def run(monkeypatch: pytest.MonkeyPatch, figures: list[Figure], *arguments: str) -> int:
    monkeypatch.setattr(bench, "PARTS", {"one": lambda folder: figures})
    monkeypatch.setattr(sys, "argv", ["bench", *arguments])
    return bench.main()


@pytest.mark.parametrize(("value", "code", "word"), [(0.15, 0, "ok"), (0.151, 1, "EXCEEDED")])
def test_a_limit_decides_the_exit_code(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    value: float,
    code: int,
    word: str,
) -> None:
    figures = [Figure("help", value, "s"), Figure("help", 900, "bytes")]
    file = tmp_path / "figures.json"
    assert run(monkeypatch, figures, "--json", str(file)) == code
    first, second = capsys.readouterr().out.splitlines()
    assert first.endswith(f"at most 0.15: {word}")
    assert "at most" not in second
    found = [(one["value"], one["limit"]) for one in json.loads(file.read_text())]
    assert found == [(value, 0.15), (900, None)]


def test_an_unknown_part_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(SystemExit) as refused:
        run(monkeypatch, [], "none")
    assert refused.value.code == 2


def test_sizes_and_operations_are_found(tmp_path: Path) -> None:
    figures = {(one.name, one.unit): one.value for one in size.measure(tmp_path)}
    whole = figures["paper_so3 f64, all code", "bytes"]
    parts = [v for (name, unit), v in figures.items() if name.startswith("paper_so3 f64 ")]
    assert whole == sum(parts) > 1000
    assert {"tracking", "law", "control"} <= {name.split()[-1] for name, _ in figures}
    assert 100 < figures["paper_so3 tracking", "operations"] < 400


def test_both_numpy_laws_agree_and_are_timed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(throughput, "ROWS", 500)
    figures = throughput.measure(tmp_path)
    assert all(figure.value > 0 for figure in figures)
    monkeypatch.setattr(throughput, "plain", lambda inertia, a, b, x: x["nu"])
    with pytest.raises(AssertionError):
        throughput.measure(tmp_path)
