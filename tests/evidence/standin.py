"""A self-test for packages that have none yet: cases over a ladder of angles, bits from this
machine's compiler, nothing judged. A package's own takes its place.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import cffi
import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from derive.evidence.emitted import Emitted
from derive.native.compile import build
from derive.native.header import parse

Array = NDArray[np.float64]

ANGLES = (0.0, 1e-8, 1e-3, 0.1, 1.0, 2.0, 3.0, np.pi - 1e-3, np.pi - 1e-6, np.pi)
AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 2, 3), (-3, 1, -2))
COMMAND = ("force", "s", "nu_u", "nu_u_dot")


def write(emitted: Emitted, scratch: Path) -> None:
    """Put test/PREFIX_test.h and .c into a package."""
    prefix, macro = emitted.prefix, emitted.macro
    cases = list(_cases(emitted, scratch))
    folder = emitted.folder / "test"
    folder.mkdir(exist_ok=True)
    (folder / f"{prefix}_test.h").write_text(
        f"#include <stdint.h>\n"
        f'#include "{prefix}.h"\n'
        f"#define {macro}_CASES {len(cases)}\n"
        f"typedef struct {{ {prefix}_state state; {prefix}_reference reference;\n"
        f"    {prefix}_command truth; {prefix}_status status; uint32_t bits; }} {prefix}_case;\n"
        f"extern const {prefix}_case {prefix}_cases[{macro}_CASES];\n"
        f"int {prefix}_test(void);\n"
    )
    (folder / f"{prefix}_test.c").write_text(
        f'#include "{prefix}_test.h"\n'
        f"const {prefix}_case {prefix}_cases[{macro}_CASES] = {{\n"
        + ",\n".join(cases)
        + f"\n}};\nint {prefix}_test(void)\n{{\n    return 0;\n}}\n"
    )


def _cases(emitted: Emitted, scratch: Path) -> Iterator[str]:
    ffi = cffi.FFI()
    ffi.cdef(parse(emitted.header.read_text()).declarations)
    library: Any = ffi.dlopen(str(build([emitted.source], emitted.include, scratch)))
    params = ffi.addressof(library, f"{emitted.prefix}_defaults")
    control = getattr(library, f"{emitted.prefix}_control")
    structs = [ffi.new(f"{emitted.prefix}_{name}*") for name in ("state", "reference", "command")]
    state, reference, command = structs
    stored, n = len(state.g), len(state.nu)
    for g, g_r in _pairs(stored):
        state.g, reference.g = list(g), list(g_r)
        state.nu = [0.3, -0.2, 0.5, 0.1, 0.4, -0.6][:n]
        reference.nu = [0.1, 0.4, -0.2, 0.2, -0.1, 0.3][:n]
        reference.nu_dot = [0.01, -0.02, 0.05, 0.03, 0.0, 0.02][:n]
        status = control(params, state, reference, command)
        truth = [getattr(command, name) for name in COMMAND]
        yield (
            f"{{{_braced(state.g, state.nu)}, "
            f"{_braced(reference.g, reference.nu, reference.nu_dot)}, "
            f"{_braced(*truth)}, ({emitted.prefix}_status){status}, "
            f"{_hash(bytes(ffi.buffer(command)))}u}}"
        )


def _pairs(stored: int) -> Iterator[tuple[Array, Array]]:
    """(g, g_r) as stored: 4 a quaternion, 9 a rotation, 16 a pose; the last is off the group."""
    reference = Rotation.from_rotvec([0.4, -0.9, 0.5])
    for angle in ANGLES:
        for axis in AXES:
            turn = Rotation.from_rotvec(angle * np.array(axis) / np.linalg.norm(axis))
            yield _stored(reference * turn, stored, 0.7), _stored(reference, stored, -0.2)
    yield 2 * _stored(reference, stored, 0.7), _stored(reference, stored, -0.2)


def _stored(turn: Rotation, stored: int, shift: float) -> Array:
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = turn.as_matrix(), [shift, -shift / 2, 0.1]
    forms = {4: np.roll(turn.as_quat(), 1), 9: turn.as_matrix().ravel(), 16: pose.ravel()}
    return np.asarray(forms[stored])


def _braced(*rows: Sequence[float]) -> str:
    """Rows of hexadecimal numbers, exact in either scalar."""
    inner = (", ".join(float(x).hex() for x in row) for row in rows)
    return "{" + ", ".join(f"{{{row}}}" for row in inner) + "}"


def _hash(data: bytes) -> int:
    value = 2166136261
    for byte in data:
        value = (value ^ byte) * 16777619 % 2**32
    return value
