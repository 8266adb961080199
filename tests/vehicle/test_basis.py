"""A [group] table that describes no group is refused with one message."""

from pathlib import Path

import pytest

from derive.vehicle import InputError
from tests.vehicle.test_group import SL2, own

E = "[[0, 1], [0, 0]]"
F = "[[0, 0], [1, 0]]"
WIDE = str([[int((i, j) == (0, 1)) for j in range(7)] for i in range(7)])

# lines of the table, key, fragment of expected, of found, of remedy
BAD = [
    (f"basis = [{E}]", "group.name", "a name for the group", "missing", "write name ="),
    ('name = "SO3 x R3"', "group.name", "letters, digits", "'SO3 x R3'", "another word"),
    ('name = ""', "group.name", "a letter first", "''", "another word"),
    ("name = 3", "group.name", "a name", "3", "in quotes"),
    ('name = "é"', "group.name", "letters, digits", "'é'", "another word"),
    (f'name = "{"a" * 49}"', "group.name", "at most 48", "'aaa", "another word"),
    ('name = "a"', "group.basis", "square matrices", "missing", "basis = [[["),
    ('name = "a"\nbasis = 3', "group.basis", "square matrices", "3", "basis = [[["),
    ('name = "a"\nbasis = [1]', "group.basis, E_1", "rows", "1", "basis = [[["),
    ('name = "a"\nbasis = [[1]]', "group.basis, E_1, row 1", "numbers", "1", "basis = [[["),
    ('name = "a"\nbasis = []', "group.basis", "1 to 12 matrices", "0 of them", "give"),
    ('name = "a"\nbasis = [[]]', "group.basis", "square", "E_1 with 0 rows", "entries"),
    ('name = "a"\nbasis = [[[1, 2]]]', "group.basis", "square", "1 row of 2", "entries"),
    (f'name = "a"\nbasis = [{E}, [[1]]]', "group.basis", "2 by 2 as E_1", "1 by 1", "zeros"),
    (f'name = "a"\nbasis = [{WIDE}]', "group.basis", "1 to 6 rows", "7 rows", "entries"),
    (f'name = "a"\nbasis = [{", ".join([E] * 13)}]', "group.basis", "1 to 12", "13 of", "give"),
    (f'name = "a"\nbasis = [{E}, [[0, 0], [0, 0]]]', "group.basis", "indep", "E_2 is zero", "E_2"),
    (f'name = "a"\nbasis = [{E}, {F}, {E}]', "group.basis", "indep", "E_3 is a comb", "remove E_3"),
    (f'name = "a"\nbasis = [{E}, {F}]', "group.basis", "closed", "[E_1, E_2], which", "add [E_1"),
    *(
        (f'name = "a"\nbasis = [[[{entry}]]]', "E_1, row 1, column 1", "exact", found, "simpler")
        for entry, found in [
            ('"1/0"', "string '1/0'"),
            ('"x"', "string 'x'"),
            ('"1.5"', "string '1.5'"),
            ('"1/-2"', "string '1/-2'"),
            ('"²/3"', "string '²/3'"),
            ("true", "boolean true"),
            ("nan", "nan"),
            ("1e999999999", "1e999999999"),
            ("1000001", "1000001"),
            ("0.0000001", "1e-7"),
            ('"1/1000001"', "'1/1000001'"),
            ("[1]", "array of 1"),
            ("1979-05-27", "a date"),
        ]
    ),
    (SL2 + 'units = "1/s"', "group.units", "3 units", "the string '1/s'", "units = ["),
    (SL2 + 'units = ["1/s"]', "group.units", "3 units", "array of 1", "units = ["),
    *(
        (SL2 + f"units = ['1/s', {unit}, '1/s']", "group.units, entry 2", "at most 24", found, "un")
        for unit, found in [
            ("3", "3"),
            ("''", "''"),
            ("'*/'", "'*/'"),
            ("'a\"'", "string 'a\"'"),
            ('"a\\n"', "a\\n"),
            ("'µm/s'", "µm/s"),
            ("'m/s '", "'m/s '"),
            (f"'{'m' * 25}'", "mmm"),
        ]
    ),
    (SL2 + "law = 3", "group.law", "kinematic law", "3", "in quotes"),
    (SL2 + "dim = 3", "group.dim", "name, basis, units, law", "unknown", "remove"),
    (SL2 + "inertia = [[1]]", "group.inertia", "basis", "unknown key", "top of the file"),
    (SL2 + "k_s = 1", "group.k_s", "basis", "unknown key", "below [gains]"),
]  # fmt: skip


@pytest.mark.parametrize(("table", "key", "expected", "found", "remedy"), BAD)
def test_a_bad_group_is_told(
    tmp_path: Path, table: str, key: str, expected: str, found: str, remedy: str
) -> None:
    with pytest.raises(InputError) as caught:
        own(tmp_path, table)
    assert key in caught.value.key
    assert expected in caught.value.expected
    assert found in caught.value.found
    assert remedy in caught.value.remedy
    message = str(caught.value).splitlines()
    assert len(message) == 4
    assert all(len(line) < 300 and line.isprintable() for line in message)
