"""Groups by name, as products and from a [group] table: read exactly, and the bad ones told."""

from dataclasses import replace
from fractions import Fraction
from itertools import product
from pathlib import Path

import pytest

from derive.lie.catalogue import GROUPS, named
from derive.vehicle import Facts, InputError, OwnGroup, Vehicle, check_facts, load, resolve
from derive.vehicle.group import group_of
from derive.vehicle.lookup import laws_on
from derive.vehicle.starter import starter

SL2 = 'name = "SL2"\nbasis = [[[0, 1], [0, 0]], [[0, 0], [1, 0]], [[1, 0], [0, -1]]]\n'
PAIRS = [f"{a} x {b}" for a, b in product(("SO2", "S3", "SE3", "SE23", "R3"), repeat=2)]
TRIPLES = ["SO2 x SO3 x SE2", "SE3 x SO3 x R2"]


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
    diagonal = [vehicle.inertia[i][i] for i in range(len(vehicle.inertia))]
    assert [entry < 1 for entry in diagonal] == [
        unit == "rad/s" for unit in named(vehicle.group).units
    ]
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
    found = group_of(vehicle)
    basis = tuple(tuple(map(tuple, e.tolist())) for e in found.basis)
    assert (found.name, basis, found.units) == ("SL2", vehicle.own.basis, vehicle.own.units)
    with pytest.raises(InputError, match="2 by 2: SL2 has dimension 2"):
        check_facts(vehicle, Facts(dim=2, is_rotation=False))


def test_a_law_that_is_not_there_is_told_with_the_reason(tmp_path: Path) -> None:
    for vehicle in (own(tmp_path, SL2), own(tmp_path, SL2 + 'law = "log"')):
        with pytest.raises(InputError) as caught:
            resolve(vehicle)
        assert "skew" in caught.value.expected
        assert "(the laws that exist on SL2)" in caught.value.expected
        assert caught.value.found.endswith("of the logarithm of SL2 is found from its basis")
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
    path = written(tmp_path, "", table=SL2.replace("SL2", name))
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("[1, 0, 0]", "[9, 0, 0]"), encoding="utf-8")  # no body on SO3
    with pytest.raises(InputError) as caught:
        resolve(load(path))
    assert caught.value.key == "group.name"
    assert f'"my_{name}"' in caught.value.remedy


def test_a_group_of_ones_own_has_no_body(tmp_path: Path) -> None:
    path = written(tmp_path, "", table=SL2)
    text = path.read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("inertia")]
    path.write_text("\n".join([*lines, "[body]", "mass = 1"]), encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load(path)
    assert (caught.value.key, caught.value.found) == ("body", "a body on SL2")


def test_a_large_group_without_a_form_is_refused(tmp_path: Path) -> None:
    row = [int(i == 0) for i in range(5)]
    scaled = [[(i + 1) * int(i == j) for j in range(5)] for i in range(5)]
    path = tmp_path / "body.toml"
    path.write_text(
        f'name = "body"\ninertia = [{row[:1]}]\n[gains]\nlambda = 0.5\nk_s = 1\n'
        f'[group]\nname = "big"\nlaw = "skew"\nbasis = [{scaled}]\n',
        encoding="utf-8",
    )
    with pytest.raises(InputError, match="at most 4 rows") as caught:
        resolve(load(path))
    assert caught.value.key == "group.basis"
