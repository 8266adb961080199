"""An emitted folder on disk, as the tools see it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from derive.emit.around import FLAGS

__all__ = ["FLAGS", "Emitted", "NotEmitted"]
# FLAGS: what the package's own build files compile with; -O comes on top.


@dataclass(frozen=True)
class Emitted:
    """A vehicle's package in one scalar.

    folder: generated/NAME, kept as a whole path: tools are run in folders of their own
    name:   of the vehicle; scalar: f32 or f64
    """

    folder: Path
    name: str
    scalar: str

    def __post_init__(self) -> None:
        object.__setattr__(self, "folder", self.folder.absolute())

    def refuse_absent(self) -> None:
        """Raise NotEmitted where the folder is none, or holds no such package."""
        expected = (self.source, self.header, self.folder / "test" / f"{self.prefix}_test.c")
        if not self.folder.is_dir():
            raise NotEmitted(self, "a file" if self.folder.exists() else "no such folder")
        if lost := [path for path in expected if not path.is_file()]:
            raise NotEmitted(self, f"no {lost[0].relative_to(self.folder)}")

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


class NotEmitted(ValueError):
    """A folder is no emitted package; says where, what was expected and what to do."""

    def __init__(self, emitted: Emitted, found: str) -> None:
        super().__init__(
            f"{emitted.folder}\n  expected: the emitted package of {emitted.name} with C in "
            f"{emitted.scalar}, and its self-test\n  found:    {found}\n"
            f"  to do:    write it with derive emit {emitted.name}.toml, or give the folder "
            "that holds it"
        )
