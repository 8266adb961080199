"""What a vehicle file says of flights: read exactly, or refused with one message."""

from fractions import Fraction
from pathlib import Path

import pytest

from derive.vehicle import InputError, load
from derive.vehicle.experiment import Course, Experiment

GOOD = """\
name = "body"
group = "SO3"
inertia = [[3.6, 0, 0], [0, 8.6, 0], [0, 0, 9.3]]
[gains]
lambda = 0.5
k_s = 1
"""


def written(folder: Path, text: str) -> Path:
    path = folder / "body.toml"
    path.write_text(GOOD + text, encoding="utf-8")
    return path


def said(folder: Path, text: str) -> Experiment:
    return load(written(folder, text)).experiment


def refusal(folder: Path, text: str) -> InputError:
    with pytest.raises(InputError) as caught:
        load(written(folder, text))
    return caught.value


def test_left_out_it_is_half_a_minute_to_rest(tmp_path: Path) -> None:
    assert said(tmp_path, "") == Experiment()
    assert said(tmp_path, "[reference]\n[simulate]\n") == Experiment()
    assert Experiment().course == Course("rest")
    assert Experiment().duration == 30
    assert Experiment().rate is None


WHOLE = """
[options]
momentum = true
external = true
[reference]
kind = "slew"
g_r = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
along = [0.1, -0.2, 0.3]
duration = 2.5
[simulate]
duration = 12
rate = 100
step = 0.001
turn = [1, 0.5, -0.25]
nu = 0.3
momentum = [1, 2, 3]
external = 0.5
disturbance = [0, 0, 1e-3]
wave = 0.1
hertz = 0.7
noise_g = 1e-3
noise_nu = 0.002
force_limit = 4
inertia_error = -0.1
"""


def test_everything_is_read_exactly(tmp_path: Path) -> None:
    third = Fraction(3, 10)
    assert said(tmp_path, WHOLE) == Experiment(
        course=Course("slew", tuple(map(Fraction, (0, -1, 0, 1, 0, 0, 0, 0, 1))),
                      along=(Fraction(1, 10), Fraction(-1, 5), third), duration=Fraction(5, 2)),
        duration=Fraction(12),
        rate=Fraction(100),
        step=Fraction(1, 1000),
        turn=(Fraction(1), Fraction(1, 2), Fraction(-1, 4)),
        nu=(third,) * 3,
        momentum=(Fraction(1), Fraction(2), Fraction(3)),
        external=(Fraction(1, 2),) * 3,
        disturbance=(Fraction(0), Fraction(0), Fraction(1, 1000)),
        wave=(Fraction(1, 10),) * 3,
        hertz=Fraction(7, 10),
        noise_g=Fraction(1, 1000),
        noise_nu=Fraction(1, 500),
        force_limit=(Fraction(4),) * 3,
        inertia_error=Fraction(-1, 10),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("keys", "kind"),
    [("", "rest"), ("nu_r = [1, 2, 3]", "rate"), ("along = 1\nduration = 3", "slew"),
     ('file = "m.csv"', "file")],
)  # fmt: skip
def test_the_kind_is_the_one_its_keys_speak_of(keys: str, kind: str, tmp_path: Path) -> None:
    assert said(tmp_path, f"[reference]\n{keys}\n").course.kind == kind


def test_a_file_stands_beside_the_vehicle(tmp_path: Path) -> None:
    course = said(tmp_path, '[reference]\nkind = "file"\nfile = "way/m.csv"\n').course
    assert course == Course("file", file=tmp_path / "way" / "m.csv")


REFERENCE = [
    ("kind = 3", "kind", "rest, rate, slew, file", "3", "in quotes"),
    ('kind = "spin"', "kind", "rest, rate, slew, file", "'spin'", "slew"),
    ('kind = "rest"\nnu_r = [1, 2, 3]', "nu_r", "kind rest: g_r", "kind rate", "leave nu_r out"),
    ('kind = "slew"\nnu_r = [1, 2, 3]', "nu_r", "g_r, along, duration", "rate", 'kind = "rate"'),
    ('kind = "rate"\nalong = [1, 2, 3]', "along", "g_r, nu_r", "kind slew", "leave along out"),
    ('kind = "rate"\nduration = 3', "duration", "g_r, nu_r", "kind slew", 'kind = "slew"'),
    ('kind = "file"\ng_r = [1]', "g_r", "keys of kind file: file", "rest or rate", "leave g_r out"),
    ('kind = "rest"\nfile = "m.csv"', "file", "kind rest", "kind file", 'write kind = "file"'),
    ('kind = "file"', "file", "motion.csv", "missing", "write file"),
    ('kind = "file"\nfile = 3', "file", "CSV file", "3", "in quotes"),
    ('kind = "rate"', "nu_r", "kind rate", "missing", "write nu_r"),
    ('kind = "slew"\nduration = 3', "along", "kind slew", "missing", "write along"),
    ('kind = "slew"\nalong = 1', "duration", "kind slew", "missing", "write duration"),
    ('kind = "slew"\nalong = 1\nduration = 0', "duration", "from 0.001", "0", "in that range"),
    ("nu_r = [1, 2]", "nu_r", "3 numbers, or one for all", "array of 2", "[0.0, 0.0, 0.0]"),
    ("nu_r = [1, nan, 2]", "nu_r, entry 2", "3 numbers", "nan", "SI units"),
    ("nu_r = [1, 2, inf]", "nu_r, entry 3", "3 numbers", "inf", "SI units"),
    ("nu_r = [1, 2, 1e10]", "nu_r, entry 3", "at most 1000000000", "10000000000", "SI units"),
    ("nu_r = [1, 2, 1e-40]", "nu_r, entry 3", "above 1e-30", "1e-40", "SI units"),
    ("nu_r = [1, 2, true]", "nu_r, entry 3", "3 numbers", "boolean true", "SI units"),
    ("nu_r = inf", "nu_r", "one for all", "inf", "SI units"),
    ("g_r = [1, 2, nan]", "g_r, entry 3", "a number", "nan", "row by row"),
    ('g_r = "e"', "g_r, entry 1", "a number", "string 'e'", "row by row"),
    ("nu = [1, 2, 3]", "nu", "g_r, nu_r", "unknown key", "below [simulate]"),
    ("momentum = true", "momentum", "kind", "unknown key", "below [options]"),
]

