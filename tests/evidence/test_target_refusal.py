"""Missing tools, a compiler that fails, an emulator that hangs, a folder that cannot be written."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from derive.evidence import tool
from derive.evidence.emitted import Emitted, NotEmitted
from derive.evidence.machine import MACHINES, MEASURED
from derive.evidence.target import missing, targets
from derive.evidence.tool import Tool, ToolFailed, run
from derive.verify.check import Check, Report
from tests.command import tree
from tests.evidence.emulated import BY_NAME, M4F, inject, need, package


def one(checks: list[Check]) -> Check:
    (check,) = checks
    return check


def test_every_missing_tool_is_named_with_what_brings_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    emitted = package("paper_so3", "f32", tmp_path)
    monkeypatch.setenv("PATH", str(tmp_path))
    reasons = missing()
    assert len(reasons) == len(MACHINES)
    for machine, reason in zip(MACHINES, reasons, strict=True):
        assert reason.startswith(f"{machine.name} was not run: {machine.compiler.command}")
        assert "apt install" in reason
    assert list(targets([emitted])) == []


def test_a_missing_emulator_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    need(M4F)
    for one in (M4F.compiler, M4F.sizer):
        (tmp_path / one.command).symlink_to(one.path)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert missing([M4F]) == (
        "Cortex-M4F was not run: qemu-system-arm is not on PATH; "
        "get it with: apt install qemu-system-arm",
    )


def test_a_tool_beside_the_compiler_is_named(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    need(M4F)
    for one in filter(None, (M4F.compiler, M4F.emulator)):
        (tmp_path / one.command).symlink_to(one.path)
    monkeypatch.setenv("PATH", str(tmp_path))
    (reason,) = missing([M4F])
    assert reason.startswith("Cortex-M4F was not run: arm-none-eabi-size is not on PATH; get it")


def test_a_missing_library_is_named() -> None:
    need(M4F)
    (reason,) = missing([replace(M4F, needs="libnowhere.a")])
    told = "libnowhere.a is not where arm-none-eabi-gcc looks for it; get it with: apt install"
    assert reason.startswith(f"Cortex-M4F was not run: {told}")


def test_a_compiler_that_fails_is_told_with_its_words(tmp_path: Path) -> None:
    need(BY_NAME["gcc"], M4F)
    emitted = inject(package("paper_so3", "f32", tmp_path), "plant", "not C;")
    emitted.source.write_text(
        emitted.source.read_text().replace("not C;", "\n#ifdef __arm__\nnot C;\n#endif\n")
    )
    checks = list(targets([emitted], machines=[BY_NAME["gcc"], M4F]))
    failed = one([check for check in checks if not check.is_ok])
    assert (failed.name, failed.subject) == ("built and run", "f32 Cortex-M4F")
    assert (failed.measured, failed.samples) == (3, 3)
    for word in ("arm-none-eabi-gcc ended with 1", "command: ", "-mcpu=cortex-m4", "error: "):
        assert word in failed.worst
    assert "\n" not in Report("v", (failed,)).table().splitlines()[2]


def test_a_compiler_that_is_no_program_is_told(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    emitted = package("paper_so3", "f32", tmp_path)
    (tmp_path / "cc-of-nowhere").write_text("not a program", encoding="utf-8")
    (tmp_path / "cc-of-nowhere").chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    machine = replace(BY_NAME["gcc"], compiler=Tool("cc-of-nowhere", "nothing"), needs="libm.a")
    assert missing([machine]) == ()  # it is there, and does not work
    (failed,) = targets([emitted], machines=[machine], levels=[MEASURED])
    assert (failed.name, failed.measured) == ("built and run", 1)
    assert "Exec format error" in failed.worst


def test_an_emulator_that_hangs_is_ended_and_told(tmp_path: Path) -> None:
    need(M4F)
    forever = "\n#ifdef __OPTIMIZE__\n{ volatile int i = 1; while (i) { } }\n#endif\n"
    emitted = inject(package("paper_so3", "f32", tmp_path), "plant", forever)
    start = time.monotonic()
    failed = one([c for c in targets([emitted], machines=[M4F], seconds=2.0) if not c.is_ok])
    assert time.monotonic() - start < 15
    assert failed.measured == 2
    assert "-O2: " in failed.worst
    assert "qemu-system-arm" in failed.worst
    assert "did not end within 2 s" in failed.worst
    elf = failed.worst.split("-kernel ")[1].split()[0]
    commands = (path.read_bytes() for path in Path("/proc").glob("[0-9]*/cmdline"))
    assert not any(elf.encode() in command for command in commands)
    assert not Path(elf).parent.exists()


@pytest.mark.parametrize(
    ("make", "found"),
    [
        (lambda folder: None, "no such folder"),
        (lambda folder: folder.touch(), "a file"),
        (lambda folder: folder.mkdir(), "no c/src/paper_so3_f32.c"),
        (lambda folder: package("paper_so3", "f32", folder.parent).header.unlink(),
         "no c/include/paper_so3_f32.h"),
    ],
)  # fmt: skip
def test_a_folder_that_is_no_package_is_told(
    make: Callable[[Path], None], found: str, tmp_path: Path
) -> None:
    folder = tmp_path / "paper_so3"
    make(folder)
    with pytest.raises(NotEmitted) as told:
        list(targets([Emitted(folder, "paper_so3", "f32")], machines=[M4F]))
    assert str(told.value).startswith(f"{folder}\n  expected: the emitted package of paper_so3")
    assert f"\n  found:    {found}\n  to do:    write it with derive emit" in str(told.value)


def test_a_relative_folder_is_as_good(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    need(BY_NAME["gcc"])
    package("paper_so3", "f32", tmp_path)
    monkeypatch.chdir(tmp_path)
    emitted = Emitted(Path("paper_so3"), "paper_so3", "f32")
    checks = list(targets([emitted], machines=[BY_NAME["gcc"]], levels=[MEASURED]))
    assert [check.name for check in checks if not check.is_ok] == []


def test_a_child_that_left_is_not_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is in a group of its own, and holds what it was given to write on."""
    monkeypatch.setattr(tool, "GRACE", 0.2)
    start = time.monotonic()
    with pytest.raises(ToolFailed, match="did not end within 1 s") as told:
        run(["sh", "-c", "echo its words; setsid sleep 8 & sleep 8"], 1)
    assert time.monotonic() - start < 5
    assert told.value.said == "its words\n"


def test_a_fault_on_the_target_is_told(tmp_path: Path) -> None:
    need(M4F)
    emitted = inject(package("paper_so3", "f32", tmp_path), "plant", "*(volatile int *)0xF0000000;")
    failed = one([c for c in targets([emitted], machines=[M4F], levels=[MEASURED]) if not c.is_ok])
    assert failed.measured == 1
    assert "ended with 98" in failed.worst
    assert "fault" in failed.worst


def test_a_package_is_only_read(tmp_path: Path) -> None:
    need(BY_NAME["gcc"], M4F)
    emitted = package("paper_so3", "f32", tmp_path)
    places = [emitted.folder, *emitted.folder.rglob("*")]
    for place in places:
        place.chmod(0o555 if place.is_dir() else 0o444)
    before = tree(emitted.folder)
    try:
        checks = list(targets([emitted], machines=[BY_NAME["gcc"], M4F], levels=[MEASURED]))
    finally:
        for place in places:
            place.chmod(0o755)
    assert all(check.is_ok for check in checks if check.name in ("built and run", "same bits"))
    assert tree(emitted.folder) == before
