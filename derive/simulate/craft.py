"""What is flown, as plain data that travels to another process: a vehicle and its emitted files."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from errno import ENOSPC
from fractions import Fraction
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory, gettempdir

from derive.control.table import CONTROLLERS
from derive.lie.catalogue import named
from derive.lie.group import Group
from derive.lie.own import of_basis
from derive.native.compile import CompileError

FULL = os.strerror(ENOSPC)  # as a compiler says it too
Basis = tuple[tuple[tuple[Fraction, ...], ...], ...]


class NoRoom(Exception):
    """The temporary folder cannot take what has to be unpacked and built there; says which."""


_KEPT: list[TemporaryDirectory[str]] = []


@dataclass(frozen=True)
class Craft:
    """A vehicle as the simulator needs it; equal crafts are equal bytes.

    inertia:    upper triangle, row by row, n(n+1)/2 numbers
    gains:      (name, value) in the controller's order
    files:      (path, text) of the emitted folder
    own, units: the basis of a user's group, and its units; None for the catalogue's
    """

    name: str
    group: str
    law: str
    controller: str
    inertia: tuple[float, ...]
    gains: tuple[tuple[str, float], ...]
    files: tuple[tuple[str, str], ...]
    options: tuple[str, ...] = ()
    own: Basis | None = None
    units: tuple[str, ...] = ()

    @property
    def has_reference(self) -> bool:
        """Whether its controller is told of a reference."""
        return CONTROLLERS[self.controller].has_reference

    @property
    def pattern(self) -> tuple[bool, ...]:
        """Where the upper triangle of the inertia is not zero."""
        return tuple(entry != 0 for entry in self.inertia)


@cache
def group_of(craft: Craft) -> Group:
    """The group it moves on."""
    if craft.own is None:
        return named(craft.group)
    return of_basis(craft.group, craft.own, craft.units)


@contextmanager
def unpacked(craft: Craft) -> Iterator[Path]:
    """Its folder, to build in. Raises NoRoom where that cannot be written to."""
    try:
        yield folder_of(craft)
    except OSError as fault:
        raise NoRoom(f"{fault.strerror or fault}: {gettempdir()}") from fault
    except CompileError as fault:
        if FULL not in fault.stderr:
            raise
        raise NoRoom(f"{FULL}: {gettempdir()}") from fault


@cache
def folder_of(craft: Craft) -> Path:
    """A folder that holds its emitted files while this process lives; OSError."""
    holder = TemporaryDirectory(prefix="derive-")
    _KEPT.append(holder)
    root = Path(holder.name)
    for path, text in craft.files:
        file = root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return root


def forget() -> None:
    """Remove these folders now, in a process that is about to end without ceremony."""
    while _KEPT:
        _KEPT.pop().cleanup()
