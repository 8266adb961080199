"""Groups by name, as products and from a [group] table: read exactly, and the bad ones told."""

import sys
from dataclasses import replace
from fractions import Fraction
from itertools import product
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from derive.control import kinematic
from derive.lie.catalogue import GROUPS, named
from derive.starter import starter
from derive.vehicle import Facts, InputError, OwnGroup, Vehicle, check_facts, load, resolve
from derive.vehicle_group import group_of
from derive.vehicle_lookup import laws_on

SL2 = 'name = "SL2"\nbasis = [[[0, 1], [0, 0]], [[0, 0], [1, 0]], [[1, 0], [0, -1]]]\n'
PAIRS = [f"{a} x {b}" for a, b in product(("SO2", "S3", "SE3", "SE23", "R3"), repeat=2)]
TRIPLES = ["SO2 x SO3 x SE2", "SE3 x SO3 x R2"]


@pytest.fixture(autouse=True)
def reason(monkeypatch: pytest.MonkeyPatch) -> None:
    """A reason why a law is not there, and a group from a basis, in place of the real ones."""

    def of_basis(name: str, basis: object, units: object) -> SimpleNamespace:
        return SimpleNamespace(name=name, basis=basis, units=units, cover=None, chart=None, dim=3)

    monkeypatch.setattr(kinematic, "why_not", lambda group, law: "for a reason", raising=False)
    own = ModuleType("derive.lie.own")
    own.__dict__["of_basis"] = of_basis
    monkeypatch.setitem(sys.modules, "derive.lie.own", own)


def written(folder: Path, group: str, n: int = 3, top: str = "", table: str = "") -> Path:
    """A file on a group: by name, or by the lines of a [group] table."""
    rows = [[int(i == j) for j in range(n)] for i in range(n)]
    name = f'group = "{group}"\n' if group else ""
    path = folder / "body.toml"
    path.write_text(
        f'name = "body"\n{name}inertia = {rows}\n{top}\n[gains]\nlambda = 0.5\nk_s = 1\n'
        + (f"[group]\n{table}" if table else ""),
        encoding="utf-8",
    )
    return path


def on(folder: Path, group: str, n: int = 3) -> Vehicle:
    return load(written(folder, group, n))


def own(folder: Path, table: str, top: str = "") -> Vehicle:
    return load(written(folder, "", top=top, table=table))


@pytest.mark.parametrize(
    ("given", "group"),
    [
        ("SO3", "SO3"),
        (" SO3 ", "SO3"),
        ("SO3  x R3", "SO3 x R3"),
        ("SO3\\tx   T3", "SO3 x R3"),
        ("T3", "R3"),
        ("T24", "R24"),
        ("T3 x T2 x SO2", "R3 x R2 x SO2"),
    ],
)
def test_a_name_has_one_spelling(tmp_path: Path, given: str, group: str) -> None:
    vehicle = on(tmp_path, given)
    assert (vehicle.group, vehicle.own) == (group, None)


@pytest.mark.parametrize("group", [*GROUPS, *PAIRS, *TRIPLES])
def test_every_group_and_product_is_looked_up(tmp_path: Path, group: str) -> None:
    n = named(group).dim
    vehicle = replace(on(tmp_path, group, n), law=laws_on(group)[0])
    facts = resolve(vehicle)
    assert facts == Facts(dim=n, is_rotation=group in ("SO3", "S3"))
    check_facts(vehicle, facts)
    assert group_of(vehicle).name == group


@pytest.mark.parametrize("group", [*GROUPS, *PAIRS, *TRIPLES, "T2", "SE2  x T1"])
def test_a_starter_is_a_vehicle_that_can_be(tmp_path: Path, group: str) -> None:
    path = tmp_path / "body.toml"
    path.write_text(starter("body", group), encoding="utf-8")
    vehicle = load(path)
    check_facts(vehicle, resolve(vehicle))
    text = path.read_text(encoding="utf-8")
    is_of_bodies = "SE23" not in group and (" x " in group or group in ("SE2", "SE3"))
    assert ("[body]" in text) == is_of_bodies
    assert all(len(line) <= 100 for line in text.splitlines() if not line.startswith("  ["))


