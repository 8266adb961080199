"""What is watched in a run holds where all is well, breaks where not, and says when it is mute."""

from __future__ import annotations

import copy
import math
import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from bench import made
from bench.algebra import algebra, exp
from derive import flight
from derive.simulate.craft import Craft
from derive.simulate.flight import Flight, recorded
from derive.simulate.invariant import Watched, crossings, invariants, symmetric
from derive.simulate.invariant import watched as together
from derive.simulate.loop import Loop
from derive.simulate.reference import Reference, rest, slew, steady
from derive.simulate.runs import Runs, Setting
from tests.simulate.plain import craft, runs, square

DECAY, GROUP, ENERGY = 0, 1, 2
TURNING = np.array([[0.4], [-0.3], [0.5]])


def motion(group: str) -> Reference:
    space = algebra(group)
    e = space.store(np.eye(space.basis.shape[-1]))[:, None]
    return slew(e, np.resize(TURNING, (space.dim, 1)), 3.0)


def flown(
    one: Craft, met: Runs, backend: str = "numpy", follow: Reference | None = None, **more: Any
) -> tuple[Loop, Flight]:
    """Three seconds of one loop."""
    asked = replace(Setting(3.0), **more)
    loop = Loop(one, backend, follow or motion(one.group), asked, met)
    (found,) = recorded(loop.moments())
    return loop, found


def watched(*given: Any, **more: Any) -> Watched:
    return invariants(*flown(*given, **more))


@pytest.mark.parametrize("name", ["SO3", "S3", "SE2", "SE3", "R3"])
def test_all_hold_in_a_good_run(name: str) -> None:
    one = craft(name)
    found = watched(one, runs(one, met=False), longest=0.025, seconds=1.5)
    assert [it.verdict for it in found] == ["holds"] * 4
    assert all(it.ok and not it.why and it.measured <= it.limit / 10 for it in found)


def test_the_energy_of_the_error_is_measured_against_its_promise() -> None:
    """W of the flight itself, by numpy: it must fall by e^(-2 k_s t), k_s = 1."""
    one = craft("SO3")
    loop, found = flown(one, runs(one, met=False))
    W = [s @ square(np.array(one.inertia)) @ s / 2 for s in found.s]
    off = max(abs(w / W[0] * math.exp(2 * t) - 1) for w, t in zip(W, found.t, strict=True))
    assert invariants(loop, found)[DECAY].measured == pytest.approx(off, rel=1e-3, abs=1e-13)


def bent(one: Craft, pattern: str, by: str) -> Craft:
    """The craft with its numpy law changed."""
    files = dict(one.files)
    path = f"numpy/{one.name}.py"
    head, mark, law = files[path].partition("def _law(")
    wrong, count = re.subn(pattern, by, law, count=1, flags=re.DOTALL)
    assert count
    return replace(one, files=tuple(sorted({**files, path: head + mark + wrong}.items())))


def test_a_wrong_sign_in_the_law_breaks_the_decay() -> None:
    one = craft("SO3")
    for wrong in (
        bent(one, r"(# eta_dot: .*?)\bnu_e_0\b", r"\1(-nu_e_0)"),
        bent(one, r"(# wanted: .*?)\bnu_u_dot_1\b", r"\1(-nu_u_dot_1)"),
    ):
        found = watched(wrong, runs(one, met=False))
        assert [it.verdict for it in found] == ["BROKEN", "holds", "holds", "holds"]
        assert not found[DECAY].ok
        assert found[DECAY].measured > 1e3 * found[DECAY].limit


class Mutant(Loop):
    """A loop whose plant is not the one it should be."""

    def __init__(self, *given: Any, bend: Callable[..., Any]) -> None:
        super().__init__(*given)
        self.space = copy.copy(self.space)
        right = self.space.acceleration
        self.space.acceleration = lambda *a, **k: bend(right, *a, **k)  # type: ignore[method-assign]


def bent_plant(bend: Callable[..., Any]) -> Watched:
    one = craft("SO3")
    loop = Mutant(one, "numpy", motion("SO3"), Setting(3.0), runs(one, met=False), bend=bend)
    (found,) = recorded(loop.moments())
    return invariants(loop, found)


