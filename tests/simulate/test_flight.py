"""Closed loops of the simulator against plain differential equations, on every group."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

import numpy as np
import pytest

from bench import made
from bench.algebra import Array, algebra, exp
from derive import flight
from derive.simulate.craft import Craft
from derive.simulate.flight import Flight, recorded
from derive.simulate.loop import Body, Loop
from derive.simulate.pace import longest
from derive.simulate.pilot import Command, Pilot
from derive.simulate.reading import settled_instant
from derive.simulate.reference import Reference, rest, slew, steady, tabled
from derive.simulate.runs import Runs, Setting
from tests.simulate.plain import Plain, craft, runs

BOTH = ("momentum", "external")

Case = tuple[str, str, tuple[str, ...], str]
CASES: list[Case] = [
    ("SO2", "log", (), "slew"),
    ("SO3", "log", (), "steady"),
    ("S3", "log", BOTH, "table"),
    ("SE2", "log", ("external",), "slew"),
    ("SE3", "log", ("momentum",), "steady"),
    ("SE23", "log", (), "slew"),
    ("R3", "log", (), "table"),
    ("SO3 x R3", "log", BOTH, "steady"),
    ("SL2", "skew", (), "slew"),
    ("Heisenberg", "log", (), "table"),
]
each_case = pytest.mark.parametrize("case", CASES, ids=[case[0] for case in CASES])


def reference(kind: str, group: str) -> Reference:
    space = algebra(group)
    random = np.random.default_rng(3)
    n = space.dim
    start = space.store(exp(space.hat(0.4 * random.normal(size=n))))[:, None]
    along = 0.5 * random.normal(size=(n, 1))
    if kind == "steady":
        return steady(start, along)
    if kind == "slew":
        return slew(start, along, 1.5)
    # Rows at whole steps: between two of them it is smooth.
    times = np.array([0.0, 0.5, 1.0, 3.0])
    return tabled(start, times, *(0.5 * random.normal(size=(2, 4, n))))


def setting(rate: float | None = None, step: float = 0.025, **more: Any) -> Setting:
    """Two seconds."""
    return replace(Setting(2.0, rate, step, hertz=0.7), **more)


def end(loop: Loop) -> Body:
    *_, last = loop.moments()
    return last.body


def apart(found: Body, i: int, wanted: Sequence[Array]) -> float:
    """Largest difference of any part of the i-th loop; relative where numbers are large."""
    parts = [one[..., i if one.shape[-1] > 1 else 0] for one in found]
    pairs = zip(parts, wanted, strict=True)
    return max(float(np.abs(a - b).max() / max(1.0, np.abs(b).max())) for a, b in pairs)


@each_case
def test_a_continuous_loop_is_that_of_the_differential_equation(case: Case) -> None:
    one, motion = craft(*case[:3]), reference(case[3], case[0])
    met, asked = runs(one), setting(step=longest(one, None, brief=motion.brief))
    found = end(Loop(one, "numpy", motion, asked, met))
    assert apart(found, 0, Plain(one, motion, asked, met).flown()) < 1e-9


@each_case
def test_a_sampled_loop_is_that_of_a_held_force(case: Case) -> None:
    one, motion = craft(*case[:3]), reference(case[3], case[0])
    met, asked = runs(one), setting(rate=20.0, step=0.005)
    found = end(Loop(one, "numpy", motion, asked, met))
    assert apart(found, 0, Plain(one, motion, asked, met).flown()) < 1e-9


def test_the_step_that_a_user_gets_is_short_enough() -> None:
    one, motion = craft("SO3"), reference("steady", "SO3")
    for rate in (None, 20.0):
        met, asked = runs(one), setting(rate, longest(one, rate))
        found = end(Loop(one, "numpy", motion, asked, met))
        assert apart(found, 0, Plain(one, motion, asked, met).flown()) < 1e-9


@pytest.mark.parametrize("rate", [None, 20.0])
def test_halving_the_step_gains_the_order_of_the_method(rate: float | None) -> None:
    """In the chart of every step, on a group that is curved, with everything acting."""
    one, motion = craft("SO3 x R3", options=BOTH), reference("steady", "SO3 x R3")
    met = runs(one)
    ends = [end(Loop(one, "numpy", motion, setting(rate, step), met)) for step in
            ((0.05, 0.025, 0.005) if rate else (0.2, 0.1, 0.02))]  # fmt: skip
    coarse, fine = (apart(one, 0, [part[..., 0] for part in ends[2]]) for one in ends[:2])
    order = 4 if rate else 6
    assert 2 ** (order - 0.6) < coarse / fine < 2 ** (order + 1.4)


@pytest.mark.parametrize("rate", [None, 20.0])
def test_the_actuators_give_no_more_than_they_can(rate: float | None) -> None:
    one, motion = craft("SE2"), reference("steady", "SE2")
    limit = (0.9, 0.1, 20.0)
    met, asked = runs(one), setting(rate, 0.0125, force_limit=limit)
    (flight,) = recorded(Loop(one, "numpy", motion, asked, met).moments())
    assert (np.abs(flight.force) <= limit).all()
    cut = np.abs(flight.asked) > limit
    assert cut[0].tolist() == [True, True, False]
    assert not cut[-1, 0]
    np.testing.assert_array_equal(flight.force[~cut], flight.asked[~cut])
    (*_, wanted) = Plain(one, motion, asked, met).flown()
    # Where it leaves the limit the rates have a corner, and every method its first order.
    assert flight.energy[-1] ** 2 == pytest.approx(wanted[0], rel=1e-5 if rate is None else 1e-9)


def flights(name: str, backend: str, met: Runs, asked: Setting, **more: Any) -> list[Flight]:
    one = craft(name, **more)
    return recorded(Loop(one, backend, reference("slew", name), asked, met).moments())


def same(a: Flight, b: Flight) -> bool:
    """Bit for bit."""
    return all(getattr(a, one.name).tobytes() == getattr(b, one.name).tobytes()
               for one in fields(Flight))  # fmt: skip


NOISY: dict[str, Any] = {"noise_g": 1e-3, "noise_nu": 2e-3}


@pytest.mark.parametrize("name", ["SO3", "SE2", "SL2"])
@pytest.mark.parametrize("rate", [None, 20.0])
def test_c_in_double_flies_as_numpy_does_bit_for_bit(name: str, rate: float | None) -> None:
    law = "skew" if name == "SL2" else "log"
    met, asked = (
        runs(craft(name, law), 3),
        setting(rate, 0.05, seconds=0.5, **(NOISY if rate else {})),
    )
    pairs = zip(*(flights(name, backend, met, asked, law=law) for backend in ("numpy", "f64")),
                strict=True)  # fmt: skip
    assert all(same(*pair) for pair in pairs)


@pytest.mark.parametrize("name", ["SO3", "SE2"])
def test_single_precision_stays_near(name: str) -> None:
    met, asked = runs(craft(name)), setting(20.0, 0.05)
    (double,), (single,) = (flights(name, one, met, asked) for one in ("f64", "f32"))
    assert 0 < np.abs(double.g - single.g).max() < 1e-4
    assert 0 < np.abs(double.nu - single.nu).max() < 1e-4


@pytest.mark.parametrize("backend", ["numpy", "f64", "f32"])
@pytest.mark.parametrize("rate", [None, 20.0])
def test_loops_fly_alone_as_in_company(backend: str, rate: float | None) -> None:
    met, asked = runs(craft("SE2"), 4), setting(rate, 0.05, seconds=0.5, **(NOISY if rate else {}))
    together = flights("SE2", backend, met, asked)
    for i in range(4):
        (alone,) = flights("SE2", backend, only(met, i), asked)
        assert same(alone, together[i])


def only(met: Runs, i: int) -> Runs:
    """The i-th run alone."""
    parts = {
        one.name: getattr(met, one.name)[:, [i]] for one in fields(Runs) if one.name != "seeds"
    }
    return Runs(**parts, seeds=(met.seeds[i],))


def test_noise_is_of_the_seed() -> None:
    one = craft("SO3")
    met, asked = replace(only(runs(one, 2), 0), seeds=(4,)), setting(20.0, **NOISY)
    first, again, other = (
        flights("SO3", "f64", replace(met, seeds=(seed,)), asked)[0] for seed in (4, 4, 5)
    )
    assert same(first, again)
    assert np.abs(first.asked[0] - other.asked[0]).max() > 1e-5
    clean = flights("SO3", "f64", met, setting(20.0))[0]
    assert 1e-5 < np.abs(first.g - clean.g).max() < 0.1


def test_what_is_measured_is_off_by_normal_numbers_of_that_spread() -> None:
    """On R3 the configuration is its own coordinates: seen - true is the noise itself."""
    one, loops, asked = craft("R3"), 100, setting(80.0, noise_g=1e-2, noise_nu=3e-2)
    met = replace(runs(one, loops), seeds=tuple(range(loops)))
    seen = Seen(one, reference("steady", "R3"), asked, met)
    for _ in seen.moments():
        pass
    for off, spread in ((seen.off_g, 1e-2), (seen.off_nu, 3e-2)):
        drawn = np.array(off)  # (instants, n, loops)
        count = drawn.size
        assert count == 161 * 3 * loops
        assert abs(drawn.mean()) < 5 * spread / np.sqrt(count)
        assert drawn.std() == pytest.approx(spread, rel=5 / np.sqrt(2 * count))
        # Neither repeated over time, nor from loop to loop, nor from entry to entry.
        for a, b in ((drawn[1:], drawn[:-1]), (drawn[..., 1:], drawn[..., :-1]),
                     (drawn[:, 1:], drawn[:, :-1])):  # fmt: skip
            assert abs(np.corrcoef(a.ravel(), b.ravel())[0, 1]) < 5 / np.sqrt(a.size)
    pair = np.corrcoef(np.ravel(seen.off_g), np.ravel(seen.off_nu))
    assert abs(pair[0, 1]) < 5 / np.sqrt(np.size(seen.off_g))


class Seen(Loop):
    """A loop that keeps what its controller was shown, less what was true."""

    def __init__(self, one: Craft, motion: Reference, asked: Setting, met: Runs) -> None:
        super().__init__(one, "numpy", motion, asked, met)
        self.off_g: list[Array] = []
        self.off_nu: list[Array] = []
        self.pilot = Pilot("numpy", self._seen(self.pilot.run))

    def _seen(self, run: Any) -> Any:
        def seen(given: Mapping[str, Array]) -> Command:
            self.off_g.append(given["g"] - self.now.g)
            self.off_nu.append(given["nu"] - self.now.nu)
            return run(given)  # type: ignore[no-any-return]

        return seen

    def command(self, t: float, body: Body, instant: int | None = None) -> Command:
        self.now = body
        return super().command(t, body, instant)


@pytest.mark.parametrize("name", ["SO3", "SE2"])
def test_reaching_flies_to_rest_at_the_identity(name: str) -> None:
    vehicle = replace(made.vehicle(name), controller="reaching")
    one = flight.craft(vehicle, None)
    space = algebra(name)
    e = space.store(np.eye(space.basis.shape[-1]))[:, None]
    met, asked = runs(craft(name), met=False), Setting(30.0, 10.0, 0.1)
    (flown,) = recorded(Loop(one, "f64", rest(e, space.dim), asked, met).moments())
    assert np.abs(flown.g[0] - e[:, 0]).max() > 0.1
    assert np.abs(flown.g[-1] - e[:, 0]).max() < 1e-5
    assert np.abs(flown.nu[-1]).max() < 1e-5


def test_what_is_recorded_is_every_instant() -> None:
    asked = setting(20.0)
    told: list[float] = []
    loop = Loop(craft("SO3"), "numpy", reference("slew", "SO3"), asked, runs(craft("SO3")))
    (flown,) = recorded(loop.moments(), told.append)
    np.testing.assert_allclose(flown.t, np.arange(41) / 20, rtol=1e-15)
    assert told == flown.t.tolist()
    g_e = np.linalg.inv(flown.g_r.reshape(-1, 3, 3)) @ flown.g.reshape(-1, 3, 3)
    np.testing.assert_allclose(flown.g_e.reshape(-1, 3, 3), g_e, atol=1e-12)
    np.testing.assert_allclose(flown.height, (3 - np.trace(g_e, axis1=1, axis2=2)) / 2, atol=1e-12)
    turned = np.einsum("tji,tj->ti", g_e, flown.nu_r)
    np.testing.assert_allclose(flown.nu_e, flown.nu - turned, atol=1e-12)
    np.testing.assert_allclose(flown.rate_error(), np.sqrt((flown.nu_e**2).sum(1)), rtol=1e-14)
    np.testing.assert_allclose(flown.effort(), np.sqrt((flown.force**2).sum(1)), rtol=1e-14)
    energy = np.sqrt(np.concatenate([[0], np.cumsum((flown.force[:-1] ** 2).sum(1) / 20)]))
    np.testing.assert_allclose(flown.energy, energy, rtol=1e-12)


@pytest.mark.parametrize(
    ("values", "found"),
    [
        ([1.0, 0.5, 0.1, 0.1], 2.0),
        ([0.1, 0.1, 0.0, 0.0], 0.0),
        ([0.0, 1.0, 0.0, 0.0], 2.0),
        ([0.0, 0.0, 0.0, 1.0], None),
        ([0.0, np.nan, 0.0, 0.0], 2.0),
        ([0.0, 0.0, 0.0, np.nan], None),
    ],
)
def test_settled_is_for_good(values: list[float], found: float | None) -> None:
    assert settled_instant(np.arange(4.0), np.array(values), 0.1) == found
