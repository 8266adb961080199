"""Compilers are found, libraries appear whole, and failures say what to do."""

import ctypes
import shutil
import time
from pathlib import Path

import pytest

from derive.native import compile
from derive.native.compile import (
    FLAGS,
    SHARED,
    WARNINGS_C,
    WARNINGS_CXX,
    CompileError,
    Compiler,
    CompilerMissing,
    build,
    build_object,
)
from tests.native import toy

COMPILERS = [name for name in ("gcc", "clang") if shutil.which(name)]


@pytest.mark.parametrize("scalar", ["f32", "f64"])
def test_build_makes_a_library_that_loads(tmp_path: Path, scalar: str) -> None:
    header, source = toy.write(tmp_path, scalar)
    library = build([source], header.parent, tmp_path / "new" / "folder")
    assert library.parent == tmp_path / "new" / "folder"
    assert hasattr(ctypes.CDLL(str(library)), f"toy_{scalar}_control")


@pytest.mark.parametrize("name", COMPILERS)
def test_libraries_of_several_compilers_share_a_folder(tmp_path: Path, name: str) -> None:
    header, source = toy.write(tmp_path, "f64")
    compiler = Compiler.find([name])
    assert compiler.family == name
    library = build([source], header.parent, tmp_path, SHARED, compiler)
    assert library.name == f"libtoy_f64_{name}.so"


@pytest.mark.parametrize("name", COMPILERS)
@pytest.mark.parametrize("scalar", ["f32", "f64"])
def test_strict_warnings_accept_clean_c(tmp_path: Path, name: str, scalar: str) -> None:
    header, source = toy.write(tmp_path, scalar)
    flags = [*FLAGS, *WARNINGS_C[name]]
    assert build_object(source, header.parent, tmp_path, flags, Compiler.find([name])).is_file()


@pytest.mark.parametrize("name", COMPILERS)
@pytest.mark.parametrize(
    "body",
    [
        "float f(double x); float f(double x) { return x; }",
        "double g(float x); double g(float x) { return x * 2.0; }",
        "int e(double x); int e(double x) { return x == 0.1; }",
        "int p(void) { return 0; }",
    ],
    ids=["conversion", "promotion", "float-equal", "missing-prototype"],
)
def test_strict_warnings_refuse_careless_c(tmp_path: Path, name: str, body: str) -> None:
    source = tmp_path / "careless.c"
    source.write_text(body + "\n", encoding="utf-8")
    with pytest.raises(CompileError, match="careless"):
        build_object(source, tmp_path, tmp_path, [*FLAGS, *WARNINGS_C[name]], Compiler.find([name]))


@pytest.mark.parametrize("name", COMPILERS)
def test_a_cpp_caller_sees_a_clean_header(tmp_path: Path, name: str) -> None:
    header, _ = toy.write(tmp_path, "f64")
    source = tmp_path / "caller.cpp"
    text = f'#include "{header.name}"\ndouble k();\ndouble k() {{ return toy_f64_defaults.k_s; }}\n'
    source.write_text(text, encoding="utf-8")
    compiler = Compiler.find([{"gcc": "g++", "clang": "clang++"}[name]])
    flags = ["-std=c++11", *WARNINGS_CXX[name]]
    assert build_object(source, header.parent, tmp_path, flags, compiler).is_file()


def test_a_compile_error_tells_command_and_reason(tmp_path: Path) -> None:
    source = tmp_path / "broken.c"
    source.write_text("int f(void) { return nothing; }\n", encoding="utf-8")
    with pytest.raises(CompileError) as failure:
        build([source], tmp_path, tmp_path / "out")
    assert "-ffp-contract=off" in failure.value.command
    assert "nothing" in failure.value.stderr
    assert str(source) in str(failure.value)
    assert list((tmp_path / "out").iterdir()) == []


def test_a_compiler_that_hangs_is_ended_and_told(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (tmp_path / "cc").write_text("#!/bin/sh\nexec sleep 60\n", encoding="utf-8")
    (tmp_path / "cc").chmod(0o755)
    monkeypatch.setattr(compile, "SECONDS", 0.2)
    start = time.monotonic()
    with pytest.raises(CompileError, match=r"cc x\.c -o .*\nit did not end within 0\.2 s"):
        Compiler("cc", tmp_path / "cc").run(["x.c"], tmp_path / "x.so")
    assert time.monotonic() - start < 5
    assert not (tmp_path / "x.so").exists()


def test_a_failed_build_leaves_the_last_library(tmp_path: Path) -> None:
    header, source = toy.write(tmp_path, "f64")
    library = build([source], header.parent, tmp_path)
    before = library.read_bytes()
    source.write_text("syntax error", encoding="utf-8")
    with pytest.raises(CompileError):
        build([source], header.parent, tmp_path)
    assert library.read_bytes() == before


def test_a_missing_compiler_says_how_to_get_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(CompilerMissing, match="apt install gcc"):
        build([tmp_path / "any.c"], tmp_path, tmp_path)


def test_the_environment_does_not_choose_the_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    expected = Compiler.find()
    monkeypatch.setenv("CC", "/nowhere/cc")
    assert Compiler.find() == expected
