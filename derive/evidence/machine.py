"""The table of machines that an emitted package runs on: compiler, emulator, what each shows."""

from __future__ import annotations

from dataclasses import dataclass

from derive.evidence.tool import Tool

LEVELS = ("-O0", "-O2", "-O3")
"""Levels of optimisation at which every row must have the same bits."""

MEASURED = "-O2"
"""The level at which instructions and stack are measured."""

_ARM = Tool("arm-none-eabi-gcc", "apt install gcc-arm-none-eabi libnewlib-arm-none-eabi")
_RISCV = Tool("riscv64-unknown-elf-gcc",
              "apt install gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf")  # fmt: skip
_QEMU_ARM = Tool("qemu-system-arm", "apt install qemu-system-arm")

_HOSTED = ("-chardev", "stdio,id=host", "-semihosting-config",
           "enable=on,target=native,chardev=host")  # fmt: skip
_QUIET = ("-nographic", "-monitor", "none", "-serial", "none")
_BARE = ("-nostartfiles",)


@dataclass(frozen=True)
class Machine:
    """A processor, or this machine under one compiler.

    scalars:  what runs on it
    flags:    of its compiler
    libraries: linked last
    board:    the template of its start-up code; linker script of that name when emulated
    emulator: and `options`, what runs an image; none: it is a program of this machine
    measured: scalars whose instructions, stack and size are measured
    needs:    a file that the compiler must find: its C library is a package of its own
    raises:   scalars whose flags (invalid, division by zero, overflow) tell of the package
    """

    name: str
    compiler: Tool
    scalars: tuple[str, ...]
    board: str
    flags: tuple[str, ...] = ()
    libraries: tuple[str, ...] = ("-lm",)
    emulator: Tool | None = None
    options: tuple[str, ...] = ()
    measured: tuple[str, ...] = ()
    needs: str = ""
    raises: tuple[str, ...] = ("f32", "f64")

    @property
    def tools(self) -> tuple[Tool, ...]:
        """All it needs."""
        sizer = (self.sizer,) if self.measured else ()
        return (self.compiler, *((self.emulator,) if self.emulator else ()), *sizer)

    @property
    def sizer(self) -> Tool:
        """The tool that comes with the compiler and tells section sizes."""
        return Tool(self.compiler.command.replace("gcc", "size"), self.compiler.install)


def _cortex(name: str, core: str, unit: str, board: str, scalars: tuple[str, ...],
            scalar: str) -> Machine:  # fmt: skip
    """A Cortex-M with a floating-point unit for one scalar; the other is computed in software."""
    return Machine(
        name, _ARM, scalars, "arm",
        (f"-mcpu={core}", "-mthumb", f"-mfpu={unit}", "-mfloat-abi=hard", *_BARE),
        emulator=_QEMU_ARM,
        # One instruction is 2^10 ns of the emulated clock: see the template.
        options=("-M", board, *_QUIET, *_HOSTED, "-icount", "shift=10", "-kernel"),
        measured=(scalar,), needs="libm.a", raises=(scalar,),
    )  # fmt: skip


def _risc_v(bits: int, abi: str) -> Machine:
    return Machine(
        f"RV{bits}", _RISCV, ("f32", "f64"), "riscv",
        (f"-march=rv{bits}imafdc", f"-mabi={abi}", "-mcmodel=medany", "-specs=picolibc.specs",
         *_BARE),
        emulator=Tool(f"qemu-system-riscv{bits}", "apt install qemu-system-misc"),
        options=("-M", "virt", "-bios", "none", *_QUIET, *_HOSTED, "-kernel"),
        needs="picolibc.specs",
    )  # fmt: skip


MACHINES = (
    Machine("gcc", Tool("gcc", "apt install gcc"), ("f32", "f64"), "host"),
    # clang divides whole vectors, what lies in unused lanes too: 0/0 there raises flags that no
    # arithmetic of the package does (not so with -ffp-exception-behavior=maytrap).
    Machine("clang", Tool("clang", "apt install clang"), ("f32", "f64"), "host", raises=()),
    _cortex("Cortex-M4F", "cortex-m4", "fpv4-sp-d16", "mps2-an386", ("f32", "f64"), "f32"),
    _cortex("Cortex-M7", "cortex-m7", "fpv5-d16", "mps2-an500", ("f64",), "f64"),
    _risc_v(32, "ilp32d"),
    _risc_v(64, "lp64d"),
)
"""The first stands for all others where no committed bits do."""
