"""Tools that build a package, as a user runs them: cmake, make, and the projects around them."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

APT = {"cmake": "cmake", "make": "make", "gcc": "gcc", "arm-none-eabi-gcc": "gcc-arm-none-eabi"}


def need(tool: str) -> None:
    """Skip, on a laptop, what this machine has no tool for."""
    if shutil.which(tool) is None:
        assert os.environ.get("CI") != "true", f"CI must have {tool}"
        pytest.skip(f"{tool} is not installed: apt install {APT[tool]}")


def run(*command: object, cwd: Path | None = None, code: int = 0) -> str:
    """Its output; a command that ends otherwise, hangs or warns of anything is a failure."""
    words = [str(word) for word in command]
    done = subprocess.run(
        words, check=False, capture_output=True, text=True, cwd=cwd, timeout=60, errors="replace"
    )
    said = done.stdout + done.stderr
    assert done.returncode == code, said
    assert "warning" not in said.lower(), said
    return said


def configure(source: Path, build: Path, *options: str) -> None:
    """Run cmake, with everything that it can be made to complain of."""
    strict = ("-Werror=dev", "-Werror=deprecated", "--warn-uninitialized", "-Wdev")
    keep = ("-G", "Unix Makefiles", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    run("cmake", "-S", source, "-B", build, *keep, *strict, *options)


def make(build: Path, *options: str) -> None:
    run("cmake", "--build", build, *options)


def project(place: Path, main: str, *lines: str) -> Path:
    """A CMake project of a user, with one program that is called `main`."""
    place.mkdir(parents=True, exist_ok=True)
    head = ("cmake_minimum_required(VERSION 3.16)", "project(user LANGUAGES C)")
    (place / "CMakeLists.txt").write_text("\n".join([*head, *lines, ""]), encoding="utf-8")
    (place / "main.c").write_text(main, encoding="utf-8")
    return place


def program(*prefixes: str) -> str:
    """A program that exits with 0 when every controller of those prefixes takes its defaults."""
    lines = [f'#include "{prefix}.h"' for prefix in prefixes]
    good = " && ".join(f"{p}_check_params(&{p}_defaults) == {p.upper()}_OK" for p in prefixes)
    # A call of control, so that the root is linked, whatever the input is worth.
    calls = [
        f"    {{ static {p}_state state; static {p}_reference reference; {p}_command command;\n"
        f"    (void){p}_control(&{p}_defaults, &state, &reference, &command); }}"
        for p in prefixes
    ]
    return "\n".join(
        [*lines, "int main(void)", "{", *calls, f"    return {good} ? 0 : 1;", "}", ""]
    )
