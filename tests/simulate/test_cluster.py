"""A Dask cluster that dies in the middle of a sweep: it is told, in bounded time."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from derive import campaign, crew
from derive.crew import let_go
from derive.simulate import cluster
from derive.simulate.cluster import Cluster
from derive.vehicle import InputError
from tests.command import ROOT
from tests.simulate.crafts import asked, plan

PATIENCE = 2.0  # s


class Dask:
    """A scheduler and a worker that nobody starts again, in processes of their own."""

    def __init__(self, folder: Path) -> None:
        self._folder, self._started = folder, list[subprocess.Popen[bytes]]()
        note = folder / "scheduler.json"
        self.scheduler = self._start("scheduler", "--port", "0", "--scheduler-file", str(note))
        until(note.exists)
        self.worker = self._start("worker", "--no-nanny", "--nthreads", "1",
                                  "--scheduler-file", str(note))  # fmt: skip
        text = note.read_text()
        self.address = text[text.index("tcp://") :].partition('"')[0]

    def _start(self, kind: str, *more: str) -> subprocess.Popen[bytes]:
        command = [sys.executable, "-m", f"distributed.cli.dask_{kind}", "--no-dashboard", *more,
                   "--host", "127.0.0.1"]  # fmt: skip
        environment = {**os.environ, "PYTHONPATH": str(ROOT)}
        log = (self._folder / f"{kind}.log").open("wb")
        made = subprocess.Popen(command, cwd=self._folder, env=environment, stdout=log, stderr=log)
        log.close()
        self._started.append(made)
        return made

    def end(self) -> None:
        for one in self._started:
            one.kill()
            one.wait()


def until(is_so: Callable[[], object], seconds: float = 40.0) -> None:
    end = time.monotonic() + seconds
    while not is_so():
        assert time.monotonic() < end
        time.sleep(0.02)


@pytest.fixture
def dask(tmp_path: Path) -> Iterator[Dask]:
    made = Dask(tmp_path)
    yield made
    made.end()


@pytest.mark.parametrize(
    ("victim", "said"), [("scheduler", "scheduler is gone"), ("worker", "no worker was left")]
)
def test_a_cluster_that_dies_is_told_and_what_came_back_is_kept(
    victim: str, said: str, dask: Dask, tmp_path: Path
) -> None:
    given: dict[str, Any] = {"runs": 400, "chunk": 4, "duration": 4.0}
    sweep = campaign.opened(plan(**given), asked(**given), tmp_path / "out", "csv", False)
    ended: list[float] = []

    def kill(doing: str) -> None:
        if "left" in doing and not ended:
            ended.append(time.monotonic())
            os.kill(getattr(dask, victim).pid, signal.SIGKILL)

    hands = Cluster(dask.address, 20.0, PATIENCE)
    with pytest.raises(InputError, match="of 100 chunks are kept") as caught, let_go(hands):
        campaign.flown(sweep, hands, kill)
    assert time.monotonic() - ended[0] < PATIENCE + 120
    assert 1 <= len(sweep.kept) < 100
    assert all(part in str(caught.value) for part in ("--cluster", said, "--resume")), caught.value


@pytest.mark.parametrize("address", ["nonsense", "http://foo:bar", ""])
def test_nobody_is_called_at_what_is_no_address(
    address: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    import distributed

    called: list[str] = []
    monkeypatch.setattr(distributed, "Client", called.append)
    with pytest.raises(InputError, match="--cluster"):
        crew.hired(address, 1)
    assert called == []


@pytest.mark.parametrize("address", ["tcp://10.0.0.1:8786", "tls://host:1", "host:1", "[::1]:1"])
def test_an_address_is_taken_as_dask_takes_it(address: str) -> None:
    cluster.check_address(address)