SIMULATE = [
    ("duration = 0", "duration", "from 0.001 to 1000000 [s]", "0", "in that range"),
    ("duration = -3", "duration", "from 0.001", "-3", "in that range"),
    ("duration = nan", "duration", "from 0.001", "nan", "in that range"),
    ("duration = 1000001", "duration", "to 1000000 [s]", "1000001", "in that range"),
    ('duration = "3"', "duration", "a number", "string '3'", "in that range"),
    ("rate = 0", "rate", "from 0.001 to 1000000 [Hz]", "0", "in that range"),
    ("rate = inf", "rate", "from 0.001", "inf", "in that range"),
    ("rate = true", "rate", "a number", "boolean", "in that range"),
    ("step = 0", "step", "from 0.000001 to 1 [s]", "0", "in that range"),
    ("step = 2", "step", "to 1 [s]", "2", "in that range"),
    ("hertz = -1", "hertz", "from 0 to", "-1", "in that range"),
    ("noise_g = 0.2", "noise_g", "from 0 to 0.1 [rad or m]", "0.2", "in that range"),
    ("noise_nu = -1e-9", "noise_nu", "from 0", "-1e-9", "in that range"),
    ("inertia_error = -1", "inertia_error", "from -0.9 to 10", "-1", "in that range"),
    ("inertia_error = 11", "inertia_error", "from -0.9 to 10", "11", "in that range"),
    ("force_limit = 0", "force_limit", "greater than 0", "0, 0, 0", "in either direction"),
    ("force_limit = [1, -1, 1]", "force_limit", "greater than 0", "1, -1, 1", "actuators"),
    ("turn = [1, 2]", "turn", "3 numbers, or one for all", "array of 2", "[0.0, 0.0, 0.0]"),
    ("turn = []", "turn", "3 numbers", "array of 0", "write turn"),
    ("turn = [nan, 0, 0]", "turn, entry 1", "3 numbers", "nan", "write turn"),
    ("nu = {x = 1}", "nu", "3 numbers", "a table", "write nu"),
    ("disturbance = [0, 0, inf]", "disturbance, entry 3", "3 numbers", "inf", "SI units"),
    ("momentum = [1, 2, 3]", "momentum", "momentum = true", "one without", "leave momentum out"),
    ("external = 1", "external", "external = true", "one without", "told of it"),
    ("seed = 3", "seed", "duration, rate, step", "unknown key", "nearest"),
    ("g_r = [1]", "g_r", "duration, rate", "unknown key", "below [reference]"),
    ("lambda = 1", "lambda", "duration, rate", "unknown key", "below [gains]"),
]

BAD = [("reference", *row) for row in REFERENCE] + [("simulate", *row) for row in SIMULATE]


@pytest.mark.parametrize(
    ("table", "text", "key", "expected", "found", "remedy"),
    BAD,
    ids=[f"{row[0]}: {row[1]}".replace("\n", ", ") for row in BAD],
)
def test_it_is_refused_and_told(
    table: str, text: str, key: str, expected: str, found: str, remedy: str, tmp_path: Path
) -> None:
    fault = refusal(tmp_path, f"[{table}]\n{text}\n")
    assert fault.file == str(tmp_path / "body.toml")
    assert fault.key == f"{table}.{key}"
    assert expected in fault.expected
    assert found in fault.found
    assert remedy in fault.remedy


@pytest.mark.parametrize("name", ["reference", "simulate"])
def test_a_table_that_is_none(name: str, tmp_path: Path) -> None:
    path = tmp_path / "body.toml"
    path.write_text(f"{name} = 3\n{GOOD}", encoding="utf-8")
    with pytest.raises(InputError, match=rf"write \[{name}\] on a line of its own"):
        load(path)
