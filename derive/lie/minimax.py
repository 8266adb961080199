"""The polynomial of least relative error on [0, 1], by Remez exchange; numbers are mpf."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import mpmath

Number = Any  # an mpf: mpmath has no stubs


def minimax(f: Callable[[Number], Number], degree: int) -> list[Number]:
    """Coefficients of p, constant term first, that minimise max |p/f - 1| over z in [0, 1].

    f is analytic and without zero there. The nodes start as extrema of a Chebyshev polynomial
    and are kept as angles, z = (1 - cos(angle))/2, in which the extrema are evenly spread. They
    are so near the true ones that a single exchange levels the error to a part in a thousand.
    """
    angles = [mpmath.pi * i / (degree + 1) for i in range(degree + 2)]
    angles = _exchanged(f, *_levelled(f, angles), angles)
    return _monomial(*_levelled(f, angles))


def _levelled(
    f: Callable[[Number], Number], angles: Sequence[Number]
) -> tuple[list[Number], list[Number]]:
    """Newton form of p of which p/f - 1 is E, -E, E, ... at the n + 2 nodes, p of degree n.

    Both f and +f, -f, +f, ... are interpolated; E removes the leading term of f - E (+-f).
    """
    nodes = [_place(angle) for angle in angles]
    values = [f(z) for z in nodes]
    plain = _differences(nodes, values)
    waves = _differences(nodes, [-y if i % 2 else y for i, y in enumerate(values)])
    level = plain[-1] / waves[-1]
    return [a - level * b for a, b in zip(plain, waves, strict=True)][:-1], nodes


def _exchanged(
    f: Callable[[Number], Number],
    newton: Sequence[Number],
    nodes: Sequence[Number],
    angles: Sequence[Number],
) -> list[Number]:
    """Angles moved to the extrema of p/f, by a parabola through three points each."""

    def error(z: Number) -> Number:
        return _newton(newton, nodes, z) / f(z)

    step = (angles[1] - angles[0]) / 4
    moved = []
    for angle in angles[1:-1]:
        low, here, high = (error(_place(angle + side * step)) for side in (-1, 0, 1))
        moved.append(angle + step * (low - high) / (2 * (low - 2 * here + high)))
    return [angles[0], *moved, angles[-1]]


def _place(angle: Number) -> Number:
    return (1 - mpmath.cos(angle)) / 2


def _differences(nodes: Sequence[Number], values: Sequence[Number]) -> list[Number]:
    """Divided differences: the coefficients of Newton's interpolation."""
    row, found = list(values), [values[0]]
    for order in range(1, len(nodes)):
        gaps = zip(nodes, nodes[order:], strict=False)
        row = [(b - a) / (y - x) for (a, b), (x, y) in zip(pairwise(row), gaps, strict=True)]
        found.append(row[0])
    return found


def _newton(coefficients: Sequence[Number], nodes: Sequence[Number], z: Number) -> Number:
    value = coefficients[-1]
    for c, node in zip(coefficients[-2::-1], nodes[len(coefficients) - 2 :: -1], strict=True):
        value = value * (z - node) + c
    return value


def _monomial(coefficients: Sequence[Number], nodes: Sequence[Number]) -> list[Number]:
    """Newton's form in powers of z, constant term first."""
    powers = [coefficients[-1]]
    for c, node in zip(coefficients[-2::-1], nodes[len(coefficients) - 2 :: -1], strict=True):
        shifted = [mpmath.mpf(0), *powers]
        powers = [a - node * b for a, b in zip(shifted, [*powers, mpmath.mpf(0)], strict=True)]
        powers[0] += c
    return powers
