"""Bounds of the kernel polynomials: true, sharp, and sensitive to the code that they judge."""

import shutil
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest

from derive.evidence import bound, exhaust, polynomial, truncation
from derive.evidence.emitted import Emitted
from derive.evidence.polynomial import Polynomial
from derive.evidence.rounding import GAPPA, rounding
from derive.evidence.tool import ToolMissing
from tests.evidence.tools import had, hide

GENERATED = Path(__file__).parents[2] / "generated"
FLOAT = Emitted(GENERATED / "underwater", "underwater", "f32")  # whose law needs k, h and m
DOUBLE = replace(FLOAT, scalar="f64")
COARSE = 1 << 14
ORDERS = truncation.ORDERS

every_kernel = pytest.mark.parametrize("name", ORDERS)


def kernel(one: Emitted, name: str) -> Polynomial:
    return next(p for p in polynomial.polynomials(one) if p.name == name)


def exact(name: str, w: float) -> mpmath.mpf:
    """The textbook's function, differentiated numerically in 60 digits."""
    with mpmath.workdps(60):
        k = mpmath.diff(lambda x: mpmath.acos(x) / mpmath.sqrt(1 - x * x), w, ORDERS[name])
        return mpmath.mpf(-1) ** ORDERS[name] * k


def horner(terms: tuple[Fraction, ...], z: Fraction) -> Fraction:
    total = Fraction(0)
    for c in terms:
        total = total * z + c
    return total


def altered(tmp_path: Path, old: str, new: str) -> Emitted:
    """A package whose float source reads otherwise."""
    place = replace(FLOAT, folder=tmp_path / "underwater")
    shutil.copytree(FLOAT.folder / "c", place.folder / "c")
    text = place.source.read_text(encoding="utf-8")
    assert text.count(old) == 1
    place.source.write_text(text.replace(old, new), encoding="utf-8")
    return place


def literal(one: Emitted, name: str, power: int) -> str:
    """A coefficient as the source spells it, with what stands before it."""
    text = one.source.read_text(encoding="utf-8").partition(f"_{name}(const float w)\n")[2]
    lines = [line for line in text.partition("return")[0].splitlines() if "sum = sum" in line]
    return lines[-1 - power].strip()


@pytest.mark.parametrize("digits", ["1.0", "0.1", "16777217.0", "0.33333558", "1.0e-3", "0.0"])
def test_a_literal_is_what_a_compiler_stores(digits: str) -> None:
    assert polynomial.rounded(digits, "float") == Fraction(float(np.float32(digits)))
    assert polynomial.rounded(digits, "double") == Fraction(float(digits))


def test_a_float_literal_is_rounded_once() -> None:
    tie = "1.00000017881393432617187499"  # below a tie of floats; in double it is the tie itself
    assert polynomial.rounded(tie, "float") == Fraction(float(np.nextafter(np.float32(1), 2)))


@pytest.mark.parametrize("one", [FLOAT, DOUBLE], ids=["f32", "f64"])
def test_every_kernel_function_is_read(one: Emitted) -> None:
    found = {p.name: p for p in polynomial.polynomials(one)}
    assert set(found) == set(ORDERS)
    for name, limit in (("k", 1), ("h", Fraction(1, 3)), ("m", Fraction(4, 15))):
        assert abs(found[name].terms[-1] / limit - 1) < 1e-6


@pytest.mark.parametrize(
    ("old", "new"),
    [("sum = sum * z", "sum = sum * w"), ("z = 1.0F - w", "z = 2.0F - w"), ("inline ", "")],
)
def test_another_scheme_is_refused(old: str, new: str) -> None:
    text = FLOAT.source.read_text(encoding="utf-8").replace(old, new)
    with pytest.raises(ValueError, match=r"Horner|its head differs"):
        polynomial.read(text)


@every_kernel
@pytest.mark.parametrize("w", [0.0, 1e-3, 0.3, 0.9, 0.999])
def test_the_series_is_the_textbook_s_function(name: str, w: float) -> None:
    found, right = truncation.least(name, 1 - Fraction(w)), exact(name, w)
    with mpmath.workdps(60):
        assert abs(mpmath.mpf(found.numerator) / found.denominator / right - 1) < 1e-25


