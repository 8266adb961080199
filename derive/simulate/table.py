"""Rows of a sweep as bytes: chunks on their way, and the result as CSV or Parquet.

The same rows are the same bytes. Floats in CSV are written so that they are read back exactly.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from pathlib import Path
from zipfile import BadZipFile

import numpy as np

from derive.simulate.chunk import Rows

GROUP = 65_536  # rows that Parquet keeps together


def packed(rows: Rows) -> bytes:
    """Rows as they are kept until the sweep is whole."""
    buffer = io.BytesIO()
    np.savez(buffer, allow_pickle=False, **rows)
    return buffer.getvalue()


def unpacked(path: Path) -> Rows | None:
    """Rows that were kept; None where the file is none of ours, or damaged."""
    try:
        with np.load(io.BytesIO(path.read_bytes()), allow_pickle=False) as kept:
            return {name: kept[name] for name in kept.files}
    except (BadZipFile, ValueError, EOFError, KeyError):
        return None


def joined(parts: Sequence[Rows]) -> Rows:
    """Chunks in the order of their runs, as one."""
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def csv(rows: Rows) -> bytes:
    """A line of names, a line per run; truth as 1 or 0, and nothing for what does not exist."""
    columns = [[_word(x) for x in values.tolist()] for values in rows.values()]
    lines = [",".join(rows), *(",".join(line) for line in zip(*columns, strict=True))]
    return ("\n".join(lines) + "\n").encode()


def parquet(rows: Rows) -> bytes:
    """The same columns, by pyarrow."""
    import pyarrow
    from pyarrow import parquet as writer

    buffer = io.BytesIO()
    writer.write_table(pyarrow.table(dict(rows)), buffer, row_group_size=GROUP)
    return buffer.getvalue()


FORMATS: dict[str, Callable[[Rows], bytes]] = {"csv": csv, "parquet": parquet}


def _word(value: float | bool) -> str:
    if isinstance(value, bool):
        return str(int(value))
    return "" if value != value else repr(value)