def test_a_plant_whose_force_is_scaled_breaks_the_decay() -> None:
    found = bent_plant(lambda right, i, nu, force, **k: right(i, nu, 1.001 * force, **k))
    assert [it.verdict for it in found] == ["BROKEN", "holds", "holds", "holds"]


def test_a_plant_with_drag_breaks_its_energy() -> None:
    found = bent_plant(lambda right, i, nu, force, **k: right(i, nu, force, **k) - 1e-7 * nu)
    assert found[ENERGY].verdict == "BROKEN"
    assert found[ENERGY].measured == pytest.approx(6e-7, rel=0.01)  # 2 x 1e-7 x 3 s


def test_a_step_that_is_far_too_long_breaks_the_decay() -> None:
    """Between instants that are 1 s apart the law moves far, which is no crossing of the cut."""
    one = craft("SO3")
    met = replace(runs(one, met=False), nu=np.array([[3.0], [-1.0], [2.0]]))
    assert watched(one, met, longest=1.0)[DECAY].verdict == "BROKEN"
    assert watched(one, met, longest=0.02)[DECAY].verdict == "holds"


@pytest.mark.parametrize("rate", [None, 1.0])
def test_a_step_that_is_far_too_long_breaks_the_energy(rate: float | None) -> None:
    one = craft("SO3")
    long = np.array([[1.0], [0.0], [0.0], [4.0], [0.0], [2.0]])
    met = replace(runs(one, met=False), nu=np.array([[3.0], [-1.0], [2.0]]), inertia=long)
    assert watched(one, met, rate=rate, longest=0.5)[ENERGY].verdict == "BROKEN"
    short = 0.004 if rate else 0.02
    assert watched(one, met, rate=rate, longest=short)[ENERGY].verdict == "holds"


def test_a_loop_that_is_lost_breaks_everything() -> None:
    met = replace(runs(craft("SO3"), met=False), nu=np.array([[1e9], [2e9], [0.0]]))
    found = watched(craft("SO3"), met)
    assert [it.verdict for it in found[1:]] == ["BROKEN"] * 3


def test_loops_that_fly_together_are_watched_apart() -> None:
    """The second one starts out of range, and is refused at once; the first one is not."""
    one = craft("SO3")
    alone = runs(one, met=False)
    fast = replace(alone, nu=np.array([[2e6], [0.0], [0.0]]))
    both = replace(alone, g=np.hstack([alone.g, fast.g]), nu=np.hstack([alone.nu, fast.nu]),
                   momentum=np.zeros((3, 2)), seeds=(0, 1))  # fmt: skip
    loop = Loop(one, "numpy", motion("SO3"), Setting(0.2, longest=0.025), both)
    first, second = together(loop, recorded(loop.moments()))
    assert [it.verdict for it in first] == ["holds"] * 4
    assert second[0].why == "the controller refused a state"
    assert (second[3].name, second[3].verdict) == ("no state is refused", "BROKEN")
    assert second[3].measured == 9
    single = flown(one, alone, seconds=0.2, longest=0.025)
    assert first == invariants(*single)


@pytest.mark.parametrize("which", ["g", "g_r"])
@pytest.mark.parametrize("name", ["SO3", "S3", "SE3", "SL2"])
def test_numbers_off_the_group_break_membership(name: str, which: str) -> None:
    one = craft(name, "skew" if name == "SL2" else "log")
    loop, found = flown(one, runs(one, met=False), seconds=0.2)
    assert invariants(loop, found)[GROUP].verdict == "holds"
    pushed = getattr(found, which).copy()
    pushed[-1, 0] += 1e-7
    pushed[-1] *= 1 + 1e-7
    assert invariants(loop, replace(found, **{which: pushed}))[GROUP].verdict == "BROKEN"
    lost = getattr(found, which) * np.nan
    assert not invariants(loop, replace(found, **{which: lost}))[GROUP].ok


def test_numbers_that_are_none_break_what_is_watched() -> None:
    one = craft("SO3")
    loop, found = flown(one, runs(one, met=False), seconds=0.2)
    lost = replace(found, s=found.s * np.nan)
    assert invariants(loop, lost)[DECAY].verdict == "BROKEN"


