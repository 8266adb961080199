"""Every group once more, in numpy and from the conventions alone: nothing of derive is used.

Judges what the emitted code computes, so it must not share a formula with it: brackets and
logarithms are those of matrices.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Algebra:
    """Matrices (m, m) with a basis of n, elements kept as k numbers.

    basis: (n, m, m); embed: (…, k) -> (…, m, m); kept: places of the k numbers in the flattened
    matrix; shape: of an element in numpy; off: matrices (…, m, m) -> distance from the group, (…)
    """

    basis: Array
    embed: Callable[[Array], Array]
    kept: tuple[int, ...]
    shape: tuple[int, ...]
    off: Callable[[Array], Array]

    @property
    def dim(self) -> int:
        """n."""
        return len(self.basis)

    def store(self, g: Array) -> Array:
        """Matrices (…, m, m) to stored numbers (…, k)."""
        return g.reshape(*g.shape[:-2], -1)[..., list(self.kept)]

    def hat(self, x: Array) -> Array:
        """Coordinates (…, n) to matrices (…, m, m)."""
        return np.asarray(np.einsum("...i,ijk->...jk", x, self.basis))

    @cached_property
    def _dual(self) -> Array:
        return np.asarray(np.linalg.pinv(self.basis.reshape(self.dim, -1)), np.float64)

    def vee(self, a: Array) -> Array:
        """Matrices (…, m, m) to coordinates (…, n)."""
        return np.asarray(a.reshape(*a.shape[:-2], -1) @ self._dual)

    def flow(self, stored: Array, nu: Array) -> Array:
        """Rates of the stored numbers, g' = g hat(nu): (…, k)."""
        return self.store(self.embed(stored) @ self.hat(nu))

    def coad(self, x: Array, a: Array) -> Array:
        """ad*_x a, (…, n): its y-component is <a; [x, e_y]>."""
        X = self.hat(x)[..., None, :, :]
        brackets = self.vee(X @ self.basis - self.basis @ X)
        return np.asarray(np.einsum("...yi,...i->...y", brackets, a))

    def pull(self, g: Array, x: Array) -> Array:
        """Ad of g^-1 on x, (…, n)."""
        return self.vee(np.linalg.inv(g) @ self.hat(x) @ g)


def _unit(m: int, i: int, j: int, value: float = 1.0) -> Array:
    out = np.zeros((m, m))
    out[i, j] = value
    return out


def _turn(m: int, i: int, j: int) -> Array:
    """Rotation from axis i towards axis j."""
    return _unit(m, j, i) - _unit(m, i, j)


def _skewness(size: int) -> Callable[[Array], Array]:
    """How far the upper left block is from orthonormal, and the rows below from 0 and 1."""

    def off(g: Array) -> Array:
        R, below = g[..., :size, :size], g[..., size:, :]
        gram = np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(size)).max((-1, -2))
        return np.asarray(gram + np.abs(below - np.eye(g.shape[-1])[size:]).sum((-1, -2)))

    return off


def _matrices(turns: list[Array], moves: list[Array], off: Callable[[Array], Array]) -> Algebra:
    """Elements kept as whole matrices, row by row; the turns come first."""
    basis = np.array([*turns, *moves])
    m = basis.shape[-1]

    def embed(stored: Array) -> Array:
        return stored.reshape(*stored.shape[:-1], m, m)

    return Algebra(basis, embed, tuple(range(m * m)), (m, m), off)


def _carrier(size: int, columns: int) -> Algebra:
    """Rotations of the plane or of space, and vectors they carry, column by column."""
    m = size + columns
    pairs = [(0, 1)] if size == 2 else [(1, 2), (2, 0), (0, 1)]
    moves = [_unit(m, i, size + c) for c in range(columns) for i in range(size)]
    return _matrices([_turn(m, *pair) for pair in pairs], moves, _skewness(size))


