"""A reference motion in a CSV file: read to the digit, or refused with its line."""

from pathlib import Path

import pytest

from derive.vehicle import InputError
from derive.vehicle.motion import Motion, read_motion

HEAD = "t,g_0,g_1,nu_r_0"
ROWS = ("0,1,0,0.5", "1,2,0,0.25", "2,3,0,0.75", "3,4,0,1.5")
GOOD = "\n".join((HEAD, *ROWS, ""))


def written(folder: Path, text: str | bytes) -> Path:
    path = folder / "m.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def read(folder: Path, text: str | bytes) -> Motion:
    return read_motion(written(folder, text), 2, 1)


def test_rows_are_read_and_rates_are_differences(tmp_path: Path) -> None:
    found = read(tmp_path, GOOD)
    assert found.t == (0.0, 1.0, 2.0, 3.0)
    assert found.g == ((1.0, 0.0), (2.0, 0.0), (3.0, 0.0), (4.0, 0.0))
    assert found.nu_r == ((0.5,), (0.25,), (0.75,), (1.5,))
    assert found.nu_r_dot == ((-0.25,), (0.125,), (0.625,), (0.75,))
    assert found.lines == (2, 3, 4, 5)


def test_rates_that_are_known_are_taken(tmp_path: Path) -> None:
    rows = "\n".join(f"{row},{place}" for place, row in enumerate(ROWS))
    found = read(tmp_path, f"{HEAD},nu_r_dot_0\n{rows}\n")
    assert found.nu_r_dot == ((0.0,), (1.0,), (2.0,), (3.0,))


@pytest.mark.parametrize(
    "text",
    [
        b"\xef\xbb\xbf" + GOOD.encode(),
        GOOD.replace("\n", "\r\n"),
        GOOD.replace(",", " , "),
        GOOD.replace("1,2,0,0.25\n", "1,2,0,0.25\n\n , , , \n"),
        GOOD.replace("0.5", "5e-1").replace("0.25", "+.25"),
    ],
    ids=["mark", "crlf", "spaces", "blank lines", "spellings"],
)
def test_other_spellings_of_the_same(text: str | bytes, tmp_path: Path) -> None:
    found = read(tmp_path, text)
    assert (found.t, found.nu_r) == ((0.0, 1.0, 2.0, 3.0), ((0.5,), (0.25,), (0.75,), (1.5,)))


def test_the_line_is_that_of_the_file(tmp_path: Path) -> None:
    assert read(tmp_path, GOOD.replace("1,2,", "\n\n1,2,")).lines == (2, 5, 6, 7)


def with_row(row: str, place: int = 1) -> str:
    return "\n".join((HEAD, *ROWS[:place], row, *ROWS[place + 1 :], ""))


# id, text, key, fragments of expected, of found, of remedy
BAD = [
    ("empty", "", "", "UTF-8", "an empty file", "give the motion"),
    ("only_head", HEAD + "\n", "line 1", "two rows", "0", "give the motion"),
    ("one_row", "\n".join((HEAD, ROWS[0])), "line 1", "two rows", "1", "give the motion"),
    ("not_utf8", b"t,\xff", "", "UTF-8", "utf-8", "beside the vehicle file"),
    ("no_head", "\n".join(ROWS), "line 1", "t, g_0, g_1, nu_r_0", "0, 1, 0", "in that order"),
    ("missing_column", GOOD.replace(",g_1", ""), "line 1", "g_1", "t, g_0, nu_r_0", "name the"),
    ("odd_column", GOOD.replace("g_1", "x"), "line 1", "g_1", "t, g_0, x", "name the"),
    ("other_order", GOOD.replace("g_0,g_1", "g_1,g_0"), "line 1", "g_0, g_1", "g_1, g_0", "order"),
    ("more_columns", GOOD.replace(HEAD, HEAD + ",extra"), "line 1", "nu_r_0", "extra", "order"),
    ("short_row", with_row("1,2,0"), "line 3", "4 cells", "3", "fill the row"),
    ("long_row", with_row("1,2,0,1,1"), "line 3", "4 cells", "5", "fill the row"),
    ("empty_cell", with_row("1,2,,1"), "line 3", "column g_1", "an empty cell", "mend that cell"),
    ("nan", with_row("1,2,0,nan", 2), "line 4", "column nu_r_0", "'nan'", "mend that cell"),
    ("infinite", with_row("1,-inf,0,1"), "line 3", "column g_0", "'-inf'", "mend that cell"),
    ("large", with_row("1,2,0,2e9"), "line 3", "at most 1e9", "'2e9'", "mend that cell"),
    ("word", with_row("one,2,0,1"), "line 3", "column t", "'one'", "mend that cell"),
    ("same_time", with_row("0,2,0,1"), "line 3", "after that of the row above", "0.0", "sort"),
    ("back", with_row("0.5,2,0,1", 2), "line 4", "after that", "t = 0.5", "each time once"),
    ("gap", GOOD.replace("\n3,", "\n5,"), "line 5", "about 1 s", "a gap of 3 s", "missing"),
    ("gap_after_blank", GOOD.replace("\n3,", "\n\n5,"), "line 6", "about 1 s", "3 s", "missing"),
]


@pytest.mark.parametrize(
    ("text", "key", "expected", "found", "remedy"),
    [row[1:] for row in BAD],
    ids=[r[0] for r in BAD],
)
def test_it_is_refused_and_told(
    text: str | bytes, key: str, expected: str, found: str, remedy: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError) as caught:
        read(tmp_path, text)
    fault = caught.value
    assert (fault.file, fault.key) == (str(tmp_path / "m.csv"), key)
    assert expected in fault.expected
    assert found in fault.found
    assert remedy in fault.remedy


def test_a_file_that_is_not_there_or_is_none(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="No such file"):
        read_motion(tmp_path / "no.csv", 2, 1)
    with pytest.raises(InputError, match="directory"):
        read_motion(tmp_path, 2, 1)
    (tmp_path / "pipe").symlink_to("/dev/null")
    with pytest.raises(InputError, match="not a regular file"):
        read_motion(tmp_path / "pipe", 2, 1)


def test_a_huge_file_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "m.csv"
    with path.open("wb") as file:
        file.truncate((256 << 20) + 1)  # sparse: takes no room
    with pytest.raises(InputError, match="more than 256 MiB"):
        read_motion(path, 2, 1)


def test_a_cell_without_an_end_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="field larger than field limit"):
        read(tmp_path, GOOD + '"' + "1" * 200_000)
