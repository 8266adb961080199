"""Groups in numpy, over batches: stored numbers, matrices, flows. For states and differences."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
Matrices = list[Array]  # one (N, m, m) per factor

TAYLOR = 20


@dataclass(frozen=True)
class Block:
    """Coordinates that are judged together: a rotation, one translation, or all of a group."""

    rows: slice
    factor: int
    kind: str  # "turn", "shift" or "own"


@dataclass(frozen=True)
class Shape:
    """One factor: matrices [[B, T], [0, 1]], or whatever a basis spans.

    turns: coordinates of the rotation; size: of B; columns: of T; is_half: B is a quaternion's
    left product, kept as its first column; basis: (n, m, m)
    """

    turns: int
    size: int
    columns: int
    basis: Array
    is_half: bool = False
    is_own: bool = False

    @property
    def is_vector(self) -> bool:
        """R^n, kept as its n numbers."""
        return not self.turns and not self.is_own

    @property
    def stored(self) -> int:
        """k, how many numbers are kept."""
        return self.size if self.is_half or self.is_vector else self.basis.shape[-1] ** 2

    def matrix(self, kept: Array) -> Array:
        """Stored numbers (N, k) to matrices (N, m, m)."""
        m = self.basis.shape[-1]
        if self.is_vector:
            whole = np.tile(np.eye(m, dtype=kept.dtype), (len(kept), 1, 1))
            whole[:, :-1, -1] = kept
            return whole
        if self.is_half:
            return np.asarray(kept[:, :1, None] * np.eye(4) + 2 * self.hat(kept[:, 1:]))
        return kept.reshape(-1, m, m)

    def kept(self, g: Array) -> Array:
        """The other way round."""
        if self.is_vector:
            return g[:, :-1, -1]
        return g[:, :, 0] if self.is_half else g.reshape(len(g), -1)

    def hat(self, x: Array) -> Array:
        """Coordinates (N, n) to matrices (N, m, m)."""
        return np.asarray(np.einsum("ni,ijk->njk", x, self.basis))

    def vee(self, a: Array) -> Array:
        """Matrices of the algebra to coordinates."""
        flat = self.basis.reshape(len(self.basis), -1)
        return np.asarray(a.reshape(len(a), -1) @ np.linalg.pinv(flat))

    def holds_one(self) -> bool:
        """Whether the unit matrix is in the algebra, and so every multiple in the group."""
        one = np.eye(self.basis.shape[-1])[None]
        return bool(np.allclose(self.hat(self.vee(one)), one))

    def is_fixed(self) -> Array:
        """Stored numbers, (k,), none of which may be changed alone without leaving the group."""
        if self.is_vector or self.is_own:
            return np.zeros(self.stored, dtype=bool)
        if self.is_half:
            return np.ones(4, dtype=bool)
        m = self.size + self.columns
        free = (np.arange(m)[:, None] < self.size) & (np.arange(m)[None, :] >= self.size)
        return np.asarray(~free.ravel())


def cross_matrix(x: Array) -> Array:
    """x^, (N, 3, 3), of vectors (N, 3): x^ y = x times y."""
    zero = np.zeros_like(x[:, 0])
    rows = ((zero, -x[:, 2], x[:, 1]), (x[:, 2], zero, -x[:, 0]), (-x[:, 1], x[:, 0], zero))
    return np.stack([np.stack(row, -1) for row in rows], -2)


def _carrying(turns: Array, columns: int) -> Shape:
    """Rotations by `turns`, (n, size, size), and `columns` vectors that they carry."""
    size = turns.shape[-1]
    basis = np.zeros((len(turns) + size * columns, size + columns, size + columns))
    basis[: len(turns), :size, :size] = turns
    for j in range(columns):
        for i in range(size):
            basis[len(turns) + j * size + i, i, size + j] = 1
    return Shape(len(turns), size, columns, basis)


_SPACE = cross_matrix(np.eye(3))
_PLANE = _SPACE[2:, :2, :2]
_LEFT = np.zeros((3, 4, 4))
_LEFT[:, 1:, 1:], _LEFT[:, 0, 1:], _LEFT[:, 1:, 0] = _SPACE, -np.eye(3), np.eye(3)

_SHAPES = {
    "SO2": _carrying(_PLANE, 0),
    "SE2": _carrying(_PLANE, 1),
    "SO3": _carrying(_SPACE, 0),
    "SE3": _carrying(_SPACE, 1),
    "SE23": _carrying(_SPACE, 2),
    "S3": Shape(3, 4, 0, _LEFT / 2, is_half=True),
}


def _shape(name: str) -> Shape:
    if vectors := re.fullmatch(r"R([1-9]\d?)", name):
        return _carrying(np.zeros((0, int(vectors[1]), int(vectors[1]))), 1)
    return _SHAPES[name]


class Space:
    """A group as its factors, over batches."""

    def __init__(self, shapes: Sequence[Shape]) -> None:
        self.shapes = tuple(shapes)
        self.dim = sum(len(one.basis) for one in shapes)

    @property
    def element(self) -> tuple[int, ...]:
        """Shape of an element as the numpy module takes it."""
        first = self.shapes[0]
        m = first.basis.shape[-1]
        if len(self.shapes) > 1 or first.is_vector or first.is_half:
            return (sum(one.stored for one in self.shapes),)
        return (m, m)

    def blocks(self) -> Iterator[Block]:
        """Coordinates in order: rotation, then each translation, of each factor."""
        start = 0
        for place, one in enumerate(self.shapes):
            sizes = [("turn", one.turns), *(("shift", one.size),) * one.columns]
            for kind, size in [("own", len(one.basis))] if one.is_own else sizes:
                if size:
                    yield Block(slice(start, start + size), place, kind)
                    start += size

    def split(self, x: Array, sizes: Sequence[int]) -> Matrices:
        """Columns of (N, sum of sizes) in consecutive pieces."""
        return np.split(x, np.cumsum(sizes)[:-1], axis=1)

    def velocities(self, x: Array) -> Matrices:
        """Coordinates of each factor."""
        return self.split(x, [len(one.basis) for one in self.shapes])

    def matrices(self, kept: Array) -> Matrices:
        """Stored numbers (N, k) to one matrix per factor."""
        pieces = self.split(kept, [one.stored for one in self.shapes])
        return [one.matrix(piece) for one, piece in zip(self.shapes, pieces, strict=True)]

    def kept(self, g: Matrices) -> Array:
        """The other way round."""
        return np.hstack([one.kept(a) for one, a in zip(self.shapes, g, strict=True)])

    def hat(self, x: Array) -> Matrices:
        """Coordinates (N, n) to matrices."""
        pairs = zip(self.shapes, self.velocities(x), strict=True)
        return [one.hat(piece) for one, piece in pairs]

    def vee(self, a: Matrices) -> Array:
        """Matrices of the algebra to coordinates (N, n)."""
        return np.hstack([one.vee(x) for one, x in zip(self.shapes, a, strict=True)])

    def error(self, g_r: Array, g: Array) -> Matrices:
        """g_r^-1 g, from stored numbers."""
        pairs = zip(self.matrices(g_r), self.matrices(g), strict=True)
        return [np.linalg.solve(a, b) for a, b in pairs]

    def pull(self, g: Matrices, x: Array) -> Array:
        """Ad of g^-1 on velocities (N, n)."""
        return self.vee([np.linalg.solve(a, b @ a) for a, b in zip(g, self.hat(x), strict=True)])

    def flowed(self, kept: Array, x: Array) -> Array:
        """Stored numbers of g exp(hat(x))."""
        pairs = zip(self.matrices(kept), self.hat(x), strict=True)
        return self.kept([a @ expm(b) for a, b in pairs])

    def tangent(self, kept: Array, nu: Array) -> Array:
        """Rates of the stored numbers along g hat(nu)."""
        pairs = zip(self.shapes, self.matrices(kept), self.hat(nu), strict=True)
        return np.hstack([one.kept(a @ b) for one, a, b in pairs])

    def structure(self) -> Array:
        """c[i, j, k]: the i-th coordinate of [E_j, E_k], (n, n, n)."""
        unit = np.eye(self.dim)
        return np.stack([self._brackets(np.tile(e, (self.dim, 1)), unit).T for e in unit], 1)

    def _brackets(self, x: Array, y: Array) -> Array:
        pairs = zip(self.hat(x), self.hat(y), strict=True)
        return self.vee([a @ b - b @ a for a, b in pairs])

    def coad(self, x: Array, momentum: Array) -> Array:
        """ad*_x of a momentum, (N, n): <ad*_x a; y> = <a; [x, y]>."""
        return np.asarray(np.einsum("ni,ijk,nj->nk", momentum, self.structure(), x))


def expm(a: Array) -> Array:
    """exp of matrices (N, m, m) by scaling, Taylor's series and squaring."""
    size = float(np.abs(a).sum(-1).max(initial=0.0))
    halvings = max(0, int(np.ceil(np.log2(size))) + 1) if size > 0 else 0
    scaled = a / 2.0**halvings
    total = term = np.broadcast_to(np.eye(a.shape[-1]), a.shape)
    for order in range(1, TAYLOR):
        term = term @ scaled / order
        total = total + term
    for _ in range(halvings):
        total = total @ total
    return np.asarray(total)


@cache
def space(of: Any) -> Space:
    """The group of a name, or of the exact basis of a user's."""
    if isinstance(of, str):
        return Space([_shape(name) for name in of.split(" x ")])
    basis = np.array([[[float(x) for x in row] for row in e] for e in of])
    return Space([Shape(0, 0, 0, basis, is_own=True)])
