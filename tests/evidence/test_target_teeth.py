"""Defects that only a target shows, each put into the emitted code, each found."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from derive.evidence.machine import MACHINES, MEASURED
from derive.evidence.target import targets
from derive.verify.check import Check
from tests.evidence.emulated import BY_NAME, M4F, inject, need, package


def measured(folder: Path, routine: str = "plant", statement: str = "") -> dict[str, Check]:
    """Checks of paper_so3 on an M4F, by name, with a statement put into a routine."""
    need(M4F)
    emitted = package("paper_so3", "f32", folder)
    if statement:
        inject(emitted, routine, statement)
    return {check.name: check for check in targets([emitted], machines=[M4F], levels=[MEASURED])}


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Check]:
    return measured(tmp_path_factory.mktemp("sound"))


def test_twice_the_same(sound: dict[str, Check], tmp_path: Path) -> None:
    assert measured(tmp_path) == sound


def test_another_result_on_one_machine_only(tmp_path: Path) -> None:
    need(BY_NAME["gcc"], M4F)
    emitted = package("paper_so3", "f32", tmp_path)
    text = emitted.source.read_text(encoding="utf-8")
    old = "turn_0 = nu_e_2*power_1 - nu_e_1*power_2;"
    assert text.count(old) == 1
    harmed = old.replace("nu_e_2*", "1.0000001F*nu_e_2*")
    new = f"\n#ifdef __arm__\n {harmed}\n#else\n{old}\n#endif\n"
    emitted.source.write_text(text.replace(old, new), encoding="utf-8")
    pair = [BY_NAME["gcc"], M4F]
    same = [
        c for c in targets([emitted], machines=pair, levels=[MEASURED]) if c.name == "same bits"
    ]
    assert [check.is_ok for check in same] == [True, False]
    assert "control, case" in same[1].details[0]
    assert any("tracking, case" in row for row in same[1].details)
    assert not any("plant" in row for row in same[1].details)


@pytest.mark.parametrize(
    ("expression", "word"),
    [("1.0F/zero", "division by zero"), ("zero/zero", "invalid"), ("big*big", "overflow")],
)
def test_a_flag(tmp_path: Path, expression: str, word: str) -> None:
    numbers = "volatile float zero = 0.0F, big = 1.0e30F, result"
    checks = measured(tmp_path, "plant", f"{{ {numbers}; result = {expression}; (void)result; }}")
    assert not checks["flags"].is_ok
    assert f"plant, case 0: {word}" in checks["flags"].worst
    assert all("plant" in row for row in checks["flags"].details)
    assert checks["same bits"].is_ok  # nothing else tells


def test_instructions_are_counted_one_by_one(sound: dict[str, Check], tmp_path: Path) -> None:
    checks = measured(tmp_path, "plant", '__asm__ volatile(".rept 7\\n nop\\n .endr");')
    for name in ("instructions, plant", "instructions, control"):
        added = checks[name].measured - sound[name].measured
        assert added == (7 if name.endswith("plant") else 0)


def test_a_clock_that_is_wrong(tmp_path: Path) -> None:
    need(M4F)
    options = tuple(option.replace("shift=10", "shift=9") for option in M4F.options)
    assert options != M4F.options
    halved = replace(M4F, options=options)
    emitted = package("paper_so3", "f32", tmp_path)
    checks = {c.name: c for c in targets([emitted], machines=[halved], levels=[MEASURED])}
    assert not checks["clock"].is_ok
    assert checks["clock"].worst.endswith("for 65")


def test_a_law_whose_time_tells_the_angle(sound: dict[str, Check], tmp_path: Path) -> None:
    loop = "{ volatile int i; for (i = 0; i < (int)(20.0F*state->g[0]); i++) { } }"
    checks = measured(tmp_path, "tracking", loop)
    assert sound["tracking, most over least"].is_ok
    assert not checks["tracking, most over least"].is_ok


def test_a_stack_beyond_the_limit(tmp_path: Path) -> None:
    checks = measured(tmp_path, "tracking", "{ volatile float row[64]; row[0] = 0.0F; (void)row; }")
    assert not checks["stack, tracking"].is_ok
    assert not checks["stack, control"].is_ok
    assert checks["painted stack, tracking"].is_ok


def test_a_stack_that_the_compiler_does_not_know_of(tmp_path: Path) -> None:
    hidden = '__asm__ volatile("sub sp, #512\\n str r0, [sp]\\n add sp, #512" ::: "memory");'
    checks = measured(tmp_path, "tracking", hidden)
    assert checks["stack, tracking"].is_ok
    assert not checks["painted stack, tracking"].is_ok


def test_a_stack_without_a_bound(tmp_path: Path) -> None:
    call = "paper_so3_f32_plant(params, state, force, nu_dot);"
    checks = measured(tmp_path, "plant", f"{{ volatile int stop = 1; if (!stop) {{ {call} }} }}")
    assert not checks["stack, plant"].is_ok
    assert checks["stack, plant"].worst.endswith("recursion")
    assert checks["stack, tracking"].is_ok


def test_a_global_that_changes(tmp_path: Path) -> None:
    checks = measured(tmp_path, "plant", "static volatile int calls; calls++;")
    assert checks["mutable, all routines"].measured == 4
    assert not checks["mutable, all routines"].is_ok


def test_a_self_test_that_fails(tmp_path: Path) -> None:
    need(M4F)
    emitted = package("paper_so3", "f32", tmp_path)
    test = emitted.folder / "test" / f"{emitted.prefix}_test.c"
    text = test.read_text(encoding="utf-8")
    head = f"int {emitted.prefix}_test(void)\n{{\n"
    assert text.count(head) == 1
    test.write_text(text.replace(head, f"{head}    if (sizeof(void *) == 4) {{ return 2; }}\n"))
    checks = {check.name: check for check in targets([emitted], machines=[M4F])}
    assert checks["self-test"].measured == 6
    assert checks["self-test"].worst == "-O0: 2, -O2: 2, -O3: 2"


def test_every_machine_has_a_level_and_a_scalar() -> None:
    assert {machine.name for machine in MACHINES} == {
        "gcc", "clang", "Cortex-M4F", "Cortex-M7", "RV32", "RV64",
    }  # fmt: skip
    assert M4F.scalars == ("f32", "f64")
