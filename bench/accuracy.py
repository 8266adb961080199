"""log(exp(x)) = x, the logarithm and its rate on every group, block by block, in C and numpy.

The error of a block is relative to the length of the true block; for a translation's rate also
to its natural scale |v| + |p| |omega|, that of the terms it is the sum of.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from bench import exact, made
from bench.exact import Array, Block, Pair, States
from bench.figure import Figure
from derive.native.compile import build
from derive.native.load import Library, load_module
from derive.terminal import progress
from derive.verify.limits import EPS, LIMITS, Limit

GROUPS = ("SO2", "SO3", "S3", "SE2", "SE3", "SE23", "R3", "SO3 x R3")
EACH = {"f64": 3, "f32": 2}
"""States for every angle and translation."""

ANY = Limit("any group", 1e-13 / EPS["f64"], "eps", "1e-13 in double, as many eps in float")
CARRIED = ("SE2", "SE3", "SE23")
BOUNDS = {
    (group, what): LIMITS[limit]
    for group in CARRIED
    for what, limit in (("log", "log_carried"), ("rate, natural scale", "rate_carried"))
}
"""What is promised beyond ANY, by group and by what is judged."""

Run = Callable[[Array, Array], tuple[Array, Array]]
"""(g, nu) -> nu_u and its rate, (N, n) each, by one backend."""


def backends(name: str, folder: Path) -> dict[str, list[Run]]:
    """By scalar, every emitted form of the law: numpy and C in double, C in float."""
    root = made.place(made.texts(name), folder)
    module = load_module(root / "numpy/made.py")
    shape = made.group(name).shape

    def numpy(g: Array, nu: Array) -> tuple[Array, Array]:
        command = module.reaching(g=g.reshape(len(g), *shape), nu=nu)
        return command.nu_u, command.nu_u_dot

    return {"f64": [numpy, _compiled(root, "f64")], "f32": [_compiled(root, "f32")]}


def _compiled(root: Path, scalar: str) -> Run:
    prefix = f"made_{scalar}"
    include = root / f"c/include/{prefix}.h"
    library = Library(include, build([root / f"c/src/{prefix}.c"], include.parent, root), prefix)

    def run(g: Array, nu: Array) -> tuple[Array, Array]:
        found = library.reaching(g, nu)
        return found["nu_u"], found["nu_u_dot"]

    return run


def _relative(off: Array, scale: Array) -> float:
    """The worst ratio; nothing is allowed where the scale is zero."""
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(off == 0, 0.0, off / scale)
    return float("inf") if np.isnan(ratio).any() else float(ratio.max())


def _off(found: Array, wanted: Pair) -> Array:
    return np.asarray(np.linalg.norm((found - wanted[0]) - wanted[1], axis=-1))


def errors(states: States, run: Run, block: Block, place: int) -> Iterator[tuple[str, float]]:
    """What is judged of a block, the worst relative error of it."""
    log, rate = (np.asarray(each, float)[:, block.rows] for each in run(states.g, states.nu))
    true_log, true_rate = (
        (high[:, block.rows], low[:, block.rows]) for high, low in (states.log, states.rate)
    )
    x = states.x[:, block.rows]
    yield "log(exp(x)) - x", _relative(_off(log, (x, 0 * x)), np.linalg.norm(x, axis=-1))
    yield "log", _relative(_off(log, true_log), np.linalg.norm(true_log[0], axis=-1))
    off = _off(rate, true_rate)
    yield "rate", _relative(off, np.linalg.norm(true_rate[0], axis=-1))
    if block.column is not None:
        natural = np.linalg.norm(states.nu[:, block.rows].astype(float), axis=-1)
        if block.turn:
            omega = np.linalg.norm(states.nu[:, block.turn].astype(float), axis=-1)
            natural = natural + states.lengths[:, place] * omega
        yield "rate, natural scale", _relative(off, natural)


def judge(name: str, scalar: str, states: States, runs: list[Run]) -> list[Figure]:
    """The worst of every block over all backends of a scalar; columns are taken together."""
    worst: dict[tuple[str, str], float] = {}
    for place, block in enumerate(exact.blocks(name)):
        for run in runs:
            for what, error in errors(states, run, block, place):
                key = what, block.name
                worst[key] = max(worst.get(key, 0.0), error)
    return [_figure(name, scalar, *key, error) for key, error in worst.items()]


def _figure(name: str, scalar: str, what: str, block: str, error: float) -> Figure:
    bound = BOUNDS.get((name, what), ANY)
    # A rotation's rate has one scale: its own.
    if name in CARRIED and (what, block) == ("rate", "rotation"):
        bound = LIMITS["rate_carried"]
    label = f"{name} {scalar} {what}, {block}"
    return Figure(label, error / EPS[scalar], "eps", bound=bound, aside=f"{error:.1e} relative")


def measure(folder: Path) -> list[Figure]:
    """Every group with a logarithm that the truth knows."""
    show = progress()
    figures = []
    for name in GROUPS:
        for scalar, runs in backends(name, folder / name.replace(" ", "")).items():
            states = exact.states(name, scalar, EACH[scalar], show)
            figures += judge(name, scalar, states, runs)
    show("")
    return figures
