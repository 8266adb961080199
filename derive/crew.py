"""Who flies a sweep and what its results are written with, as asked for and as found here."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec

from derive.demand import PLACE
from derive.simulate.chunk import Rows
from derive.simulate.cluster import Cluster
from derive.simulate.executor import Alone, Crew, Processes
from derive.simulate.style import is_drawable
from derive.simulate.sweep_picture import pictures
from derive.simulate.table import FORMATS
from derive.sweep_folder import Sweep
from derive.vehicle import InputError

EXTRA = "pip install 'gsmc-derive[{}]'"


def form_of(asked: str | None) -> str:
    """The format of the results. Raises InputError for an unknown one, or without pyarrow."""
    has_pyarrow = find_spec("pyarrow") is not None
    if asked is None:
        return "parquet" if has_pyarrow else "csv"
    if asked not in FORMATS:
        expected = f"one of {', '.join(sorted(FORMATS))}"
        raise InputError(PLACE, "--format", expected, asked, "choose one of them")
    if asked == "parquet" and not has_pyarrow:
        remedy = f"{EXTRA.format('cluster')}, or --format csv"
        raise InputError(PLACE, "--format", "pyarrow, for parquet", "it is not installed", remedy)
    return asked


def hired(cluster: str | None, workers: int) -> Crew:
    """This process, local processes, or a cluster. Raises InputError."""
    if cluster is None:
        return Alone() if workers == 1 else Processes(workers)
    if find_spec("distributed") is None:
        expected, remedy = "dask.distributed, for a cluster", EXTRA.format("cluster")
        raise InputError(PLACE, "--cluster", expected, "it is not installed", remedy)
    try:
        return Cluster(cluster)
    except (OSError, ValueError) as fault:
        expected = "the address of a Dask scheduler that has workers"
        found = f"{cluster!r}: {str(fault).splitlines()[0] if str(fault) else type(fault).__name__}"
        remedy = "start one with `dask scheduler` and `dask worker`, or leave --cluster out"
        raise InputError(PLACE, "--cluster", expected, found, remedy) from fault


@contextmanager
def let_go(crew: Crew) -> Iterator[None]:
    """Let go of a crew in the end, at once where that is not the end of its work."""
    is_done = False
    try:
        yield
        is_done = True
    finally:
        crew.close(is_done)


def drawn(rows: Rows, sweep: Sweep) -> str:
    """Write the pictures; what is to be said where they cannot be drawn. Raises InputError."""
    if not is_drawable():
        return f"no pictures: matplotlib is not installed; {EXTRA.format('plot')}"
    craft = sweep.plan.craft
    title = f"{craft.name}: {craft.controller} on {craft.group}"
    seconds = max(one.seconds for one in sweep.plan.settings)
    for name, data in pictures(rows, title, seconds).items():
        sweep.save(sweep.out / name, data)
    return ""