def _left(q: Array) -> Array:
    """Matrix of the product p -> q p of quaternions, scalar first."""
    w, x, y, z = np.moveaxis(q, -1, 0)
    rows = [[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def _vectors(n: int) -> Algebra:
    """R^n as translations of n-space."""

    def embed(stored: Array) -> Array:
        g = np.zeros((*stored.shape[:-1], n + 1, n + 1)) + np.eye(n + 1)
        g[..., :n, n] = stored
        return g

    kept = tuple(i * (n + 1) + n for i in range(n))
    basis = np.array([_unit(n + 1, i, n) for i in range(n)])
    return Algebra(basis, embed, kept, (n,), lambda g: np.zeros(g.shape[:-2]))


def _triangular(g: Array) -> Array:
    return np.asarray(np.abs(np.tril(g) - np.eye(g.shape[-1])).max((-1, -2)))


_SINGLE: dict[str, Callable[[], Algebra]] = {
    "SO2": lambda: _carrier(2, 0),
    "SO3": lambda: _carrier(3, 0),
    "SE2": lambda: _carrier(2, 1),
    "SE3": lambda: _carrier(3, 1),
    "SE23": lambda: _carrier(3, 2),
    "S3": lambda: Algebra(_left(np.eye(4)[1:]) / 2, _left, (0, 4, 8, 12), (4,), _skewness(4)),
    "Heisenberg": lambda: _matrices(
        [], [_unit(3, 0, 1), _unit(3, 1, 2), _unit(3, 0, 2)], _triangular
    ),
    "SL2": lambda: _matrices(
        [],
        [np.diag([0.5, -0.5]), _unit(2, 0, 1), _unit(2, 1, 0)],
        lambda g: np.asarray(np.abs(np.linalg.det(g) - 1)),
    ),
}

OWN = ("Heisenberg", "SL2")
"""Groups that no catalogue knows: made of their basis."""


@cache
def algebra(name: str) -> Algebra:
    """A group, R1 to R24, or a product; KeyError for an unknown one."""
    parts = [_one(part) for part in name.split(" x ")]
    return parts[0] if len(parts) == 1 else _product(parts)


def _one(name: str) -> Algebra:
    vectors = re.fullmatch(r"R([1-9]\d?)", name)
    return _vectors(int(vectors[1])) if vectors else _SINGLE[name]()


def _product(parts: list[Algebra]) -> Algebra:
    """Block-diagonal matrices; numbers and coordinates one part after the other."""
    sizes = [one.basis.shape[-1] for one in parts]
    m, starts = sum(sizes), np.cumsum([0, *sizes])
    numbers = np.cumsum([len(one.kept) for one in parts])

    def diagonal(blocks: list[Array]) -> Array:
        out = np.zeros((*blocks[0].shape[:-2], m, m))
        for start, block in zip(starts, blocks, strict=False):
            end = start + block.shape[-1]
            out[..., start:end, start:end] = block
        return out

    def block(g: Array, i: int) -> Array:
        return g[..., starts[i] : starts[i + 1], starts[i] : starts[i + 1]]

    def embed(stored: Array) -> Array:
        pieces = np.split(stored, numbers[:-1], axis=-1)
        return diagonal([one.embed(piece) for one, piece in zip(parts, pieces, strict=True)])

    def off(g: Array) -> Array:
        return np.asarray(np.max([one.off(block(g, i)) for i, one in enumerate(parts)], axis=0))

    def placed(i: int) -> Array:
        zero: Any = [np.zeros((parts[i].dim, size, size)) for size in sizes]
        return diagonal([*zero[:i], parts[i].basis, *zero[i + 1 :]])

    kept = [
        int((start + place // size) * m + start + place % size)
        for one, start, size in zip(parts, starts, sizes, strict=False)
        for place in one.kept
    ]
    basis = np.concatenate([placed(i) for i in range(len(parts))])
    return Algebra(basis, embed, tuple(kept), (len(kept),), off)


def exp(a: Array) -> Array:
    """Matrix exponential, (…, m, m): a Taylor series after six halvings, for norms up to 10."""
    small, unit = a / 2**6, np.eye(a.shape[-1])
    total = unit + np.zeros_like(a)
    for order in range(18, 0, -1):
        total = unit + small @ total / order
    for _ in range(6):
        total = total @ total
    return total


def log(a: Array) -> Array:
    """Principal matrix logarithm, (…, m, m): four square roots by Denman and Beavers, a series.

    scipy's serves one matrix at a time, in threads that wait for each other.
    """
    unit = np.eye(a.shape[-1])
    for _ in range(4):
        root, back = a, unit + np.zeros_like(a)
        for _ in range(9):
            root, back = (root + np.linalg.inv(back)) / 2, (back + np.linalg.inv(root)) / 2
        a = root
    z = (a - unit) @ np.linalg.inv(a + unit)
    total = np.zeros_like(a)
    for order in range(25, 0, -2):
        total = unit / order + z @ z @ total
    return np.asarray(2**5 * z @ total)
