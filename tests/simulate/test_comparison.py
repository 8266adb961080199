"""The comparison as commands call it: what is refused, what is written, and what docs say."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from derive import comparison, folder
from derive.comparison import Comparison, entered
from derive.simulate import claim_table, style
from derive.simulate.invariant import Invariant
from derive.simulate.scenario import ENTRANTS
from derive.vehicle import InputError, Vehicle, load
from tests.command import ROOT

DOCS = ROOT / "docs" / "simulations.md"
FILES = [f"scenario1{name}" for name in
         (".json", ".png", ".svg", "_s.png", "_s.svg", "_axis.png", "_axis.svg")]  # fmt: skip


def paper() -> Vehicle:
    return load(ROOT / "vehicles" / "paper_so3.toml")


@pytest.mark.parametrize("name", ["paper_s3", "freeflyer", "sl2"])
def test_another_group_is_refused(name: str) -> None:
    vehicle = load(ROOT / "vehicles" / f"{name}.toml")
    with pytest.raises(InputError, match="rotation matrix"):
        comparison.scenarios(vehicle, None, (1,), "numpy", lambda _: None)


def test_an_unknown_backend_is_refused() -> None:
    with pytest.raises(InputError, match="--backend"):
        comparison.scenarios(paper(), None, (1,), "f16", lambda _: None)


def only(compared: Comparison, number: int) -> Comparison:
    return replace(compared, flights={number: compared.flights[number]})


def test_without_matplotlib_numbers_are_given(
    compared: Comparison, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(style, "find_spec", lambda name: None)
    files = comparison.documents(only(compared, 1), lambda _: None)
    assert list(files) == ["scenario1.json", "claims.md"]


def test_all_files_are_written_or_none(compared: Comparison, tmp_path: Path) -> None:
    files = comparison.documents(only(compared, 1), lambda _: None)
    assert list(files) == [*FILES, "claims.md"]
    (tmp_path / "mine.txt").write_text("kept")
    folder.save_all(tmp_path, files)
    found = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert found == {**files, "mine.txt": b"kept"}
    (tmp_path / "claims.md").unlink()
    (tmp_path / "claims.md").mkdir()  # in the way
    with pytest.raises(IsADirectoryError):
        folder.save_all(tmp_path, dict.fromkeys(files, b"new"))
    assert {name: (tmp_path / name).read_bytes() for name in FILES} == {
        name: files[name] for name in FILES
    }
    assert not list(tmp_path.glob(".derive-*"))


def test_files_come_back_when_one_cannot_be_put(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder.save_all(tmp_path, {"a": b"old", "b": b"old"})
    rename, calls = Path.rename, []

    def failing(path: Path, to: Path) -> Path:
        calls.append(path)
        if path.parent.name == "new" and path.name == "b" and len(calls) < 6:
            raise OSError(28, "No space left on device")
        return rename(path, to)

    monkeypatch.setattr(Path, "rename", failing)
    with pytest.raises(OSError, match="No space"):
        folder.save_all(tmp_path, {"a": b"new", "b": b"new"})
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {
        "a": b"old", "b": b"old",
    }  # fmt: skip


def test_the_paper_enters_with_its_own_gains() -> None:
    for entrant in ENTRANTS.values():
        made = entered(paper(), entrant, "f64")
        assert made.gains == tuple((name, Fraction(x)) for name, x in entrant.gains)
        assert (made.controller, made.law) == (entrant.controller, entrant.law)


def test_a_vehicle_keeps_its_gains_and_law_and_scales_those_of_a_force() -> None:
    twice = tuple(tuple(2 * x for x in row) for row in paper().inertia)
    own = replace(paper(), law="mrp", gains=(("lambda", Fraction(2)), ("k_s", Fraction(3))),
                  inertia=twice)  # fmt: skip
    made = {name: entered(own, one, "f64") for name, one in ENTRANTS.items()}
    assert (made["gsmc"].law, made["gsmc"].gains) == ("mrp", own.gains)
    assert made["lsf"].gains == (("k", Fraction(1)), ("kappa", Fraction(1, 2)))
    assert made["pd_plus"].gains == (("k_R", Fraction("18.5")), ("k_Omega", Fraction(37)))


def test_another_body_is_told(compared: Comparison) -> None:
    crafts = tuple(replace(one, inertia=(3.0, *one.inertia[1:])) for one in compared.crafts)
    assert (
        "not the paper's body and controllers: inertia" in replace(compared, crafts=crafts).table()
    )
    assert "not the paper's" not in compared.table()


def test_a_broken_invariant_is_told(compared: Comparison) -> None:
    assert compared.ok
    watched = {n: dict(each) for n, each in compared.watched.items()}
    broken = Invariant("no state is refused", 3.0, 0.0)
    watched[3]["pd_plus"] = (*watched[3]["pd_plus"][:-1], broken)
    found = replace(compared, watched=watched)
    assert not found.ok
    assert "scenario 3, PD+: no state is refused BROKEN, 3, at most 0" in found.table()
    assert (
        json.loads(found.as_json(3))["controllers"]["pd_plus"]["invariants"][-1]["verdict"]
        == "BROKEN"
    )


def test_the_paper_keeps_every_invariant(compared: Comparison) -> None:
    for each in compared.watched.values():
        for name, found in each.items():
            assert [one.verdict for one in found][1:] == ["holds"] * 3
            assert found[0].verdict == "holds" or name != "gsmc"


def test_the_tables_of_the_documents_are_the_measured_ones(compared: Comparison) -> None:
    """`python -m bench.scenarios` writes it."""
    assert claim_table.markdown(compared.claims) in DOCS.read_text(encoding="utf-8")
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert claim_table.brief(compared.claims) in readme


def test_every_table_says_which_form_of_lsf_it_judges(compared: Comparison) -> None:
    assert {one.claim.name for one in compared.claims if one.differs} == {
        "equal energy",
        "together",
    }
    head, _, *rows = claim_table.brief(compared.claims).splitlines()
    assert "LSF as printed" in head
    assert "LSF as printed" in claim_table.markdown(compared.claims).splitlines()[0]
    assert "LSF as printed" in claim_table.text(compared.claims).splitlines()[0]
    for one, row in zip(compared.claims, rows, strict=True):
        other = f"{one.printed.verdict}; with LSF corrected: {one.corrected.verdict} |"
        assert row.endswith(other if one.differs else f"| {one.printed.verdict} |")


@pytest.mark.parametrize("name", ["scenario1.svg", "scenario1_s.svg", "scenario1_axis.svg"])
def test_the_documents_pictures_are_there(name: str) -> None:
    assert (ROOT / "docs" / name).stat().st_size > 10_000
    assert f"]({name})" in DOCS.read_text(encoding="utf-8")
