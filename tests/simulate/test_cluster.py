"""A Dask cluster that dies in the middle of a sweep: it is told, in bounded time."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from derive import campaign, crew
from derive.crew import let_go
from derive.simulate import cluster
from derive.simulate.cluster import Cluster
from derive.vehicle import InputError
from tests.simulate.crafts import asked, plan
from tests.simulate.dask import Dask
from tests.simulate.dask import cluster as a_cluster

PATIENCE = 2.0  # s


@pytest.fixture
def dask(tmp_path: Path) -> Iterator[Dask]:
    with a_cluster(tmp_path, 1) as made:
        yield made


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
            process = dask.scheduler if victim == "scheduler" else dask.workers[0]
            process.kill()

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