def test_far_away_the_group_is_judged_by_the_size_of_the_numbers() -> None:
    """A position of 3e5 m holds no more than 1e-10 m; that is no drift."""
    one = craft("SE3")
    space = algebra("SE3")
    far = np.eye(4)
    far[:3, 3] = (1e5, -2e5, 3e5)
    met = runs(one, met=False)
    moved = space.store(far @ space.embed(met.g[:, 0]))[:, None]
    follow = steady(space.store(far)[:, None], np.resize(TURNING, (6, 1)))
    found = watched(one, replace(met, g=moved), follow=follow, seconds=0.5)
    assert found[GROUP].verdict == "holds"


def reaching() -> Craft:
    return flight.craft(
        replace(made.vehicle("SO3"), controller="pd_plus", law="lee", gains=PD), None
    )


PD = tuple((name, value) for (_, value), name in zip(made.GAINS, ("k_R", "k_Omega"), strict=True))

PUSH = np.array([[0.1], [0.0], [0.0]])

REASONS: dict[str, dict[str, Any]] = {
    "the controller is sampled": {"rate": 20.0},
    "single precision moves s by more than the limit": {"backend": "f32"},
    "measurements are noisy": {"noise_nu": 1e-3},
    "the actuators saturate": {"force_limit": (0.1, 5.0, 5.0)},
}
"""Why the decay is not judged -> how it is flown."""

MET: dict[str, dict[str, Any]] = {
    "a disturbance acts": {"disturbance": PUSH},
    "the inertia is in error": {"inertia": 1.1 * np.array(craft("SO3").inertia)[:, None]},
    "the controller refused a state": {"nu": np.array([[1e9], [0.0], [0.0]])},
}
"""Why -> what the run meets."""


def why(met: Runs | None = None, **more: Any) -> str:
    met = met or runs(craft("SO3"), met=False)
    return watched(craft("SO3"), met, seconds=0.3, **more)[DECAY].why


@pytest.mark.parametrize("reason", REASONS)
def test_the_decay_is_not_judged_as_it_is_flown(reason: str) -> None:
    assert why(**REASONS[reason]) == reason


@pytest.mark.parametrize("reason", MET)
def test_the_decay_is_not_judged_for_what_is_met(reason: str) -> None:
    assert why(met=replace(runs(craft("SO3"), met=False), **MET[reason])) == reason


@pytest.mark.parametrize("part", ["sine", "cosine"])
def test_a_wave_is_a_disturbance_too(part: str) -> None:
    given: dict[str, Any] = {part: PUSH}
    met = replace(runs(craft("SO3"), met=False), **given)
    assert why(met=met) == "a disturbance acts"


def test_the_decay_is_not_judged_of_another_controller() -> None:
    one = reaching()
    found = watched(one, runs(craft("SO3"), met=False), seconds=0.3)
    assert found[DECAY].why == "pd_plus has no such law"
    assert found[DECAY].verdict == "not applicable: pd_plus has no such law"
    assert found[DECAY].ok


def test_the_decay_is_not_judged_across_the_cut() -> None:
    space = algebra("SO3")
    g = space.store(exp(space.hat(np.array([3.1, 0.0, 0.0]))))[:, None]
    met = replace(runs(craft("SO3"), met=False), g=g, nu=np.array([[4.0], [0.0], [0.0]]))
    assert why(met=met) == "the error crosses the cut locus"
    loop, found = flown(craft("SO3"), met, seconds=0.3)
    assert crossings(found, loop.space.turns, loop.setting.period) == 1


def test_the_decay_is_not_judged_from_nothing() -> None:
    e = np.eye(3).reshape(9, 1)
    still = np.zeros((3, 1))
    met = replace(runs(craft("SO3"), met=False), g=e, nu=still)
    found = watched(craft("SO3"), met, follow=rest(e, 3))
    assert found[DECAY].why == "s starts at zero"
    assert found[ENERGY].why == "it starts at rest"
    assert all(it.ok for it in found)


def test_the_decay_is_judged_beside_a_reference_that_moves() -> None:
    e = np.eye(3).reshape(9, 1)
    found = watched(craft("SO3"), runs(craft("SO3"), met=False), follow=steady(e, TURNING))
    assert found[DECAY].verdict == "holds"


def test_an_upper_triangle_is_made_whole() -> None:
    for n in range(1, 25):
        upper = np.random.default_rng(n).normal(size=n * (n + 1) // 2)
        np.testing.assert_array_equal(symmetric(upper.tolist()), square(upper))
