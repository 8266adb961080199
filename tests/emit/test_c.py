"""The emitted C compiles without a warning, links anywhere and is as small as it says."""

from __future__ import annotations

import re
import subprocess
import zlib
from dataclasses import replace
from functools import cache
from itertools import product
from pathlib import Path

import pytest

from derive.native.compile import (
    FLAGS,
    WARNINGS_C,
    WARNINGS_CXX,
    CompileError,
    Compiler,
    build_object,
)
from derive.vehicle import Vehicle
from derive.vehicle.check import LONGEST_NAME
from tests.emit import subjects
from tests.emit.subjects import COMPILERS, CPP, FILES, GUARDED, SPARSE

SCALARS = ("f32", "f64")
ROOT = {"f32": "sqrtf", "f64": "sqrt"}
EITHER_C = (
    "memset",
    "memcpy",
)  # a struct assigned, an array set to zero: any C environment has them

# What computes in double or converts from or to it. Moves (movsd, movapd), shuffles (unpcklpd)
# and bitwise operations (andpd, xorpd) carry bits, whatever they are: compilers use them on
# floats, two at a time. x87 code would begin with f.
DOUBLE = re.compile(
    r"v?(add|sub|mul|div|sqrt|min|max|cmp\w*|u?comi|round|hadd|hsub|addsub|fn?m(add|sub)\w*)[sp]d"
    r"|v?cvt\w*[sp]d\w*"
    r"|f\w+"
)

every_compiler = pytest.mark.parametrize("name", COMPILERS)
every_scalar = pytest.mark.parametrize("scalar", SCALARS)


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("emitted")


@cache
def compiled(vehicle: Vehicle, scalar: str, name: str, folder: Path, *flags: str) -> Path:
    """The object of one source, in a folder of its own for every set of flags."""
    source = subjects.source(vehicle, scalar, folder)
    include = subjects.header(vehicle, scalar, folder).parent
    own = folder / f"objects_{zlib.crc32(' '.join(flags).encode())}"
    return build_object(source, include, own, flags, Compiler.find([name]))


def undefined(item: Path) -> set[str]:
    done = subprocess.run(["nm", "-u", item], capture_output=True, text=True, check=True)
    return {line.split()[-1] for line in done.stdout.splitlines() if line.strip()}


