"""Formulas read back: the text of every entry of every step is worth what the step is worth."""

import re
from random import Random

import pytest
import sympy
from sympy import Abs, Expr, Function, Piecewise, Rational, Symbol, pi, sqrt, symbols

from derive import pipeline
from derive.explain.formula import TALLEST, display, spell
from derive.explain.latex import LATEX
from derive.explain.mathml import MATHML
from derive.explain.notation import Notation, parts
from derive.explain.text import TEXT
from derive.lie.kernel import H, K, M
from derive.vehicle import Vehicle
from derive.vehicle.group import group_of
from tests.explain.subjects import SUBJECTS

a, b, w = symbols("a b w", real=True)
a_0, a_1, b_0, b_1, c_0, c_1 = symbols("a_0 a_1 b_0 b_1 c_0 c_1", real=True)
SIZES = {"a": 2, "b": 2, "c": 3}


def read(text: str) -> Expr:
    """Mathematics written by juxtaposition, as sympy reads it."""
    line = (
        re.sub(r"\|([^|]*)\|", r"Abs(\1)", text).replace("^", "**").replace("lambda", "rate_gain")
    )
    line = re.sub(r"(?<=[\w)]) (?=[\w(])", "*", line)
    names = {name: Symbol(name, real=True) for name in re.findall(r"[A-Za-z_]\w*(?!\w*\()", line)}
    known = {**{name: Function(name) for name in "khm"}, "Abs": Abs, "sqrt": sqrt, "pi": pi}
    called = {name: known[name] for name in known if f"{name}(" in line or name == "pi"}
    gain = Symbol("reach_gain", real=True)
    return sympy.sympify(line.replace("k_s", gain.name), {**names, gain.name: gain, **called})


def worth(value: Expr, seed: int) -> Expr:
    """At random numbers, the same for a name whatever else it stands with."""
    numbers = {
        symbol: Rational(Random(f"{seed}{symbol}").randint(1, 99), 100)
        for symbol in value.free_symbols
    }
    here = value.xreplace(numbers)
    for name, special in (("k", K), ("h", H), ("m", M)):
        here = here.replace(Function(name), special)
    return here.evalf(30)


@pytest.mark.parametrize("vehicle", SUBJECTS, ids=lambda v: v.name)
def test_every_entry_reads_back(vehicle: Vehicle) -> None:
    parts = pipeline.derivations(vehicle)
    entries = {
        entry
        for d in (parts.main, *parts.public)
        for step in d.steps
        for entry in step.formula
        if not entry.has(Piecewise)
    }
    assert len(entries) > 4 * group_of(vehicle).dim
    for entry in sorted(entries, key=str):
        text = spell(entry, TEXT)
        plain = entry.xreplace({s: Symbol(s.name, real=True) for s in entry.free_symbols})
        assert abs(worth(read(text), 1) - worth(plain, 1)) < 1e-20, text


@pytest.mark.parametrize(
    ("entries", "said"),
    [
        ((w * b_0, w * b_1), "a = w b"),
        ((w * b_0, w * b_0), "a_0 = w b_0\na_1 = w b_0"),
        ((w * b_0, b_1), "a_0 = w b_0\na_1 = b_1"),
        ((w * c_0, w * c_1), "a_0 = w c_0\na_1 = w c_1"),
        ((b_0, sympy.S.Zero), "a_0 = b_0\na_1 = 0"),
    ],
)
def test_a_vector_is_one_formula_only_where_all_entries_agree(
    entries: tuple[Expr, ...], said: str
) -> None:
    assert display("a", entries, SIZES, TEXT) == said


def test_cases_are_shown_with_their_conditions() -> None:
    choice = [(w > 0) & (b >= 1), w < 0]
    pieces = [
        ((b_0, choice[0]), (b_1, choice[1]), (0, True)),
        ((1, choice[0]), (2, choice[1]), (3, True)),
    ]
    entries = [Piecewise(*rows, evaluate=False) for rows in pieces]
    assert display("a", entries, SIZES, TEXT) == (
        "a = \n    (b_0, 1)  if b >= 1 and w > 0\n    (b_1, 2)  if w < 0\n    (0, 3)    otherwise"
    )
    assert r"\begin{cases} \begin{pmatrix} b_{0} \\ 1 \end{pmatrix}" in display(
        "a", entries, SIZES, LATEX
    )
    assert "<mo>&lt;</mo>" in display("a", entries, SIZES, MATHML)


