"""Decides how numpy arrays become C structs: a numpy record with the offsets the C struct has."""

from collections.abc import Iterable, Mapping
from typing import Any

import cffi
import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[Any]
Record = np.dtype[Any]

_SCALARS = {"double": "f8", "float": "f4", "int": "i4", "int32_t": "i4", "uint32_t": "u4"}


def record(ffi: cffi.FFI, ctype: Any) -> Record:
    """The numpy type with the layout of a C struct, array, enum or number."""
    if ctype.kind == "struct":
        fields = dict(ctype.fields)
        return np.dtype(
            {
                "names": list(fields),
                "formats": [record(ffi, field.type) for field in fields.values()],
                "offsets": [field.offset for field in fields.values()],
                "itemsize": ffi.sizeof(ctype),
            }
        )
    if ctype.kind == "array":
        return np.dtype((record(ffi, ctype.item), (ctype.length,)))
    if ctype.kind == "enum":
        return np.dtype(f"{'i' if min(ctype.elements) < 0 else 'u'}{ffi.sizeof(ctype)}")
    return np.dtype(_SCALARS[ctype.cname])


def field(layout: Record, name: str) -> Record:
    """The numpy type of one field of a record."""
    fields: Mapping[str, tuple[Any, ...]] = layout.fields or {}
    found: Record = fields[name][0]
    return found


def shaped(values: ArrayLike, wanted: tuple[int, ...], name: str) -> Array:
    """`values` as (…, *wanted); a (…, m, m) matrix is taken for m*m numbers, row by row.

    Raises ValueError when the last axes do not fit.
    """
    array = np.asarray(values)
    if not wanted:
        return array
    is_matrix = array.ndim >= 2 and array.shape[-2:] != wanted[-2:]
    if (
        is_matrix
        and array.shape[-1] != wanted[-1]
        and array.shape[-2] * array.shape[-1] == wanted[-1]
    ):
        array = array.reshape(*array.shape[:-2], wanted[-1])
    if array.shape[array.ndim - len(wanted) :] != wanted:
        raise ValueError(f"{name}: shape {array.shape} does not end in {wanted}")
    return array


def batch(pairs: Iterable[tuple[Array, int]]) -> tuple[int, ...]:
    """The common leading shape of arrays given with the number of their own axes."""
    return np.broadcast_shapes(*(array.shape[: array.ndim - own] for array, own in pairs))
