"""One step of the plant under a held force, for all loops in one call of C.

The arithmetic is that of derive.simulate.loop, operation by operation: the same bits, sooner.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache

import numpy as np

from derive.control import mechanics, motion
from derive.emit import inline
from derive.native.kernel import Kernel
from derive.simulate.craft import Craft, folder_of
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
    return Kernel(_text(craft, space), _PROTOTYPES, folder_of(craft) / "build", name)


_POINTER = "const double *restrict "
_GIVEN = ("weight", "turn", "g", "nu", "momentum", "effort", "force",
          "inertia", "external", "disturbance", "sine", "cosine")  # fmt: skip
_FOUND = ("g_new", "nu_new", "momentum_new", "effort_new")
_STEP = ", ".join([*(_POINTER + n for n in _GIVEN), *(f"double *restrict {n}" for n in _FOUND)])
_APART = ", ".join([*(_POINTER + n for n in ("g", "nu", "g_r", "nu_r")),
                    *(f"double *restrict {n}" for n in ("g_e", "nu_e", "height"))])  # fmt: skip
_FOLLOW = ", ".join(
    [*(_POINTER + n for n in ("weight", "nu_r", "g_r")), "double *restrict g_r_new"]
)
_PROTOTYPES = (
    f"void held_step(long rows, {_STEP}); void apart(long rows, {_APART}); void follow({_FOLLOW});"
)


def _text(craft: Craft, space: Space) -> str:
    """C source, with every size a constant so that the compiler unrolls what is small."""
    group = space.group
    plant = mechanics.plant(group, craft.pattern, craft.options)
    known = {"inertia": "I", "nu": "v", "force": "pushed", "momentum": "p", "external": "ext"}
    arguments = ", ".join(known[one.name] for one in plant.inputs)
    derived = [motion.advance(group), motion.chart_rate(group), motion.deviation(group), plant]
    sizes = {"K": space.size, "N": space.dim, "M": len(craft.inertia)}
    defines = "\n".join(f"#define {name} {size}" for name, size in sizes.items())
    body = _SOURCE
    for mark, by in {
        "STEP_ARGUMENTS": _STEP,
        "APART_ARGUMENTS": _APART,
        "FOLLOW_ARGUMENTS": _FOLLOW,
        "PLANT_ARGUMENTS": arguments,
    }.items():
        body = body.replace(mark, by)
    counts = {name: range(size) for name, size in sizes.items()} | {"R": range(1, space.dim)}
    lines = [one for line in body.splitlines() for one in _written(line, counts)]
    return "\n".join([inline.functions(derived), defines, *lines, ""])


_STAGE = """
N: pushed[$] = f[$] + (d[$] + turn[TWICE] * a[$] + turn[TWICE + 1] * b[$]);
plant(PLANT_ARGUMENTS, kvSTAGE);
chart_rate(x, v, kxSTAGE);
"""
_NEXT = """
N: x[$] = 0.0 + weight[STAGE] * kxSTAGE[$];
N: v[$] = v0[$] + weight[STAGE] * kvSTAGE[$];
N: p[$] = p0[$] + weight[STAGE] * -f[$];
"""
_START = """
N: x[$] = 0.0;
N: v[$] = v0[$];
N: p[$] = p0[$];
"""
_ADD = """
N: x[$] = x[$] + weight[3 + STAGE] * kxSTAGE[$];
N: v[$] = v[$] + weight[3 + STAGE] * kvSTAGE[$];
N: p[$] = p[$] + weight[3 + STAGE] * -f[$];
e = e + weight[3 + STAGE] * square;
"""


def _staged(text: str, stage: int) -> str:
    return text.replace("STAGE", str(stage)).replace("TWICE", str(2 * stage))


_STEPS = "".join(
    [_START, *(_staged(_STAGE + _NEXT * (stage < 3), stage) for stage in range(4)),
     _START, *(_staged(_ADD, stage) for stage in range(4))]
)  # fmt: skip

_SOURCE = f"""
void held_step(long rows, STEP_ARGUMENTS)
{{
#pragma GCC ivdep
for (long i = 0; i < rows; ++i) {{
double g0[K], v0[N], p0[N], f[N], I[M], ext[N], d[N], a[N], b[N];
double kx0[N], kx1[N], kx2[N], kx3[N], kv0[N], kv1[N], kv2[N], kv3[N];
double x[N], v[N], p[N], pushed[N], g1[K];
K: g0[$] = g[$ * rows + i];
M: I[$] = inertia[$ * rows + i];
N: v0[$] = nu[$ * rows + i];
N: p0[$] = momentum[$ * rows + i];
N: f[$] = force[$ * rows + i];
N: ext[$] = external[$ * rows + i];
N: d[$] = disturbance[$ * rows + i];
N: a[$] = sine[$ * rows + i];
N: b[$] = cosine[$ * rows + i];
double e = effort[i], square = f[0] * f[0];
R: square = square + f[$] * f[$];
{_STEPS}
advance(g0, x, g1);
K: g_new[$ * rows + i] = g1[$];
N: nu_new[$ * rows + i] = v[$];
N: momentum_new[$ * rows + i] = p[$];
effort_new[i] = e;
}}
}}

void apart(long rows, APART_ARGUMENTS)
{{
#pragma GCC ivdep
for (long i = 0; i < rows; ++i) {{
double g0[K], v0[N], g1[K], v1[N], far[1];
K: g0[$] = g[$ * rows + i];
N: v0[$] = nu[$ * rows + i];
deviation(g0, v0, g_r, nu_r, g1, v1, far);
K: g_e[$ * rows + i] = g1[$];
N: nu_e[$ * rows + i] = v1[$];
height[i] = far[0];
}}
}}

void follow(FOLLOW_ARGUMENTS)
{{
double k[4][N], x[N];
N: x[$] = 0.0;
for (int s = 0; s < 4; ++s) {{
chart_rate(x, nu_r + s * N, k[s]);
if (s == 3) break;
N: x[$] = 0.0 + weight[s] * k[s][$];
}}
N: x[$] = 0.0;
for (int s = 0; s < 4; ++s) {{
N: x[$] = x[$] + weight[3 + s] * k[s][$];
}}
advance(g_r, x, g_r_new);
}}
"""
"""A line `N: ...` stands for one statement per coordinate `$`; K is of stored numbers, M of the
inertia, R of all coordinates but the first. No loop is left inside that over the rows, which the
compiler can then do several rows at a time."""


def _written(line: str, counts: Mapping[str, range]) -> list[str]:
    """The statements of a line of _SOURCE."""
    head, mark, statement = line.partition(": ")
    if not mark or head not in counts:
        return [line]
    return [statement.replace("$", str(place)) for place in counts[head]]
