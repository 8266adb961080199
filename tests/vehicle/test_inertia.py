"""An inertia is judged exactly, and as numpy judges it where the verdict is clear."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from derive.vehicle import Facts, InputError, Vehicle, check_facts, load
from derive.vehicle.check import determinant

BODY = Facts(dim=3, is_rotation=True)


def with_inertia(folder: Path, rows: str) -> Vehicle:
    path = folder / "body.toml"
    text = f'name = "body"\ngroup = "SO3"\ninertia = {rows}\ngains = {{lambda = 0.5, k_s = 1}}\n'
    path.write_text(text, encoding="utf-8")
    return load(path)


@pytest.mark.parametrize(
    ("rows", "expected", "found"),
    [
        (
            "[[1, 0.1, 0], [0.1, 1, 0.2], [0, 0.20000000000000000001, 1]]",
            "a symmetric matrix",
            "row 2, column 3 is 0.2, row 3, column 2 is 0.20000000000000000001 (difference -1e-20)",
        ),
        (
            "[[-1, 0], [0, 1]]",
            "positive definite",
            "minor 1, the determinant of the upper left ent",
        ),
        ("[[1, 2, 0], [2, 1, 0], [0, 0, 1]]", "positive definite", "2 by 2 block, is -3"),
        ("[[0.1, 0.3], [0.3, 0.9]]", "greater than 0", "leading minor 2"),  # 0, but not in floats
    ],
)
def test_bad_inertia_is_told_with_its_numbers(
    tmp_path: Path, rows: str, expected: str, found: str
) -> None:
    with pytest.raises(InputError) as caught:
        with_inertia(tmp_path, rows)
    assert caught.value.key == "inertia"
    assert expected in caught.value.expected
    assert found in caught.value.found


def diagonal(path: Path, *moments: str) -> Vehicle:
    a, b, c = moments
    return with_inertia(path, f"[[{a}, 0, 0], [0, {b}, 0], [0, 0, {c}]]")


@pytest.mark.parametrize("place", range(3))
def test_triangle_inequality_is_exact(tmp_path: Path, place: int) -> None:
    moments = ["0.1", "0.2"]
    moments.insert(place, "0.3")  # a flat plate: in floating point 0.1 + 0.2 > 0.3
    check_facts(diagonal(tmp_path, *moments), BODY)
    moments[place] = "0.30000000000000000000001"
    with pytest.raises(InputError, match="none greater than the sum"):
        check_facts(diagonal(tmp_path, *moments), BODY)


def test_triangle_message_prints_the_principal_moments(tmp_path: Path) -> None:
    with pytest.raises(InputError) as told:
        diagonal(tmp_path, "4", "1", "2")
    sound = diagonal(tmp_path, "4", "3", "2")
    thin = replace(sound, inertia=((Fraction(9), *sound.inertia[0][1:]), *sound.inertia[1:]))
    with pytest.raises(InputError) as caught:
        check_facts(thin, BODY)
    assert told.value.found == "principal moments 1, 2, 4, but 4 > 1 + 2"
    assert caught.value.found == "principal moments 2, 3, 9, but 9 > 2 + 3"
    assert caught.value.key == told.value.key == "inertia"
    check_facts(thin, Facts(dim=3, is_rotation=False))
    check_facts(replace(thin, is_in_fluid=True), BODY)


def test_dimension_of_the_group_is_required(tmp_path: Path) -> None:
    vehicle = with_inertia(tmp_path, "[[1, 0], [0, 1]]")
    with pytest.raises(InputError) as caught:
        check_facts(vehicle, BODY)
    assert (caught.value.expected, caught.value.found) == (
        "3 by 3: SO3 has dimension 3",
        "2 by 2",
    )


def test_inertia_is_judged_as_numpy_judges_it(tmp_path: Path) -> None:
    rng = np.random.default_rng(0)
    seen = set()
    for _ in range(300):
        square = rng.integers(-9, 10, (3, 3))
        matrix = square + square.T + int(rng.integers(0, 30)) * np.eye(3, dtype=int)
        low, middle, high = np.linalg.eigvalsh(matrix)
        if min(abs(low), abs(low + middle - high)) < 1e-6:
            continue
        try:
            check_facts(with_inertia(tmp_path, str(matrix.tolist())), BODY)
            verdict = "body"
        except InputError as error:
            verdict = error.expected.split()[1]
        wanted = "positive" if low < 0 else "moments" if low + middle < high else "body"
        assert verdict == wanted
        seen.add(verdict)
    assert seen == {"positive", "moments", "body"}


def test_determinant_agrees_with_numpy() -> None:
    rng = np.random.default_rng(1)
    for n in range(1, 7):
        matrix = rng.integers(-2, 3, (n, n))  # small numbers, so that zero pivots occur
        exact = determinant(tuple(tuple(map(Fraction, map(int, row))) for row in matrix), range(n))
        np.testing.assert_allclose(float(exact), np.linalg.det(matrix), atol=1e-9)
