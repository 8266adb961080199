"""What is drawn for a run, from the seed of that run alone.

Every run takes the same numbers from its generator, whatever the spread is: a run with a wider
spread is the same run, farther out. Roots, sines and the like are taken one number at a time, so
that a run is the same in whatever company it flies.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from derive.lie.group import Group
from derive.simulate.craft import Craft
from derive.simulate.reference import Reference
from derive.simulate.runs import Runs
from derive.simulate.space import Array, Space, space_of

Numbers = list[float]
Column = tuple[float, ...]

PARTS = 8
"""Parts of a whole turn: an angle of 2 pi in steps of less than 1 rad."""


@dataclass(frozen=True)
class Spread:
    """How far a run may lie from the nominal one: half widths of uniform draws, and what is given.

    box:         initial error in algebra coordinates, rad and m, where the group is not compact
    speed:       initial velocity error per coordinate, rad/s and m/s
    inertia:     of the plant, relative
    disturbance: constant force, (n,), N m and N; () is zero, as below
    wave:        amplitudes of the periodic force, of its sine and of its cosine, (n,)
    momentum, external: of wheels at the start, and the known force, (n,); not drawn
    """

    box: float = 1.0
    speed: float = 0.5
    inertia: float = 0.0
    disturbance: Column = ()
    wave: Column = ()
    momentum: Column = ()
    external: Column = ()


@dataclass(frozen=True)
class Draw:
    """The numbers of one run, each uniform in [-1, 1) but for `rate` in [0, 1) and the normals."""

    rate: float
    place: Numbers
    speed: Numbers
    inertia: Numbers
    force: Numbers
    sine: Numbers
    cosine: Numbers
    normal: Numbers


def draw(seed: int, dim: int, leaves: int) -> Draw:
    """The numbers of a seed, for n coordinates and so many factors."""
    source = np.random.default_rng(seed)
    rate, *rest = source.random(1 + 6 * dim).tolist()
    place, speed, inertia, force, sine, cosine = (
        [2 * x - 1 for x in rest[i * dim : (i + 1) * dim]] for i in range(6)
    )
    normal = source.standard_normal(4 * leaves).tolist()
    return Draw(rate, place, speed, inertia, force, sine, cosine, normal)


def seed_of(root: int, run: int) -> int:
    """The seed of a run of a sweep, 63 bits."""
    words = np.random.SeedSequence(root, spawn_key=(run,)).generate_state(1, np.uint64)
    return int(words[0]) >> 1


def choice(seed: int, choices: int) -> int:
    """Which of so many alternatives that run takes."""
    return int(float(np.random.default_rng(seed).random()) * choices)


def drawn(craft: Craft, reference: Reference, spread: Spread, seeds: Sequence[int]) -> Runs:
    """The runs of these seeds, which start off the reference by the drawn errors.

    g(0) = g_r(0) g_e(0); nu(0) is the reference's velocity in the body frame plus an error.
    """
    space = space_of(craft)
    plan = list(leaves(space.group, craft.own is None))
    draws = [draw(seed, space.dim, len(plan)) for seed in seeds]
    g_e = _errors(space, plan, spread, draws)
    nu_r, _ = reference.at(0.0)
    eta = -space.deviation(g_e, np.zeros((space.dim, len(seeds))), space.identity, nu_r)[1]
    n = space.dim
    return Runs(
        g=space.compose(reference.start, g_e),
        nu=eta + spread.speed * _columns([one.speed for one in draws]),
        momentum=_column(spread.momentum, n),
        inertia=_inertias(craft.inertia, [one.inertia for one in draws], spread.inertia),
        external=_column(spread.external, n),
        disturbance=_forces(spread.disturbance, [one.force for one in draws]),
        sine=_forces(spread.wave, [one.sine for one in draws]),
        cosine=_forces(spread.wave, [one.cosine for one in draws]),
        seeds=tuple(seeds),
    )


def initial_angles(craft: Craft, seeds: Sequence[int]) -> Array:
    """The angle of g_e(0), (N,), rad: the largest of its factors; NaN where nothing turns."""
    space = space_of(craft)
    plan = list(leaves(space.group, craft.own is None))
    return np.array([_angle(plan, draw(seed, space.dim, len(plan))) for seed in seeds])


class Leaf(NamedTuple):
    """A factor: its first coordinate, how many turn it uniformly, its largest angle, rad."""

    start: int
    turning: int
    reach: float


def leaves(group: Group, is_known: bool, start: int = 0) -> Iterator[Leaf]:
    """The factors. Rotations come first in the catalogue's groups, in the usual basis.

    is_known: whether the group is the catalogue's; of a user's nothing is known
    """
    for factor in group.factors:
        yield from leaves(factor, is_known, start)
        start += factor.dim
    if not group.factors:
        turning = group.units.count("rad/s") if is_known else 0
        reach = 2 * math.pi if group.shape == (4,) and turning == 3 else math.pi
        yield Leaf(start, turning if turning in (1, 3) else 0, reach)


def _errors(space: Space, plan: list[Leaf], spread: Spread, draws: list[Draw]) -> Array:
    """g_e(0), (k, N): uniform where it turns, in the box where it moves."""
    moves = [_move(plan, spread.box, one) for one in draws]
    turns = [_turn(plan, one) for one in draws]
    parts = min(64, max(1, math.ceil(2 * spread.box)))  # of the spread, not of the runs
    g = np.repeat(space.identity, len(draws), 1)
    for x, steps in ((moves, parts), (turns, PARTS)):
        part = np.array(x).T / steps
        for _ in range(steps):
            g = space.advance(g, part)
    return g


def _move(plan: list[Leaf], box: float, one: Draw) -> Numbers:
    """The displacement in the box, (n,), of what is not turned."""
    x = [box * u for u in one.place]
    for leaf in plan:
        x[leaf.start : leaf.start + leaf.turning] = [0.0] * leaf.turning
    return x


def _turn(plan: list[Leaf], one: Draw) -> Numbers:
    """The rotations, (n,), of up to a whole turn."""
    x = [0.0] * len(one.place)
    for i, leaf in enumerate(plan):
        if leaf.turning == 1:
            x[leaf.start] = math.pi * one.place[leaf.start]
        elif leaf.turning == 3:
            x[leaf.start : leaf.start + 3] = _rotation(one.normal[4 * i : 4 * i + 4])
    return x


def _angle(plan: list[Leaf], one: Draw) -> float:
    """The largest angle of its rotations, as far as each factor knows it; NaN for none."""
    x = _turn(plan, one)
    found: list[float] = []
    for start, turning, reach in plan:
        if turning:
            angle = math.sqrt(sum(u * u for u in x[start : start + turning]))
            found.append(min(angle, 2 * math.pi - angle) if angle > reach else angle)
    return max(found, default=math.nan)


def _rotation(normal: Numbers) -> Numbers:
    """Rotation vector of a quaternion that is uniform on the sphere, its angle up to 2 pi."""
    w, x, y, z = normal
    long = math.sqrt(x * x + y * y + z * z)
    scale = 2 * math.atan2(long, w) / long if long else 0.0
    return [scale * x, scale * y, scale * z]


def _inertias(upper: tuple[float, ...], draws: list[Numbers], width: float) -> Array:
    """D I D with D = diag(sqrt(1 + e)), (n(n+1)/2, N): as definite as I, with its zeros."""
    roots = [[math.sqrt(1 + width * e) for e in one] for one in draws]
    n = len(roots[0])
    pairs = [(i, j) for i in range(n) for j in range(i, n)]
    return np.array([[entry * root[i] * root[j] for root in roots]
                     for entry, (i, j) in zip(upper, pairs, strict=True)])  # fmt: skip


def _forces(width: Column, draws: list[Numbers]) -> Array:
    """Uniform within the width, (n, N); where that is zero, a zero without a sign."""
    n = len(draws[0])
    return _column(width, n) * _columns(draws) + 0.0


def _columns(draws: list[Numbers]) -> Array:
    return np.array(draws).T


def _column(values: Column, n: int) -> Array:
    return np.array(values or (0.0,) * n)[:, None]
