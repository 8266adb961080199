"""`derive check` shows where a folder is not what its vehicle gives, and what mends it."""

import re
from pathlib import Path

import pytest

from tests.command import FILES, ROOT, derive, refused


def drifted(place: Path, home: Path, *arguments: str) -> list[str]:
    result = derive(place, "check", *arguments, home=home)
    assert (result.returncode, result.stderr) == (1, "")
    return result.stdout.splitlines()


@pytest.mark.parametrize(
    ("find", "put", "expected", "found"),
    [
        ("#include <math.h>", "#include <maths.h>", "#include <math.h>", "#include <maths.h>"),
        (
            "#include <math.h>\n",
            "#include <math.h>\r\n",
            "#include <math.h>",
            "'#include <math.h>\\r'",
        ),
        ("#include <math.h>", "#include <math.h> ", "#include <math.h>", "'#include <math.h> '"),
        ("#include <math.h>\n", "", "#include <math.h>", "an empty line"),
        ("#include <math.h>", "\udcff", "#include <math.h>", "'\\udcff'"),
    ],
    ids=["word", "return", "blank", "gone", "bytes"],
)
def test_drift_is_shown_by_its_first_line(
    body: Path, home: Path, find: str, put: str, expected: str, found: str
) -> None:
    derive(body.parent, "emit", body.name, home=home)
    source = body.parent / "generated" / "body" / "c" / "src" / "body_f64.c"
    text = source.read_text()
    number = text[: text.index(find)].count("\n") + 1
    source.write_bytes(text.replace(find, put).encode("utf-8", "surrogateescape"))
    assert drifted(body.parent, home, body.name) == [
        f"generated/body/c/src/body_f64.c:{number}",
        f"  expected: {expected}",
        f"  found:    {found}",
        "update with: derive emit body.toml",
    ]


def test_missing_and_unknown_files_are_drift_and_the_command_shown_mends(
    body: Path, home: Path
) -> None:
    place = body.parent
    assert len(drifted(place, home, body.name)) == 3 * 16 + 1
    derive(place, "emit", body.name, "--out", "my out", home=home)
    module = place / "my out" / "body" / "numpy" / "body.py"
    module.write_text(module.read_text().removesuffix("\n"))
    (place / "my out" / "body" / "c" / "include" / "body_f32.h").unlink()
    lines = drifted(place, home, body.name, "--out", "my out")
    assert next(line for line in lines if line.startswith("my out")).endswith("body_f32.h")
    assert "(without a newline)" in lines[-2]
    assert lines[-1] == "update with: derive emit body.toml --out 'my out'"
    derive(place, "emit", body.name, "--out", "my out", home=home)
    result = derive(place, "check", body.name, "--out", "my out", home=home)
    assert (result.returncode, result.stdout) == (0, "same my out/body\n")


def test_check_takes_the_vehicles_of_the_current_folder(body: Path, home: Path) -> None:
    assert "vehicles/*.toml" in refused(body.parent, "check", home=home)
    result = derive(ROOT, "check", home=home)
    assert result.returncode == 0
    assert re.fullmatch(r"(note: not written yet: .*\n)?", result.stderr)
    assert result.stdout.splitlines() == [f"same generated/{Path(file).stem}" for file in FILES]
