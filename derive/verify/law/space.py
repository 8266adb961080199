"""A group in plain numpy, from its basis alone: exponential, logarithm, angles, stored numbers.

Nothing of a group's formulas is used but hat of the basis and where its numbers are stored, so
that laws and Morse functions are judged on elements, and along curves, of this file's making.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sympy import MatrixSymbol

from derive.lie.group import Group

Array = NDArray[Any]

HALVINGS, TERMS = 10, 14  # exp: norms below 4 are exact to rounding
ROOTS, ODD_TERMS = 6, 9  # log
STEPS = 24  # of the iteration for a square root, at most
SAME = 1e-14  # relative; the iteration doubles the digits that agree


@dataclass(frozen=True)
class Space:
    """Elements are matrices (..., m, m), coordinates (..., n), stored numbers (..., k)."""

    group: Group

    @cached_property
    def basis(self) -> Array:
        """(n, m, m)."""
        return np.array([np.array(e, dtype=float) for e in self.group.basis])

    @cached_property
    def one(self) -> Array:
        """The identity, (m, m)."""
        return np.eye(self.basis.shape[1])

    @cached_property
    def _places(self) -> tuple[Array, Array]:
        """Row and column of the matrix that each stored number is."""
        m = len(self.one)
        kept = self.group.store(MatrixSymbol("g", m, m).as_explicit())
        return np.array([int(x.i) for x in kept]), np.array([int(x.j) for x in kept])

    @cached_property
    def turns(self) -> list[tuple[slice, int]]:
        """Coordinates of each factor that are angular rates, and its first row in the matrix."""
        found, first, row = [], 0, 0
        for one in self.group.factors or (self.group,):
            count = turning(one)
            if count:
                found.append((slice(first, first + count), row))
            first, row = first + one.dim, row + one.basis[0].rows
        return found

    @cached_property
    def whole(self) -> Array | None:
        """A whole turn of the first factor where it is not the identity, as on S3, (m, m)."""
        turns = (self.exp(2 * np.pi * np.eye(len(self.basis))[one.start]) for one, _ in self.turns)
        return next((g for g in turns if np.abs(g - self.one).max() > 1), None)

    @cached_property
    def reach(self) -> float:
        """The largest rotation angle: pi, or 2 pi where a whole turn is not the identity."""
        return float(np.pi if self.whole is None else 2 * np.pi)

    def hat(self, x: Array) -> Array:
        """Coordinates to the matrix of the algebra."""
        return np.asarray(np.einsum("...i,ijk->...jk", x, self.basis))

    def exp(self, x: Array) -> Array:
        """Of hat(x), by scaling and squaring."""
        scaled = self.hat(x) / 2.0**HALVINGS
        off = np.zeros_like(scaled)
        for order in range(TERMS, 0, -1):  # exp - 1, which loses nothing near the identity
            off = scaled @ (self.one + off) / order
        for _ in range(HALVINGS):
            off = 2 * off + off @ off
        return np.asarray(self.one + off)

    def store(self, g: Array) -> Array:
        """Stored numbers of elements."""
        rows, columns = self._places
        return np.asarray(g[..., rows, columns])

    def log(self, g: Array) -> Array:
        """Coordinates of the principal logarithm, by square roots and a series."""
        for _ in range(ROOTS):
            g = _root(g, self.one)
        z = np.linalg.solve(g + self.one, g - self.one)
        square, total = z @ z, np.zeros_like(z)
        for order in range(2 * ODD_TERMS + 1, 0, -2):
            total = total @ square + self.one / order
        return self.vee(2.0 ** (ROOTS + 1) * z @ total)

    def vee(self, a: Array) -> Array:
        """Coordinates of matrices of the algebra, by least squares."""
        left = np.linalg.pinv(self.basis.reshape(len(self.basis), -1).T)
        return np.asarray(a.reshape(*a.shape[:-2], -1) @ left.T)

    def angles(self, g: Array) -> Array:
        """Rotation angle of each factor that turns, (..., turns); on S3 up to 2 pi."""
        found = []
        for place, row in self.turns:
            own = slice(row, row + self._size(place))
            fastest = np.abs(np.linalg.eigvals(self.basis[place.start][own, own])).max()
            turned = np.abs(np.angle(np.linalg.eigvals(g[..., own, own]))).max(-1)
            found.append(turned / fastest)
        return np.stack(found, -1) if found else np.zeros((*g.shape[:-2], 0))

    def _size(self, place: slice) -> int:
        """Rows of the rotation block: those that the generators of the factor move."""
        moved = np.abs(self.basis[place]).sum(0).any(0)
        return int(moved.sum())


def turning(group: Group) -> int:
    """How many leading coordinates of a group are rates of one rotation: 3, 1 or 0.

    They are if their generators turn leading axes by an angle, or by half of it, with the brackets
    of space where there are three, and all other generators are nilpotent: translations. What
    units the coordinates have does not matter. A group that turns in other ways counts as none.
    """
    basis = [np.array(e, dtype=float) for e in group.basis]
    for count in (3, 1):
        turns, others = basis[:count], basis[count:]
        nilpotent = (np.linalg.matrix_power(e, len(e)) for e in others)
        if len(turns) == count and _is_rotation(turns) and not any(map(np.any, nilpotent)):
            return count
    return 0


def _is_rotation(turns: list[Array]) -> bool:
    """Whether generators turn leading axes as those of a plane or of space do."""
    moved = np.abs(turns).sum(0).any(0)
    squares = [float(np.trace(e @ e) / max(np.linalg.matrix_rank(e), 1)) for e in turns]
    is_cubic = all(np.allclose(e @ e @ e, s * e) for e, s in zip(turns, squares, strict=True))
    pairs = ((0, 1, 2), (1, 2, 0), (2, 0, 1))[: len(turns) // 3 * 3]
    brackets = (turns[i] @ turns[j] - turns[j] @ turns[i] - turns[k] for i, j, k in pairs)
    return (
        is_cubic
        and len({*squares}) == 1
        and squares[0] in (-1.0, -0.25)
        and not any(map(np.any, brackets))
        and bool(moved[: int(moved.sum())].all())
    )


def _root(g: Array, one: Array) -> Array:
    """Principal square root, by Denman and Beavers."""
    y, z = g, np.broadcast_to(one, g.shape)
    for _ in range(STEPS):
        last = y
        y, z = (y + np.linalg.inv(z)) / 2, (z + np.linalg.inv(y)) / 2
        if np.abs(y - last).max() < SAME * np.abs(y).max():
            break
    return y
