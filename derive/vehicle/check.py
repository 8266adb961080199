"""What a name and an inertia must satisfy; every test of an inertia is exact, on fractions."""

import keyword
import re
import sys
from fractions import Fraction
from itertools import combinations

from derive.vehicle.text import InputError, quoted, shown

Matrix = tuple[tuple[Fraction, ...], ...]

LONGEST_NAME = 48  # characters
NAME = re.compile(r"[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*")
IN_FLUID = "for a body that carries fluid with it write [options] added_mass = true"
SCALAR_SUFFIXES = ("_f32", "_f64")  # NAME_f64 is the prefix of what is emitted

_C_WORDS = """
alignas alignof asm auto bool break case catch char class const constexpr continue decltype
default delete do double else enum explicit export extern false float for friend goto if
inline int long mutable namespace new noexcept nullptr operator private protected public
register restrict return short signed sizeof static struct switch template this throw true
try typedef typeid typename typeof union unsigned using virtual void volatile wchar_t while
and and_eq bitand bitor compl concept not not_eq or or_eq requires thread_local xor xor_eq
char8_t char16_t char32_t co_await co_return co_yield const_cast consteval constinit
dynamic_cast reinterpret_cast static_assert static_cast typeof_unqual
"""
C_WORDS = frozenset(_C_WORDS.split())
# What the emitted module, which is named like the vehicle, may import.
OWN_MODULES = frozenset({*sys.stdlib_module_names, "numpy"})
DEVICES = frozenset(  # no file of such a name, whatever its ending, can exist on Windows
    ["aux", "con", "nul", "prn", *(f"{port}{n}" for port in ("com", "lpt") for n in range(1, 10))]
)

TARGETS_OF_OTHERS = frozenset(  # of CMake itself, and the library that the package links
    "all clean edit_cache help install list_install_components m package package_source "
    "rebuild_cache test uninstall".split()
)


def check_name(file: str, name: str) -> None:
    """Raise InputError unless the name can be the prefix of C, and the name of a module."""
    problem = _problem(name)
    if problem:
        expected = (
            "a C identifier that is no one else's: letters and digits, single underscores between "
            f"them, a letter first, at most {LONGEST_NAME} characters, not ending in _f32 or _f64"
        )
        found = f"{quoted(name)}, which {problem}"
        raise InputError(file, "name", expected, found, f'write name = "{_suggestion(name)}"')


def _problem(name: str) -> str:
    """Why a name cannot be used; empty when it can."""
    if not NAME.fullmatch(name):
        return "is not of that form"
    if len(name) > LONGEST_NAME:
        return f"has {len(name)} characters"
    if name.lower().endswith(SCALAR_SUFFIXES):
        return "ends like the prefix of one scalar"
    taken = (
        ("is the name of a scalar", f"_{name.lower()}" in SCALAR_SUFFIXES),
        ("is a keyword of C or C++", name in C_WORDS),
        ("is a keyword of Python", keyword.iskeyword(name) or keyword.issoftkeyword(name)),
        ("would hide the Python module of that name", name in OWN_MODULES),
        ("names a device on Windows", name.lower() in DEVICES),
        ("is a target of CMake or a library it links", name.lower() in TARGETS_OF_OTHERS),
    )
    return next((problem for problem, is_so in taken if is_so), "")


def _suggestion(name: str) -> str:
    """An allowed name that is like the given one."""
    words = re.findall("[A-Za-z0-9]+", name)
    while words and words[-1].lower() in {"f32", "f64"}:
        words.pop()
    usable = "_".join(words)[: LONGEST_NAME - len("vehicle_")].rstrip("_")
    return usable if not _problem(usable) else f"vehicle_{usable or 1}"


def check_symmetric(file: str, inertia: Matrix, key: str = "inertia") -> None:
    """Raise InputError naming the first two mirrored entries that differ; exact."""
    for i, j in combinations(range(len(inertia)), 2):
        upper, lower = inertia[i][j], inertia[j][i]
        if upper != lower:
            raise InputError(
                file,
                key,
                f"a symmetric matrix: row {i + 1}, column {j + 1} equal to its mirror image",
                f"row {i + 1}, column {j + 1} is {shown(upper)}, row {j + 1}, column {i + 1} is "
                f"{shown(lower)} (difference {shown(upper - lower, 6)})",
                "make the two entries equal",
            )


def check_positive_definite(file: str, inertia: Matrix, key: str = "inertia") -> None:
    """Raise InputError naming the first leading minor that is not positive (Sylvester); exact."""
    for size in range(1, len(inertia) + 1):
        minor = determinant(inertia, range(size))
        if minor <= 0:
            of_what = "entry" if size == 1 else f"{size} by {size} block"
            raise InputError(
                file,
                key,
                "a positive definite matrix: every leading minor greater than 0",
                f"leading minor {size}, the determinant of the upper left {of_what}, is "
                f"{shown(minor, 6)}",
                "check the units and signs: diagonal entries are positive, and products of "
                "inertia smaller than the geometric mean of their two moments",
            )


def pivots(inertia: Matrix) -> list[Fraction]:
    """Ratios of successive leading minors, exact, up to the first that is not positive."""
    found: list[Fraction] = []
    before = Fraction(1)
    for size in range(1, len(inertia) + 1):
        minor = determinant(inertia, range(size))
        found.append(minor / before)
        if minor <= 0:
            break
        before = minor
    return found


def check_triangle(
    file: str, inertia: Matrix, key: str = "inertia", in_fluid: str = IN_FLUID
) -> None:
    """Raise InputError unless no principal moment exceeds the sum of the others; exact.

    The moments obey it exactly when tr(J)/2 I - J is positive semidefinite, that is when all its
    principal minors are at least 0; so no eigenvalue is computed to judge, only to be shown.
    """
    n = len(inertia)
    half_trace = sum((inertia[i][i] for i in range(n)), Fraction()) / 2
    mass = tuple(
        tuple((half_trace if i == j else 0) - inertia[i][j] for j in range(n)) for i in range(n)
    )
    blocks = (block for size in range(1, n + 1) for block in combinations(range(n), size))
    if all(determinant(mass, block) >= 0 for block in blocks):
        return
    *small, large = _principal_moments(inertia)
    sum_of_small = " + ".join(f"{moment:.9g}" for moment in small)
    raise InputError(
        file,
        key,
        "principal moments of a rigid body about its centre of mass: none greater than the sum of "
        "the others",
        f"principal moments {', '.join(f'{moment:.9g}' for moment in (*small, large))}, but "
        f"{large:.9g} > {sum_of_small}",
        "check the entries: no distribution of mass has these moments (a common cause is products "
        f"of inertia in other units, or a moment of another axis); {in_fluid}",
    )


def determinant(matrix: Matrix, block: range | tuple[int, ...]) -> Fraction:
    """Determinant of the rows and columns of a block, by exact elimination."""
    rows = [[matrix[i][j] for j in block] for i in block]
    value = Fraction(1)
    while rows:
        pivot = next((row for row in rows if row[0]), None)
        if pivot is None:
            return Fraction()
        place = rows.index(pivot)
        value *= pivot[0] if place % 2 == 0 else -pivot[0]
        rows = [
            [a - row[0] / pivot[0] * b for a, b in zip(row[1:], pivot[1:], strict=True)]
            for row in rows[:place] + rows[place + 1 :]
        ]
    return value


def _principal_moments(inertia: Matrix) -> list[float]:
    """Eigenvalues, smallest first; only ever printed."""
    import numpy as np

    moments = np.linalg.eigvalsh([[float(entry) for entry in row] for row in inertia])
    return [float(moment) for moment in moments]
