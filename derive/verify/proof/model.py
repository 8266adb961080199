"""Models in which the formulas of the tangent bundle and of motions on a group are decided.

Words: a free group, where only what follows from the axioms holds. Elements: exact rational
elements of one group, reached by Cayley's map; a polynomial identity that holds there holds
everywhere but with the probability of meeting its zeros by chance (Schwartz and Zippel).
"""

from __future__ import annotations

import random
from typing import Any

import sympy
from sympy import Matrix, Rational, Symbol

from derive.lie.group import Group
from derive.verify.proof.tangent import State

Word = tuple[tuple[str, int], ...]


class Words:
    """Reduced words in free letters; lambda nu_u of a word is a symbol.

    is_law: it is 0 at the empty word and odd, properties (i) and (ii); otherwise it is anything
    """

    name = "any group"

    def __init__(self, *, is_law: bool = True) -> None:
        self.is_law = is_law
        a, b, c = (State(((letter, 1),), Symbol(f"nu_{letter}")) for letter in "abc")
        self.states, self.rest = (a, b, c), State((), sympy.S.Zero)

    def product(self, a: Word, b: Word) -> Word:
        """One after the other, with x x^-1 struck out where they meet."""
        while a and b and a[-1] == (b[0][0], -b[0][1]):
            a, b = a[:-1], b[1:]
        return a + b

    def inverse(self, a: Word) -> Word:
        """Backwards, each letter inverted."""
        return tuple((letter, -power) for letter, power in reversed(a))

    def drive(self, a: Word) -> sympy.Expr:
        """lambda nu_u, and nothing known of it but what is_law says."""
        if not self.is_law:
            return Symbol(f"lambda nu_u{a}")
        if not a:
            return sympy.S.Zero
        first = max(a, self.inverse(a))
        return (1 if a == first else -1) * Symbol(f"lambda nu_u{first}")

    def entries(self, a: Word, nu: sympy.Expr) -> list[Any]:
        """The length of the word and the formal sum."""
        return [len(a), nu]


class Elements:
    """Exact elements of a group with the law vee(g - g^-1)/2, which is odd on every group."""

    def __init__(self, group: Group, seed: int = 0) -> None:
        rng = random.Random(seed)
        self.group, self.name = group, group.name
        a, b, c = (State(element(group, rng), vector(group.dim, rng)) for _ in range(3))
        self.states = (a, b, c)
        self.rest = State(a.g**0, sympy.zeros(group.dim, 1))

    def product(self, a: Matrix, b: Matrix) -> Matrix:
        """Of matrices."""
        return a * b

    def inverse(self, a: Matrix) -> Matrix:
        """The group's own."""
        return self.group.inverse(a)

    def drive(self, a: Matrix) -> Matrix:
        """lambda nu_u with lambda = 1/2."""
        return self.group.vee(a - self.inverse(a)) / 4

    def entries(self, a: Matrix, nu: Matrix) -> list[Any]:
        """Of a - 1 and of nu."""
        return [*(a - a**0), *nu]


def element(group: Group, rng: random.Random) -> Matrix:
    """An exact element (1 - X/2)^-1 (1 + X/2), X = hat(x) with random rational x.

    ValueError where that is not on the group: it is on every group that keeps a bilinear form or
    is affine over one.
    """
    half = group.hat(vector(group.dim, rng)) / 2
    one = half**0
    g = Matrix((one - half).inv() * (one + half))
    back = group.inverse(g)
    stays = all(group.hat(group.vee(g * e * back)) == g * e * back for e in group.basis)
    if g * back != one or Matrix(group.embed(group.store(g))) != g or not stays:
        raise ValueError(f"{group.name}: Cayley's map of its algebra does not lead into the group")
    return g


def vector(size: int, rng: random.Random) -> Matrix:
    """Rational numbers between -9/7 and 9/7, (size, 1)."""
    return Matrix([Rational(rng.randint(-9, 9), 7) for _ in range(size)])
