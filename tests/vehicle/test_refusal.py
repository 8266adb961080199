"""Every bad vehicle file is refused with one message: where, what was expected, what to do."""

import time
from pathlib import Path

import pytest

from derive.vehicle import InputError, load

GOOD = """\
name = "body"
group = "SO3"
inertia = [[3.6046, -0.0706, 0.1491], [-0.0706, 8.6868, 0.0449], [0.1491, 0.0449, 9.3484]]
[gains]
lambda = 0.5
k_s = 1
"""
INERTIA = GOOD.splitlines()[2]
HEAD = GOOD[: GOOD.index("[gains]")]
PD_PLUS = f'controller = "pd_plus"\n{HEAD}[gains]\nk_R = 1\nk_Omega = 1000000.1\n'


def written(folder: Path, text: str | bytes) -> Path:
    path = folder / "body.toml"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return path


def refusal(path: Path) -> InputError:
    with pytest.raises(InputError) as caught:
        load(path)
    return caught.value


def with_inertia(value: str) -> str:
    return GOOD.replace(INERTIA, f"inertia = {value}")


def with_line(line: str) -> str:
    return line + "\n" + GOOD


def with_gain(text: str) -> str:
    return GOOD.replace("k_s = 1", text)


def with_emit(line: str) -> str:
    return f"{GOOD}[emit]\n{line}\n"


def named(name: str) -> str:
    return GOOD.replace('"body"', name)


