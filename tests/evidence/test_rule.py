"""The rules: kept by what is emitted, and every kind of breach is found."""

import re
import shutil
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from derive.emit.deviation import DEVIATIONS, LONGEST, long_functions
from derive.evidence import diagnostic, misra, symbol
from derive.evidence.diagnostic import COMPILERS, compiled, tidied
from derive.evidence.documentation import documented
from derive.evidence.emitted import Emitted
from derive.evidence.tool import ToolFailed, ToolMissing, run
from derive.verify.check import Check
from tests.evidence.tools import had, hide

GENERATED = Path(__file__).parents[2] / "generated"
NAMES = ("paper_s3", "paper_so3", "sl2", "underwater")  # one of each kind of configuration
EVERY = [Emitted(GENERATED / name, name, scalar) for name in NAMES for scalar in ("f32", "f64")]
FLOAT, DOUBLE = (Emitted(GENERATED / "paper_so3", "paper_so3", s) for s in ("f32", "f64"))
SPATIAL = Emitted(GENERATED / "underwater", "underwater", "f32")
SMALL = Emitted(GENERATED / "paper_so3_lsf", "paper_so3_lsf", "f32")  # what is spoilt below
P = SMALL.prefix
CALLS = "calls through a pointer"

Kind = Callable[[Emitted], Iterator[Check]]


def broken(kind: Kind, one: Emitted) -> dict[str, str]:
    """The checks that fail, by name, with the first finding of each."""
    return {c.name: c.worst for c in had(lambda: list(kind(one))) if not c.is_ok}


@pytest.fixture
def copy(tmp_path: Path) -> Emitted:
    """A package to be spoilt."""
    shutil.copytree(SMALL.folder, tmp_path / SMALL.name)
    return replace(SMALL, folder=tmp_path / SMALL.name)


def spoil(one: Emitted, text: str) -> None:
    """Add to the source."""
    one.source.write_text(one.source.read_text(encoding="utf-8") + text, encoding="utf-8")


def function(head: str, *lines: str) -> str:
    """A function with its prototype."""
    return "\n".join(["", f"{head};", head, "{", *(f"    {line}" for line in lines), "}", ""])


@pytest.mark.parametrize("kind", [compiled, tidied, documented])
def test_all_that_is_emitted_is_clean(kind: Kind) -> None:
    assert {one.prefix: bad for one in EVERY if (bad := broken(kind, one))} == {}


@pytest.mark.parametrize("one", [FLOAT, DOUBLE, SPATIAL], ids=lambda one: one.prefix)
def test_misra_finds_what_the_table_says(one: Emitted) -> None:
    checks = had(lambda: list(misra.misra(one)))
    assert [c.worst for c in checks if not c.is_ok] == []
    assert checks[0].samples > len(DEVIATIONS)
    assert all(re.match(r"\d+\.\d+: \d+ places, first in line \d+", d) for d in checks[0].details)


@pytest.mark.parametrize("one", [FLOAT, DOUBLE, SPATIAL], ids=lambda one: one.prefix)
def test_nothing_is_called_but_the_root(one: Emitted) -> None:
    checks = had(lambda: list(symbol.symbols(one)))
    assert [c.worst for c in checks if not c.is_ok] == []
    root = "sqrtf" if one.scalar == "f32" else "sqrt"
    assert root in checks[0].details[0].split(", ")


@pytest.mark.parametrize(
    "text",
    [
        function(f"void {P}_a(void)", "int unused;"),
        function(f"float {P}_b(float x)", "return x * 0.5;"),
        function(f"int {P}_c(int n)", "float row[n];", "row[0] = 1.0F;", "return row[0] > 0.0F;"),
        f"\nvoid {P}_undeclared(void)\n{{\n}}\n",
    ],
    ids=["unused", "promoted", "variable length", "undeclared"],
)
def test_every_compiler_warns(copy: Emitted, text: str) -> None:
    spoil(copy, text)
    assert list(broken(compiled, copy)) == [f"{name}: warnings" for name in COMPILERS]


def test_the_example_and_the_self_test_are_compiled_too(copy: Emitted) -> None:
    assert [file.name for file in diagnostic.units(DOUBLE)][:2] == [DOUBLE.source.name, "main.c"]
    place = copy.folder / "test"
    place.mkdir(exist_ok=True)
    (place / "more.c").write_text(
        f'#include "{P}.h"\n{function("int more(int x)", "int y;", "return x;")}', encoding="utf-8"
    )
    assert len(broken(compiled, copy)) == len(COMPILERS)


def test_clang_tidy_finds_a_path_without_a_value(copy: Emitted) -> None:
    lines = ("int y;", "if (x > 0) {", "    y = 1;", "}", "return y;")
    spoil(copy, function(f"int {P}_a(int x)", *lines))
    (found,) = broken(tidied, copy).values()
    assert "clang-analyzer" in found


def test_a_long_function_needs_a_row(copy: Emitted) -> None:
    body = [f"x += {i};" for i in range(LONGEST - 1)]
    spoil(copy, function(f"int {P}_a(int x)", *body, "return x;"))
    assert broken(tidied, copy) == {
        f"functions over {LONGEST} lines: no row": f"{P}_a: {LONGEST + 1} lines"
    }
    text = copy.source.read_text(encoding="utf-8")
    assert (f"{P}_a", LONGEST + 1) in long_functions({"c/src/it.c": text})
    copy.source.write_text(text.replace("    x += 7;\n", ""), encoding="utf-8")
    assert broken(tidied, copy) == {}


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("/**< control force [N m] */", "/* control force [N m] */"),
        ("/** What was found.", "/* What was found."),
        (" * @param[in] force applied", " * @param[in] power applied"),
        (" * @return the largest", " * the largest"),
        ("/** largest velocity", "/* largest velocity"),
    ],
)
def test_doxygen_misses_what_is_not_described(copy: Emitted, old: str, new: str) -> None:
    text = copy.header.read_text(encoding="utf-8")
    assert text.count(old) == 1
    copy.header.write_text(text.replace(old, new), encoding="utf-8")
    assert list(broken(documented, copy)) == ["doxygen: warnings"]


