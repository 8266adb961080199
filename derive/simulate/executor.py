"""Who flies the chunks: this process, processes of this machine, or another crew.

A chunk whose worker died is flown again, by whoever is there; only when several attempts in a
row come to nothing is it given up. What a chunk gives does not depend on who flew it.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from typing import Any, Protocol

from derive.simulate.chunk import Plan, Rows, fly
from derive.simulate.craft import forget

Chunk = tuple[int, int]
"""The first run and the one after the last."""

FRUITLESS = 4
"""Losses in a row, without a chunk that came back, after which a sweep is given up."""


class WorkersLost(Exception):
    """Workers die again and again, or the cluster is gone."""


class Crew(Protocol):
    """Takes chunks, and may lose them."""

    lost: tuple[type[BaseException], ...]
    size: int

    def submit(self, plan: Plan, chunk: Chunk) -> Any:
        """A future of the chunk's rows."""

    def first(self, futures: Sequence[Any]) -> Sequence[Any]:
        """Those that are done, at least one."""

    def renew(self) -> None:
        """Be ready again after a loss."""

    def close(self, is_done: bool) -> None:
        """Let go of the workers, at once where the work is not done."""


class Alone:
    """This process, a chunk at a time."""

    lost: tuple[type[BaseException], ...] = ()
    size = 1

    def submit(self, plan: Plan, chunk: Chunk) -> Any:
        """A call that is made when it is asked for."""
        return _Call(plan, chunk)

    def first(self, futures: Sequence[Any]) -> Sequence[Any]:
        """The oldest."""
        return futures[:1]

    def renew(self) -> None:
        """Nothing is ever lost."""

    def close(self, is_done: bool) -> None:
        """Nothing is held."""


class _Call:
    def __init__(self, plan: Plan, chunk: Chunk) -> None:
        self._given = plan, chunk

    def result(self) -> Rows:
        plan, chunk = self._given
        return fly(plan, *chunk)


class Processes:
    """Processes of this machine."""

    lost: tuple[type[BaseException], ...] = (BrokenProcessPool,)

    def __init__(self, workers: int) -> None:
        self.size = workers
        self._pool = _pool(workers)

    def submit(self, plan: Plan, chunk: Chunk) -> Any:
        """A future of the pool."""
        return self._pool.submit(fly, plan, *chunk)

    def first(self, futures: Sequence[Any]) -> Sequence[Any]:
        """Those that are done."""
        done = wait(futures, return_when=FIRST_COMPLETED).done
        return [one for one in futures if one in done]

    def renew(self) -> None:
        """A new pool."""
        self.close(is_done=False)
        self._pool = _pool(self.size)

    def close(self, is_done: bool) -> None:
        """End the pool; its processes too, where nobody waits for what they do."""
        if not is_done:
            for process in list((getattr(self._pool, "_processes", None) or {}).values()):
                process.terminate()
        self._pool.shutdown(wait=True, cancel_futures=True)


def flown(crew: Crew, plan: Plan, chunks: Sequence[Chunk]) -> Iterator[tuple[Chunk, Rows]]:
    """Every chunk as it comes back, in any order. Raises WorkersLost, CannotFly."""
    waiting, flying = deque(chunks), dict[Any, Chunk]()
    fruitless = 0
    while waiting or flying:
        try:
            while waiting and len(flying) < 2 * crew.size:
                flying[crew.submit(plan, waiting[0])] = waiting[0]
                waiting.popleft()
            for future in crew.first(list(flying)):
                rows = future.result()
                fruitless = 0
                yield flying.pop(future), rows
        except crew.lost as fault:
            fruitless += 1
            waiting.extend(flying.values())
            flying.clear()
            if fruitless >= FRUITLESS:
                raise WorkersLost(f"workers died {fruitless} times in a row") from fault
            crew.renew()


def _pool(workers: int) -> ProcessPoolExecutor:
    context = multiprocessing.get_context("spawn")
    return ProcessPoolExecutor(workers, mp_context=context, initializer=_ready)


def _ready() -> None:
    """In a worker: Ctrl-C is for the parent, whose end is the worker's."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda *_: _end())
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_follow, args=(parent.join,), daemon=True).start()


def _follow(gone: Callable[[], None]) -> None:
    gone()
    _end()


def _end() -> None:
    """Leave at once, and no folder behind."""
    forget()
    os._exit(1)
