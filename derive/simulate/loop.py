"""The closed loop: N plants on their group, each with the emitted controller, step by step."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import NamedTuple

import numpy as np

from derive.simulate.craft import Craft
from derive.simulate.held import Held
from derive.simulate.method import BUTCHER, KUTTA, Method, State, step
from derive.simulate.pilot import Command, pilot
from derive.simulate.reference import Reference
from derive.simulate.runs import Noise, Runs, Setting
from derive.simulate.space import Array, space_of


class Body(NamedTuple):
    """The whole state: g, nu, g_r (k, 1), momentum of the wheels, integral of force^2."""

    g: Array
    nu: Array
    g_r: Array
    momentum: Array
    effort: Array


@dataclass(frozen=True)
class Moment:
    """One instant of all loops: columns (size, N) or (N,).

    command is the controller's, force what the actuators give; g_e, nu_e and height are true
    errors, whatever was measured, g_e that which is driven to the identity; nu_r is (n, 1).
    """

    t: float
    body: Body
    nu_r: Array
    g_e: Array
    nu_e: Array
    height: Array
    command: Command
    force: Array


class Loop:
    """A craft, one backend of its controller, a reference, a setting and the runs in it."""

    def __init__(
        self, craft: Craft, backend: str, reference: Reference, setting: Setting, runs: Runs
    ) -> None:
        """Raises CompilerMissing, CompileError where the backend is C and cannot be built."""
        self.space, self.craft = space_of(craft, backend != "numpy"), craft
        self.pilot = pilot(craft, backend, len(runs))
        self.reference, self.setting, self.runs = reference, setting, runs
        # Where C can be compiled, a held force is integrated by it: the same bits, sooner.
        self._held = Held(craft, runs) if setting.rate and backend != "numpy" else None
        self._noise = Noise(runs.seeds, self.space.dim) if setting.is_noisy else None
        bound = setting.force_limit
        self._bound = None if bound is None else np.array(bound)[:, None]

    def moments(self) -> Iterator[Moment]:
        """Every instant at which the controller is called, the first and the last included."""
        setting, body = self.setting, self._first()
        period = setting.period
        for instant in range(setting.periods + 1):
            t = instant * period
            command = self.command(t, body, instant)
            force = self.limited(command.force)
            yield self._moment(t, body, command, force)
            if instant < setting.periods:
                body = self._sampled(t, body, force) if setting.rate else self._smooth(t, body)

    def coasted(self) -> Iterator[Body]:
        """The same plants from the same states with no force at all, instant by instant."""
        body, period, parts = self._first(), self.setting.period, self.setting.parts
        free = np.zeros_like(body.nu)
        still = replace(self.runs, disturbance=free, sine=free, cosine=free, external=free)
        method = KUTTA if self.setting.rate else BUTCHER
        held = Held(self.craft, still) if self._held else None
        yield body
        for instant in range(self.setting.periods):
            for part in range(parts):
                h = period / parts
                t = instant * period + part * h
                if held:
                    body = self._pushed(held, t, h, body, free)
                else:
                    body = self._moved(method, t, h, body, lambda _, __: free, still)
            yield body

    def command(self, t: float, body: Body, instant: int | None = None) -> Command:
        """What the controller says of a state, measured with the noise of that instant."""
        g, nu = body.g, body.nu
        if self._noise is not None and instant is not None:
            drawn, n = self._noise.at(instant), self.space.dim
            g = self.space.advance(g, self.setting.noise_g * drawn[:n])
            nu = nu + self.setting.noise_nu * drawn[n:]
        nu_r, nu_r_dot = self.reference.at(t)
        given: dict[str, Array] = {"g": g, "nu": nu, **self._extras(body.momentum, self.runs)}
        if self.craft.has_reference:
            given |= {"g_r": body.g_r, "nu_r": nu_r, "nu_r_dot": nu_r_dot}
        return self.pilot.run(given)

    def limited(self, force: Array) -> Array:
        """What the actuators give of it."""
        return force if self._bound is None else np.clip(force, -self._bound, self._bound)

    def _first(self) -> Body:
        runs, loops = self.runs, len(self.runs)
        wide = [
            np.repeat(one, loops // one.shape[1], 1) for one in (runs.g, runs.nu, runs.momentum)
        ]
        return Body(wide[0], wide[1], self.reference.start, wide[2], np.zeros(loops))

    def _moment(self, t: float, body: Body, command: Command, force: Array) -> Moment:
        nu_r = self.reference.at(t)[0]
        apart = self._held or self.space
        side = command.side
        g = body.g if side is None else np.where(side < 0, -body.g, body.g)
        g_e, nu_e, height = apart.deviation(g, body.nu, body.g_r, nu_r)
        return Moment(t, body, nu_r, g_e, nu_e, height, command, force)

    def _sampled(self, t: float, body: Body, force: Array) -> Body:
        """One period with the force held: the plant alone is integrated."""
        parts = self.setting.parts
        h = self.setting.period / parts
        for part in range(parts):
            start = t + part * h
            if self._held:
                body = self._pushed(self._held, start, h, body, force)
            else:
                body = self._moved(KUTTA, start, h, body, lambda _, __: force)
        return body

    def _pushed(self, held: Held, t: float, h: float, body: Body, force: Array) -> Body:
        """_moved with a held force, by `held`."""
        times = [t + node * h for node in KUTTA.nodes]
        turns = [_turn(self.setting.hertz, at) for at in times]
        state = (body.g, body.nu, body.momentum, body.effort)
        g, nu, momentum, effort = held.step(h, turns, state, force)
        g_r = held.follow(h, [self.reference.at(at)[0] for at in times], body.g_r)
        return Body(g, nu, g_r, momentum, effort)

    def _smooth(self, t: float, body: Body) -> Body:
        """One period with the controller called in every stage of every step."""
        parts = self.setting.parts
        h = self.setting.period / parts
        for part in range(parts):
            body = self._moved(BUTCHER, t + part * h, h, body, self._answer)
        return body

    def _answer(self, t: float, stage: Callable[[], Body]) -> Array:
        return self.limited(self.command(t, stage()).force)

    def _moved(
        self,
        method: Method,
        t: float,
        h: float,
        body: Body,
        answer: Callable[[float, Callable[[], Body]], Array],
        runs: Runs | None = None,
    ) -> Body:
        """One step in the charts g exp(hat(x)) and g_r exp(hat(x_r)) of its start."""
        met = runs or self.runs

        def rates(at: float, state: State) -> State:
            x, nu, x_r, momentum, _ = state
            force = answer(at, partial(self._lifted, body, state))
            nu_r, _ = self.reference.at(at)
            pushed = force + _disturbance(met, self.setting.hertz, at)
            moved = self.space.acceleration(met.inertia, nu, pushed, **self._extras(momentum, met))
            turned = self.space.chart_rate(x, nu), self.space.chart_rate(x_r, nu_r)
            return turned[0], moved, turned[1], -force, square(force)

        still = np.zeros_like(body.nu), body.nu, np.zeros((self.space.dim, 1))
        return self._lifted(body, step(method, rates, t, h, (*still, *body[3:])))

    def _lifted(self, body: Body, state: State) -> Body:
        """Back from the charts of `body` to the group."""
        x, nu, x_r, momentum, effort = state
        advance = self.space.advance
        return Body(advance(body.g, x), nu, advance(body.g_r, x_r), momentum, effort)

    def _extras(self, momentum: Array, runs: Runs) -> Mapping[str, Array]:
        known = {"momentum": momentum, "external": runs.external}
        return {name: known[name] for name in self.space.options}


def _disturbance(runs: Runs, hertz: float, t: float) -> Array:
    """The force that nobody told the controller of, (n, N)."""
    sine, cosine = _turn(hertz, t)
    return runs.disturbance + sine * runs.sine + cosine * runs.cosine


def _turn(hertz: float, t: float) -> tuple[float, float]:
    """Sine and cosine of the periodic force's phase."""
    turn = 2 * math.pi * hertz * t
    return math.sin(turn), math.cos(turn)


def square(x: Array) -> Array:
    """Sum of the squares of each column, (N,), in the order of its entries."""
    total: Array = x[0] * x[0]
    for entry in x[1:]:
        total = total + entry * entry
    return total
