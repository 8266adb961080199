"""A sweep is the same bytes whoever flies it, in whatever chunks, after whatever went wrong."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive import campaign, crew, folder, simulation
from derive.crew import let_go
from derive.simulate import executor, table
from derive.simulate.chunk import Plan, Rows, fly, fly_seeds
from derive.simulate.cluster import Cluster
from derive.simulate.executor import Alone, Chunk, Crew, Processes
from derive.simulate.summary import summary
from derive.simulate.sweep_picture import pictures
from derive.simulate.table import csv
from derive.vehicle import InputError
from tests.command import ROOT, derive
from tests.simulate.crafts import asked, plan, vehicle

RUNS = 70
BRIEF = 0.4  # s, of every run
SHORT = ("--duration", "1", "--rate", "20", "--rate", "30", "--noise-g", "0.001")
ERRORS = ("--inertia-error", "0.1", "--disturbance", "0.01")


def opened(out: Path, chunk: int = 8, **given: Any) -> campaign.Sweep:
    """A new sweep of numpy loops on SO(3), at two rates and with noise."""
    said = said_of(chunk, given)
    return campaign.opened(plan(**said), asked(**said), out, "csv", False)


def said_of(chunk: int, given: dict[str, Any]) -> dict[str, Any]:
    plain = {"runs": RUNS, "rates": (20.0, 30.0), "noise_g": 0.001, "seconds": BRIEF}
    return {**plain, "chunk": chunk, **given}


def flown(out: Path, crew: Crew, chunk: int = 8, told: Callable[[str], object] = len) -> bytes:
    """The bytes of the result."""
    sweep = opened(out, chunk)
    with let_go(crew):
        rows = campaign.flown(sweep, crew, told)
    sweep.finish(rows)
    assert sweep.results.read_bytes() == csv(rows)
    return csv(rows)


@pytest.fixture(scope="module")
def truth(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """The sweep flown in one piece."""
    return flown(tmp_path_factory.mktemp("truth") / "out", Alone(), chunk=RUNS)


class Killer:
    """Kills one process, for good, as soon as the first chunk has come back."""

    def __init__(self, victim: Callable[[], int]) -> None:
        self.victim, self.killed = victim, 0

    def __call__(self, doing: str) -> None:
        if "left" in doing and not self.killed:
            self.killed = self.victim()
            os.kill(self.killed, signal.SIGKILL)


@pytest.mark.parametrize("chunk", [7, 64])
def test_chunks_do_not_matter(chunk: int, truth: bytes, tmp_path: Path) -> None:
    assert flown(tmp_path / "out", Alone(), chunk) == truth


def test_local_workers_do_not_matter_even_if_one_is_killed(truth: bytes, tmp_path: Path) -> None:
    crew = Processes(2)
    killer = Killer(lambda: next(iter(vars(crew)["_pool"]._processes)))
    assert flown(tmp_path / "out", crew, 7, killer) == truth
    assert killer.killed


@pytest.fixture
def cluster() -> Iterator[Any]:
    """A Dask cluster of two worker processes on this machine."""
    from distributed import LocalCluster

    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, host="127.0.0.1"
    ) as made:
        yield made


def test_a_cluster_gives_the_same_even_if_a_worker_is_killed(
    cluster: Any, truth: bytes, tmp_path: Path
) -> None:
    killer = Killer(lambda: int(next(iter(cluster.workers.values())).pid))
    crew = Cluster(cluster.scheduler_address)
    before = {one.pid for one in cluster.workers.values()}
    assert flown(tmp_path / "out", crew, 5, killer) == truth
    assert killer.killed in before


class Lossy:
    """A crew that loses every chunk, or each one once."""

    lost: tuple[type[BaseException], ...] = (ConnectionError,)
    size = 2

    def __init__(self, losses: float) -> None:
        self.left, self.renewed = losses, 0
        self.ended: bool | None = None

    def submit(self, plan: Plan, chunk: Chunk) -> Any:
        return Lent(self, plan, chunk)

    def first(self, futures: Sequence[Any]) -> Sequence[Any]:
        return futures[-1:]

    def renew(self) -> None:
        self.renewed += 1

    def close(self, is_done: bool) -> None:
        self.ended = is_done


class Lent:
    def __init__(self, crew: Lossy, plan: Plan, chunk: Chunk) -> None:
        self.crew, self.plan, self.chunk = crew, plan, chunk

    def result(self) -> Rows:
        if self.crew.left > 0:
            self.crew.left -= 1
            raise ConnectionError("gone")
        return fly(self.plan, *self.chunk)


def test_what_is_lost_is_flown_again(truth: bytes, tmp_path: Path) -> None:
    crew = Lossy(executor.FRUITLESS - 1)
    assert flown(tmp_path / "out", crew, 16) == truth
    assert (crew.renewed, crew.ended) == (executor.FRUITLESS - 1, True)


def test_a_crew_that_comes_to_nothing_is_given_up(tmp_path: Path) -> None:
    crew = Lossy(np.inf)
    with pytest.raises(InputError, match=r"0 of 5 chunks are kept") as caught:
        flown(tmp_path / "out", crew, 16)
    assert "--resume" in str(caught.value)
    assert crew.ended is False
    assert crew.renewed < 10


def test_a_full_disk_is_told_and_what_is_there_stays(
    truth: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain, written = folder.save_bytes, []

    def full(path: Path, data: bytes) -> None:
        if path.suffix == ".npz":
            written.append(path)
            if len(written) == 3:
                raise OSError(28, os.strerror(28), str(path))
        plain(path, data)

    monkeypatch.setattr(folder, "save_bytes", full)
    with pytest.raises(InputError, match=r"No space left on device"):
        flown(tmp_path / "out", Alone(), 16)
    monkeypatch.undo()
    kept = sorted(path.name for path in (tmp_path / "out" / "chunks").iterdir())
    assert kept == ["00000.npz", "00001.npz"]
    assert resumed(tmp_path / "out", 16) == truth


def resumed(out: Path, chunk: int, **given: Any) -> bytes:
    said = said_of(chunk, given)
    sweep = campaign.opened(plan(**said), asked(**said), out, "csv", True)
    rows = campaign.flown(sweep, Alone(), len)
    sweep.finish(rows)
    return sweep.results.read_bytes()


def test_a_damaged_chunk_is_flown_again(truth: bytes, tmp_path: Path) -> None:
    sweep = opened(tmp_path / "out", 16)
    for number, chunk in enumerate(sweep.chunks):
        sweep.keep(chunk, fly(sweep.plan, *chunk))
        place = tmp_path / "out" / "chunks" / f"{number:05}.npz"
        whole = place.read_bytes()
        place.write_bytes((whole, b"", whole[: len(whole) // 2], b"none", whole)[number])
    sweep.keep(sweep.chunks[4], fly(sweep.plan, *sweep.chunks[0]))
    assert resumed(tmp_path / "out", 16) == truth


@pytest.mark.parametrize(
    ("given", "key"),
    [({"settle": 0.5}, "settle"), ({"seconds": 2.5}, r"setting.0.seconds"), ({"seed": 4}, "seed"),
     ({"inertia_error": 0.2}, r"spread.inertia")],
    ids=str,
)  # fmt: skip
def test_another_sweep_is_not_resumed(given: dict[str, Any], key: str, tmp_path: Path) -> None:
    opened(tmp_path / "out", 16)
    with pytest.raises(InputError, match=rf"sweep.json: {key}\n") as caught:
        resumed(tmp_path / "out", 16, **given)
    assert "as the sweep there has it" in str(caught.value)


def test_a_run_is_replayed_by_its_seed(truth: bytes) -> None:
    lines = truth.decode().splitlines()
    names = lines[0].split(",")
    for line in (lines[1], lines[30], lines[-1]):
        row = dict(zip(names, line.split(","), strict=True))
        alone = plan(**{**said_of(8, {}), "rates": (float(row["rate"]),)})
        again = csv(fly_seeds(alone, [int(row["seed"])], int(row["run"]))).decode().splitlines()
        assert again == [lines[0], line]


def test_numbers_are_read_back_exactly(truth: bytes) -> None:
    rows = fly(plan(**said_of(8, {})), 0, RUNS)
    names, *lines = (line.split(",") for line in truth.decode().splitlines())
    assert names == [*rows]
    for name, column in zip(names, zip(*lines, strict=True), strict=True):
        kind = rows[name].dtype
        words = ["nan" if word == "" else word for word in column]
        read = np.array([float(word) if kind == np.float64 else int(word) for word in words])
        np.testing.assert_array_equal(read.astype(kind), rows[name], name)
    assert "" in dict(zip(names, zip(*lines, strict=True), strict=True))["settling_time"]


@pytest.mark.parametrize("backend", ["numpy", "f64"])
def test_derive_simulate_flies_the_run_of_a_seed(backend: str) -> None:
    said = asked(backend=backend, seconds=1.0, wave=(0.1,), hertz=0.5)
    row = fly(campaign.plan(vehicle("SO3"), None, said), 4, 5)
    given = {**said.given, "rate": said.rates[0]}
    seed = int(row["seed"][0])
    again = simulation.Asked(backend, seed, said.box, said.speed, given)
    flight = simulation.simulate(vehicle("SO3"), None, again).flight
    assert row["energy"][0] == flight.energy[-1]
    assert row["final_height"][0] == flight.height[-1]
    assert row["initial_height"][0] == flight.height[0]


@pytest.mark.parametrize(("group", "settle"), [("SO3", 0.3), ("R3", 1e-9)])
def test_pictures_are_drawn_of_any_outcome(group: str, settle: float) -> None:
    rows = fly(plan(group, settle=settle, seconds=1.0, rates=(10.0,)), 0, 20)
    drawn = pictures(rows, "some")
    assert {*drawn} == {f"{name}.{form}" for name in ("settling_time", "success_map")
                        for form in ("png", "svg")}  # fmt: skip
    assert drawn["success_map.png"].startswith(b"\x89PNG")
    assert drawn == pictures(rows, "some")
    other = {**rows, "settled": ~rows["settled"], "settling_time": np.ones(20)}
    assert drawn["success_map.svg"] != pictures(other, "some")["success_map.svg"]


def test_the_summary_is_what_the_rows_say() -> None:
    rows = fly(plan(settle=0.05, seconds=6.5, rates=(10.0,)), 0, 30)
    found, settled = summary(rows), rows["settled"]
    assert 0 < settled.sum() < 30
    assert found["share_settled"] == pytest.approx(settled.mean())
    times = sorted(rows["settling_time"][settled])
    assert found["quantiles"]["settling_time"][1] == pytest.approx(np.median(times))
    assert found["quantiles"]["energy"][2] == pytest.approx(np.percentile(rows["energy"], 95))
    assert found["slowest"]["settling_time"] == times[-1]
    assert [one["run"] for one in found["failed"]] == np.flatnonzero(~settled)[:5].tolist()
    assert found["crossings"] == rows["crossings"].sum()


def test_parquet_holds_what_csv_holds(truth: bytes, tmp_path: Path) -> None:
    from pyarrow import parquet

    rows = fly(plan(**said_of(8, {})), 0, RUNS)
    assert table.parquet(rows) == table.parquet(rows)
    (tmp_path / "rows.parquet").write_bytes(table.parquet(rows))
    read = parquet.read_table(tmp_path / "rows.parquet").to_pydict()
    assert csv({name: np.array(values) for name, values in read.items()}) == truth


def test_the_command_interrupted_and_resumed(tmp_path: Path) -> None:
    plain = ("sweep", str(ROOT / "vehicles" / "paper_so3.toml"), "--runs", "240", *SHORT, *ERRORS,
             "--chunk", "12", "--format", "csv", "--no-cache", "--out")  # fmt: skip
    whole = derive(tmp_path, *plain, "whole", "--workers", "2")
    assert whole.returncode == 0, whole.stderr
    assert "settled" in whole.stdout
    assert "derive simulate" in whole.stdout
    assert whole.stderr == ""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-m", "derive", *plain, "part", "--workers", "1"]
    with subprocess.Popen(command, cwd=tmp_path, env=environment, stderr=subprocess.PIPE,
                          stdout=subprocess.DEVNULL, text=True) as flying:  # fmt: skip
        until(lambda: list((tmp_path / "part" / "chunks").glob("*.npz")))
        flying.send_signal(signal.SIGINT)
        _, said = flying.communicate(timeout=30)
    assert flying.returncode == 130
    assert "go on with --resume" in said
    kept = len(list((tmp_path / "part" / "chunks").glob("*.npz")))
    assert 1 <= kept < 20
    assert not list((tmp_path / "part").glob("results.*"))
    assert not list(tmp_path.rglob(".derive-*"))
    again = derive(tmp_path, *plain, "part", "--workers", "1", "--resume")
    assert again.returncode == 0, again.stderr
    for name in ("results.csv", "summary.json", "success_map.png", "settling_time.svg"):
        same = [(tmp_path / folder / name).read_bytes() for folder in ("whole", "part")]
        assert same[0] == same[1], name
    assert not (tmp_path / "part" / "chunks").exists()
    found = json.loads((tmp_path / "part" / "summary.json").read_text())
    assert found["runs"] == 240


def until(is_so: Callable[[], object], seconds: float = 40.0) -> None:
    end = time.monotonic() + seconds
    while not is_so():
        assert time.monotonic() < end
        time.sleep(0.01)


def test_missing_extras_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(crew, "find_spec", lambda name: None)
    assert crew.form_of(None) == "csv"
    with pytest.raises(InputError, match="pyarrow"):
        crew.form_of("parquet")
    with pytest.raises(InputError, match="gsmc-derive"):
        crew.hired("tcp://127.0.0.1:1", 1)
