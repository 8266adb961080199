"""The lengths against which errors are judged: natural scales, block by block.

A rotation is judged on the scale of an angle; a translation of the logarithm on that of p, of a
rate on |v| + |p||omega|; a user's group, whose blocks are not known, on the length of its terms.
What is a sum, s and the force, has the length of its terms, where these cancel.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify.limits import LIMITS
from derive.verify.plant import Plant
from derive.verify.sample import States
from derive.verify.shape import Block, space
from derive.verify.term import TERMS

Array = NDArray[Any]

HALVES = ("half_log", "lee", "sign_vec")
"""Laws that grow with half the angle: their natural scale is half that of the others."""


def lengths(blocks: tuple[Block, ...], x: Array) -> Array:
    """Length of each block of (N, n), (N, blocks)."""
    whole = np.asarray(x, np.float64)
    return np.stack([np.linalg.norm(whole[:, block.rows], axis=-1) for block in blocks], -1)


def blocks_of(vehicle: Plant) -> tuple[Block, ...]:
    """What is judged together."""
    return tuple(space(vehicle.space).blocks())


@dataclass(frozen=True)
class Natural:
    """Scales of a batch, (N, blocks) each.

    sine:    of half the angle of each factor's rotation, (N, factors); 0 where nothing turns
    outputs: of the truth: nu_u, nu_u_dot, and eta, nu_e, eta_dot on the move
    """

    vehicle: Plant
    states: States
    sine: Array
    outputs: dict[str, Array]

    def scales(self) -> dict[str, Array]:
        """Of every output, (N, blocks)."""
        s, push = TERMS[self.vehicle.controller](self)
        push = push + self.length("external")
        return {
            "nu_u": self.value,
            "nu_u_dot": self.rate,
            "s": s,
            "force": push / LIMITS["cancellation"].figure,
        }

    def terms(self) -> dict[str, Array]:
        """Of derivatives along the flow, (N, blocks): how far their inputs round."""
        nu, given = (lengths(self.blocks, x) for x in (self.states.nu, self.states.nu_r_dot))
        speed, reference = self.speed, self.reference
        growth = self._swept(given) * self.spread + self._bracket(speed, reference)
        force = self.flat(growth + sum(self.gains) * speed)
        rate = self._swept((nu + reference) / 2) * self.spread
        # What was found at rest is a force, less what the structure constants make of eta and nu.
        at_rest = np.einsum("ni,ijk,nj->nk", nu, self._structure, reference)
        return {"nu_u_dot": rate, "eta_dot": np.maximum(growth, at_rest), "force": force}

    def stepped(self) -> dict[str, Array]:
        """As terms, of differences: their step is an arc of the whole velocity, not of a block."""
        terms, whole = self.terms(), np.linalg.norm(self.speed, axis=-1, keepdims=True)
        rate = np.maximum(terms["nu_u_dot"], self.of("nu_u") * (whole - self.speed))
        return terms | {
            "nu_u_dot": rate,
            "eta_dot": np.maximum(terms["eta_dot"], self.reference * whole),
        }

    def acceleration(self, force: Array) -> Array:
        """Of nu_dot under a force (N, n): of its terms, where they cancel, (N, blocks)."""
        pushed = lengths(self.blocks, force) + lengths(self.blocks, self.states.external)
        pushed = pushed + self.carried(lengths(self.blocks, self.states.nu))
        sharp = np.linalg.inv(np.array(self.vehicle.stored("f64")[0]))
        return self._mapped(sharp, pushed) / LIMITS["cancellation"].figure

    @property
    def gains(self) -> tuple[float, ...]:
        """Gains in double."""
        return self.vehicle.stored("f64")[1]

    @property
    def is_moving(self) -> bool:
        """Whether the reference moves."""
        return bool(self.states.nu_r.any())

    def length(self, name: str) -> Array:
        """Of what a state holds."""
        return lengths(self.blocks, getattr(self.states, name))

    def of(self, name: str) -> Array:
        """Of an output of the truth; zero where it has none of that name."""
        if name in self.outputs:
            return lengths(self.blocks, self.outputs[name])
        return np.zeros((len(self.states.angle), len(self.blocks)))

    @cached_property
    def blocks(self) -> tuple[Block, ...]:
        """What is judged together."""
        return blocks_of(self.vehicle)

    @cached_property
    def value(self) -> Array:
        """Of the law: twice the sine of half the angle, |p|, the terms of a user's group."""
        unit = 0.5 if self.vehicle.law in HALVES else 1.0
        turn = 2 * unit * self.sine[:, [block.factor for block in self.blocks]]
        return self._by_kind(turn, self.arm, self._terms)

    @cached_property
    def rate(self) -> Array:
        """Of its rate: |omega|, |v| + |p||omega|."""
        unit = 0.5 if self.vehicle.law in HALVES else 1.0
        return self._by_kind(unit * self.speed, self._swept(self.speed), self.speed * self.spread)

    @cached_property
    def speed(self) -> Array:
        """Of nu_e: of a rotation its own; of a translation that of its terms."""
        if "nu_e" not in self.outputs:
            return lengths(self.blocks, self.states.nu)
        terms = lengths(self.blocks, self.states.nu) + self.reference
        return self._by_kind(self.of("nu_e"), terms, terms)

    @cached_property
    def reference(self) -> Array:
        """Of eta."""
        given = lengths(self.blocks, self.states.nu_r)
        return self._by_kind(given, self._swept(given), given * self.spread)

    @cached_property
    def growth(self) -> Array:
        """Of its rate."""
        given, own = lengths(self.blocks, self.states.nu_r_dot), self.of("eta_dot")
        if not given.any():
            return own
        terms = self._swept(given) + self._bracket(self.speed, self.reference)
        return self._by_kind(own, terms, given * self.spread + self.speed * self.reference)

    @cached_property
    def arm(self) -> Array:
        """|p| of a translation, 1 rad of a rotation; of a user's group the length of g."""
        moved = np.hstack([
            np.linalg.norm(a[:, : one.size, one.size :], axis=1) if one.columns
            else np.ones((len(a), 0))
            for one, a in zip(self._space.shapes, self._error, strict=True)
        ])  # fmt: skip
        whole = np.ones((len(self.states.angle), len(self.blocks)))
        whole[:, [block.kind == "shift" for block in self.blocks]] = moved
        return self._by_kind(np.ones_like(whole), whole, self.spread)

    @cached_property
    def spread(self) -> Array:
        """|g||g^-1| of the error of a user's group, by which Ad and a product can grow; else 1."""
        whole = np.ones((len(self.states.angle), len(self.blocks)))
        for one, a, r in zip(self._space.shapes, self._error, self._start, strict=True):
            if one.is_own:
                whole[:] = (_condition(a) * _condition(r))[:, None]
        return whole

    @cached_property
    def _terms(self) -> Array:
        """|g| + |g^-1| in the entries that vee reads, what the law of a user's group is made of."""
        (one, *_), (g, *_) = self._space.shapes, self._error
        read = one.basis.any(0)
        off = [np.linalg.norm(a * read, axis=(1, 2)) for a in (g, np.linalg.inv(g))]
        return np.asarray((off[0] + off[1])[:, None] * self.spread)

    @property
    def _space(self) -> Any:
        return space(self.vehicle.space)

    @cached_property
    def _error(self) -> list[Array]:
        g_r, g = (x.astype(np.float64) for x in (self.states.g_r, self.states.g))
        return list(self._space.error(g_r, g))

    @cached_property
    def _start(self) -> list[Array]:
        return list(self._space.matrices(self.states.g_r.astype(np.float64)))

    def _by_kind(self, turn: Array, shift: Array, own: Array) -> Array:
        kinds = np.array([block.kind for block in self.blocks])
        return np.asarray(np.where(kinds == "turn", turn, np.where(kinds == "shift", shift, own)))

    def _swept(self, x: Array) -> Array:
        """|v| + |p||omega|, from lengths of a velocity."""
        return np.asarray(x + self.arm * self._turning(x))

    def _turning(self, x: Array) -> Array:
        """Of each block, the length of its factor's rotation."""
        factor, kind = ([getattr(b, what) for b in self.blocks] for what in ("factor", "kind"))
        each = [
            next((x[:, i] for i, f in enumerate(factor) if f == mine and kind[i] == "turn"),
                 np.zeros(len(x)))
            for mine in factor
        ]  # fmt: skip
        return np.stack(each, -1)

    def _bracket(self, x: Array, y: Array) -> Array:
        """Of [x, y], from lengths, (N, blocks)."""
        return np.asarray(np.einsum("ni,ijk,nj->nk", x, self._structure.transpose(1, 2, 0), y))

    def carried(self, x: Array, nu: Array | None = None) -> Array:
        """Of ad*_x (I nu + momentum), from lengths of x and of nu, which is the state's."""
        whole = self.flat(self.length("nu") if nu is None else nu) + self.length("momentum")
        return np.asarray(np.einsum("ni,ijk,nj->nk", whole, self._structure, x))

    @cached_property
    def _structure(self) -> Array:
        """Largest structure constant of each triple of blocks."""
        return self._largest(np.abs(self._space.structure()))

    def _largest(self, c: Array) -> Array:
        rows = [block.rows for block in self.blocks]
        return np.array([[[c[i, j, k].max() for k in rows] for j in rows] for i in rows])

    def flat(self, x: Array) -> Array:
        """Of I x, from lengths of x."""
        return self._mapped(np.array(self.vehicle.stored("f64")[0]), x)

    def _mapped(self, matrix: Array, x: Array) -> Array:
        """Of a matrix times x, from lengths of x."""
        rows = [block.rows for block in self.blocks]
        sizes = [[np.linalg.norm(matrix[i, j], 2) for j in rows] for i in rows]
        return np.asarray(x @ np.array(sizes).T)


def _condition(a: Array) -> Array:
    """|a||a^-1| of matrices (N, m, m)."""
    return np.asarray(np.linalg.cond(a.astype(np.float64)))
