"""A [body] becomes the inertia that point masses have, and each wrong one is told."""

from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from derive.vehicle import InputError, Vehicle, load
from derive.vehicle.key import BODY_KEYS
from derive.vehicle.rigid import KINDS, kinds

Array = NDArray[np.float64]

MOMENTS = "moments = [[2, 0, 0], [0, 3, 0], [0, 0, 4]]"


def of_body(folder: Path, group: str, *bodies: str, options: str = "") -> Vehicle:
    """The vehicle of a file with those bodies, the lines of each in one text."""
    head = "[body]" if len(bodies) == 1 else "[[body]]"
    tables = [f"{head}\n{body}\n" for body in bodies]
    path = folder / "body.toml"
    path.write_text(
        f'name = "body"\ngroup = "{group}"\ngains = {{lambda = 0.5, k_s = 1}}\n{options}\n'
        + "".join(tables),
        encoding="utf-8",
    )
    return load(path)


def points(seed: int, d: int) -> tuple[Array, Array]:
    """Masses, 16 in all so that means are exact, and places (8, d)."""
    random = np.random.default_rng(seed)
    return np.full(8, 2.0), random.integers(-4, 5, (8, d)).astype(float)


def energy(masses: Array, places: Array, x: Array) -> float:
    """Kinetic energy of point masses fixed in a frame that moves with x, rotation first."""
    d = places.shape[1]
    turn, v = (x[:3], x[3:]) if d == 3 else (np.array([0, 0, x[0]]), x[1:])
    deep = np.pad(places, ((0, 0), (0, 3 - d)))
    speeds = v + np.cross(turn, deep)[:, :d]
    return float(np.sum(masses * np.sum(speeds**2, axis=1)) / 2)


def measured(masses: Array, places: Array) -> Array:
    """Inertia (n, n) by polarisation of the energy."""
    n = {2: 3, 3: 6}[places.shape[1]]
    unit = np.eye(n)
    single = [energy(masses, places, x) for x in unit]
    inertia = 2 * np.diag(single)
    for i, j in combinations(range(n), 2):
        both = energy(masses, places, unit[i] + unit[j])
        inertia[i, j] = inertia[j, i] = both - single[i] - single[j]
    return inertia


def told(masses: Array, places: Array) -> str:
    """The same points as a [body]: mass, centre of mass, and moments about it."""
    mass, center = masses.sum(), masses @ places / masses.sum()
    arms = places - center
    moments: object
    if places.shape[1] == 2:
        moments = float(np.sum(masses * np.sum(arms**2, axis=1)))
    else:
        squares = np.sum(arms**2, axis=1)
        parts = [m * (s * np.eye(3) - np.outer(r, r))
                 for m, s, r in zip(masses, squares, arms, strict=True)]  # fmt: skip
        moments = np.sum(parts, axis=0).tolist()
    return f"mass = {mass}\ncenter = {center.tolist()}\nmoments = {moments}"


def floats(vehicle: Vehicle) -> Array:
    return np.array([[float(entry) for entry in row] for row in vehicle.inertia])


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize(("group", "d"), [("SE2", 2), ("SE3", 3)])
def test_a_body_has_the_energy_of_its_points(tmp_path: Path, group: str, d: int, seed: int) -> None:
    masses, places = points(seed, d)
    vehicle = of_body(tmp_path, group, told(masses, places))
    np.testing.assert_allclose(floats(vehicle), measured(masses, places), rtol=1e-14, atol=1e-12)
    assert not vehicle.is_in_fluid


