"""A vehicle file is read exactly, without heavy imports, and its group and law are looked up."""

import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

import pytest

from derive.vehicle import Facts, InputError, check_facts, load, resolve
from derive.vehicle.starter import starter

ROOT = Path(__file__).parents[2]
VEHICLES = sorted((ROOT / "vehicles").glob("*.toml"))
BODY = Facts(dim=3, is_rotation=True)

GOOD = """\
name = "body"
group = "SO3"
inertia = [[3.6046, -0.0706, 0.1491], [-0.0706, 8.6868, 0.0449], [0.1491, 0.0449, 9.3484]]
[gains]
lambda = 0.5
k_s = 1
"""
INERTIA = GOOD.splitlines()[2]


def written(folder: Path, text: str | bytes) -> Path:
    path = folder / "body.toml"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return path


def test_numbers_are_exact(tmp_path: Path) -> None:
    vehicle = load(written(tmp_path, GOOD))
    assert vehicle.inertia[0][0] == Fraction(18023, 5000)
    assert vehicle.gains == (("lambda", Fraction(1, 2)), ("k_s", Fraction(1)))
    entries = [entry for row in vehicle.inertia for entry in row]
    assert {type(entry) for entry in entries} == {Fraction}


def test_defaults_order_and_byte_order_mark(tmp_path: Path) -> None:
    plain = load(written(tmp_path, GOOD))
    assert (plain.law, plain.controller) == ("log", "gsmc")
    assert (plain.scalars, plain.targets) == (("f32", "f64"), ("c99", "numpy"))
    full = GOOD + '[emit]\nscalars = ["f64", "f32"]\ntargets = ["numpy"]\n'
    vehicle = load(written(tmp_path, b"\xef\xbb\xbf" + full.replace("\n", "\r\n").encode()))
    assert vehicle == replace(plain, targets=("numpy",))


def test_gains_follow_the_controller_not_the_file(tmp_path: Path) -> None:
    swapped = GOOD.replace("lambda = 0.5\nk_s = 1", "k_s = 1\nlambda = 0.5")
    assert load(written(tmp_path, swapped)) == load(written(tmp_path, GOOD))


def test_two_places_of_one_vehicle_are_equal(tmp_path: Path) -> None:
    vehicle = load(written(tmp_path, GOOD))
    assert replace(vehicle, source="elsewhere") == vehicle
    assert hash(replace(vehicle, source="elsewhere")) == hash(vehicle)


def test_pattern_is_the_upper_triangle(tmp_path: Path) -> None:
    text = GOOD.replace(INERTIA, "inertia = [[2, 0, 0.5], [0, 2, 0], [0.5, 0, 2]]")
    assert load(written(tmp_path, text)).pattern == (True, False, True, True, False, True)


def test_loading_imports_nothing_heavy() -> None:
    code = (
        "import sys; from pathlib import Path; from derive.vehicle import load, check_facts, Facts;"
        "from derive.vehicle.starter import starter; starter('body', 'SO3');"
        "vehicles = [load(path) for path in sorted(Path('vehicles').glob('*.toml'))];"
        "[check_facts(vehicle, Facts(len(vehicle.inertia), False)) for vehicle in vehicles];"
        "check_facts(vehicles[0], Facts(3, True));"
        "print(sorted({'sympy', 'numpy', 'casadi', 'mpmath', 'difflib'} & set(sys.modules)))"
    )
    run = [sys.executable, "-c", code]
    result = subprocess.run(run, cwd=ROOT, capture_output=True, text=True, check=True)
    assert result.stdout == "[]\n"


@pytest.fixture
def catalogue(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two groups and three laws in place of the real ones."""
    sizes = {"SO3": True, "S3": True, "SE2": False}
    groups = {
        name: SimpleNamespace(name=name, dim=3, is_rotation=turns) for name, turns in sizes.items()
    }
    on = {"log": ("SO3", "S3"), "half_log": ("S3",), "skew": ("SO3", "SE2")}
    laws = {(there, law): None for law, homes in on.items() for there in homes}

    def laws_of(group: SimpleNamespace) -> dict[str, None]:
        return {law: None for law, homes in on.items() if group.name in homes}

    lie = SimpleNamespace(GROUPS=groups, named=groups.__getitem__)
    kinematic = SimpleNamespace(
        LAWS=laws, laws_of=laws_of, why_not=lambda group, law: f"no {law} here"
    )
    monkeypatch.setitem(sys.modules, "derive.lie.catalogue", lie)
    monkeypatch.setitem(sys.modules, "derive.control.kinematic", kinematic)


@pytest.mark.usefixtures("catalogue")
@pytest.mark.parametrize(
    ("group", "law", "fragments"),
    [
        ("so3", "log", ("body.toml: group", "one of SO3, S3, SE2", "'so3'", 'group = "SO3"')),
        ("S3", "logg", ("body.toml: law", "one of log, half_log", "'logg'", 'law = "log"')),
        (
            "S3",
            "skew",
            (
                "law",
                "exist on S3",
                "'skew', which exists only on SO3, SE2: no skew here",
                "choose a",
            ),
        ),
        ("SO3", "half_log", ("law", "log, skew", "exists only on S3", "choose a law")),
        ("S3", "gibbs", ("law", "one of log, half_log", "'gibbs'", "choose a law of that list")),
    ],
)
def test_unknown_group_or_law_is_told_with_those_that_exist(
    tmp_path: Path, group: str, law: str, fragments: tuple[str, ...]
) -> None:
    vehicle = replace(load(written(tmp_path, GOOD)), group=group, law=law)
    with pytest.raises(InputError) as caught:
        resolve(vehicle)
    for fragment in fragments:
        assert fragment in str(caught.value)


@pytest.mark.usefixtures("catalogue")
def test_resolving_gives_the_facts_of_the_group(tmp_path: Path) -> None:
    assert resolve(load(written(tmp_path, GOOD))) == BODY


@pytest.mark.parametrize("path", VEHICLES, ids=lambda path: path.stem)
def test_committed_vehicles_load_and_are_bodies(path: Path) -> None:
    vehicle = load(path)
    assert vehicle.name == path.stem
    check_facts(vehicle, resolve(vehicle))


@pytest.mark.parametrize("group", ["SO3", "S3"])
def test_starter_loads(tmp_path: Path, group: str) -> None:
    vehicle = load(written(tmp_path, starter("body", group)))
    assert (vehicle.name, vehicle.group) == ("body", group)
    check_facts(vehicle, resolve(vehicle))


@pytest.mark.usefixtures("catalogue")
def test_starter_chooses_what_exists_on_the_group(tmp_path: Path) -> None:
    vehicle = load(written(tmp_path, starter("body", "SE2")))
    assert vehicle.law == "skew"
    check_facts(vehicle, resolve(vehicle))


@pytest.mark.usefixtures("catalogue")
@pytest.mark.parametrize(("name", "group"), [("a b", "SO3"), ("body", "SO4")])
def test_starter_refuses_what_would_not_load(name: str, group: str) -> None:
    with pytest.raises(InputError, match="derive init"):
        starter(name, group)