@pytest.mark.parametrize(
    ("group", "fragments"),
    [
        ("SO3xR3", ('write group = "SO3 x R3", with a space on both sides',)),
        ("SO3 × R3", ('write group = "SO3 x R3", with a space on both sides',)),
        ("SO3 X SO3*SO2", ('write group = "SO3 x SO3 x SO2", with',)),
        ("SO3 x SE", ("the string 'SE' in 'SO3 x SE'", 'write the factor as "SE3", the nearest')),
        ("R3 x ", ("the string 'R3 x'", '"R3"')),
        ("so3", ("'so3'", 'group = "SO3"', "R1 to R24", "[group] table")),
        ("SL2", ("'SL2'", "[group] table with name, basis and law")),
        ("quux", ("choose a group of that list", "[group] table with name, basis and law")),
        (" ", ("''", "choose a group")),
        ("R0", ("'R0'", "choose a group", "R1 to R24")),
        ("R100", ("'R100'", "R1 to R24")),
        ("R25", ("at most 24 dimensions", "25, in 'R25'")),
        ("SE23 x SE23 x SE23", ("at most 24 dimensions", "27, in")),
        (" x ".join(["SE3"] * 500), ("at most 24 dimensions", "3000, in 'SE3 x SE3")),
    ],
)
def test_an_unknown_group_is_told(tmp_path: Path, group: str, fragments: tuple[str, ...]) -> None:
    with pytest.raises(InputError) as caught:
        resolve(on(tmp_path, group))
    assert caught.value.key == "group"
    message = str(caught.value)
    for fragment in fragments:
        assert fragment in message
    assert len(message.splitlines()) == 4
    assert all(len(line) < 300 and line.isprintable() for line in message.splitlines())


def test_a_group_of_ones_own_is_exact(tmp_path: Path) -> None:
    table = (
        'name = "mine"\nlaw = "skew"\nunits = ["rad/s", "1/s"]\n'
        'basis = [[["1/3", 0.1], [0, "-2/7"]], [[0, 1], [0, 0]]]\n'
    )
    vehicle = own(tmp_path, table)
    third, tenth, sevenths = Fraction(1, 3), Fraction(1, 10), Fraction(-2, 7)
    zero, one = Fraction(), Fraction(1)
    basis = (((third, tenth), (zero, sevenths)), ((zero, one), (zero, zero)))
    assert vehicle.own == OwnGroup("mine", basis, ("rad/s", "1/s"))
    assert (vehicle.group, vehicle.law) == ("mine", "skew")
    assert hash(vehicle) == hash(replace(vehicle, source="elsewhere"))


def test_a_group_of_ones_own_is_looked_up(tmp_path: Path) -> None:
    vehicle = own(tmp_path, SL2 + 'law = "skew"')
    assert vehicle.own is not None
    assert vehicle.own.units == ("1/s",) * 3
    facts = resolve(vehicle)
    assert facts == Facts(dim=3, is_rotation=False)
    check_facts(vehicle, facts)
    found: Any = group_of(vehicle)
    assert (found.name, found.basis, found.units) == ("SL2", vehicle.own.basis, vehicle.own.units)
    with pytest.raises(InputError, match="2 by 2: SL2 has dimension 2"):
        check_facts(vehicle, Facts(dim=2, is_rotation=False))


def test_a_law_that_is_not_there_is_told_with_the_reason(tmp_path: Path) -> None:
    for vehicle in (own(tmp_path, SL2), own(tmp_path, SL2 + 'law = "log"')):
        with pytest.raises(InputError) as caught:
            resolve(vehicle)
        assert "skew" in caught.value.expected
        assert "(the laws that exist on SL2)" in caught.value.expected
        assert caught.value.found.endswith(", ...: for a reason")
    with pytest.raises(InputError, match="choose a law of that list"):
        resolve(own(tmp_path, SL2 + 'law = "quux"'))


def test_the_law_stands_in_either_place(tmp_path: Path) -> None:
    inner, top = 'law = "skew"', 'law = "skew"'
    laws = {own(tmp_path, SL2 + a, b).law for a, b in [(inner, ""), ("", top), (inner, top)]}
    assert laws == {"skew"}
    with pytest.raises(InputError) as caught:
        own(tmp_path, SL2 + inner, 'law = "log"')
    assert (caught.value.key, caught.value.expected) == ("group.law", "one law")
    assert caught.value.found == "'skew', and 'log' at the top of the file"


@pytest.mark.parametrize("name", ["SO3", "R3", "T2", "R20"])
def test_the_name_of_another_group_is_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(InputError) as caught:
        resolve(own(tmp_path, SL2.replace("SL2", name)))
    assert caught.value.key == "group.name"
    assert f'"my_{name}"' in caught.value.remedy


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


def test_a_group_of_ones_own_has_no_body(tmp_path: Path) -> None:
    path = written(tmp_path, "", table=SL2)
    text = path.read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("inertia")]
    path.write_text("\n".join([*lines, "[body]", "mass = 1"]), encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load(path)
    assert (caught.value.key, caught.value.found) == ("body", "a body on SL2")
