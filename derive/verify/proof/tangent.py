"""The tangent bundle as a group: Lemmas 1 and 2, Remark 1, and the sliding variable.

The operation star is written once, over a model of G x g: words over free letters with nu_u
uninterpreted, which proves the lemmas for every group and every kinematic law at once, or exact
elements of one group.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

from derive.verify.proof.statement import Fact, Statement, vanish


class State(NamedTuple):
    """A point (g, nu) of TG."""

    g: Any
    nu: Any


class Model(Protocol):
    """A group with lambda nu_u on it, and three states in general position."""

    name: str
    states: tuple[State, State, State]
    rest: State

    def product(self, a: Any, b: Any) -> Any:
        """Of two elements."""

    def inverse(self, a: Any) -> Any:
        """Of an element."""

    def drive(self, a: Any) -> Any:
        """lambda nu_u(a), with properties (i) and (ii) of the Definition and no other."""

    def entries(self, a: Any, nu: Any) -> list[Any]:
        """Numbers that all vanish only if a = e and nu = 0."""


@dataclass(frozen=True)
class Bundle:
    """The paper's formulas on TG."""

    star: Callable[[Model, State, State], State]
    inverse: Callable[[Model, State], State]
    s: Callable[[Model, State], Any]


def star(m: Model, a: State, b: State) -> State:
    """(g1 g2, nu1 + nu2 + lambda (nu_u(g1) + nu_u(g2) - nu_u(g1 g2))); eq. (BnyOp)."""
    g = m.product(a.g, b.g)
    return State(g, a.nu + b.nu + m.drive(a.g) + m.drive(b.g) - m.drive(g))


def naive(m: Model, a: State, b: State) -> State:
    """(g1 g2, nu1 + nu2), rem. (Lem1)."""
    return State(m.product(a.g, b.g), a.nu + b.nu)


BUNDLE = Bundle(
    star,
    inverse=lambda m, h: State(m.inverse(h.g), -h.nu),
    s=lambda m, h: h.nu + m.drive(h.g),
)


def _same(m: Model, what: str, a: State, b: State) -> Fact:
    return vanish(what, m.entries(m.product(m.inverse(a.g), b.g), a.nu - b.nu))


def _sliding(m: Model, h: State) -> State:
    """The state of H above g."""
    return State(h.g, -m.drive(h.g))


def _is_group(m: Model, claim: Bundle) -> Iterator[Fact]:
    times, a, f = claim.star, m.states[0], m.rest
    yield _same(m, "h f = h", times(m, a, f), a)
    yield _same(m, "f h = h", times(m, f, a), a)
    yield _same(m, "h h^-1 = f", times(m, a, claim.inverse(m, a)), f)
    yield _same(m, "h^-1 h = f", times(m, claim.inverse(m, a), a), f)
    yield from _is_associative(m, claim)


def _is_associative(m: Model, claim: Bundle) -> Iterator[Fact]:
    times, (a, b, c) = claim.star, m.states
    left, right = times(m, times(m, a, b), c), times(m, a, times(m, b, c))
    yield _same(m, "(a b) c = a (b c)", left, right)


def _is_subgroup(m: Model, claim: Bundle) -> Iterator[Fact]:
    a, b = (_sliding(m, h) for h in m.states[:2])
    for what, h in (
        ("f is in H", m.rest),
        ("h^-1 is in H", claim.inverse(m, a)),
        ("h1 h2 is in H", claim.star(m, a, b)),
    ):
        yield vanish(what, m.entries(m.rest.g, claim.s(m, h)))


def _is_not_closed(m: Model, claim: Bundle) -> Iterator[Fact]:
    yield from _is_associative(m, claim)
    a, b = m.states[:2]
    product = claim.star(m, _sliding(m, a), _sliding(m, b))
    inside = vanish("", m.entries(m.rest.g, claim.s(m, product)))
    yield Fact("h1 h2 leaves H for some h1, h2 of H", not inside.holds)


def _is_homomorphism(m: Model, claim: Bundle) -> Iterator[Fact]:
    a, b = m.states[:2]
    off = claim.s(m, claim.star(m, a, b)) - claim.s(m, a) - claim.s(m, b)
    yield vanish("s(h1 h2) = s(h1) + s(h2)", m.entries(m.rest.g, off))
    back = claim.s(m, claim.inverse(m, a)) + claim.s(m, a)
    yield vanish("s(h^-1) = -s(h)", m.entries(m.rest.g, back))


def _with(formula: Callable[[Model, State, State], State]) -> Bundle:
    return Bundle(formula, BUNDLE.inverse, BUNDLE.s)


def _added(m: Model, a: State, b: State) -> State:
    """Star with the sign of its last term changed."""
    h = star(m, a, b)
    return State(h.g, h.nu + m.drive(h.g) + m.drive(h.g))


def _lopsided(m: Model, a: State, b: State) -> State:
    """Star without nu_u(g2)."""
    h = star(m, a, b)
    return State(h.g, h.nu - m.drive(b.g))


_HARMED = {
    "the sign of nu_u(g1 g2)": _with(_added),
    "without nu_u(g2)": _with(_lopsided),
    "inverse (g^-1, nu)": Bundle(star, lambda m, h: State(m.inverse(h.g), h.nu), BUNDLE.s),
}
_FLIPPED = {
    "the sign of lambda in s": Bundle(star, BUNDLE.inverse, lambda m, h: h.nu - m.drive(h.g))
}
_WORDS = "words, nu_u uninterpreted"

STATEMENTS = (
    Statement(
        "Lemma 1: (TG, star) is a group", "lem. 1 (LieGroup)", _WORDS, "tangent", _is_group, BUNDLE,
        _HARMED,
    ),
    Statement(
        "star is associative whatever nu_u is", "rem. (Associativity)", "words, nu_u any map",
        "bundle", _is_associative, BUNDLE,
        {
            "the sign of nu_u(g1 g2)": _with(_added),
            "without nu_u(g2)": _with(_lopsided),
        },
    ),
    Statement(
        "Remark 1: with (g1 g2, nu1 + nu2), H is not closed", "rem. (Lem1)", _WORDS, "closure",
        _is_not_closed, _with(naive),
        {"star in its place": BUNDLE, "without nu_u(g2)": _with(_lopsided)},
    ),
    Statement(
        "Lemma 2: H is a subgroup", "lem. 2 (LieSubGroup)", _WORDS, "tangent", _is_subgroup, BUNDLE,
        _HARMED | _FLIPPED | {"(g1 g2, nu1 + nu2)": _with(naive)},
    ),
    Statement(
        "s: (TG, star) -> (g, +) is a homomorphism", "eq. (sldS)", _WORDS, "tangent",
        _is_homomorphism, BUNDLE, _HARMED | _FLIPPED,
    ),
)  # fmt: skip
"""Statements about the tangent bundle."""
