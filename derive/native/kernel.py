"""Decides how a C function over columns is called: arrays as they lie in memory."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import cffi

from derive.native.compile import FLAGS, CompileError, Compiler, build

FAST = (*FLAGS, "-O3", "-fno-trapping-math", "-fPIC", "-shared")
"""-fno-trapping-math: both sides of a choice may be computed; no result depends on it."""

HERE = "-march=native"  # wider registers, the same roundings; not every compiler has it


class Kernel:
    """Functions of one C source, by name.

    prototypes: as cffi reads them; raises CompilerMissing, CompileError
    """

    def __init__(self, text: str, prototypes: str, folder: Path, name: str) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        source = folder / f"{name}.c"
        source.write_text(text, encoding="utf-8")
        self._ffi = cffi.FFI()
        self._ffi.cdef(prototypes)
        compiler = Compiler.find()
        try:
            place = build([source], folder, folder, (*FAST, HERE), compiler)
        except CompileError:
            place = build([source], folder, folder, FAST, compiler)
        self._library = self._ffi.dlopen(str(place.resolve()))

    def __getitem__(self, name: str) -> Callable[..., None]:
        """A function: it takes numbers, and pointers from `column`."""
        found: Callable[..., None] = getattr(self._library, name)
        return found

    def column(self, array: Any) -> Any:
        """The address of an array of doubles without gaps, which must outlive it."""
        return self._ffi.from_buffer("double[]", array)
