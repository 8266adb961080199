"""The Definition of a kinematic law, decided for a group, a law and its Morse functions.

(i) and (ii) exactly, on the law's own steps at exact elements; (ii) on dense samples as well;
jumps, equilibria, (iii) and (iv) by oracles in plain numpy, which know the law by its values
alone. Every verdict is computed; claims of the records are compared with it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sympy import Matrix

from derive.control import morse, tangent
from derive.control.law import KinematicLaw
from derive.emit.function import compiled
from derive.lie.group import Group
from derive.verify.law import cut, exact, rest, slope
from derive.verify.law.cloud import cloud, span
from derive.verify.law.factor import claimed
from derive.verify.law.place import named, numbers, where
from derive.verify.law.space import Space
from derive.verify.law.verdict import Equilibria, Fall, Jump, Oddness, Verdict

Array = NDArray[Any]

CURVES, STARTS, SAMPLES = 12, 60, 400
ODD = 1e-8  # what is left of nu_u(g) + nu_u(g^-1), relative, over the distance from a cut
FLAT = 1e-7  # of y: beyond, V falls
AT_REST = 1e-6  # |nu_u| at an equilibrium
FITS = 1e-6  # a stated y, relative to 1 + |y|
AT_CUT = 1e-4  # clearance where a law jumps


def judge(group: Group, law: KinematicLaw, seed: int = 0) -> Verdict:
    """Decide the Definition for one law on one group."""
    return _Trial(group, law, seed).verdict()


@dataclass(frozen=True)
class _Trial:
    group: Group
    law: KinematicLaw
    seed: int

    @cached_property
    def space(self) -> Space:
        return Space(self.group)

    @cached_property
    def _steps(self) -> Any:
        return tangent.kinematics(self.group, self.law)

    @cached_property
    def _run(self) -> Callable[..., dict[str, Array]]:
        return compiled(self._steps)

    def nu_u(self, g: Array) -> Array:
        """Of matrices, in double, as printed."""
        return self._run(g=self.space.store(g))["nu_u"]

    def clearance(self, g: Array) -> Array:
        """Of matrices."""
        return self._run(g=self.space.store(g))["clearance"]

    def verdict(self) -> Verdict:
        """Everything, in the order of the Definition."""
        crossings = self._crossings
        jumps = self._jumps(crossings)
        falls = tuple(self._fall(name) for name in morse.heights_of(self.group))
        rests = self._rests()
        return Verdict(
            self.group.name, self.law.name, self.law.doc, self._is_zero_at_e(),
            self._oddness(jumps), jumps, rests, falls, self._unwinds(),
            tuple(self._contradictions(crossings, jumps, falls)),
        )  # fmt: skip

    def _exactly(self, g: Matrix) -> dict[str, list[Any]]:
        return exact.outputs(self._steps, {"g": self.group.store(g)})

    def _is_zero_at_e(self) -> bool:
        g = self.group.embed(Matrix(self.group.identity))
        return exact.vanishes(self._exactly(g)["nu_u"])

    def _oddness(self, jumps: tuple[Jump, ...]) -> Oddness:
        points = [*exact.general(self.group), *exact.turned(self.group)]
        poles = {one.place for one in jumps if one.is_steep or np.isinf(one.size)}
        fails: dict[str, str] = {}
        undefined: dict[str, None] = {}
        for point in points:
            place = where(self.space, point)
            there = self._exactly(point.g)
            if exact.vanishes(there["clearance"]) and place in poles:
                undefined[place] = None
                continue
            back = self._exactly(point.g.inv())["nu_u"]
            total = [a + b for a, b in zip(there["nu_u"], back, strict=True)]
            if not exact.vanishes(total) and place not in fails:
                fails[place] = (
                    f"g = {numbers(self.group.store(point.g))} has nu_u = "
                    f"{numbers(there['nu_u'])}, and g^-1 has {numbers(back)}"
                )
        g, _ = self._cloud()
        worst = self._odd_on(g)
        if worst:
            fails.setdefault("some samples", worst)
        example = next(iter(fails.values()), "")
        return Oddness(len(points), bool(points), tuple(fails), tuple(undefined), example)

    def _odd_on(self, g: Array) -> str:
        """A sample on which (ii) fails in double, in words; empty where there is none."""
        there, back = self.nu_u(g), self.nu_u(np.linalg.inv(g))
        scale = (1 + np.abs(there).max(-1)) ** 2 * (1 + np.abs(g).max((-1, -2)))
        off = np.abs(there + back).max(-1) / scale
        bad = np.flatnonzero(off > ODD)
        if not len(bad):
            return ""
        i = bad[np.argmax(off[bad])]
        return (
            f"g = {numbers(self.space.store(g[i]))} has nu_u = {numbers(there[i])}, and g^-1 "
            f"has {numbers(back[i])}"
        )

    @cached_property
    def _crossings(self) -> list[cut.Cut]:
        return cut.cuts(self.nu_u, cut.curves(self.space, CURVES, np.random.default_rng(self.seed)))

    def _jumps(self, crossings: list[cut.Cut]) -> tuple[Jump, ...]:
        found: dict[str, Jump] = {}
        for one in crossings:
            place = named(self.space, one.g, one.angles)
            last = found.get(place, Jump(place, 0.0, False))
            found[place] = Jump(place, max(last.size, one.size), last.is_steep or one.is_steep)
        return tuple(found.values())

    def _rests(self) -> tuple[Equilibria, ...]:
        g, _ = self._cloud(STARTS, 1)
        found: dict[str, Equilibria] = {}
        for one in rest.rests(self.space, self.nu_u, self.clearance, g):
            place = named(self.space, one.g, one.angles)
            nearby = numbers(self.space.store(one.g))
            example = f"nu_u = 0 at g = {self._exact_rests.get(place, nearby)}"
            is_every = self._is_zero_at(one.angles)
            made = Equilibria(place, one.dimension, one.repels, is_every, example)
            found.setdefault(place, made)
        return tuple(sorted(found.values(), key=lambda one: one.place))

    def _is_zero_at(self, angles: Array) -> bool:
        """Whether the law vanishes on random elements of that angle; of one factor."""
        if len(angles) != 1 or self.group.factors:
            return False
        g, _ = cloud(self.space, STARTS, np.random.default_rng(self.seed), float(angles[0]))
        return bool(np.abs(self.nu_u(g)).max() < AT_REST)

    @cached_property
    def _exact_rests(self) -> dict[str, str]:
        """Exact elements on which the law vanishes exactly, by place."""
        points = [one for one in exact.turned(self.group)
                  if exact.vanishes(self._exactly(one.g)["nu_u"])]  # fmt: skip
        # The last is about the least special axis.
        return {where(self.space, one): numbers(self.group.store(one.g)) for one in points}

    def _cloud(self, count: int = SAMPLES, seed: int = 0) -> tuple[Array, Array]:
        """Elements over all angles, (count, m, m), and the angle of each, (count,)."""
        return cloud(self.space, count, np.random.default_rng(self.seed + 1 + seed))

    def _fall(self, name: str) -> Fall:
        g, angle = self._cloud()
        nu, value = self.nu_u(g), slope.values(self.space, name)
        judged = (np.linalg.norm(nu, axis=-1) > AT_REST) & (self.clearance(g) > AT_CUT)
        g, angle, nu = g[judged], angle[judged], nu[judged]
        y = slope.fall(self.space, value, g, nu) / value(g)
        bad = np.flatnonzero(~(y > FLAT))
        rises = (float(angle[bad].min()), float(angle[bad].max())) if len(bad) else ()
        example = ""
        if len(bad):
            i = bad[np.argmin(y[bad])]
            example = (
                f"V'/V = {-y[i]:.4g} at g = {numbers(self.space.store(g[i]))}, "
                f"nu_u = {numbers(nu[i])}"
            )
        low, high, text, misfit = float(y.min()), float(y.max()), "", 0.0
        stated = claimed(self.group.name, self.law.name, name)
        if stated:
            expected = stated.of_angle(angle)
            text, misfit = stated.text, float((np.abs(y - expected) / (1 + np.abs(y))).max())
            if misfit <= FITS:
                low, high = span(stated.of_angle, self.space.reach)
        return Fall(name, rises, low, high, text, misfit, len(g), example)

    def _unwinds(self) -> bool:
        """Whether a whole turn, which is not the identity, changes the law."""
        if self.space.whole is None:
            return False
        g, _ = self._cloud()
        return bool(np.abs(self.nu_u(self.space.whole @ g) - self.nu_u(g)).max() > AT_CUT)

    def _contradictions(self, crossings: list[cut.Cut], jumps: tuple[Jump, ...],
                        falls: tuple[Fall, ...]) -> list[str]:  # fmt: skip
        """Claims of the records that are not borne out."""
        found = []
        off = [float(self.clearance(one.g)) for one in crossings]
        if off and max(off) > AT_CUT:
            found.append(f"the law jumps where its clearance is {max(off):.3g}, not 0")
        is_pole = any(one.is_steep or np.isinf(one.size) for one in jumps)
        if is_pole and not self.law.is_pole:
            found.append("the record states no pole, and there is one")
        if jumps and self.law.is_pole and not is_pole:
            found.append("the record states a pole, and the law only jumps")
        if self.space.turns and self.law.is_pole and not jumps:
            found.append("the record states a pole, and none is found")
        found += [f"y = {one.factor} for {one.morse} is off by {one.misfit:.3g}"
                  for one in falls if not one.misfit <= FITS]  # fmt: skip
        return found
