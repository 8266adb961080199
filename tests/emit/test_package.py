"""The emitted folder is a C package: for CMake, for make, and with an example that runs."""

import json
import re
import subprocess
import tomllib
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from derive import __version__
from derive.emit import around
from derive.native.compile import FLAGS, WARNINGS_C, Compiler
from derive.vehicle import Vehicle
from tests.emit import subjects
from tests.emit.package import configure, make, need, program, project, run
from tests.emit.subjects import COMPILERS, FILES, STEERED

BY_NAME = {vehicle.name: vehicle for vehicle in FILES}
SINGLE = tuple(
    replace(BY_NAME[name], name=f"{name}_single", scalars=("f32",))
    for name in ("paper_so3", "paper_s3")
)
FREE = next(v for v in STEERED if v.controller == "reaching" and v.group == "SE2")
"""A controller without a reference."""

SHOWN = (*FILES, *SINGLE, FREE)
LOOSE = tuple(flag for flag in FLAGS if flag != "-O2")

every_shown = pytest.mark.parametrize("vehicle", SHOWN, ids=lambda v: v.name)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("packages")


def example(root: Path, vehicle: Vehicle, name: str, *changed: tuple[str, str]) -> Path:
    """The example and the code it calls, compiled under the strictest warnings."""
    scalar = vehicle.scalars[-1]
    texts = [root / "example" / "main.c", root / f"c/src/{vehicle.name}_{scalar}.c"]
    for number, (path, (old, new)) in enumerate(zip(texts, changed, strict=False)):
        text = path.read_text(encoding="utf-8")
        assert old == new or text.count(old) == 1
        texts[number] = root / f"changed_{path.name}"
        texts[number].write_text(text.replace(old, new), encoding="utf-8")
    flags = [*FLAGS, *WARNINGS_C[name], f"-I{root / 'c/include'}", *map(str, texts), "-lm"]
    return Compiler.find([name]).run(flags, root / f"example_{name}")


@every_shown
def test_the_example_is_clean_and_runs_to_its_end(folder: Path, vehicle: Vehicle) -> None:
    root = subjects.place(vehicle, folder)
    for name in COMPILERS:
        run(example(root, vehicle, name))


def test_the_example_ends_where_it_must_not_fly(tmp_path: Path) -> None:
    vehicle = BY_NAME["paper_so3"]
    root = subjects.place(vehicle, tmp_path)
    same, name = ("", ""), COMPILERS[0]
    run(example(root, vehicle, name, same, ("0.5, /* lambda */", "-0.5, /* lambda */")), code=1)
    for broken in ("0.0, 0.0, 0.0, 0.0", "0.0/0.0, 0.0, 0.0, 1.0"):
        run(example(root, vehicle, name, ("0.6, 0.0, 0.0, 0.8", broken)), code=2)
    call = "from_xyzw(measured, state->g);"
    run(example(root, vehicle, name, (call, f"{call} state->g[0] += 1e-3;")), code=2)


BORDER = """
#define main example_main
#include "example/main.c"
#undef main
#include <stdio.h>
#include <stdlib.h>
int main(int count, char **words)
{
    KIND q[4], g[9];
    int i;
    for (i = 0; i < 4 && count > 4; i++) { q[i] = (KIND)atof(words[i + 1]); }
    from_xyzw(q, g);
    for (i = 0; i < STORED; i++) { printf("%.17g ", (double)g[i]); }
    return example_main();
}
"""

QUATERNIONS = (
    (0, 0, 0, 1),
    (0.6, 0, 0, 0.8),
    (1, 2, -3, 4),
    (-0.1, 0.2, 0.3, -0.9),
    (0, 1e-3, 1, 0),
)


@pytest.mark.parametrize(
    "vehicle", [BY_NAME["paper_so3"], BY_NAME["paper_s3"], *SINGLE], ids=lambda v: v.name
)
def test_the_border_is_scipy_s_rotation(folder: Path, vehicle: Vehicle) -> None:
    """A quaternion, scalar last, of any length: what drivers give, and what scipy takes."""
    root, scalar = subjects.place(vehicle, folder), vehicle.scalars[-1]
    kind, eps = {"f32": ("float", 2.0**-23), "f64": ("double", 2.0**-52)}[scalar]
    stored = {"SO3": 9, "S3": 4}[vehicle.group]
    (root / "border.c").write_text(BORDER, encoding="utf-8")
    sources = [str(root / "border.c"), str(root / f"c/src/{vehicle.name}_{scalar}.c")]
    flags = [f"-DKIND={kind}", f"-DSTORED={stored}", f"-I{root}", f"-I{root / 'c/include'}"]
    built = Compiler.find().run([*FLAGS, *flags, *sources, "-lm"], root / "border")
    for q in QUATERNIONS:
        found = np.array(run(built, *q).split(), float)
        turn = Rotation.from_quat(np.array(q, np.float32 if scalar == "f32" else float))
        right = turn.as_matrix().ravel() if stored == 9 else np.roll(turn.as_quat(), 1)
        np.testing.assert_allclose(found, right, rtol=0, atol=8 * eps)


def test_a_group_without_an_attitude_has_no_border(folder: Path) -> None:
    for vehicle in SHOWN:
        text = (subjects.place(vehicle, folder) / "example/main.c").read_text(encoding="utf-8")
        assert ("from_xyzw(measured" in text) == (vehicle.group in ("SO3", "S3"))


