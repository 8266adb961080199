"""One step of the plant under a held force, for all loops in one call of C.

The arithmetic is that of derive.simulate.loop, operation by operation: the same bits, sooner.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np

from derive.control import mechanics, motion
from derive.emit import inline
from derive.emit.render import environment
from derive.native.kernel import Kernel
from derive.simulate.craft import Craft, unpacked
from derive.simulate.method import KUTTA
from derive.simulate.runs import Runs
from derive.simulate.space import Array, Space, space_of


class Held:
    """The plant of a craft over N loops; raises CompilerMissing, CompileError."""

    def __init__(self, craft: Craft, runs: Runs) -> None:
        self._kernel, self._loops = _kernel(craft), len(runs)
        names = ("held_step", "apart", "follow")
        self._step, self._apart, self._follow = (self._kernel[name] for name in names)
        space = space_of(craft)
        self._sizes = (space.size, space.dim, 1)
        shared = (runs.inertia, runs.external, runs.disturbance, runs.sine, runs.cosine)
        self._shared = [np.ascontiguousarray(self._wide(one)) for one in shared]
        self._fixed = [self._kernel.column(one) for one in self._shared]

    def step(
        self,
        h: float,
        turns: Sequence[tuple[float, float]],
        state: tuple[Array, Array, Array, Array],
        force: Array,
    ) -> tuple[Array, Array, Array, Array]:
        """g, nu, momentum and effort after h seconds, from those before.

        turns: sine and cosine of the periodic force's phase, at each of the four stages
        """
        given = [self._column(one) for one in (*state, force)]
        found = [np.empty((n, self._loops)) for n in (*self._sizes[:2], self._sizes[1])]
        effort = np.empty(self._loops)
        phases = np.array(turns)
        numbers = [self._column(one) for one in (_weights(h), phases)]
        outputs = [self._column(one) for one in (*found, effort)]
        self._step(self._loops, *numbers, *given, *self._fixed, *outputs)
        return found[0], found[1], found[2], effort

    def follow(self, h: float, nu_r: Sequence[Array], g_r: Array) -> Array:
        """g_r (k, 1) after h seconds, with the velocities (n, 1) of the four stages."""
        found = np.empty_like(g_r)
        given = (_weights(h), np.concatenate(nu_r), g_r, found)
        self._follow(*(self._column(one) for one in given))
        return found

    def deviation(self, g: Array, nu: Array, g_r: Array, nu_r: Array) -> tuple[Array, ...]:
        """As Space.deviation, of a reference that all loops share."""
        found = [np.empty((n, self._loops)) for n in self._sizes]
        given = [self._column(one) for one in (g, nu, g_r, nu_r)]
        self._apart(self._loops, *given, *(self._column(one) for one in found))
        return found[0], found[1], found[2][0]

    def _wide(self, values: Array) -> Array:
        return np.repeat(values, self._loops // values.shape[1], 1)

    def _column(self, array: Array) -> object:
        return self._kernel.column(np.ascontiguousarray(array))


@cache
def _weights(h: float) -> Array:
    """Three weights of the stages before, and four of the step."""
    return np.array([h * w for row in (*KUTTA.rows[1:], KUTTA.weights) for w in row if w])


@cache
def _kernel(craft: Craft) -> Kernel:
    space = space_of(craft)
    name = f"{craft.name}_held"
    text = _text(craft, space)
    with unpacked(craft) as folder:
        return Kernel(text, _PROTOTYPES, folder / "build", name)


_STATE = ("g", "nu", "momentum", "effort")
_MET = ("inertia", "external", "disturbance", "sine", "cosine")
_ARGUMENTS = {
    "step": (("weight", "turn", *_STATE, "force", *_MET), tuple(f"{one}_new" for one in _STATE)),
    "apart": (("g", "nu", "g_r", "nu_r"), ("g_e", "nu_e", "height")),
    "follow": (("weight", "nu_r", "g_r"), ("g_r_new",)),
}
"""Function -> the columns it takes, and those it gives."""

_POINTERS = {
    name: ", ".join(
        [f"const double *restrict {one}" for one in taken]
        + [f"double *restrict {one}" for one in given]
    )
    for name, (taken, given) in _ARGUMENTS.items()
}
_PROTOTYPES = (
    f"void held_step(long rows, {_POINTERS['step']}); "
    f"void apart(long rows, {_POINTERS['apart']}); void follow({_POINTERS['follow']});"
)


def _text(craft: Craft, space: Space) -> str:
    """C source, with every size a constant so that the compiler unrolls what is small."""
    group = space.group
    plant = mechanics.plant(group, craft.pattern, craft.options)
    local = {"inertia": "inertia0", "nu": "v", "force": "pushed", "momentum": "p",
             "external": "known"}  # fmt: skip
    derived = [motion.advance(group), motion.chart_rate(group), motion.deviation(group), plant]
    return environment().get_template("simulate/held.c.jinja").render(
        functions=inline.functions(derived),
        plant=[local[one.name] for one in plant.inputs],
        k=space.size,
        n=space.dim,
        m=len(craft.inertia),
        **_POINTERS,
    )  # fmt: skip
