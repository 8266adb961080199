"""What README.md tells to write into one's own build, written there; and a bare target."""

import re
import shlex
from dataclasses import replace
from pathlib import Path

import pytest

from tests.emit import subjects
from tests.emit.package import configure, make, need, program, project, run
from tests.emit.subjects import FILES

README = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
SECTION = README.partition("### Into your build\n")[2].partition("\n###")[0]
BODY = replace(next(v for v in FILES if v.name == "paper_so3"), name="my_sat")
MAIN = program("my_sat_f64", "my_sat_f32")

M4F = ("-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard")
TOOLCHAIN = f"""
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_C_FLAGS_INIT "{" ".join(M4F)}")
"""
LINKED = {
    "nothing links": "set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)\n",
    "semihosting": 'set(CMAKE_EXE_LINKER_FLAGS_INIT "--specs=rdimon.specs")\n',
}
"""How a toolchain file lets CMake try the compiler."""


def block(language: str, holds: str = "") -> str:
    """The one block of that language in the section that holds a word."""
    found = re.findall(rf"^```{language}\n(.*?)^```$", SECTION, re.M | re.S)
    (text,) = [one for one in found if holds in one]
    return str(text)


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """A project that holds generated/my_sat and nothing else."""
    subjects.place(BODY, tmp_path / "generated")
    return tmp_path


@pytest.mark.parametrize("is_found", [False, True], ids=["add_subdirectory", "find_package"])
def test_the_lines_for_cmake(place: Path, is_found: bool) -> None:
    need("cmake")
    lines = block("cmake").splitlines()
    options: tuple[str, ...] = ()
    if is_found:
        configure(place / "generated" / "my_sat", place / "own")
        make(place / "own")
        run("cmake", "--install", place / "own", "--prefix", place / "prefix")
        (found,) = re.findall(r"`(find_package\(.*?\))`", SECTION)
        lines[0] = found
        options = (f"-DCMAKE_PREFIX_PATH={place / 'prefix'}",)
    configure(project(place, MAIN, *lines), place / "build", *options)
    make(place / "build")
    run(place / "build" / "flight")


def test_the_lines_for_make(place: Path) -> None:
    need("make")
    (place / "main.c").write_text(MAIN, encoding="utf-8")
    (place / "Makefile").write_text(block("make"), encoding="utf-8")
    run("make", "--warn-undefined-variables", cwd=place)
    run(place / "flight")


def test_the_line_for_a_compiler_alone(place: Path) -> None:
    need("arm-none-eabi-gcc")
    line = block("console", "arm-none-eabi-gcc -mcpu").removeprefix("$ ").replace("\\\n", "")
    assert set(M4F) <= set(shlex.split(line))
    run(*shlex.split(line), "-Wall", "-Wextra", "-Werror", cwd=place)
    said = run("arm-none-eabi-nm", "-u", place / "my_sat_f32.o")
    assert set(re.findall(r"U (\w+)", said)) == set()


def test_the_line_for_its_own_test(place: Path) -> None:
    need("cmake")
    said = run("sh", "-c", block("console", "ctest").removeprefix("$ "), cwd=place)
    assert "100% tests passed" in said


@pytest.mark.parametrize("linked", LINKED)
def test_a_toolchain_file_for_a_bare_target(place: Path, linked: str) -> None:
    """M4F computes sqrtf and calls sqrt: a package of both scalars hands on m, linked or not."""
    need("cmake")
    need("arm-none-eabi-gcc")
    (place / "bare.cmake").write_text(TOOLCHAIN + LINKED[linked], encoding="utf-8")
    for scalars, wants in ((("f32", "f64"), True), (("f32",), linked == "nothing links")):
        root = subjects.place(replace(BODY, scalars=scalars), place / scalars[-1])
        build = place / f"build_{scalars[-1]}"
        release = "-DCMAKE_BUILD_TYPE=Release"
        configure(root, build, f"-DCMAKE_TOOLCHAIN_FILE={place / 'bare.cmake'}", release)
        make(build)
        assert not list(build.glob("*_example*"))
        run("cmake", "--install", build, "--prefix", build / "prefix")
        (told,) = (build / "prefix").rglob("my_satConfig.cmake")
        links = re.findall(r'INTERFACE_LINK_LIBRARIES "(.*)"', told.read_text(encoding="utf-8"))
        assert links == ["m"] * wants
