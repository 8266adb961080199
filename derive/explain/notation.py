"""What a way to spell mathematics consists of, and how a name of the code is read as a symbol.

Entries of a record are patterns for `%`; what they take is spelled already.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

GREEK = {
    "lambda": "λ",
    "eta": "η",
    "kappa": "κ",
    "nu": "ν",
    "rho": "ρ",
    "phi": "φ",
    "sigma": "σ",
    "theta": "θ",
    "pi": "π",
    "Omega": "Ω",
}
"""Words that are letters of the paper."""

RENAMED = {"rate_gain": "lambda", "reach_gain": "k_s"}
"""Names that the code spells out, as the paper has them."""

Cases = Sequence[tuple[str, str]]
"""(value, condition), the last condition empty."""


@dataclass(frozen=True)
class Notation:
    """One way to spell a formula.

    is_flat: a quotient stands on the line, and its parts need parentheses
    minus, less: the sign of one term, and between two
    width:   of a line of a formula, in characters of its text; of a column's entry as well
    relations: operators of conditions that are spelled in another way
    opening, closing: parentheses around several lines
    single, rows: a displayed formula, of one line or of (left, right) lines
    plain, code: a sentence and a line of C as the document takes them
    """

    symbol: Callable[[str], str]
    is_flat: bool
    width: int
    product: str
    plus: str
    minus: str
    less: str
    fraction: str
    power: str
    root: str
    absolute: str
    group: str
    opening: str
    closing: str
    call: str
    prime: str
    actions: dict[str, str]
    relation: str
    relations: dict[str, str]
    both: str
    column: Callable[[Sequence[str]], str]
    matrix: Callable[[Sequence[Sequence[str]]], str]
    cases: Callable[[Cases], str]
    single: str
    rows: Callable[[Sequence[tuple[str, str]]], str]
    plain: Callable[[str], str]
    code: Callable[[str], str]


def parts(name: str) -> tuple[str, tuple[str, ...], bool]:
    """Base, subscripts and whether dotted: nu_r_dot_0 is (nu, (r, 0), True).

    A name that begins with a word of its own keeps all of its words, but not the letters that
    mark it: to_body_a_3 is (to body, (a, 3), False).
    """
    base, *rest = RENAMED.get(name, name).split("_")
    is_dotted = "dot" in rest
    rest = [part for part in rest if part != "dot"]
    is_word = len(base) > 1 and base not in GREEK
    while is_word and rest and len(rest[0]) > 1 and not rest[0].isdigit():
        base = f"{base} {rest.pop(0)}"
    return base, tuple(rest), is_dotted


def conditions(cases: Cases, when: str, otherwise: str) -> list[tuple[str, str]]:
    """Each value with its condition in words."""
    return [(value, when % condition if condition else otherwise) for value, condition in cases]