def mnemonics(item: Path) -> set[str]:
    command = ["objdump", "-d", "--no-show-raw-insn", str(item)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    columns = (line.split("\t") for line in done.stdout.splitlines())
    return {column[1].split()[0] for column in columns if len(column) > 1}


def strict(name: str) -> tuple[str, ...]:
    return (*FLAGS, *WARNINGS_C[name])


KINDS = [v for v in FILES if v.name in ("paper_so3", "paper_s3", "underwater", "sl2")]
"""A vehicle file of each kind of group."""


@every_compiler
@every_scalar
@pytest.mark.parametrize("vehicle", KINDS, ids=lambda v: v.name)
def test_no_flag_may_assume_away_what_control_looks_for(
    folder: Path, vehicle: Vehicle, scalar: str, name: str
) -> None:
    for flag in ("-ffast-math", "-Ofast", "-ffinite-math-only"):
        with pytest.raises(CompileError, match=rf"leave out .*{flag}.*NaN and infinity"):
            compiled(vehicle, scalar, name, folder, *FLAGS, flag)


@every_compiler
@every_scalar
@pytest.mark.parametrize("vehicle", GUARDED, ids=lambda v: v.name)
def test_strictest_warnings_find_nothing(
    folder: Path, vehicle: Vehicle, scalar: str, name: str
) -> None:
    item = compiled(vehicle, scalar, name, folder, *strict(name))
    assert undefined(item) <= set(EITHER_C)
    if scalar == "f32":
        assert not [word for word in mnemonics(item) if DOUBLE.fullmatch(word)]


@every_compiler
@pytest.mark.parametrize("law", sorted({(v.group, v.law) for v in SPARSE}), ids="_".join)
def test_an_inertia_with_zeros_leaves_no_warning(
    folder: Path, law: tuple[str, str], name: str
) -> None:
    """All zero patterns and both scalars of a law in one file, to start a compiler but once."""
    pairs = [(v, scalar) for v in SPARSE if (v.group, v.law) == law for scalar in SCALARS]
    sources = [subjects.source(vehicle, scalar, folder) for vehicle, scalar in pairs]
    text = folder / f"{'_'.join(law)}.c"
    text.write_text("".join(f'#include "{one}"\n' for one in sources), encoding="utf-8")
    places = [f"-I{subjects.header(*pair, folder).parent}" for pair in pairs]
    build_object(text, folder, folder, [*strict(name), *places], Compiler.find([name]))


@every_compiler
@every_scalar
@pytest.mark.parametrize("vehicle", KINDS, ids=lambda v: v.name)
def test_any_optimisation_needs_but_a_root(
    folder: Path, vehicle: Vehicle, scalar: str, name: str
) -> None:
    for level, errno in product(("-O0", "-O2", "-Os"), ("-fmath-errno", "-fno-math-errno")):
        item = compiled(vehicle, scalar, name, folder, "-std=c99", level, errno)
        assert undefined(item) <= {ROOT[scalar], *EITHER_C}, (level, errno)
        found = [word for word in mnemonics(item) if DOUBLE.fullmatch(word)]
        assert not found or scalar == "f64", (level, errno)


def test_double_arithmetic_would_be_seen(tmp_path: Path) -> None:
    source = tmp_path / "double.c"
    for text in ("float f(float x) { return x * 2.1; }", "double f(double x) { return x + x; }"):
        source.write_text(text + "\n", encoding="utf-8")
        item = build_object(source, tmp_path, tmp_path)
        assert [word for word in mnemonics(item) if DOUBLE.fullmatch(word)]


CALLER = """
static int {prefix}_is_good(void)
{{
    const {prefix}_params params = {prefix}_defaults;
    return {prefix}_check_params(&params) == {macro}_OK ? 1 : 0;
}}
"""


def caller(vehicles: tuple[Vehicle, ...]) -> str:
    """A program that uses every header; exit code 0 when all default parameters are good."""
    prefixes = [f"{vehicle.name}_{scalar}" for vehicle in vehicles for scalar in SCALARS]
    lines = [f'#include "{prefix}.h"' for prefix in prefixes * 2]  # twice: the guards hold
    lines += [CALLER.format(prefix=prefix, macro=prefix.upper()) for prefix in prefixes]
    verdict = " && ".join(f"{prefix}_is_good() == 1" for prefix in prefixes)
    return "\n".join([*lines, f"int main() {{ return ({verdict}) ? 0 : 1; }}", ""])


@every_compiler
def test_all_vehicles_link_into_one_image_with_a_cpp_caller(folder: Path, name: str) -> None:
    pairs = list(product(FILES, SCALARS))
    objects = [compiled(vehicle, scalar, name, folder, *FLAGS) for vehicle, scalar in pairs]
    text = folder / f"caller_{name}.cpp"
    text.write_text(caller(FILES), encoding="utf-8")
    flags = ["-std=c++11", *WARNINGS_CXX[name], str(text)]
    flags += [f"-I{subjects.header(vehicle, 'f64', folder).parent}" for vehicle in FILES]
    program = Compiler.find([CPP[name]]).run(
        [*flags, *map(str, objects), "-lm"], folder / f"all_{name}"
    )
    assert subprocess.run([program], check=False).returncode == 0


@every_scalar
def test_every_public_symbol_carries_the_prefix(folder: Path, scalar: str) -> None:
    for vehicle in GUARDED:
        item = compiled(vehicle, scalar, COMPILERS[0], folder, *strict(COMPILERS[0]))
        command = ["nm", "--defined-only", "--extern-only", str(item)]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        symbols = {line.split()[2]: line.split()[1] for line in done.stdout.splitlines()}
        assert all(symbol.startswith(f"{vehicle.name}_{scalar}_") for symbol in symbols)
        # T code and R read-only data: nothing that changes.
        assert set(symbols.values()) == {"T", "R"}


@every_scalar
def test_the_force_may_stand_where_the_acceleration_goes(folder: Path, scalar: str) -> None:
    """`plant` reads all of its inputs before it writes: force and nu_dot may be one array."""
    vehicle = next(v for v in FILES if v.name == "paper_so3")
    prefix, kind = f"{vehicle.name}_{scalar}", {"f32": "float", "f64": "double"}[scalar]
    program = f"""
    #include "{prefix}.h"
    int main(void)
    {{
        const {prefix}_state state = {{ {{0}}, {{1, 2, 3}} }};
        const {kind} force[3] = {{4, 5, 6}};
        {kind} apart[3], same[3] = {{4, 5, 6}};
        {prefix}_plant(&{prefix}_defaults, &state, force, apart);
        {prefix}_plant(&{prefix}_defaults, &state, same, same);
        return apart[0] == same[0] && apart[1] == same[1] && apart[2] == same[2] ? 0 : 1;
    }}
    """
    text = folder / f"alias_{scalar}.c"
    text.write_text(program, encoding="utf-8")
    source = subjects.source(vehicle, scalar, folder)
    include = subjects.header(vehicle, scalar, folder).parent
    flags = [*FLAGS, f"-I{include}", str(text), str(source), "-lm"]
    done = Compiler.find().run(flags, folder / f"alias_{scalar}")
    assert subprocess.run([done], check=False).returncode == 0


def test_a_long_vehicle_name_is_no_trouble(folder: Path) -> None:
    vehicle = replace(FILES[0], name=("vehicle_" * 9)[: LONGEST_NAME - 1] + "s")
    for scalar, name in product(SCALARS, COMPILERS):
        compiled(vehicle, scalar, name, folder, *strict(name))
    for path, text in subjects.texts(vehicle).items():
        if path.endswith((".c", ".h", ".py")):
            wide = [line for line in text.splitlines() if len(line) > 100]
            assert not [line for line in wide if " " in line.strip()], path  # could be broken
