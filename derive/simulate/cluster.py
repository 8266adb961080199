"""A crew of another make: the workers of a Dask cluster."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from time import monotonic
from typing import Any

from derive.simulate.chunk import Plan, fly
from derive.simulate.executor import Chunk, WorkersLost

SCHEMES = ("tcp", "tls")
LOOK = 1.0  # s between two looks at who is left


class Cluster:
    """Workers of a Dask cluster, whose scheduler is at an address.

    patience: seconds without any worker after which nobody is waited for
    """

    size = 1

    def __init__(self, address: str, seconds: float = 5.0, patience: float = 30.0) -> None:
        """Raises ValueError for what is no address, OSError where no scheduler with a worker is."""
        from distributed import Client
        from distributed.client import FutureCancelledError, FuturesCancelledError
        from distributed.comm.core import CommClosedError
        from distributed.scheduler import KilledWorker

        self.lost: tuple[type[BaseException], ...] = (
            *(KilledWorker, CommClosedError),
            *(FutureCancelledError, FuturesCancelledError),
        )
        check_address(address)
        logging.getLogger("distributed.client").setLevel(logging.CRITICAL)  # what it tells, we tell
        self._patience = patience
        self._client = Client(address, timeout=seconds, set_as_default=False)
        try:
            self._client.wait_for_workers(1, timeout=seconds)
        except BaseException:
            self._client.close()
            raise
        self.size = max(1, sum(self._client.ncores().values()))

    def submit(self, plan: Plan, chunk: Chunk) -> Any:
        """A future of the cluster, which itself starts a lost chunk anew."""
        return self._client.submit(fly, plan, *chunk, pure=False, retries=2)

    def first(self, futures: Sequence[Any]) -> Sequence[Any]:
        """Those that are done. Raises WorkersLost where nobody is left to do one."""
        from distributed import TimeoutError as NotYet
        from distributed import wait as awaited

        deserted = None
        while True:
            try:
                with self._client.as_current():
                    done = awaited(list(futures), LOOK, "FIRST_COMPLETED").done
                return [one for one in futures if one in done]
            except NotYet:
                deserted = None if self._client.nthreads() else deserted or monotonic()
            if deserted and monotonic() - deserted > self._patience:
                raise WorkersLost(f"no worker was left for {self._patience:g} s")

    def renew(self) -> None:
        """Wait for new workers; raises WorkersLost when there are none."""
        try:
            self._client.wait_for_workers(1, timeout=self._patience)
        except (OSError, ValueError, RuntimeError) as fault:
            raise WorkersLost("no worker is left, or the scheduler is gone") from fault

    def close(self, is_done: bool) -> None:
        """Forget what was asked for."""
        self._client.close()


def check_address(address: str) -> None:
    """Raise ValueError for what no scheduler can be at."""
    from distributed.comm.addressing import parse_address, parse_host_port

    scheme, place = parse_address(address)
    if scheme not in SCHEMES:
        raise ValueError("not tcp://HOST:PORT, tls://HOST:PORT or HOST:PORT")
    host, _ = parse_host_port(place)
    if not host:
        raise ValueError("it names no host")