@pytest.mark.parametrize(
    ("group", "body", "inertia"),
    [
        ("SO2", "moments = 0.5", [[0.5]]),
        ("SO3", MOMENTS, np.diag([2, 3, 4])),
        ("S3", MOMENTS, np.diag([2, 3, 4])),
        ("R1", "mass = 3", [[3]]),
        ("R4", "mass = 3", 3 * np.eye(4)),
        ("T2", "mass = 3", 3 * np.eye(2)),
        ("SE2", "mass = 3\nmoments = 2", np.diag([2, 3, 3])),
        ("SE3", f"mass = 5\n{MOMENTS}", np.diag([2, 3, 4, 5, 5, 5])),
        ("R2", "mass = 3\nadded_mass = [[1, 0.5], [0.5, -1]]", [[4, 0.5], [0.5, 2]]),
        ("SO3", f"{MOMENTS}\nadded_mass = [[9, 0, 0], [0, 0, 0], [0, 0, 0]]", np.diag([11, 3, 4])),
    ],
)
def test_every_group_of_a_body_has_its_keys(
    tmp_path: Path, group: str, body: str, inertia: Array
) -> None:
    vehicle = of_body(tmp_path, group, body)
    assert floats(vehicle).tolist() == np.array(inertia, float).tolist()
    assert vehicle.is_in_fluid == ("added_mass" in body)


def test_a_product_has_a_block_for_each_body(tmp_path: Path) -> None:
    masses, places = points(0, 3)
    vehicle = of_body(tmp_path, "SE3 x SO3  x T2", told(masses, places), MOMENTS, "mass = 7")
    assert vehicle.group == "SE3 x SO3 x R2"
    expected = np.zeros((11, 11))
    expected[:6, :6] = measured(masses, places)
    expected[6:, 6:] = np.diag([2, 3, 4, 7, 7])
    np.testing.assert_allclose(floats(vehicle), expected, rtol=1e-14, atol=1e-12)


@pytest.mark.parametrize("group", [name for name, kind in KINDS.items() if kind.is_body] + ["R3"])
def test_a_key_that_says_nothing_is_refused(tmp_path: Path, group: str) -> None:
    (kind,) = kinds(group)
    for key in {*BODY_KEYS} - {*kind.keys}:
        with pytest.raises(InputError) as caught:
            of_body(tmp_path, group, f"{key} = 1")
        assert caught.value.key == f"body.{key}"
        assert f"all that there is of a body on {group}" in caught.value.expected


SPACE = f"mass = 5\n{MOMENTS}"
FAR = "[[1, 0, 0], [0, 1, 0], [0, 0, 3]]"