# id, text, key, fragment of expected, fragment of found, fragment of remedy
BAD = [
    ("empty", "", "", "TOML", "empty file", "derive init"),
    ("only_space", " \n\t\n", "", "TOML", "empty file", "derive init"),
    ("not_toml", "inertia = [[1, 2", "", "TOML", "Unclosed array", "derive init"),
    ("key_twice", GOOD + "k_s = 2\n", "", "TOML", "line 7", "mend"),
    ("not_utf8", b'name = "\xff"', "", "UTF-8", "from byte 8", "save the file as UTF-8"),
    ("utf16", GOOD.encode("utf-16"), "", "UTF-8", "from byte 0", "save the file as UTF-8"),
    ("too_large", "#" * (1 << 20) + "\n", "", "1 MiB", "more than 1 MiB", "own file"),
    ("nested", "inertia = " + "[" * 100_000, "", "TOML", "nested too deeply", "mend"),
    ("digits", with_gain("k_s = " + "9" * 5000), "", "numbers", "4300 digits", "mend"),
    ("unknown_key", with_line('grup = "S3"'), "grup", "group", "unknown key", "write group"),
    ("key_case", with_line('Law = "log"'), "Law", "law", "unknown key", "write law"),
    ("odd_key", with_line('"\\u001b[31m" = 1'), r"'\x1b[31m'", "name", "unknown key", "remove"),
    ("unknown_table", GOOD + "[emitt]\n", "emitt", "emit", "unknown key", "write emit"),
    ("unknown_gain", GOOD + "k_z = 1\n", "gains.k_z", "lambda, k_s", "unknown key", "write k_s"),
    ("other_gain", GOOD + "kappa = 1\n", "gains.kappa", "of gsmc", "lsf_printed, lsf", '"lsf"'),
    ("unknown_emit", with_emit("scalar = []"), "emit.scalar", "scalars", "unknown", "scalars"),
    ("below", GOOD + 'law = "log"\n', "gains.law", "lambda", "unknown key", "above the first"),
    ("above", with_line("k_s = 1"), "k_s", "inertia", "unknown key", "move k_s below [gains]"),
    ("other_schema", with_line("schema = 2"), "schema", "the number 1", "2", "schema = 1"),
    ("schema_text", with_line('schema = "1"'), "schema", "the number 1", "string", "schema = 1"),
    ("schema_true", with_line("schema = true"), "schema", "number 1", "boolean true", "schema = 1"),
    ("no_name", GOOD.replace('name = "body"', ""), "name", "name", "missing", "write name ="),
    ("name_number", named("3"), "name", "name", "3", "in quotes"),
    ("name_empty", named('""'), "name", "C identifier", "''", '"vehicle_1"'),
    ("name_dash", named('"paper-so3"'), "name", "C identifier", "'paper-so3'", '"paper_so3"'),
    ("name_digit", named('"3u"'), "name", "a letter first", "'3u'", '"vehicle_3u"'),
    ("name_accent", named('"é"'), "name", "C identifier", "'é'", '"vehicle_1"'),
    ("name_newline", named('"body\\n"'), "name", "C identifier", r"'body\n'", '"body"'),
    ("name_path", named('"../body"'), "name", "C identifier", "'../body'", '"body"'),
    ("name_underscore", named('"_body"'), "name", "a letter first", "'_body'", '"body"'),
    ("name_reserved", named('"a__b"'), "name", "single underscores", "'a__b'", '"a_b"'),
    ("name_long", named(f'"{"a" * 49}"'), "name", "at most 48", "49 characters", '"aaa'),
    ("name_c", named('"register"'), "name", "C identifier", "C or C++", '"vehicle_register"'),
    ("name_python", named('"lambda"'), "name", "identifier", "of Python", '"vehicle_lambda"'),
    ("name_module", named('"numpy"'), "name", "no one else's", "hide", '"vehicle_numpy"'),
    ("name_device", named('"aux"'), "name", "no one else's", "Windows", '"vehicle_aux"'),
    ("name_target", named('"install"'), "name", "no one else's", "CMake", '"vehicle_install"'),
    ("name_scalar", named('"body_f64"'), "name", "not ending in _f32", "'body_f64'", '"body"'),
    ("no_group", GOOD.replace('group = "SO3"', ""), "group", "SO3", "missing", "write group ="),
    ("group_table", GOOD.replace('"SO3"', "{dim = 3}"), "group.dim", "basis", "unknown", "name"),
    ("group_list", GOOD.replace('"SO3"', '["SO3"]'), "group", "name of", "array of 1", "group"),
    ("law_number", with_line("law = 1.5"), "law", "kinematic law", "1.5", 'law = "log"'),
    (
        "unknown_controller",
        with_line('controller = "GSMC "'),
        "controller",
        "reaching",
        "'GSMC '",
        "gsmc",
    ),
    ("no_inertia", GOOD.replace(INERTIA, ""), "inertia", "rows", "missing", "[[J1, 0, 0]"),
    ("flat", with_inertia("[1, 2, 3]"), "inertia", "array of rows", "array of 3", "[[J1, 0, 0]"),
    ("no_rows", with_inertia("[]"), "inertia", "array of rows", "array of 0", "[[J1, 0, 0]"),
    ("scalar", with_inertia("2.5"), "inertia", "array of rows", "2.5", "[[J1, 0, 0]"),
    ("ragged", with_inertia("[[1, 0], [0]]"), "inertia, row 2", "2 numbers", "of 1", "2 by 2"),
    ("wide", with_inertia("[[1, 0]]"), "inertia, row 1", "of 1 numbers", "array of 2", "1 by 1"),
    ("row_text", with_inertia('[[1, 0], "0, 1"]'), "inertia, row 2", "2 num", "string", "2 by 2"),
    ("huge_matrix", with_inertia(f"{[[1] * 25] * 25}"), "inertia", "at most 24", "25 rows", "one"),
    (
        "entry_text",
        with_inertia('[[1, 0], [0, "2"]]'),
        "row 2, column 2",
        "number",
        "string '2'",
        "quotes",
    ),
    (
        "entry_boolean",
        with_inertia("[[true]]"),
        "row 1, column 1",
        "number",
        "boolean true",
        "decimal",
    ),
    ("entry_nan", with_inertia("[[nan]]"), "row 1, column 1", "a number", "nan", "decimal number"),
    ("entry_inf", with_inertia("[[-inf]]"), "row 1, column 1", "a number", "-inf", "decimal"),
    ("entry_date", with_inertia("[[1979-05-27]]"), "column 1", "a number", "a date", "decimal"),
    ("entry_large", with_inertia("[[1.1e9]]"), "column 1", "1000000000", "1100000000", "decimal"),
    (
        "entry_hex",
        with_inertia("[[0x" + "f" * 9999 + "]]"),
        "column 1",
        "number",
        "60 dig",
        "write",
    ),
    ("entry_tiny", with_inertia("[[1e-31]]"), "column 1", "1e-30", "1e-31", "decimal"),
    (
        "coupling_tiny",
        with_inertia("[[1, 1e-31], [1e-31, 1]]"),
        "row 1, column 2",
        "1e-30",
        "1e-31",
        "write 0",
    ),
    ("name_of_scalar", named('"f64"'), "name", "C identifier", "name of a scalar", '"vehicle_1"'),
    ("no_gains", HEAD, "gains.lambda", "greater than 0", "missing", "[gains]"),
    ("no_gain", with_gain(""), "gains.k_s", "greater than 0", "missing", "write k_s = 1.0"),
    ("gains_list", HEAD + "gains = 1", "gains", "a table", "1", "write [gains]"),
    ("gain_zero", with_gain("k_s = 0"), "gains.k_s", "greater than 0", "0", "k_s = 1.0"),
    ("gain_minus_zero", with_gain("k_s = -0.0"), "gains.k_s", "greater than 0", "0", "k_s = 1.0"),
    ("gain_negative", with_gain("k_s = -2.5"), "gains.k_s", "greater than 0", "-2.5", "positive"),
    ("gain_nan", with_gain("k_s = nan"), "gains.k_s", "greater than 0", "nan", "k_s = 1.0"),
    ("gain_inf", with_gain("k_s = +inf"), "gains.k_s", "at most 10000", "+inf", "k_s = 1.0"),
    ("gain_large", with_gain("k_s = 10000.1"), "gains.k_s", "most 10000", "10000.1", "in 1/s"),
    ("gain_of_energy", PD_PLUS, "k_Omega", "most 1000000", "1000000.1", "in N m s"),
    ("gain_exponent", with_gain("k_s = 1e999999999"), "gains.k_s", "at most", "1e999999999", "k_s"),
    ("gain_small", with_gain("k_s = 9.9e-10"), "gains.k_s", "at least 1e-9", "9.9e-10", "k_s"),
    ("gain_tiny", with_gain("k_s = 1e-999999999"), "gains.k_s", "1e-9", "1e-999999999", "k_s"),
    ("gain_long", with_gain("k_s = 0." + "3" * 300), "gains.k_s", "number", "0.333", "k_s"),
    ("gain_text", with_gain('k_s = "1.0"'), "gains.k_s", "a number", "the string '1.0'", "quotes"),
    ("gain_boolean", with_gain("k_s = true"), "gains.k_s", "a number", "boolean true", "quotes"),
    ("gain_array", with_gain("k_s = [1, 1, 1]"), "gains.k_s", "a number", "array of 3", "k_s = 1"),
    ("scalar_f16", with_emit('scalars = ["f16"]'), "emit.scalars", "f32, f64", "'f16'", "nearest"),
    ("scalar_text", with_emit('scalars = "f32"'), "emit.scalars", "array", "string", "scalars ="),
    ("scalar_none", with_emit("scalars = []"), "emit.scalars", "one or more", "of 0", "scalars ="),
    (
        "scalar_twice",
        with_emit('scalars = ["f32", "f32"]'),
        "emit.scalars",
        "each once",
        "'f32' twice",
        "leave",
    ),
    ("target_c", with_emit('targets = ["C99"]'), "emit.targets", "c99", "'C99'", "nearest"),
    ("target_number", with_emit("targets = [99]"), "emit.targets", "c99", "99", "targets ="),
    ("emit_list", GOOD + "[[emit]]\n", "emit", "a table", "array of 1", "write [emit]"),
]


@pytest.mark.parametrize(
    ("text", "key", "expected", "found", "remedy"),
    [case[1:] for case in BAD],
    ids=[c[0] for c in BAD],
)
def test_bad_file_is_refused_with_one_message(
    tmp_path: Path, text: str | bytes, key: str, expected: str, found: str, remedy: str
) -> None:
    path = written(tmp_path, text)
    start = time.monotonic()
    error = refusal(path)
    assert time.monotonic() - start < 2
    assert error.file == str(path)
    assert key in error.key
    assert bool(key) == bool(error.key)
    assert expected in error.expected
    assert found in error.found
    assert remedy in error.remedy or (remedy == "nearest" and remedy in error.found)
    message = str(error)
    assert message.startswith(f"{path}: {error.key}" if key else str(path))
    assert len(message.splitlines()) == 4
    assert all(len(line) < 300 and line.isprintable() for line in message.splitlines())
