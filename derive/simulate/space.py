"""The group in numbers: derivations of derive.control.motion, run over columns.

A quantity of N loops is an array (size, N), or (size, 1) where all loops share it. Only
additions, products, quotients, square roots and choices are made, each on its own column: the
result for one loop does not depend on how many others stand beside it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.control import mechanics, motion
from derive.emit.function import Function, compiled
from derive.lie.group import Group
from derive.simulate.columns import Columns, in_c
from derive.simulate.craft import Craft, group_of, unpacked

Array = NDArray[np.float64]


class Space:
    """What the loop needs of a group and of the plant on it."""

    def __init__(
        self,
        group: Group,
        pattern: tuple[bool, ...],
        options: tuple[str, ...],
        native: tuple[Path, str] | None = None,
    ) -> None:
        """native: folder and name of what is built in C; None for numpy, with the same bits."""
        self.group, self.options = group, options
        self.dim, self.size = group.dim, group.size
        derivations = [
            motion.advance(group),
            motion.chart_rate(group),
            motion.deviation(group),
            mechanics.plant(group, pattern, options),
        ]
        made: Sequence[Function | Columns] = (
            in_c(derivations, *native) if native else [compiled(d) for d in derivations]
        )
        self._advance, self._chart_rate, self._deviation, self._plant = made
        residual = mechanics.residual(group)
        self._residual: Function | None = compiled(residual) if residual.outputs else None

    @cached_property
    def _compose(self) -> Function:
        return compiled(motion.compose(self.group))

    @property
    def identity(self) -> Array:
        """The stored numbers of e, (k, 1)."""
        return np.array(self.group.identity, dtype=np.float64)[:, None]

    @property
    def turns(self) -> list[int]:
        """The coordinates that are angles, in which a law can jump; of a user's group as told."""
        return [i for i, unit in enumerate(self.group.units) if unit.startswith("rad")]

    def advance(self, g: Array, x: Array) -> Array:
        """g exp(hat(x)), (k, N), for displacements x (n, N) that turn by at most 1 rad."""
        return self._first(self._advance, g=g, x=x)

    def far(self, g: Array, x: Array) -> Array:
        """The same for a displacement that turns by more, in steps that are small enough."""
        parts = max(1, math.ceil(2 * float(np.abs(x[self.turns]).max(initial=0.0))))
        for _ in range(parts):
            g = self.advance(g, x / parts)
        return g

    def compose(self, g: Array, g_e: Array) -> Array:
        """g g_e, (k, N)."""
        return self._first(self._compose, g=g, g_e=g_e)

    def chart_rate(self, x: Array, nu: Array) -> Array:
        """x', (n, N), where g0 exp(hat(x)) moves with the body velocity nu (n, N)."""
        return self._first(self._chart_rate, x=x, nu=nu)

    def deviation(self, g: Array, nu: Array, g_r: Array, nu_r: Array) -> tuple[Array, ...]:
        """g_e (k, N), nu_e (n, N) and the height of g_e (N,)."""
        return self._deviation.columns(g=g, nu=nu, g_r=g_r, nu_r=nu_r)

    def acceleration(self, inertia: Array, nu: Array, force: Array, **extras: Array) -> Array:
        """nu', (n, N), under a force; extras are those of the options. Eq. (EulerP)."""
        return self._first(self._plant, inertia=inertia, nu=nu, force=force, **extras)

    def drift(self, g: Array) -> Array:
        """How far stored numbers are from the group, (N,): the largest residual."""
        if self._residual is None:
            return np.zeros(g.shape[1])
        return np.asarray(np.abs(self._first(self._residual, g=g)).max(0))

    def _first(self, function: Function | Columns, **given: Any) -> Array:
        wanted = {one.name for one in function.inputs}
        found: Array = function.columns(**{n: v for n, v in given.items() if n in wanted})[0]
        return found


@cache
def space_of(craft: Craft, is_native: bool = False) -> Space:
    """The space of a craft, derived once per process; is_native: in C, where CompilerMissing and
    CompileError may be raised.
    """
    if not is_native:
        return Space(group_of(craft), craft.pattern, craft.options)
    with unpacked(craft) as folder:
        native = folder / "build", f"{craft.name}_space"
        return Space(group_of(craft), craft.pattern, craft.options, native)