# group, bodies, key, fragment of expected, of found, of remedy
BAD = [
    ("SE3", [MOMENTS], "body.mass", "greater than 0", "missing", "mass = 1.0"),
    ("SE3", ["mass = 5"], "body.moments", "rows", "missing", "kg m^2"),
    ("SE2", ["mass = 5"], "body.moments", "greater than 0", "missing", "kg m^2"),
    ("SE2", [f"mass = 5\n{MOMENTS}"], "body.moments", "a number", "array of 3", "moments = 0.1"),
    ("SE3", ["mass = 5\nmoments = 3"], "body.moments", "array of rows", "3", "[[J1, 0, 0]"),
    ("SE3", ["mass = 5\nmoments = [[1]]"], "body.moments", "3 rows of 3", "1 rows", "[[J1, 0, 0]"),
    ("SE3", ["mass = -5\n" + MOMENTS], "body.mass", "greater than 0", "-5", "mass = 1.0"),
    ("SE3", ["mass = '5'\n" + MOMENTS], "body.mass", "a number", "string '5'", "mass = 1.0"),
    ("SE3", [SPACE + "\ncenter = [1, 2]"], "body.center", "3 numbers", "array of 2", "in m"),
    ("SE2", ["mass = 1\nmoments = 1\ncenter = [1, 2, 3]"], "body.center", "2", "of 3", "in m"),
    ("SE3", [SPACE + "\ncenter = 0"], "body.center", "3 numbers", "0", "in m"),
    ("SE3", [SPACE + "\ncenter = [0, true, 0]"], "body.center, entry 2", "3", "true", "in m"),
    ("SE3", [SPACE + "\ncenter = [0, 0, 10001]"], "center, entry 3", "10000", "10001", "in m"),
    ("SE3", [f"mass = 5\nmoments = {FAR}"], "body.moments", "none greater", "3 > 1 + 1", "added_"),
    ("SO3", [f"moments = {FAR}"], "body.moments", "none greater", "3 > 1 + 1", "added_mass"),
    (
        "SO3",
        ["moments = [[1, 2, 0], [2, 1, 0], [0, 0, 1]]"],
        "body.moments",
        "positive definite",
        "minor 2",
        "signs",
    ),
    (
        "SO3",
        ["moments = [[3, 1, 0], [0, 3, 0], [0, 0, 3]]"],
        "body.moments",
        "symmetric",
        "is 1",
        "equal",
    ),
    ("SO3", [MOMENTS + "\nadded_mass = 1"], "body.added_mass", "rows", "1", "all 3 rows"),
    ("SO3", [MOMENTS + "\nadded_mass = [[1]]"], "body.added_mass", "3 rows", "1 rows", "all 3"),
    (
        "R2",
        ["mass = 1\nadded_mass = [[0, 1], [0, 0]]"],
        "body.added_mass",
        "symmetric",
        "row 1, column 2 is 1",
        "equal",
    ),
    (
        "R2",
        ["mass = 1\nadded_mass = [[0, 1], [1, 0]]"],
        "body, with added_mass",
        "positive definite",
        "leading minor 2",
        "check",
    ),
    (
        "SE3",
        ["mass = 1e9\ncenter = [0, 0, 9]\n" + MOMENTS],
        "body",
        "1000000000",
        "row 1, column 1",
        "units",
    ),
    (
        "SE2",
        ["mass = 1e-20\nmoments = 1\ncenter = [1e-20, 0]"],
        "body",
        "1e-30",
        "1e-40",
        "units",
    ),
    ("SO3", [MOMENTS + "\nk_s = 1"], "body.k_s", "moments, added_mass", "unknown", "below [gains]"),
    ("SO3", [MOMENTS + "\nmas = 1"], "body.mas", "moments, added_mass", "unknown", "remove"),
    ("SE23", [SPACE], "body", "SO2, SO3, S3, SE2, SE3, R1", "a body on SE23", "inertia ="),
    ("SO3 x SE23", [MOMENTS, SPACE], "body", "a group of bodies", "on SE23", "inertia ="),
    ("SO4", [SPACE], "group", "SO3", "'SO4'", "SO3"),
    ("R24 x R1", ["mass = 1", "mass = 1"], "group", "at most 24", "25", "one vehicle"),
    ("SO3", [MOMENTS, MOMENTS], "body", "SO3 is no product", "2 of them", "[body] once"),
    ("SO3 x SO3", [MOMENTS], "body", "2 bodies, one for each factor", "1 of them", "[[body]] once"),
    ("SO3 x R3", [MOMENTS, MOMENTS], "body 2.moments", "mass", "says nothing", "remove moments"),
    ("SO3 x R3", [MOMENTS, "mass = 0"], "body 2.mass", "greater than 0", "0", "mass = 1.0"),
]


@pytest.mark.parametrize(("group", "bodies", "key", "expected", "found", "remedy"), BAD)
def test_a_bad_body_is_told(
    tmp_path: Path, group: str, bodies: list[str], key: str, expected: str, found: str, remedy: str
) -> None:
    with pytest.raises(InputError) as caught:
        of_body(tmp_path, group, *bodies)
    assert key in caught.value.key
    assert expected in caught.value.expected
    assert found in caught.value.found
    assert remedy in caught.value.remedy
    message = str(caught.value).splitlines()
    assert len(message) == 4
    assert all(len(line) < 300 and line.isprintable() for line in message)


def test_a_body_and_an_inertia_are_one_too_many(tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        of_body(tmp_path, "SO3", MOMENTS, options="inertia = [[1]]")
    assert (caught.value.key, caught.value.found) == ("body", "both")


def test_what_is_no_table_is_no_body(tmp_path: Path) -> None:
    for given in ("3", "[1, 2]", "[{mass = 1}, 2]"):
        path = tmp_path / "body.toml"
        path.write_text(f'name = "body"\ngroup = "SE3"\nbody = {given}\n[gains]\nlambda=1\nk_s=1')
        with pytest.raises(InputError) as caught:
            load(path)
        assert (caught.value.key, caught.value.expected) == ("body", "a table")
