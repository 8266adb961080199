"""The controllers with a law of their own: what a file may say, and how it is told otherwise."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from derive.control.table import CONTROLLERS
from derive.vehicle import InputError, Vehicle, load, resolve
from derive.vehicle.starter import starter

GAINS = {
    "gsmc": "lambda = 0.5\nk_s = 1",
    "lsf_printed": "k = 1\nkappa = 0.5",
    "lsf": "k = 1\nkappa = 0.5",
    "pd_plus": "k_R = 9.25\nk_Omega = 18.5",
}
LAW = {"lsf_printed": "skew", "lsf": "skew", "pd_plus": "lee"}
each_baseline = pytest.mark.parametrize("name", LAW)


def read(
    folder: Path, controller: str, gains: str, *lines: str, group: str = '"SO3"', n: int = 3
) -> Vehicle:
    diagonal = [[float(3 + i) if i == j else 0.0 for j in range(n)] for i in range(n)]
    text = ['name = "body"', f"group = {group}", f"inertia = {diagonal}"]
    text += [f'controller = "{controller}"', *lines, "[gains]", gains]
    path = folder / "body.toml"
    path.write_text("\n".join(text), encoding="utf-8")
    return load(path)


def refusal(*given: str, folder: Path, **more: object) -> InputError:
    with pytest.raises(InputError) as caught:
        read(folder, *given, **more)  # type: ignore[arg-type]
    return caught.value


@each_baseline
def test_its_law_is_its_own_said_or_not(tmp_path: Path, name: str) -> None:
    bare = read(tmp_path, name, GAINS[name])
    said = read(tmp_path, name, GAINS[name], f'law = "{LAW[name]}"')
    assert bare == said
    assert bare.law == LAW[name]
    assert tuple(gain for gain, _ in bare.gains) == CONTROLLERS[name].names
    assert resolve(bare).dim == 3


def test_gains_are_exact_and_in_order(tmp_path: Path) -> None:
    swapped = read(tmp_path, "pd_plus", "k_Omega = 18.5\nk_R = 9.25")
    assert swapped.gains == (("k_R", Fraction(37, 4)), ("k_Omega", Fraction(37, 2)))


@each_baseline
@pytest.mark.parametrize("law", ["log", "mrp", "nonsense"])
def test_another_law_is_refused(tmp_path: Path, name: str, law: str) -> None:
    fault = refusal(name, GAINS[name], f'law = "{law}"', folder=tmp_path)
    assert (fault.key, fault.found) == ("law", f"the string '{law}'")
    assert fault.expected == f'nothing, or "{LAW[name]}": {name} has an attitude error of its own'
    assert 'leave law out, or write controller = "gsmc"' in fault.remedy


OWN = '{name = "SL2", basis = [[[0, 1], [0, 0]], [[0, 0], [1, 0]], [[1, 0], [0, -1]]]}'


@each_baseline
@pytest.mark.parametrize(
    ("group", "n"), [('"S3"', 3), ('"SE3"', 6), ('"SO3 x R3"', 6), ('"SO2"', 1), (OWN, 3)]
)
def test_another_group_is_refused(tmp_path: Path, name: str, group: str, n: int) -> None:
    fault = refusal(name, GAINS[name], folder=tmp_path, group=group, n=n)
    assert fault.key == "controller"
    assert fault.expected.endswith(": gsmc, reaching")
    assert f"'{name}', which exists on SO3 only: its attitude error is made of" in fault.found
    assert fault.remedy.startswith('write controller = "gsmc", which exists on every group')


@pytest.mark.parametrize(
    ("controller", "gains", "key", "found", "remedy"),
    [
        ("lsf", GAINS["gsmc"], "lambda", "a gain of gsmc, reaching", '"gsmc" or "reaching"'),
        ("pd_plus", GAINS["lsf"], "k", "a gain of lsf_printed, lsf", "give k_R and k_Omega, or"),
        ("gsmc", GAINS["pd_plus"], "k_R", "a gain of pd_plus", 'controller = "pd_plus" above'),
        ("lsf", GAINS["lsf"] + "\nk_z = 1", "k_z", "an unknown key", "write k, the nearest"),
        ("lsf", "k = 1", "kappa", "nothing, the key is missing", "in 1/s^2, below [gains]"),
        ("lsf", "k = 0\nkappa = 1", "k", "0", "another positive number"),
        ("pd_plus", "k_R = -1\nk_Omega = 1", "k_R", "-1", "in N m, below [gains]"),
        ("pd_plus", 'k_R = 1\nk_Omega = "1"', "k_Omega", "the string '1'", "in N m s, below"),
        ("lsf", "k = 1\nkappa = 1e7", "kappa", "10000000", "in 1/s^2"),
    ],
)
def test_a_bad_gain_is_told(
    tmp_path: Path, controller: str, gains: str, key: str, found: str, remedy: str
) -> None:
    fault = refusal(controller, gains, folder=tmp_path)
    assert (fault.key, fault.found) == (f"gains.{key}", found)
    assert remedy in fault.remedy


def test_a_controller_that_nobody_knows_is_told_with_all_of_them(tmp_path: Path) -> None:
    fault = refusal("pd", GAINS["pd_plus"], folder=tmp_path)
    assert fault.expected == "one of gsmc, reaching, lsf_printed, lsf, pd_plus"
    assert "pd_plus" in fault.remedy


@pytest.mark.parametrize(
    ("group", "controllers"),
    [("SO3", "gsmc, reaching, lsf_printed, lsf, pd_plus"), ("SE3", "gsmc, reaching")],
)
def test_the_starter_names_those_that_exist_there(group: str, controllers: str) -> None:
    assert f'controller = "gsmc"  # one of: {controllers}\n' in starter("body", group)
