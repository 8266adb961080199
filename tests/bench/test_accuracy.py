"""What `python -m bench accuracy` says of a group is measured, and a small mistake shows."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from bench import accuracy, exact
from bench.accuracy import Run
from bench.exact import Array
from bench.figure import Figure
from derive.verify.limits import EPS

ANGLES = (0.0, 1e-8, 1.0, np.pi - 1e-6)
LENGTHS = (1e-6, 1e6)


@pytest.fixture(autouse=True)
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(exact, "ANGLES", ANGLES)
    monkeypatch.setattr(exact, "LENGTHS", LENGTHS)


def judged(name: str, scalar: str, runs: list[Run]) -> dict[str, Figure]:
    figures = accuracy.judge(name, scalar, exact.states(name, scalar, 1), runs)
    return {one.name.removeprefix(f"{name} {scalar} "): one for one in figures}


@pytest.mark.parametrize("name", ["SO2", "SE2", "SE3", "SO3 x R3"])
def test_every_limit_is_kept(name: str, tmp_path: Path) -> None:
    for scalar, runs in accuracy.backends(name, tmp_path).items():
        assert len(runs) == (2 if scalar == "f64" else 1)
        found = judged(name, scalar, runs)
        assert all(one.is_within for one in found.values()), found
        assert {"log, rotation", "rate, rotation", "log(exp(x)) - x, rotation"} <= {*found}
        assert found["log, rotation"].value > 1e-3  # it is not compared with itself


def test_what_was_promised() -> None:
    assert accuracy.ANY.figure * EPS["f64"] == pytest.approx(1e-13)
    figures = [accuracy._figure("SE3", "f64", what, block, 0.0)
               for what, block in (("log", "rotation"), ("log", "translation"),
                                   ("rate", "rotation"),
                                   ("rate, natural scale", "translation"))]  # fmt: skip
    assert [one.limit.figure for one in figures if one.limit] == [4, 4, 4, 4]
    assert {*accuracy.GROUPS} >= {"SO2", "SO3", "S3", "SE2", "SE3", "SE23", "R3"}


def bent(run: Run, log: float, rate: float, column: int) -> Run:
    """A backend with a relative mistake in one coordinate."""

    def wrong(g: Array, nu: Array) -> tuple[Array, Array]:
        nu_u, nu_u_dot = (each.copy() for each in run(g, nu))
        nu_u[:, column] *= 1 + log
        nu_u_dot[:, column] *= 1 + rate
        return nu_u, nu_u_dot

    return wrong


@pytest.mark.parametrize(("column", "block"), [(0, "rotation"), (5, "translation")])
def test_a_mistake_of_some_eps_exceeds_a_limit(column: int, block: str, tmp_path: Path) -> None:
    run = accuracy.backends("SE3", tmp_path)["f64"][0]
    log = judged("SE3", "f64", [run, bent(run, 4e-15, 0.0, column)])
    assert not log[f"log, {block}"].is_within
    assert log["rate, rotation"].is_within
    rate = judged("SE3", "f64", [run, bent(run, 0.0, 8e-15, column)])
    name = "rate, rotation" if block == "rotation" else "rate, natural scale, translation"
    assert not rate[name].is_within
    assert rate[f"log, {block}"].is_within


def test_nothing_but_zero_is_right_where_the_truth_is_zero() -> None:
    zero = np.zeros(2)
    assert accuracy._relative(zero, zero) == 0.0
    assert accuracy._relative(np.array([0.0, 1e-300]), zero) == np.inf
    assert accuracy._relative(np.array([np.nan, 0.0]), zero + 1) == np.inf


def test_states_are_of_the_angle_and_the_length_they_are_said_to_be() -> None:
    states = exact.states("SE3", "f64", 1)
    angle = np.linalg.norm(states.log[0][:, :3], axis=-1)
    np.testing.assert_allclose(angle, np.repeat(ANGLES, len(LENGTHS)), rtol=1e-9)
    length = np.linalg.norm(states.log[0][:, 3:], axis=-1)
    np.testing.assert_allclose(length, np.tile(LENGTHS, len(ANGLES)), rtol=1e-9)
    moved = np.linalg.norm(states.g.reshape(-1, 4, 4)[:, :3, 3], axis=-1)
    np.testing.assert_allclose(states.lengths[:, 1], moved, rtol=1e-15)
