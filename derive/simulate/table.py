"""Rows of a sweep as bytes: chunks on their way, and the result as CSV or Parquet.

The same rows are the same bytes. Floats in CSV are written so that they are read back exactly.
"""

from __future__ import annotations

import hashlib
import io
from collections.abc import Callable, Sequence

import numpy as np

from derive.simulate.chunk import Rows

GROUP = 65_536  # rows that Parquet keeps together
SEAL = 32  # bytes before a chunk that say whether it is as it was written


def packed(rows: Rows, bound: bytes) -> bytes:
    """Rows as they are kept until the sweep is whole; `bound` is what the sweep is defined by."""
    buffer = io.BytesIO()
    np.savez(buffer, allow_pickle=False, **rows)
    data = buffer.getvalue()
    return _seal(data, bound) + data


def unpacked(kept: bytes, bound: bytes) -> Rows | None:
    """Rows that were kept; None where a single bit is not as it was written, for that sweep."""
    seal, data = kept[:SEAL], kept[SEAL:]
    if seal != _seal(data, bound):
        return None
    with np.load(io.BytesIO(data), allow_pickle=False) as found:
        return {name: found[name] for name in found.files}


def _seal(data: bytes, bound: bytes) -> bytes:
    return hashlib.sha256(bound + data).digest()


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


def from_csv(data: bytes) -> Rows:
    """Rows that `csv` wrote. Raises ValueError."""
    names, *lines = (line.split(",") for line in data.decode().splitlines())
    found = dict(zip(names, zip(*lines, strict=True), strict=True))
    return {name: np.array([_number(word, KINDS.get(name, float)) for word in words])
            for name, words in found.items()}  # fmt: skip


def from_parquet(data: bytes) -> Rows:
    """Rows that `parquet` wrote. Raises ValueError, ImportError."""
    import pyarrow
    from pyarrow import parquet as reader

    read = reader.read_table(pyarrow.BufferReader(data))
    return {name: read[name].to_numpy() for name in read.column_names}


FORMATS: dict[str, Callable[[Rows], bytes]] = {"csv": csv, "parquet": parquet}
READERS: dict[str, Callable[[bytes], Rows]] = {"csv": from_csv, "parquet": from_parquet}

KINDS: dict[str, type] = {"settled": bool, "run": int, "seed": int, "crossings": int,
                          "worst_status": int}  # fmt: skip
"""Columns whose numbers are not floats."""


def _number(word: str, kind: type) -> float | bool:
    if kind is float:
        return float(word or "nan")
    return bool(int(word)) if kind is bool else int(word)


def _word(value: float | bool) -> str:
    if isinstance(value, bool):
        return str(int(value))
    return "" if value != value else repr(value)
