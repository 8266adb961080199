"""The program that measures calls what the header declares, and nothing that it does not."""

import re
from pathlib import Path

from derive.evidence.emitted import Emitted
from derive.evidence.firmware import Image, program
from tests.evidence.emulated import M4F, M7

HEADER = """
typedef enum { BODY_F32_OK = 0 } body_f32_status;
typedef struct { float inertia[6]; } body_f32_params;
extern const body_f32_params body_f32_defaults;
body_f32_status body_f32_check_params(const body_f32_params *params);
body_f32_status body_f32_control(const body_f32_params *params, const body_f32_state *state,
        body_f32_side *side, body_f32_command *command);
void body_f32_reaching(const body_f32_params *params, const body_f32_state *state,
        body_f32_command *command);
void body_f32_plant(const body_f32_params *params, const body_f32_state *state,
        const float force[3], float nu_dot[3]);
"""


def written(folder: Path, level: str = "-O2", scalar: str = "f32") -> str:
    emitted = Emitted(folder, "body", scalar)
    emitted.include.mkdir(parents=True, exist_ok=True)
    emitted.header.write_text(HEADER.replace("f32", scalar))
    return program(Image(emitted, M4F, level))


def test_every_routine_is_called_with_what_a_case_has(tmp_path: Path) -> None:
    text = written(tmp_path)
    calls = re.findall(r"^    (\(void\)|status = \(unsigned\))?routine\((.*)\);$", text, re.M)
    params, state = "&body_f32_defaults", "&one->state"
    assert calls == [
        ("status = (unsigned)", f"{params}, {state}, &output.side, &output.command"),
        ("", f"{params}, {state}, &output.command"),
        ("", f"{params}, {state}, one->truth.force, output.nu_dot"),
    ]


def test_what_a_caller_keeps_is_cleared_and_not_taken_for_the_answer(tmp_path: Path) -> None:
    text = written(tmp_path)
    struct = text[text.index("static struct {") : text.index("} output;")]
    assert re.findall(r"^    (.*);$", struct, re.M) == [
        "body_f32_command command", "body_f32_side side", "float nu_dot[3]",
    ]  # fmt: skip
    rows = re.findall(r'^    \{"(\w+)", .*&output\.(\w+), .*, (\d)\},$', text, re.M)
    assert rows == [
        ("control", "command", "1"), ("reaching", "command", "0"), ("plant", "nu_dot", "0"),
    ]  # fmt: skip


def test_only_one_level_and_scalar_of_a_machine_is_measured(tmp_path: Path) -> None:
    assert "write_cost" in written(tmp_path)
    assert "write_cost" not in written(tmp_path, "-O3")
    assert "write_cost" not in written(tmp_path, scalar="f64")
    assert M7.measured == ("f64",)
