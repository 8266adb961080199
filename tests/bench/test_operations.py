"""The table of operations names every group, and the states of the bench lie on theirs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from bench import made, operations
from bench.algebra import algebra
from bench.hand_count import BY_HAND, total
from bench.subject import ANGLES, AXES, MEASURED, states, vehicle
from derive.lie.catalogue import GROUPS


def test_every_group_is_counted(tmp_path: Path) -> None:
    figures = {one.name: one for one in operations.measure(tmp_path)}
    assert all(f"{name} tracking, log, full" in figures for name in GROUPS)
    # Vectors: 3 n differences and products for nu_e, s, wanted and the inertia; no bracket.
    assert figures["R3 tracking, log, diagonal"].value == 9 * 3
    assert figures["R3 tracking, log, full"].value == 9 * 3 + 2 * 6
    for group, more in (("SE2", 20), ("SE3", 120)):
        n = made.group(group).dim
        fuller, bare = (figures[f"{group} tracking, log, {one}"] for one in ("full", "diagonal"))
        assert fuller.value > bare.value > 30 * n
        # I nu and I wanted: one product and one sum for each entry off the diagonal; on SE2
        # nobody asks for the angular momentum, the first row of I nu.
        assert fuller.value - bare.value == more
        assert f"dim {n}, " in fuller.aside


@pytest.mark.parametrize("group", BY_HAND)
def test_the_emitted_tracking_costs_hardly_more_than_by_hand(group: str, tmp_path: Path) -> None:
    """Nor less than a count by hand could overlook: the terms stand for the same task."""
    figures = {one.name: one for one in operations.measure(tmp_path)}
    ratio = figures[f"{group} tracking, over a count by hand"]
    assert 1 <= ratio.value <= 1.1
    assert ratio.limit is not None
    assert ratio.is_within
    assert figures[f"{group} tracking, log, full"].value == pytest.approx(
        ratio.value * total(group)
    )


def test_the_count_by_hand_adds_up() -> None:
    """Matrix products and cross products in the table, against their own formulas."""
    by_name = {term.what: term for term in BY_HAND["SE3"]}
    assert by_name["R_e = R_r' R"].operations == 9 * (3 + 2)
    assert by_name["I nu"].operations == 6 * (6 + 5)
    assert by_name["v x p and v x (v x p)"].operations == 2 * 9
    assert total("SE3") == sum(term.operations for term in BY_HAND["SE3"])


@pytest.mark.parametrize("name", MEASURED)
def test_measured_states_are_on_the_group(name: str) -> None:
    space = algebra(vehicle(name).group)
    rows = list(states(vehicle(name).group))
    assert len(rows) == len(ANGLES) * len(AXES)
    for row in rows:
        for g in (row["g"], row["g_r"]):
            assert space.off(space.embed(g)) < 1e-14
        assert [row[one].shape for one in ("nu", "nu_r", "nu_r_dot")] == [(space.dim,)] * 3
        assert np.isfinite(row["g"]).all()
