"""A sweep is the same bytes whoever flies it, in whatever chunks, after whatever went wrong."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive import campaign, crew, simulation
from derive.simulate import executor, table
from derive.simulate.chunk import Plan, Rows, columns, fly, fly_seeds
from derive.simulate.cluster import Cluster
from derive.simulate.executor import Alone, Chunk, Processes
from derive.simulate.summary import summary
from derive.simulate.sweep_picture import pictures
from derive.simulate.table import csv
from derive.vehicle import InputError
from tests.command import ROOT, derive
from tests.simulate.crafts import asked, plan, vehicle
from tests.simulate.dask import cluster, until
from tests.simulate.sweeps import RUNS, flown, said_of

SHORT = ("--duration", "1", "--rate", "20", "--rate", "30", "--noise-g", "0.001")
ERRORS = ("--inertia-error", "0.1", "--disturbance", "0.01")


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


def test_a_cluster_gives_the_same_even_if_a_worker_is_killed(truth: bytes, tmp_path: Path) -> None:
    with cluster(tmp_path, 2) as dask:
        killer = Killer(lambda: dask.workers[0].pid)
        crew = Cluster(dask.address, 20.0)
        assert flown(tmp_path / "out", crew, 5, killer) == truth
        assert killer.killed == dask.workers[0].pid
        assert dask.workers[0].wait(10) != 0


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


def test_a_run_is_replayed_by_its_seed(truth: bytes) -> None:
    lines = truth.decode().splitlines()
    names = lines[0].split(",")
    for line in (lines[1], lines[30], lines[-1]):
        row = dict(zip(names, line.split(","), strict=True))
        alone = plan(**{**said_of(8, {}), "rates": (float(row["rate"]),)})
        again = csv(fly_seeds(alone, [int(row["seed"])], int(row["run"]))).decode().splitlines()
        assert again == [lines[0], line]


def test_names_are_told_before_a_flight() -> None:
    for given in ({}, {"wave": (0.1,), "hertz": 1.0}):
        made = plan(**{**said_of(8, {}), **given})
        assert columns(made) == (*fly(made, 0, 3),)


def test_a_csv_is_read_as_it_was_written(truth: bytes) -> None:
    read = table.from_csv(truth)
    assert csv(read) == truth
    for name, values in fly(plan(**said_of(8, {})), 0, RUNS).items():
        assert read[name].dtype == values.dtype


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
    said = asked(backend=backend, duration=1.0, wave=(0.1,), hertz=0.5)
    row = fly(campaign.plan(vehicle("SO3"), None, said), 4, 5)
    given = {**said.given, "rate": said.rates[0]}
    seed = int(row["seed"][0])
    again = simulation.Asked(backend, seed, said.box, said.speed, given=given)
    flight = simulation.simulate(vehicle("SO3"), None, again).flight
    assert row["energy"][0] == flight.energy[-1]
    assert row["final_height"][0] == flight.height[-1]
    assert row["initial_height"][0] == flight.height[0]


@pytest.mark.parametrize(("group", "settle"), [("SO3", 0.3), ("R3", 1e-9)])
def test_pictures_are_drawn_of_any_outcome(group: str, settle: float) -> None:
    rows = fly(plan(group, settle=settle, duration=1.0, rates=(10.0,)), 0, 20)
    drawn = pictures(rows, "some", 1.0)
    assert {*drawn} == {f"{name}.{form}" for name in ("settling_time", "success_map")
                        for form in ("png", "svg")}  # fmt: skip
    assert drawn["success_map.png"].startswith(b"\x89PNG")
    assert drawn == pictures(rows, "some", 1.0)
    other = {**rows, "settled": ~rows["settled"], "settling_time": np.ones(20)}
    assert drawn["success_map.svg"] != pictures(other, "some", 1.0)["success_map.svg"]


def test_the_summary_is_what_the_rows_say() -> None:
    rows = fly(plan(settle=0.05, duration=6.5, rates=(10.0,)), 0, 30)
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
    assert csv(table.from_parquet(table.parquet(rows))) == truth
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
        until(lambda: list((tmp_path / "part" / "chunks").glob("*.chunk")))
        flying.send_signal(signal.SIGINT)
        _, said = flying.communicate(timeout=30)
    assert flying.returncode == 130
    assert "go on with --resume" in said
    kept = len(list((tmp_path / "part" / "chunks").glob("*.chunk")))
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


def test_missing_extras_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(crew, "find_spec", lambda name: None)
    assert crew.form_of(None) == "csv"
    with pytest.raises(InputError, match="pyarrow"):
        crew.form_of("parquet")
    with pytest.raises(InputError, match="gsmc-derive"):
        crew.hired("tcp://127.0.0.1:1", 1)
