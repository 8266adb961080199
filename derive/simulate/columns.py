"""Derivations over columns in C: what derive.emit.function does in numpy, bit for bit, sooner."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from derive.emit import inline
from derive.native.kernel import Kernel
from derive.routine.derivation import Derivation, Quantity

Array = NDArray[np.float64]


class Columns:
    """One derivation over columns (size, N) or (size, 1); see Function.columns."""

    def __init__(self, d: Derivation, kernel: Kernel) -> None:
        self.inputs = tuple(d.inputs)
        self._outputs = tuple(quantity for quantity, _ in d.outputs)
        self._call, self._address = kernel[inline.symbol(d)], kernel.column

    def columns(self, **given: Array) -> tuple[Array, ...]:
        """Outputs in order, (size, N), or (N,) of a scalar."""
        arrays = [np.ascontiguousarray(given[one.name]) for one in self.inputs]
        loops = max((array.shape[-1] for array in arrays), default=1)
        found = [np.empty(_shape(one, loops)) for one in self._outputs]
        addresses: list[object] = []
        for array in arrays:
            addresses += [self._address(array), int(array.shape[-1] == loops)]
        self._call(loops, *addresses, *(self._address(one) for one in found))
        return tuple(found)


def in_c(derivations: Sequence[Derivation], folder: Path, name: str) -> list[Columns]:
    """Each derivation in C. Raises CompilerMissing, CompileError."""
    kernel = Kernel(inline.over_columns(derivations), inline.prototypes(derivations), folder, name)
    return [Columns(d, kernel) for d in derivations]


def _shape(quantity: Quantity, loops: int) -> tuple[int, ...]:
    return (loops,) if quantity.is_scalar else (quantity.size, loops)
