"""A Dask cluster of this machine: a scheduler and workers in processes of their own."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from tests.command import ROOT

START = 60.0  # s, within which a scheduler must have written where it is


class Dask:
    """A scheduler and workers that nobody starts again."""

    def __init__(self, folder: Path, workers: int) -> None:
        self._folder, self._started = folder, list[subprocess.Popen[bytes]]()
        note = folder / "scheduler.json"
        try:
            self.scheduler = self._start("scheduler", "--port", "0", "--scheduler-file", str(note))
            until(lambda: "tcp://" in self._read(note), START)
            text = self._read(note)
            self.address = text[text.index("tcp://") :].partition('"')[0]
            self.workers = [
                self._start("worker", self.address, "--no-nanny", "--nthreads", "1")
                for _ in range(workers)
            ]
        except BaseException:
            self.end()
            raise

    def _start(self, kind: str, *more: str) -> subprocess.Popen[bytes]:
        command = [sys.executable, "-m", f"distributed.cli.dask_{kind}", "--no-dashboard", *more,
                   "--host", "127.0.0.1"]  # fmt: skip
        environment = {**os.environ, "PYTHONPATH": str(ROOT)}
        with (self._folder / f"{kind}.log").open("ab") as log:
            made = subprocess.Popen(
                command, cwd=self._folder, env=environment, stdin=subprocess.DEVNULL,
                stdout=log, stderr=log,
            )  # fmt: skip
        self._started.append(made)
        return made

    @staticmethod
    def _read(note: Path) -> str:
        return note.read_text() if note.exists() else ""

    def said(self) -> str:
        """The last words of its processes."""
        return "\n".join(log.read_text()[-600:] for log in sorted(self._folder.glob("*.log")))

    def end(self) -> None:
        """Kill what runs."""
        for one in self._started:
            one.kill()
            one.wait()


def until(is_so: Callable[[], object], seconds: float = 40.0) -> None:
    """Wait for it; TimeoutError after that many seconds."""
    end = time.monotonic() + seconds
    while not is_so():
        if time.monotonic() > end:
            raise TimeoutError(f"not so within {seconds:g} s")
        time.sleep(0.02)


@cache
def refusal() -> str:
    """Why no Dask cluster can be had on this machine; empty where it can."""
    from distributed import Client

    with TemporaryDirectory() as folder:
        try:
            made = Dask(Path(folder), 1)
        except TimeoutError as fault:
            words = "\n".join(log.read_text()[-600:] for log in Path(folder).glob("*.log"))
            return f"no Dask scheduler starts here: {fault}\n{words}"
        try:
            with Client(made.address, timeout=30, set_as_default=False) as client:
                client.submit(len, "dask", pure=False).result(timeout=30)
        except (OSError, TimeoutError) as fault:
            return f"a Dask cluster does not answer here: {fault}\n{made.said()}"
        finally:
            made.end()
    return ""


@contextmanager
def cluster(folder: Path, workers: int) -> Iterator[Dask]:
    """A cluster while the block lasts; the test is skipped where none can be had."""
    if why := refusal():
        pytest.skip(why)
    made = Dask(folder, workers)
    try:
        yield made
    finally:
        made.end()
