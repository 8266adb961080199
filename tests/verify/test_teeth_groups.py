"""Seeded faults in the emitted text of groups other than attitude: one sign, and it is seen."""

from __future__ import annotations

import re
from functools import cache

import pytest

from derive import pipeline
from derive.vehicle import Vehicle
from derive.verify.check import Report
from derive.verify.run import run
from tests.verify.subjects import plant, vehicle
from tests.verify.test_suite import failures

SE3 = vehicle("SE3", "log", options=("external", "momentum"))
SUBJECTS = {
    "SE3": SE3,
    "SE2": vehicle("SE2", "log"),
    "SE23": vehicle("SE23", "log"),
    "SO3 x R3": vehicle("SO3 x R3", "log"),
    "SL2": vehicle("SL2", "cayley"),
}

TRACKING = re.compile(r"^ +((?:(?:rho|eta|swing|nu_u_dot|force)\w*|c)_\d) = ")
"""A line of the emitted numpy module that computes what the law is made of."""


@cache
def texts(of: Vehicle) -> dict[str, str]:
    return pipeline.texts(of)


def judged(of: Vehicle, files: dict[str, str]) -> Report:
    """The numpy module alone: nothing is compiled, and C cannot disagree with it."""
    only = {path: text for path, text in files.items() if path.endswith(".py")}
    return run(of.name, only, plant(of), each=2)


def broken(of: Vehicle, line: str) -> dict[str, str]:
    """The module with the value of one line turned round."""
    (path,) = (path for path in texts(of) if path.endswith(".py"))
    name, _, value = line.partition(" = ")
    assert texts(of)[path].count(line) >= 1
    harmed = f"{name} = -({value})" if value.count("(") == value.count(")") else line
    return {path: texts(of)[path].replace(line, harmed)}


def lines(of: Vehicle) -> list[str]:
    """Whole assignments of the module, each of another quantity."""
    (path,) = (path for path in texts(of) if path.endswith(".py"))
    found: dict[str, str] = {}
    for line in texts(of)[path].split("\n"):
        hit = TRACKING.match(line)
        if hit and line.count("(") == line.count(")") and "np.where" not in line:
            found.setdefault(hit[1].rpartition("_")[0], line)
    return list(found.values())


@pytest.mark.parametrize("group", SUBJECTS)
def test_a_turned_sign_is_seen(group: str) -> None:
    of = SUBJECTS[group]
    assert failures(judged(of, texts(of))) == []
    assert lines(of)
    for line in lines(of):
        assert failures(judged(of, broken(of, line))) != [], line


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (r"(whole_momentum_3 = \(\s*)momentum_3", r"\1-momentum_3"),
        (r"(    force_4 = [^=]*?)- external_4", r"\1+ external_4"),
        (r"external_0, external_1", r"external_1, external_0"),
    ],
)
def test_the_extras_of_se3_are_judged(right: str, wrong: str) -> None:
    (path,) = (path for path in texts(SE3) if path.endswith(".py"))
    harmed, count = re.subn(right, wrong, texts(SE3)[path])
    assert count, right
    assert failures(judged(SE3, {path: harmed})) != []