@pytest.mark.parametrize("n", [LATEX, MATHML], ids=["latex", "mathml"])
def test_a_long_sum_is_broken_and_nothing_is_lost(n: Notation) -> None:
    terms = symbols(" ".join(f"long_name_{i}" for i in range(20)), real=True)
    shown = display("w", [sympy.Add(*terms)], {}, n)
    assert all(n.symbol(f"long_name_{i}") in shown for i in range(20))
    assert shown.count("<mtr>" if n is MATHML else r"&\quad +") >= 3


@pytest.mark.parametrize(("size", "is_column"), [(TALLEST, True), (TALLEST + 1, False)])
def test_a_column_is_no_taller_than_a_page(size: int, is_column: bool) -> None:
    entries = [Symbol(f"b_{i}", real=True) + i for i in range(size)]
    shown = display("a", entries, {"a": size}, LATEX)
    assert ("pmatrix" in shown) == is_column
    assert ("align*" in shown) != is_column
    assert all(f"b_{{{i}}}" in shown for i in range(size))


@pytest.mark.parametrize(
    ("value", "text", "latex"),
    [
        (a * (1 - w) / b, "a (1 - w)/b", r"\frac{a\,\left(1 - w\right)}{b}"),
        (1 / (a * b), "1/(a b)", r"\frac{1}{a\,b}"),
        (a / 2 - b / 2, "1/2 (a - b)", r"\frac{1}{2}\,\left(a - b\right)"),
        (-a - b, "-a - b", "-a - b"),
        (-(a**2) * b, "-b a^2", r"-b\,a^{2}"),
        ((a + b) ** 2, "(a + b)^2", r"\left(a + b\right)^{2}"),
        (a**-2, "1/a^2", r"\frac{1}{a^{2}}"),
        (sqrt(a + 1), "sqrt(1 + a)", r"\sqrt{1 + a}"),
        (Abs(w), "|w|", r"\left|w\right|"),
        (K(w), "k(w)", r"k\left(w\right)"),
        (pi / a, "pi/a", r"\frac{\pi}{a}"),
    ],
)
def test_precedence(value: Expr, text: str, latex: str) -> None:
    assert spell(value, TEXT) == text
    assert spell(value, LATEX) == latex


def test_what_no_rule_spells_is_refused() -> None:
    with pytest.raises(TypeError, match="no rule spells"):
        spell(sympy.I, TEXT)


@pytest.mark.parametrize(
    ("name", "read_as", "latex"),
    [
        ("nu_e", ("nu", ("e",), False), r"\nu_{e}"),
        ("nu_r_dot_2", ("nu", ("r", "2"), True), r"\dot{\nu}_{r,2}"),
        ("eta_dot", ("eta", (), True), r"\dot{\eta}"),
        ("to_body_7", ("to body", ("7",), False), r"\mathrm{to~body}_{7}"),
        ("k_near", ("k", ("near",), False), r"k_{\mathrm{near}}"),
        ("rate_gain", ("lambda", (), False), r"\lambda"),
        ("reach_gain", ("k", ("s",), False), "k_{s}"),
        ("lower_10", ("lower", ("10",), False), r"\mathrm{lower}_{10}"),
    ],
)
def test_a_name_is_read_as_the_papers_symbol(
    name: str, read_as: tuple[str, tuple[str, ...], bool], latex: str
) -> None:
    assert parts(name) == read_as
    assert LATEX.symbol(name) == latex


@pytest.mark.parametrize("n", [LATEX, MATHML], ids=["latex", "mathml"])
def test_a_long_sum_is_broken_within_a_product(n: Notation) -> None:
    terms = symbols(" ".join(f"long_name_{i}" for i in range(20)), real=True)
    shown = display("w", [(sympy.Add(*terms)) / c_0], {}, n)
    assert all(n.symbol(f"long_name_{i}") in shown for i in range(20))
    over = n.fraction % (n.symbol("1"), n.symbol("c_0"))
    assert over + n.product + n.opening in shown
    assert shown.count(n.opening) == shown.count(n.closing) == 1
    assert shown.index(n.opening) < shown.index(n.closing)