@every_kernel
def test_the_truncation_is_bounded_and_no_more(name: str) -> None:
    terms = kernel(FLOAT, name).terms
    found = float(had(lambda: truncation.truncation(name, terms, Fraction(0), Fraction(1))))
    ladder = [Fraction(i, 256) for i in range(1, 257)]
    sampled = max(
        abs(float(horner(terms, z)) / float(exact(name, float(1 - z))) - 1) for z in ladder
    )
    assert sampled <= found <= 1.1 * sampled
    worse = (*terms[:-1], terms[-1] * (1 + Fraction(1, 10**6)))
    moved = truncation.truncation(name, worse, Fraction(0), Fraction(1))
    assert 0.9e-6 < moved < found + 1e-6


def test_the_rounding_is_bounded_and_no_more() -> None:
    """Of k in float, where 1 - w is exact: against numpy's arithmetic, step by step."""
    terms, ends = kernel(FLOAT, "k").terms, (Fraction(1, 2), Fraction(1))
    found = had(lambda: rounding("float", terms, *ends))
    w = np.linspace(0.5, 1.0, 4097, dtype=np.float32)
    z = np.float32(1) - w
    total, right = np.zeros_like(z), np.zeros(z.shape)
    for c in terms:
        total = total * z + np.float32(c)
        right = right * z.astype(float) + float(c)
    sampled = np.abs(total - right).max()
    assert sampled <= found <= 1.5 * sampled
    assert rounding("double", terms, *ends) == pytest.approx(float(found) / 2**29, rel=0.1)


def test_the_bounds_are_within_what_is_promised() -> None:
    checks = had(lambda: [*bound.bounds(FLOAT), *bound.maxima(FLOAT, COARSE)])
    assert [c.name for c in checks if not c.is_ok] == []
    assert [c.name for c in checks] == [
        *(f"kernel {name}: proved" for name in ORDERS),
        *(f"kernel {name}: largest" for name in ORDERS),
        *(f"kernel {name}: largest over proved" for name in ORDERS),
    ]
    assert all("eps" in c.details[0] for c in checks[:3])


def test_the_double_is_bounded_too() -> None:
    (k,) = (p for p in polynomial.polynomials(DOUBLE) if p.name == "k")
    found = had(lambda: bound.bound(k))
    assert found.whole == found.truncation + found.rounding
    assert 0.5 < found.whole * 2**52 < 1.5
    assert list(bound.maxima(DOUBLE, COARSE)) == []


@pytest.mark.parametrize(("name", "power"), [("k", 0), ("h", 1), ("m", 2)])
def test_a_wrong_coefficient_is_found(tmp_path: Path, name: str, power: int) -> None:
    """Wrong by a part in a hundred thousand: both by the proof and by the maximum."""
    old = literal(FLOAT, name, power)
    head, number = old.rsplit(" ", 1)
    value = float(number.rstrip("F;"))
    wrong = altered(tmp_path, old, f"{head} {value * (1 + 1e-5):.9f}F;")
    assert not next(
        c for c in bound.maxima(wrong, COARSE) if c.name.startswith(f"kernel {name}")
    ).is_ok
    checks = {c.name: c for c in had(lambda: list(bound.bounds(wrong)))}
    assert not checks.pop(f"kernel {name}: proved").is_ok
    assert all(c.is_ok for c in checks.values())


def test_every_number_has_its_turn(tmp_path: Path) -> None:
    """An error at a single place in sixteen million is found when all are looked at."""
    old = "    return sum;\n}\n\n/* Kernel function h"
    place = float(np.float32(0.87654322))
    wrong = altered(tmp_path, old, f"    if (z == {place:.9g}F) {{ return 2.0F; }}\n{old}")
    found = exhaust.largest(wrong, {"k": 0}, 16)["k"]
    assert np.float32(1) - np.float32(found.at) == np.float32(place)
    assert found.error > 0.1
    assert 3 * 2**23 <= found.evaluations < 3 * 2**23 + 16


def test_a_vehicle_without_kernel_functions_has_no_bound() -> None:
    bare = Emitted(GENERATED / "sl2", "sl2", "f32")
    assert list(bound.bounds(bare)) == list(bound.maxima(bare)) == []


def test_without_gappa_it_says_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    hide(monkeypatch, "gappa")
    with pytest.raises(ToolMissing, match="apt install gappa"):
        rounding("float", (Fraction(1), Fraction(1)), Fraction(0), Fraction(1))
    assert GAPPA.command == "gappa"


def test_without_flint_it_says_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "flint", None)
    with pytest.raises(ToolMissing, match=r"pip install gsmc-derive\[evidence\]"):
        truncation.truncation("k", (Fraction(1),), Fraction(0), Fraction(1))
