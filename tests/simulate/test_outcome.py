"""What a sweep says of a run, against the recorded flight of that run, read on its own."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from derive.simulate.chunk import Plan, fly_seeds
from derive.simulate.draw import drawn, seed_of
from derive.simulate.flight import Flight, recorded
from derive.simulate.loop import Loop
from derive.simulate.outcome import OUTCOMES
from derive.simulate.reference import Course
from tests.simulate.crafts import plan

SEEDS = [seed_of(2, i) for i in range(24)]


def moving(group: str, **given: Any) -> Plan:
    """About a moving reference."""
    made = plan(group, **given)
    rate = tuple(0.1 * (i + 1) for i in range(len(made.course.rows[0])))
    return replace(made, course=Course("steady", made.course.start, (rate,)))


def flown(made: Plan) -> list[Flight]:
    """The same runs, recorded, in numpy's plant."""
    reference = made.course.reference()
    runs = drawn(made.craft, reference, made.spread, SEEDS)
    return recorded(Loop(made.craft, made.backend, reference, made.settings[0], runs).moments())


@pytest.mark.parametrize(
    ("group", "given"),
    [
        ("SO3", {"duration": 9.5}),
        ("SO3", {"duration": 7.0, "backend": "f64", "settle": 0.05}),
        ("SO3", {"duration": 2.0, "force_limit": (2.0,)}),
        ("SO3", {"duration": 3.0, "noise_g": 0.01, "noise_nu": 0.02}),
        ("S3", {"duration": 4.0, "speed": 3.0}),
        ("SE2", {"duration": 6.0}),
        ("R3", {"duration": 8.0, "settle": 0.1}),
    ],
    ids=str,
)
def test_every_outcome_is_what_the_flight_shows(group: str, given: dict[str, Any]) -> None:
    made = moving(group, **given)
    rows = fly_seeds(made, SEEDS)
    for i, flight in enumerate(flown(made)):
        rate, force = np.linalg.norm(flight.nu_e, axis=1), np.linalg.norm(flight.force, axis=1)
        off = np.flatnonzero((flight.height > made.settle) | (rate > made.settle))
        is_settled = not len(off) or off[-1] < len(flight.t) - 1
        assert rows["settled"][i] == is_settled
        if is_settled:
            assert rows["settling_time"][i] == flight.t[off[-1] + 1 if len(off) else 0]
        else:
            assert np.isnan(rows["settling_time"][i])
        found = [rows[name][i] for name in ("energy", "peak_force", "final_height", "final_rate")]
        wanted = [flight.energy[-1], force.max(), flight.height[-1], rate[-1]]
        np.testing.assert_allclose(found, wanted, rtol=1e-14)
        assert rows["worst_status"][i] == flight.status.max()
        assert rows["initial_height"][i] == flight.height[0]
        np.testing.assert_allclose(rows["initial_rate"][i], rate[0], rtol=1e-14)


def test_some_runs_settle_and_some_do_not() -> None:
    rows = fly_seeds(moving("SO3", duration=7.0, settle=0.05), SEEDS)
    assert 3 < rows["settled"].sum() < len(SEEDS) - 3


def test_a_crossing_of_the_cut_is_a_rotation_vector_that_turns_over() -> None:
    """On SO(3) near pi: from one instant to the next it points the other way."""
    made = moving("SO3", duration=3.0, speed=5.0)
    counted = fly_seeds(made, SEEDS)["crossings"]
    turned = []
    for flight in flown(made):
        before, after = flight.nu_u[:-1], flight.nu_u[1:]
        far = np.linalg.norm(before, axis=1) > 2.5
        turned.append(int(np.sum(far & ((before * after).sum(1) < 0))))
    assert counted.tolist() == turned
    assert sum(turned) >= 5


def test_nothing_crosses_where_nothing_turns() -> None:
    assert not fly_seeds(moving("R3", speed=30.0), SEEDS)["crossings"].any()


def test_a_plant_that_is_off_its_group_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    made = plan("SO3", duration=0.2)
    assert fly_seeds(made, SEEDS)["drift"].max() < 1e-12
    plain = Loop._lifted
    monkeypatch.setattr(
        Loop, "_lifted", lambda *given: plain(*given)._replace(g=1.001 * given[1].g)
    )
    assert fly_seeds(made, SEEDS)["drift"].min() > 1e-4


@pytest.mark.parametrize("group", ["SO2", "SO3", "S3", "SE2", "SE3", "SE23", "R3", "SE3 x SO3",
                                   "SL2"])  # fmt: skip
def test_every_group_is_swept(group: str) -> None:
    rows = fly_seeds(plan(group, duration=0.2), SEEDS[:3])
    assert {*OUTCOMES} < {*rows}
    for name in ("energy", "peak_force", "final_height", "final_rate"):
        assert np.all(np.isfinite(rows[name]))
        assert np.all(rows[name] > 0)
    assert rows["drift"].max() < 1e-12
    assert rows["worst_status"].max() < 16
