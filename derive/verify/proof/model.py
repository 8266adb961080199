"""Models in which the formulas of the tangent bundle and of motions on a group are decided.

Words: a free group, where only what follows from the axioms holds. Elements: exact rational
elements of one group; a polynomial identity that holds there holds everywhere but with the
probability of meeting its zeros by chance (Schwartz and Zippel).
"""

from __future__ import annotations

import random
from functools import reduce
from typing import Any

import sympy
from sympy import Matrix, Rational, Symbol

from derive.lie.group import Group
from derive.verify.proof.exponential import one_parameter
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
    """Exact elements with a law that is odd on every group, and additive on none.

    x + x^3, entry by entry, of x = vee(g - g^-1)/4.
    """

    def __init__(self, group: Group, seed: int = 0) -> None:
        rng = random.Random(seed)
        self.group, self.name = group, group.name
        a, b, c = (State(element(group, rng), numbers(group.dim, rng)) for _ in range(3))
        self.states = (a, b, c)
        self.rest = State(a.g**0, sympy.zeros(group.dim, 1))

    def product(self, a: Matrix, b: Matrix) -> Matrix:
        """Of matrices."""
        return a * b

    def inverse(self, a: Matrix) -> Matrix:
        """The group's own."""
        return self.group.inverse(a)

    def drive(self, a: Matrix) -> Matrix:
        """lambda nu_u."""
        x = self.group.vee(a - self.inverse(a)) / 4
        return x + x.multiply_elementwise(x).multiply_elementwise(x)

    def entries(self, a: Matrix, nu: Matrix) -> list[Any]:
        """Of a - 1 and of nu."""
        return [*(a - a**0), *nu]


N = 2**61
"""How many values each free number may take, on either side of zero."""


def number(rng: random.Random) -> Rational:
    """A random rational number between -1 and 1, never 0."""
    return Rational(rng.choice((-1, 1)) * rng.randrange(1, N), N)


def numbers(size: int, rng: random.Random) -> Matrix:
    """Random rational numbers, (size, 1)."""
    return Matrix([number(rng) for _ in range(size)])


def element(group: Group, rng: random.Random) -> Matrix:
    """An exact element; ValueError for a group of which none is known.

    By Cayley's map of the algebra, or else as a product of one-parameter elements, one for each
    basis vector: such products fill a neighbourhood of the identity, and so miss nothing.
    """
    x = numbers(group.dim, rng)
    half = group.hat(x) / 2
    one = half**0
    if (one - half).det() != 0:
        g = Matrix((one - half).inv() * (one + half))
        if _is_element(group, g):
            return g
    g = reduce(Matrix.__mul__, (one_parameter(e, t) for e, t in zip(group.basis, x, strict=True)))
    if not _is_element(group, g):
        raise ValueError(f"{group.name}: the inverse, Ad or storage of exp(x) is not the group's")
    return g


def _is_element(group: Group, g: Matrix) -> bool:
    """Whether inverse, storage and Ad keep what they have to."""
    back = group.inverse(g)
    stored = group.store(g)
    if g * back != g**0 or Matrix(group.embed(stored)) != g or any(group.residual(stored)):
        return False
    return all(group.hat(group.vee(g * e * back)) == g * e * back for e in group.basis)
