"""Decides how C is compiled: which compiler, which flags, and what is said when it fails."""

import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

# -ffp-contract=off: no fused multiply-add, so every compiler rounds alike.
# -fno-math-errno: sqrt is an instruction, not a call that sets errno.
FLAGS = ("-std=c99", "-O2", "-ffp-contract=off", "-fno-math-errno")
SHARED = (*FLAGS, "-fPIC", "-shared")

SECONDS = 300.0
"""After which a compiler is ended; it takes a second or two."""

_STRICT = (
    *("-Wall", "-Wextra", "-Wpedantic", "-Werror", "-Wconversion", "-Wdouble-promotion"),
    *("-Wfloat-equal", "-Wshadow", "-Wcast-qual"),
)
_PROTOTYPES = ("-Wstrict-prototypes", "-Wmissing-prototypes")

WARNINGS_C: dict[str, tuple[str, ...]] = {
    "gcc": (*_STRICT, *_PROTOTYPES),
    # -Weverything is told that C99 is meant: padding and declarations after statements are fine,
    # and a pointer is the only way C has to hand over an array.
    "clang": (
        *(*_STRICT, *_PROTOTYPES, "-Weverything", "-Wno-padded", "-Wno-unknown-warning-option"),
        *("-Wno-declaration-after-statement", "-Wno-unsafe-buffer-usage"),
    ),
}
"""Warnings under which emitted C is clean, by compiler family."""

WARNINGS_CXX: dict[str, tuple[str, ...]] = {"gcc": _STRICT, "clang": _STRICT}
"""Warnings under which a C++ file that includes an emitted header is clean."""


class CompilerMissing(Exception):
    """No C compiler of the wanted names is on PATH."""


class CompileError(Exception):
    """The compiler refused; `command` is the command line, `stderr` what it said."""

    def __init__(self, command: Sequence[str], stderr: str) -> None:
        self.command = tuple(command)
        self.stderr = stderr
        super().__init__(f"the C compiler failed\n  command: {shlex.join(command)}\n{stderr}")


@dataclass(frozen=True)
class Compiler:
    """A compiler found on PATH."""

    name: str
    path: Path

    @classmethod
    def find(cls, names: Sequence[str] = ("cc", "gcc", "clang")) -> "Compiler":
        """The first of `names` on PATH; raises CompilerMissing."""
        for name in names:
            if path := shutil.which(name):
                return cls(name, Path(path))
        raise CompilerMissing(
            f"no C compiler found: looked on PATH for {', '.join(names)}; "
            "install one: `apt install gcc`, `dnf install gcc` or `xcode-select --install`"
        )

    @property
    def family(self) -> str:
        """`clang` or `gcc`, as the compiler says itself: `cc` may be either."""
        said = subprocess.run([self.path, "--version"], capture_output=True, text=True, check=True)
        return "clang" if "clang" in said.stdout else "gcc"

    def run(self, arguments: Sequence[str], output: Path) -> Path:
        """Compile to `output`, which appears whole or not at all; raises CompileError."""
        output.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=output.parent) as scratch:
            part = Path(scratch) / output.name
            command = [str(self.path), *arguments, "-o", str(part)]
            try:
                done = subprocess.run(command, capture_output=True, text=True, check=False,
                                      timeout=SECONDS)  # fmt: skip
            except subprocess.TimeoutExpired:
                raise CompileError(command, f"it did not end within {SECONDS:g} s") from None
            if done.returncode:
                raise CompileError(command, done.stderr)
            part.replace(output)
        return output


def build(
    sources: Sequence[Path],
    include: Path,
    folder: Path,
    flags: Sequence[str] = SHARED,
    compiler: Compiler | None = None,
) -> Path:
    """Compile `sources` into one shared library in `folder` and return its path.

    `include` is the folder of the headers. The file is named after the first source and the
    compiler, so libraries of several compilers fit in one folder. A library that is already
    loaded is replaced on disk, not in memory. Raises CompilerMissing, CompileError.
    """
    chosen = compiler or Compiler.find()
    output = folder / f"lib{sources[0].stem}_{chosen.name}.so"
    arguments = [*flags, f"-I{include}", *(str(source) for source in sources)]
    # Last, for the machines on which sqrt is a call after all.
    return chosen.run([*arguments, "-lm"], output)


def build_object(
    source: Path,
    include: Path,
    folder: Path,
    flags: Sequence[str] = FLAGS,
    compiler: Compiler | None = None,
) -> Path:
    """Compile one source, without linking, into an object file in `folder`; raises as `build`."""
    chosen = compiler or Compiler.find()
    output = folder / f"{source.stem}_{chosen.name}.o"
    return chosen.run([*flags, f"-I{include}", "-c", str(source)], output)
