"""The route to disk: the same bytes whatever the seed, the cache and the company."""

import os
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from derive import folder, pipeline
from derive.evidence.stamp import PAGE
from derive.vehicle import InputError, Vehicle, load

ROOT = Path(__file__).parents[1]
FILES = sorted((ROOT / "vehicles").glob("*.toml"))
BODY = load(ROOT / "vehicles" / "paper_so3.toml")
GENERATED = ROOT / "generated"
WARNED = [
    f"warning: {of}" for of in ("paper_s3", "paper_so3_lsf, paper_so3_lsf_printed", "quadrotor")
]


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A cache that holds BODY."""
    place = tmp_path_factory.mktemp("cache")
    pipeline.texts(BODY, place)
    return place


def start(out: Path, home: Path, seed: str, *options: str) -> subprocess.Popen[str]:
    """A whole process that emits every vehicle."""
    environment = {**os.environ, "HOME": str(home), "PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-m", "derive", "emit", *map(str, FILES), "--out", str(out)]
    return subprocess.Popen(
        [*command, *options], env=environment, stderr=subprocess.PIPE, stdout=subprocess.PIPE,
        text=True, cwd=home,
    )  # fmt: skip


def ended(process: subprocess.Popen[str]) -> str:
    output, errors = process.communicate(timeout=120)
    told = [line.partition(": law ")[0] for line in errors.splitlines()]
    assert (process.returncode, told) == (0, WARNED)
    return output


def committed() -> dict[str, str]:
    """All that is derived: evidence is measured."""
    found = folder.read(GENERATED)
    return {path: text for path, text in found.items() if Path(path).name != PAGE}


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_generated_is_what_the_vehicle_files_give(file: Path, tmp_path: Path) -> None:
    """As it is derived, and as it is kept from then on."""
    for _ in range(2):
        (_, drifts), = pipeline.check([load(file)], GENERATED, tmp_path)  # fmt: skip
        assert drifts == []
        assert list(tmp_path.iterdir())


def test_generated_holds_nothing_else() -> None:
    assert sorted(path.name for path in GENERATED.iterdir()) == sorted(
        load(file).name for file in FILES
    )
    assert [file.stem for file in FILES] == [load(file).name for file in FILES]


@pytest.mark.parametrize("seed", ["0", "random"])
def test_bytes_do_not_depend_on_the_hash_seed(tmp_path: Path, seed: str) -> None:
    ended(start(tmp_path / "out", tmp_path, seed, "--no-cache"))
    assert folder.read(tmp_path / "out") == committed()
    assert not (tmp_path / ".cache").exists()


def test_two_processes_at_once_write_what_one_does(tmp_path: Path) -> None:
    for _ in range(2):  # into an empty cache, then from a full one over what is there
        both = [start(tmp_path / "out", tmp_path, "random") for _ in range(2)]
        for process in both:
            ended(process)
        assert folder.read(tmp_path / "out") == committed()
        (tmp_path / "out" / BODY.name / "trace.csv").unlink()


def test_the_cache_changes_no_byte(kept: Path) -> None:
    assert pipeline.texts(BODY, kept) == pipeline.texts(BODY)


def test_new_numbers_derive_nothing(kept: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    heavier = tuple(tuple(2 * entry for entry in row) for row in BODY.inertia)
    gains = tuple((name, 3 * value) for name, value in BODY.gains)
    other = replace(BODY, inertia=heavier, gains=gains)
    plain = pipeline.texts(other)
    monkeypatch.delattr(pipeline, "derived")
    assert pipeline.texts(other, kept) == plain
    assert plain != pipeline.texts(BODY, kept)


@pytest.mark.parametrize(
    "change",
    [
        {"name": "other"},
        {"law": "lee"},
        {"controller": "reaching"},
        {"inertia": tuple(tuple(Fraction(i == j) for j in range(3)) for i in range(3))},
    ],
    ids=lambda change: next(iter(change)),
)
def test_what_moves_the_derivation_is_derived_anew(kept: Path, change: dict[str, object]) -> None:
    other = replace(BODY, **change)  # type: ignore[arg-type]
    assert pipeline.texts(other, kept) == pipeline.texts(other)


def damages(whole: bytes) -> Iterator[bytes]:
    yield b""
    yield whole[: len(whole) // 2]
    yield whole.replace(b"nu_e_0", b"nu_e_1", 1)
    yield b'{"payload": "{}", "sha256": "0"}'


def test_a_damaged_entry_is_derived_anew_and_mended(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = pipeline.texts(BODY, tmp_path)
    (entry,) = tmp_path.iterdir()
    whole = entry.read_bytes()
    data = pipeline.derived(BODY)
    calls: list[Vehicle] = []

    def derived(vehicle: Vehicle) -> pipeline.Printed:
        calls.append(vehicle)
        return data

    monkeypatch.setattr(pipeline, "derived", derived)
    for number, damaged in enumerate(damages(whole), 1):
        assert damaged != whole
        entry.write_bytes(damaged)
        assert pipeline.texts(BODY, tmp_path) == plain
        assert len(calls) == number
        assert entry.read_bytes() == whole


def test_a_cache_that_cannot_be_kept_is_done_without(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    assert pipeline.texts(BODY, tmp_path / "file") == pipeline.texts(BODY)


def test_a_body_that_cannot_be_is_refused_from_the_cache_too(kept: Path) -> None:
    thin = tuple(tuple(x if i != j or i else 100 * x for j, x in enumerate(row))
                 for i, row in enumerate(BODY.inertia))  # fmt: skip
    for place in (kept, None):
        with pytest.raises(InputError, match="principal moments"):
            pipeline.texts(replace(BODY, inertia=thin), place)


def test_nothing_is_written_unless_all_can_be(tmp_path: Path, kept: Path) -> None:
    unknown = replace(BODY, name="unknown", law="logg")
    twin = replace(BODY, name=BODY.name.upper(), source="other.toml")
    for other, told in ((unknown, "logg"), (BODY, "name"), (twin, "capitals")):
        with pytest.raises(InputError, match=told):
            pipeline.emit([BODY, other], tmp_path / "out", kept)
        assert not (tmp_path / "out").exists()


def test_scalars_and_targets_choose_files(kept: Path) -> None:
    everything = pipeline.texts(BODY, kept)
    numpy = pipeline.texts(replace(BODY, targets=("numpy",), scalars=("f64",)), kept)
    single = pipeline.texts(replace(BODY, targets=("c99",), scalars=("f32",)), kept)
    kinds = [{path.partition("/")[0] for path in texts} for texts in (numpy, single)]
    shared = {"trace.csv", "MANIFEST.toml"}
    assert kinds == [
        shared | {"numpy"},
        shared | {"c", "example", "test", "CMakeLists.txt", "DEVIATIONS.md", "paper_so3.mk"},
    ]
    assert all("f64" not in path for path in single)
    code = [path for path in {**numpy, **single} if path.startswith(("c/", "numpy/"))]
    assert len(code) == 3
    for path in code:
        assert everything[path] == {**numpy, **single}[path]


def test_the_cache_is_in_the_home_of_the_user(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    assert pipeline.cache_folder() == tmp_path / ".cache" / "derive"

    def homeless() -> Path:
        raise RuntimeError

    monkeypatch.setattr(Path, "home", homeless)
    assert pipeline.cache_folder() is None