@every_shown
def test_no_file_has_a_place_on_this_machine(vehicle: Vehicle) -> None:
    texts = subjects.texts(vehicle)
    for path, text in texts.items():
        assert not re.search(r"""(^|[\s"'=(:]|-I)(/|~/|[A-Z]:\\)[A-Za-z]""", text), path
    hashes = tomllib.loads(texts["MANIFEST.toml"])["files"]
    assert {"CMakeLists.txt", f"{vehicle.name}.mk", "example/main.c"} <= hashes.keys()
    for path, told in hashes.items():
        assert sha256(texts[path].encode()).hexdigest() == told


def test_what_was_not_emitted_is_not_built() -> None:
    for path, text in subjects.texts(SINGLE[0]).items():
        words = re.sub(r'"[0-9a-f]{64}"', '""', text)  # a hash may hold any letters
        assert "f64" not in words or path == "trace.csv" or path.endswith(".py"), path
    numpy = subjects.texts(replace(BY_NAME["sl2"], targets=("numpy",)))
    assert sorted(numpy) == ["MANIFEST.toml", "numpy/sl2.py", "trace.csv"]


def test_the_flags_are_those_that_everything_was_judged_under() -> None:
    assert around.FLAGS == LOOSE


def undefined(item: Path) -> set[str]:
    done = subprocess.run(["nm", "-u", item], capture_output=True, text=True, check=True)
    return {line.split()[-1] for line in done.stdout.splitlines() if " U " in line}


@pytest.mark.parametrize("name", ["paper_so3", "paper_s3", "underwater"])
@pytest.mark.parametrize("kind", ["Debug", "Release"])
def test_cmake_builds_a_package_on_its_own(
    folder: Path, tmp_path: Path, name: str, kind: str
) -> None:
    need("cmake")
    configure(subjects.place(BY_NAME[name], folder), tmp_path, f"-DCMAKE_BUILD_TYPE={kind}")
    make(tmp_path)
    run(tmp_path / f"{name}_example")
    archive = tmp_path / f"lib{name}.a"  # static by default
    calls = bool(undefined(archive) & {"sqrt", "sqrtf"})
    link = (tmp_path / f"CMakeFiles/{name}_example.dir/link.txt").read_text(encoding="utf-8")
    assert calls == (" -lm" in link)


def test_two_packages_in_one_project(folder: Path, tmp_path: Path) -> None:
    need("cmake")
    pair = [BY_NAME["paper_so3"], BY_NAME["quadrotor"]]
    roots = [subjects.place(vehicle, folder) for vehicle in pair]
    user = project(
        tmp_path / "user",
        program(*(f"{v.name}_{scalar}" for v in pair for scalar in v.scalars)),
        *(f"add_subdirectory({root} {root.name})" for root in roots),
        "add_executable(main main.c)",
        f"target_link_libraries(main {' '.join(f'{v.name}::{v.name}' for v in pair)})",
    )
    build = tmp_path / "build"
    configure(user, build)
    make(build)
    run(build / "main")
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    assert len(commands) == 5  # no example is built in another's project
    for one in commands:
        is_ours = not one["file"].endswith("main.c")
        assert [flag in one["command"].split() for flag in LOOSE] == [is_ours] * len(LOOSE)


def test_an_installed_package_is_found(folder: Path, tmp_path: Path) -> None:
    need("cmake")
    name = "underwater"
    configure(subjects.place(BY_NAME[name], folder), tmp_path / "own")
    make(tmp_path / "own")
    run("cmake", "--install", tmp_path / "own", "--prefix", tmp_path / "prefix")
    (tmp_path / "prefix").rename(tmp_path / "moved")  # what is installed may be moved
    user = project(
        tmp_path / "user",
        program(f"{name}_f64", f"{name}_f32"),
        f"find_package({name} REQUIRED)",
        "add_executable(main main.c)",
        f"target_link_libraries(main {name}::{name})",
    )
    configure(user, tmp_path / "build", f"-DCMAKE_PREFIX_PATH={tmp_path / 'moved'}")
    make(tmp_path / "build")
    run(tmp_path / "build" / "main")
    major, _, rest = __version__.partition(".")
    for asked, is_found in ((__version__, 1), (major, 1), (f"{int(major) + 1}.{rest}", 0)):
        line = f"find_package({name} {asked} QUIET)"
        told = f'message(STATUS "found ${{{name}_FOUND}} ${{{name}_VERSION}}")'
        user = project(tmp_path / asked, "int main(void) { return 0; }", line, told)
        here = ("-S", user, "-B", user / "build", f"-DCMAKE_PREFIX_PATH={tmp_path / 'moved'}")
        assert (f"-- found 1 {__version__}" in run("cmake", *here)) == is_found


def test_a_makefile_takes_two_fragments(tmp_path: Path) -> None:
    need("make")
    pair = [BY_NAME["paper_s3"], BY_NAME["freeflyer"]]
    for vehicle in pair:
        subjects.place(vehicle, tmp_path)
    (tmp_path / "user").mkdir()
    text = program(*(f"{v.name}_{scalar}" for v in pair for scalar in v.scalars))
    (tmp_path / "user" / "main.c").write_text(text, encoding="utf-8")
    each = {
        word: " ".join(f"$({v.name}_{word})" for v in pair)
        for word in ("SOURCES", "CPPFLAGS", "CFLAGS", "LDLIBS")
    }
    lines = [f"include ../{vehicle.name}/{vehicle.name}.mk" for vehicle in pair]
    lines += [f"main: main.c {each['SOURCES']}"]
    lines += [f"\t$(CC) -O2 {each['CPPFLAGS']} {each['CFLAGS']} -o $@ $^ {each['LDLIBS']}"]
    (tmp_path / "user" / "Makefile").write_text("\n".join([*lines, ""]), encoding="utf-8")
    said = run("make", "--warn-undefined-variables", cwd=tmp_path / "user")
    assert all(flag in said for flag in LOOSE)
    run(tmp_path / "user" / "main")
