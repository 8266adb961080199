"""Break `lie`, `control` or `emit` in one place, and the suite must turn red.

The oracles stand apart from all three, so no break can move both sides of a comparison.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction

import pytest
import sympy

from derive import pipeline
from derive.control import port, quaternion_law
from derive.emit import literal, printer
from derive.lie import catalogue, cover, kernel
from derive.lie.group import Group
from derive.verify import derived
from derive.verify.run import run
from tests.verify.subjects import PAPER, plant
from tests.verify.test_suite import failures, verified, with_law

Patch = pytest.MonkeyPatch


@pytest.fixture(autouse=True)
def _unharmed() -> Iterator[None]:
    """No test sees a group that another has harmed."""
    yield
    for kept in (catalogue.named, derived.lie_group):
        kept.cache_clear()


def conjugate_reference(patch: Patch) -> None:
    """Ad of g for Ad of its inverse."""
    wrong = replace(catalogue.SO3, short_Ad=lambda rotation: rotation.T)
    patch.setitem(catalogue.GROUPS, "SO3", wrong)
    catalogue.named.cache_clear()


def coad_with_minus(patch: Patch) -> None:
    patch.setattr(Group, "coad", lambda self, x: -self.ad(x).T)


def bracket_with_minus(patch: Patch) -> None:
    """The sign of the structure constants, and with it that of eta_dot and coad."""
    right = Group.ad
    patch.setattr(Group, "ad", lambda self, x: -right(self, x))


def kernel_slope_with_plus(patch: Patch) -> None:
    patch.setattr(kernel.Arc, "fdiff", lambda self, _=2: kernel.Arc(self.args[0] + 1, self.args[1]))


def kernel_coefficient_off(patch: Patch) -> None:
    """One coefficient of the polynomial, by one part in 1e9."""
    right = kernel.coefficients

    def wrong(order: int, scalar: str) -> tuple[Fraction, ...]:
        terms = list(right(order, scalar))
        terms[3] *= 1 + Fraction(1, 10**9)
        return tuple(terms)

    patch.setattr("derive.emit.printed.coefficients", wrong)


def quaternion_of_transpose(patch: Patch) -> None:
    right = cover._quadruple
    patch.setattr(cover, "_quadruple", lambda let, R: right(let, R.T))


def rate_along_axis_doubled(patch: Patch) -> None:
    right = quaternion_law._along
    patch.setattr(quaternion_law, "_along", lambda *terms: 2 * right(*terms))


def gains_exchanged(patch: Patch) -> None:
    right = port.take_gains
    patch.setattr("derive.control.sliding.take_gains", lambda *given: right(*given)[::-1])


def half_law_for_whole(patch: Patch) -> None:
    law = quaternion_law.LAWS["SO3"]["log"]
    half = quaternion_law.Quaternion(lambda _, e: kernel.K(e.w) / 2, quaternion_law._at_pi)
    patch.setitem(quaternion_law.LAWS["SO3"], "log", replace(law, write=half))


def minus_printed_as_plus(patch: Patch) -> None:
    right = printer._signed
    patch.setattr(printer, "_signed", lambda term: (False, right(term)[1]))


def literals_cut_short(patch: Patch) -> None:
    """Twelve digits of every number."""
    right = literal.decimal

    def wrong(value: Fraction, scalar: str) -> str:
        return right(Fraction(f"{float(value):.12g}"), scalar)

    for place in ("derive.emit.printer.decimal", "derive.emit.printed.decimal"):
        patch.setattr(place, wrong)
    patch.setattr("derive.emit.printed.c_literal", lambda v, s: wrong(v, s) + literal.SUFFIX[s])


def root_of_absolute_forgotten(patch: Patch) -> None:
    rules = tuple((k, (lambda v, d: "1.0") if k is sympy.Pow else r) for k, r in printer._RULES)
    patch.setattr(printer, "_RULES", rules)


BREAKS: tuple[Callable[[Patch], None], ...] = (
    conjugate_reference,
    coad_with_minus,
    bracket_with_minus,
    kernel_slope_with_plus,
    kernel_coefficient_off,
    quaternion_of_transpose,
    rate_along_axis_doubled,
    gains_exchanged,
    half_law_for_whole,
    minus_printed_as_plus,
    literals_cut_short,
    root_of_absolute_forgotten,
)


@pytest.mark.parametrize("harm", BREAKS, ids=lambda harm: harm.__name__)
def test_a_break_turns_the_suite_red(harm: Callable[[Patch], None], monkeypatch: Patch) -> None:
    harm(monkeypatch)
    assert failures(verified(PAPER, each=3)) != []


def test_a_break_on_s3_turns_the_suite_red(monkeypatch: Patch) -> None:
    """Beyond pi the kernel goes on by k(w) = pi/s - k(-w); take 3 for pi."""
    monkeypatch.setattr(cover, "pi", sympy.Integer(3))
    assert failures(verified(with_law("S3", "log"), each=3)) != []


EDITS = (
    ("reaching: sign of s", "command->s[0] = s_0;", "command->s[0] = -s_0;", -1),
    ("reaching: entry of the rate", "nu_u_dot[0] = nu_u_dot_0;", "nu_u_dot[0] = nu_u_dot_1;", -1),
    ("control: sign of the force", "return paper_so3_f64_verdict(",
     "command->force[0] = -command->force[0]; return paper_so3_f64_verdict(", 0),
    ("control: any drift will do", "< params->max_drift*params->max_drift", "<= 1e9", 0),
    ("check_params: any drift will do", "max_drift >= PAPER_SO3_F64_LEAST_DRIFT &&",
     "max_drift > 0.0 &&", 0),
    ("check_params: first pivot", "pivot[0] = inertia_0;", "pivot[0] = 1.0;", 0),
)  # fmt: skip
"""What, the emitted C as it is, as it is broken, and which occurrence of it."""


@pytest.mark.parametrize(("what", "right", "wrong", "which"), EDITS, ids=[e[0] for e in EDITS])
def test_an_edit_of_the_emitted_c_turns_the_suite_red(
    what: str, right: str, wrong: str, which: int
) -> None:
    files = pipeline.texts(PAPER)
    path = "c/src/paper_so3_f64.c"
    places = [match.start() for match in re.finditer(re.escape(right), files[path])]
    assert places, what
    at = places[which]
    files[path] = files[path][:at] + wrong + files[path][at + len(right) :]
    assert failures(run("paper_so3", files, plant(PAPER), each=2)) != []


def test_unharmed_the_same_run_is_green() -> None:
    assert failures(verified(PAPER, each=3)) == []
