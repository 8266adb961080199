"""A derivation as a numpy function: its steps printed as emitted numpy has them, and run.

For whoever wants the numbers of a derivation without a package: what is computed is the printed
text, so that no second translation of the formulas exists.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from derive.emit import printer
from derive.emit.printed import Printed, kernels, routine
from derive.emit.statement import choice
from derive.routine.derivation import Derivation, Quantity

Array = Any  # a numpy array, or what np.asarray makes one of


@dataclass(frozen=True)
class Function:
    """Rows in by name, rows out by name, over any leading axes.

    text: the Python source that runs
    """

    name: str
    text: str
    inputs: tuple[Quantity, ...]
    _run: Callable[..., tuple[tuple[Array, ...], ...]]
    _outputs: tuple[Quantity, ...]

    def __call__(self, **given: Array) -> dict[str, Array]:
        """Outputs by name, (..., size) or (...) of a scalar, of inputs shaped alike.

        Arrays broadcast; complex ones pass through. Raises ValueError for a shape that does not
        fit, TypeError for a name that is missing or unknown.
        """
        if set(given) != {one.name for one in self.inputs}:
            wanted = ", ".join(one.name for one in self.inputs)
            raise TypeError(f"{self.name}: expected {wanted}, found {', '.join(given)}")
        rows = {one.name: _row(one, given[one.name]) for one in self.inputs}
        batch = np.broadcast_shapes(*(row.shape[:-1] for row in rows.values()))
        columns = {name: np.moveaxis(row, -1, 0) for name, row in rows.items()}
        pairs = zip(self._outputs, self._found(columns), strict=True)
        return {one.name: _stacked(one, entries, batch) for one, entries in pairs}

    def columns(self, **given: Array) -> tuple[Array, ...]:
        """Outputs in order, (size, N) or (N,), of columns (size, N) or (N,): nothing is judged.

        Each entry of the result depends on its own column alone, whatever N is.
        """
        rows = {
            one.name: given[one.name][None] if one.is_scalar else given[one.name]
            for one in self.inputs
        }
        batch = np.broadcast_shapes(*(row.shape[1:] for row in rows.values()))
        pairs = zip(self._outputs, self._found(rows), strict=True)
        return tuple(_column(one, entries, batch) for one, entries in pairs)

    def _found(self, columns: dict[str, Array]) -> tuple[tuple[Array, ...], ...]:
        with np.errstate(all="ignore"):  # of the cases of a choice all are computed
            return self._run(**columns)


def compiled(d: Derivation) -> Function:
    """The derivation as a function of its inputs."""
    text = source(d)
    scope: dict[str, Any] = {"np": np}
    exec(compile(text, f"<{d.name}>", "exec"), scope)
    outputs = tuple(quantity for quantity, _ in d.outputs)
    return Function(d.name, text, tuple(d.inputs), scope[d.name], outputs)


def source(d: Derivation) -> str:
    """Python text of the kernel functions it calls and of the derivation itself."""
    printed = routine(d, printer.numpy())
    arguments = ", ".join(one["name"] for one in printed["inputs"])
    lines = [line for kernel in kernels([d], "f64") for line in _kernel(kernel)]
    lines += [f"def {d.name}({arguments}):", f'    """{d.doc}; {d.source}"""']
    for one in printed["inputs"]:
        lines += [f"    {name} = {one['name']}[{index}]" for name, index in one["entries"]]
    for step in printed["steps"]:
        lines += [f"    {line}" for line in _step(step)]
    outputs = ("".join(f"{entry}, " for entry in one["entries"]) for one in printed["outputs"])
    return "\n".join([*lines, f"    return ({''.join(f'({one}), ' for one in outputs)})\n"])


def _kernel(kernel: Printed) -> list[str]:
    """Horner's scheme in 1 - w, highest power first."""
    (sign, first), *rest = kernel["terms"]
    lines = [f"    value = value * z {sign} {term}" for sign, term in rest]
    start = f"    value = {'-' if sign == '-' else ''}{first}"
    return [f"def _{kernel['name']}(w):", "    z = 1.0 - w", start, *lines, "    return value"]


def _step(step: Printed) -> Iterator[str]:
    """Assignments of one step, after a comment that says what it is."""
    yield f"# {step['name']}: {step['doc']} [{step['unit']}]"
    yield from (f"{name} = {value}" for name, value in step["lines"])
    yield from (f"{name} = {value}" for name, value in choice(step))


def _row(quantity: Quantity, value: Array) -> Array:
    """The value as (..., size), in double at least."""
    array = np.asarray(value)
    row = array[..., None] if quantity.is_scalar else array
    if row.ndim < 1 or row.shape[-1] != quantity.size:
        wanted = "(...)" if quantity.is_scalar else f"(..., {quantity.size})"
        raise ValueError(f"{quantity.name}: expected an array {wanted}, found {array.shape}")
    return row.astype(np.result_type(row, np.float64), copy=False)


def _column(quantity: Quantity, entries: tuple[Array, ...], batch: tuple[int, ...]) -> Array:
    if quantity.is_scalar:
        return np.broadcast_to(entries[0], batch)
    columns = np.empty((len(entries), *batch), np.result_type(np.float64, *entries))
    for column, entry in zip(columns, entries, strict=True):
        column[...] = entry
    return columns


def _stacked(quantity: Quantity, entries: tuple[Array, ...], batch: tuple[int, ...]) -> Array:
    rows = [np.broadcast_to(entry, batch) for entry in entries]
    return rows[0].copy() if quantity.is_scalar else np.stack(rows, axis=-1)
