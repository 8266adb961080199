"""An emitted folder on disk, as the tools see it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from derive.emit.around import FLAGS

__all__ = ["FLAGS", "Emitted"]
# FLAGS: what the package's own build files compile with; -O comes on top.


@dataclass(frozen=True)
class Emitted:
    """A vehicle's package in one scalar.

    folder: generated/NAME; name: of the vehicle; scalar: f32 or f64
    """

    folder: Path
    name: str
    scalar: str

    @property
    def prefix(self) -> str:
        """Of every C name."""
        return f"{self.name}_{self.scalar}"

    @property
    def macro(self) -> str:
        """Of every C macro."""
        return self.prefix.upper()

    @property
    def include(self) -> Path:
        """The folder of the header."""
        return self.folder / "c" / "include"

    @property
    def header(self) -> Path:
        """The header."""
        return self.include / f"{self.prefix}.h"

    @property
    def source(self) -> Path:
        """The one source."""
        return self.folder / "c" / "src" / f"{self.prefix}.c"