@pytest.mark.parametrize(
    ("rule", "text"),
    [
        ("7.1", function(f"int {P}_a(int x)", "return x + 010;")),
        (
            "12.3",
            function(
                f"int {P}_a(int x)", "int i;", "for (i = 0, x = 1; i < x; i++) {", "}", "return i;"
            ),
        ),
        ("15.1", function(f"int {P}_a(int x)", "goto end;", "end:", "return x;")),
        ("17.2", function(f"int {P}_a(int x)", f"return {P}_a(x);")),
        ("21.3", "\n#include <stdlib.h>" + function(f"void *{P}_a(void)", "return malloc(1);")),
        ("unreadVariable", function(f"void {P}_a(void)", "int x;", "x = 1;")),
    ],
)
def test_a_departure_without_a_row_is_found(copy: Emitted, rule: str, text: str) -> None:
    """Rule 12.3 has a row, of declarations: a true comma operator is none of these."""
    spoil(copy, text)
    found = had(lambda: misra.findings(copy))
    added = copy.source.read_text(encoding="utf-8").count("\n") - text.count("\n")
    assert rule in {f.rule for f in found if f.line > added}
    assert list(broken(misra.misra, copy)) == ["cppcheck, MISRA C:2012: no row"]


@pytest.mark.parametrize(
    ("old", "new", "name"),
    [
        ("| 8.7 | advisory", "| 9.9 | advisory", "cppcheck, MISRA C:2012: no row"),
        ("| 8.7 | advisory |", "| 8.7 |", "cppcheck, MISRA C:2012: no row"),
        (
            "| 8.7 | adv",
            "| 8.1 | required | all | none |\n| 8.7 | adv",
            "deviations: nothing found",
        ),
    ],
)
def test_the_table_in_the_package_counts(copy: Emitted, old: str, new: str, name: str) -> None:
    place = copy.folder / "DEVIATIONS.md"
    text = place.read_text(encoding="utf-8")
    assert text.count(old) == 1
    place.write_text(text.replace(old, new), encoding="utf-8")
    assert name in broken(misra.misra, copy)


def test_a_row_that_nothing_needs_is_found(copy: Emitted) -> None:
    """A source that keeps to every rule has no use for the table."""
    copy.source.write_text("/* nothing */\n", encoding="utf-8")
    assert list(broken(misra.misra, copy)) == ["deviations: nothing found"]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("calls other than sqrt, memcpy, memset",
         function(f"double {P}_a(double x)", "return sin(x);")),
        ("calls other than sqrt, memcpy, memset",
         "\n#include <stdlib.h>" + function(f"void *{P}_a(int n)", "return malloc((unsigned)n);")),
        ("data that can be written to",
         function(f"int {P}_a(void)", "static int count;", "count++;", "return count;")),
        ("data that can be written to", f"\nint {P}_one = 1;\n"),
        ("names without the prefix", function("int a(void)", "return 1;")),
        ("functions that call themselves",
         f"\nint {P}_b(int x);" + function(f"int {P}_a(int x)", f"return {P}_b(x) + 1;")
         + function(f"int {P}_b(int x)", f"return x > 0 ? {P}_a(x - 1) : 0;")),
        ("calls through a pointer", function(f"int {P}_a(int (*f)(int))", "return f(1);")),
    ],
    ids=["libm", "heap", "static", "global", "name", "recursion", "pointer"],
)  # fmt: skip
def test_the_object_file_tells(copy: Emitted, name: str, text: str) -> None:
    spoil(copy, text)
    assert list(broken(symbol.symbols, copy)) == [name]


def test_cppcheck_writes_nothing_beside_the_source(monkeypatch: pytest.MonkeyPatch) -> None:
    """It keeps a dump beside what it reads: so it must not read the package itself."""
    asked: list[str] = []

    def seen(command: Sequence[str], *others: Any, **named: Any) -> str:
        asked.extend(command)
        return run(command, *others, **named)

    monkeypatch.setattr(misra, "run", seen)
    assert had(lambda: misra.findings(SMALL))
    assert [word for word in asked if str(SMALL.folder) in word] == []


def test_one_compiler_less_spares_those_after_it(monkeypatch: pytest.MonkeyPatch) -> None:
    had(lambda: list(compiled(FLOAT)))
    hide(monkeypatch, "clang")
    for rule, name in ((compiled, "arm-none-eabi-gcc: warnings"), (symbol.symbols, CALLS)):
        found: list[Check] = []
        with pytest.raises(ToolMissing, match=r"^clang is not on PATH; get it with: apt"):
            found.extend(rule(FLOAT))
        assert name in [check.name for check in found]


def test_a_source_that_does_not_compile_is_no_evidence(copy: Emitted) -> None:
    spoil(copy, "\n#error broken\n")
    assert len(broken(compiled, copy)) == len(COMPILERS)
    with pytest.raises(ToolFailed, match="broken"):
        had(lambda: list(symbol.symbols(copy)))
