"""One closed loop: the emitted controller and plant between hand-written motion and judgement.

g, g_r and the momentum h of the wheels are integrated beside nu as plain differential
equations, with nothing put back on the group. What is judged is computed from the states alone.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np

from bench import made
from bench.algebra import Algebra, Array, algebra, log
from bench.motion import ROWS, Case, start

SECONDS = 8.0
RATE_GAIN, REACH_GAIN = (float(value) for _, value in made.GAINS)
TOLERANCE = 1e-13  # of a step, relative: W has fallen to 1e-7 of its start after 8 s
JUDGED = 40  # accepted steps at which W is compared, at most


@dataclass(frozen=True)
class Found:
    """What a flight shows, the worst over its rows and steps.

    energy: |W/(W(0) exp(-2 k_s t)) - 1|; turn: largest of an error, rad, on S3 half its angle;
    drift: of g and g_r from the group; plant: error of the emitted acceleration, relative;
    fallen: the largest W(8 s)/W(0); statuses: of `control` where judged
    """

    energy: float
    turn: float
    drift: float
    plant: float
    fallen: float
    statuses: frozenset[int]


class Flight:
    """A case with the module that was emitted for it, in closed loop."""

    def __init__(self, case: Case, module: ModuleType, seed: int = 0) -> None:
        self.case, self.module = case, module
        self.space, self.start = algebra(case.group), start(case, seed)
        rows, columns = np.triu_indices(self.space.dim)
        self.params = module.Params(self.start.inertia[:, rows, columns], RATE_GAIN, REACH_GAIN)

    def split(self, y: Array) -> list[Array]:
        """g, nu, g_r and h of a state vector, (rows, …) each."""
        k, n = len(self.space.kept), self.space.dim
        return np.split(y.reshape(ROWS, -1), np.cumsum([k, n, k]), axis=-1)

    def extras(self, t: float, momentum: Array) -> dict[str, Array]:
        """The optional inputs that the case asks for."""
        known = {"external": self.start.external.at(t), "momentum": momentum}
        return {name: known[name] for name in self.case.options}

    def command(self, t: float, y: Array, routine: str) -> Any:
        """What the emitted controller says: `tracking`, the bare law, or `control`."""
        g, nu, g_r, momentum = self.split(y)
        shape = (ROWS, *self.space.shape)
        return getattr(self.module, routine)(
            g=g.reshape(shape),
            nu=nu,
            g_r=g_r.reshape(shape),
            nu_r=self.start.reference.at(t),
            nu_r_dot=self.start.reference.rate(t),
            params=self.params,
            **self.extras(t, momentum),
        )

    def acceleration(self, t: float, y: Array, force: Array) -> Array:
        """What the emitted plant says, (rows, n)."""
        _, nu, _, momentum = self.split(y)
        extras = self.extras(t, momentum)
        return np.asarray(self.module.plant(nu=nu, force=force, params=self.params, **extras))

    def rates(self, t: float, y: Array) -> Array:
        """Of the whole state vector; what turns the body turns the wheels back, h' = -force."""
        g, nu, g_r, _ = self.split(y)
        force = self.command(t, y, "tracking").force
        reference = self.space.flow(g_r, self.start.reference.at(t))
        nu_dot = self.acceleration(t, y, force)
        return np.hstack([self.space.flow(g, nu), nu_dot, reference, -force]).ravel()

    def error(self, y: Array) -> Array:
        """g_r^-1 g as matrices, (rows, m, m)."""
        g, _, g_r, _ = self.split(y)
        return np.asarray(np.linalg.solve(self.space.embed(g_r), self.space.embed(g)), np.float64)

    def energy(self, t: float, y: Array) -> Array:
        """W of every row by its definition: s = nu - Ad(g_e^-1) nu_r + lambda nu_u(g_e)."""
        g_e, nu = self.error(y), self.split(y)[1]
        nu_u = LAWS[self.case.law](self.space, g_e)
        s = nu - self.space.pull(g_e, self.start.reference.at(t)) + RATE_GAIN * nu_u
        return np.asarray(np.einsum("ri,rij,rj->r", s, self.start.inertia, s) / 2)

    def turn(self, y: Array) -> float:
        """Largest argument of an eigenvalue of an error, rad: pi at the cut of every law."""
        return float(np.abs(np.angle(np.linalg.eigvals(self.error(y)))).max())

    def plant_error(self, t: float, y: Array, force: Array) -> float:
        """Of the emitted acceleration against I^-1 (ad*_nu (I nu + h) + external + force)."""
        _, nu, _, momentum = self.split(y)
        extras = self.extras(t, momentum)
        whole = np.einsum("rij,rj->ri", self.start.inertia, nu) + extras.get("momentum", 0.0)
        total = self.space.coad(nu, whole) + force + extras.get("external", 0.0)
        wanted = np.linalg.solve(self.start.inertia, total[..., None])[..., 0]
        off = np.linalg.norm(self.acceleration(t, y, force) - wanted, axis=-1)
        return float((off / np.linalg.norm(wanted, axis=-1)).max())

    def flown(self) -> tuple[Array, Array]:
        """Times of all accepted steps, (steps,), and their states; ArithmeticError if it fails."""
        first = self.start
        y = np.hstack([first.g, first.nu, first.g_r, first.momentum]).ravel()
        accuracy = {"rtol": TOLERANCE, "atol": TOLERANCE / 10}
        solved = _integrator()(self.rates, (0.0, SECONDS), y, method="DOP853", **accuracy)
        if not solved.success:
            raise ArithmeticError(f"{self.case.name}: {solved.message}")
        return solved.t, solved.y.T

    def run(self) -> Found:
        """Integrate and judge."""
        times, states = self.flown()
        matrices = [self.space.embed(self.split(y)[i]) for y in states for i in (0, 2)]
        few = np.unique(np.linspace(0, len(times) - 1, JUDGED).astype(int))
        judged = list(zip(times[few], states[few], strict=True))
        energy = np.array([self.energy(t, y) for t, y in judged])
        decay, wanted = energy / energy[0], np.exp(-2 * REACH_GAIN * times[few])
        commands = [self.command(t, y, "control") for t, y in judged]
        rows = [(t, y, one.force) for (t, y), one in zip(judged, commands, strict=True)]
        return Found(
            energy=float(np.abs(decay / wanted[:, None] - 1).max()),
            turn=max(self.turn(y) for y in states),
            drift=float(self.space.off(np.array(matrices)).max()),
            plant=max(self.plant_error(*row) for row in rows),
            fallen=float(decay[-1].max()),
            statuses=frozenset(int(status) for one in commands for status in one.status),
        )


def _log(space: Algebra, g: Array) -> Array:
    return space.vee(log(g))


def _skew(space: Algebra, g: Array) -> Array:
    return space.vee(g - np.linalg.inv(g)) / 2


def _cayley(space: Algebra, g: Array) -> Array:
    unit = np.eye(g.shape[-1])
    return 2 * space.vee((g - unit) @ np.linalg.inv(g + unit))


LAWS: dict[str, Callable[[Algebra, Array], Array]] = {
    "log": _log,
    "skew": _skew,
    "cayley": _cayley,
}
"""nu_u of matrices (rows, m, m), (rows, n), by matrix functions."""


def _integrator() -> Callable[..., Any]:
    try:
        from scipy.integrate import solve_ivp
    except ImportError as missing:
        raise SystemExit(
            "the closed loop needs scipy, which is one of the test tools: pip install -e '.[test]'"
        ) from missing
    found: Callable[..., Any] = solve_ivp
    return found
