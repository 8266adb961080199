"""One step of the plant under a held force, for all loops in one call of C.

The arithmetic is that of derive.simulate.loop, operation by operation: the same bits, sooner.
"""

from __future__ import annotations

from collections.abc import Sequence
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
    return f"{inline.functions(derived)}\n{defines}\n{body}"


_SOURCE = """
void held_step(long rows, STEP_ARGUMENTS)
{
    for (long i = 0; i < rows; ++i) {
        double g0[K], v0[N], p0[N], f[N], I[M], ext[N], d[N], a[N], b[N];
        double kx[4][N], kv[4][N], x[N], v[N], p[N], pushed[N], g1[K];
        for (int j = 0; j < K; ++j) g0[j] = g[j * rows + i];
        for (int j = 0; j < M; ++j) I[j] = inertia[j * rows + i];
        for (int j = 0; j < N; ++j) {
            v0[j] = nu[j * rows + i];
            p0[j] = momentum[j * rows + i];
            f[j] = force[j * rows + i];
            ext[j] = external[j * rows + i];
            d[j] = disturbance[j * rows + i];
            a[j] = sine[j * rows + i];
            b[j] = cosine[j * rows + i];
        }
        for (int s = 0; s < 4; ++s) {
            for (int j = 0; j < N; ++j) {
                x[j] = s ? 0.0 + weight[s - 1] * kx[s ? s - 1 : 0][j] : 0.0;
                v[j] = s ? v0[j] + weight[s - 1] * kv[s ? s - 1 : 0][j] : v0[j];
                p[j] = s ? p0[j] + weight[s - 1] * -f[j] : p0[j];
                pushed[j] = f[j] + (d[j] + turn[2 * s] * a[j] + turn[2 * s + 1] * b[j]);
            }
            plant(PLANT_ARGUMENTS, kv[s]);
            chart_rate(x, v, kx[s]);
        }
        double square = f[0] * f[0], e = effort[i];
        for (int j = 1; j < N; ++j) square = square + f[j] * f[j];
        for (int j = 0; j < N; ++j) {
            x[j] = 0.0;
            v[j] = v0[j];
            p[j] = p0[j];
        }
        for (int s = 0; s < 4; ++s) {
            for (int j = 0; j < N; ++j) {
                x[j] = x[j] + weight[3 + s] * kx[s][j];
                v[j] = v[j] + weight[3 + s] * kv[s][j];
                p[j] = p[j] + weight[3 + s] * -f[j];
            }
            e = e + weight[3 + s] * square;
        }
        advance(g0, x, g1);
        for (int j = 0; j < K; ++j) g_new[j * rows + i] = g1[j];
        for (int j = 0; j < N; ++j) {
            nu_new[j * rows + i] = v[j];
            momentum_new[j * rows + i] = p[j];
        }
        effort_new[i] = e;
    }
}

void apart(long rows, APART_ARGUMENTS)
{
    for (long i = 0; i < rows; ++i) {
        double g0[K], v0[N], g1[K], v1[N], far[1];
        for (int j = 0; j < K; ++j) g0[j] = g[j * rows + i];
        for (int j = 0; j < N; ++j) v0[j] = nu[j * rows + i];
        deviation(g0, v0, g_r, nu_r, g1, v1, far);
        for (int j = 0; j < K; ++j) g_e[j * rows + i] = g1[j];
        for (int j = 0; j < N; ++j) nu_e[j * rows + i] = v1[j];
        height[i] = far[0];
    }
}

void follow(FOLLOW_ARGUMENTS)
{
    double k[4][N], x[N];
    for (int s = 0; s < 4; ++s) {
        for (int j = 0; j < N; ++j) x[j] = s ? 0.0 + weight[s - 1] * k[s ? s - 1 : 0][j] : 0.0;
        chart_rate(x, nu_r + s * N, k[s]);
    }
    for (int j = 0; j < N; ++j) x[j] = 0.0;
    for (int s = 0; s < 4; ++s)
        for (int j = 0; j < N; ++j) x[j] = x[j] + weight[3 + s] * k[s][j];
    advance(g_r, x, g_r_new);
}
"""
