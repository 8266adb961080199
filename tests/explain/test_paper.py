"""What is said of the paper is what is computed: every formula without coordinates, evaluated."""

import re
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy
from scipy.linalg import expm
from sympy import Matrix, Symbol

from derive import pipeline
from derive.explain import paper
from derive.explain.latex import LATEX
from derive.explain.mathml import MATHML
from derive.explain.text import TEXT
from derive.lie.group import Group
from derive.lie.kernel import CONSTANTS
from derive.routine.derivation import Derivation, Quantity
from derive.vehicle import Vehicle
from derive.vehicle.group import group_of
from tests.explain.subjects import SUBJECTS

Scope = dict[str, Any]

every_vehicle = pytest.mark.parametrize("vehicle", SUBJECTS, ids=lambda v: v.name)


def coordinates(group: Group, a: Any) -> Matrix:
    """Of a matrix of the algebra, by least squares."""
    stacked = np.array([np.array(e, float).ravel() for e in group.basis]).T
    return Matrix(np.linalg.lstsq(stacked, np.array(a, float).ravel(), rcond=None)[0])


def actions(group: Group) -> Scope:
    """Ad, ad and coad by their definitions on matrices."""

    def hat(x: Matrix) -> Any:
        return sum((float(a) * np.array(e, float) for a, e in zip(x, group.basis, strict=True)))

    def conjugation(g: Matrix) -> Matrix:
        there, back = np.array(g, float), np.linalg.inv(np.array(g, float))
        images = (there @ np.array(e, float) @ back for e in group.basis)
        return Matrix.hstack(*(coordinates(group, image) for image in images))

    def ad(x: Matrix) -> Matrix:
        images = (hat(x) @ np.array(e, float) - np.array(e, float) @ hat(x) for e in group.basis)
        return Matrix.hstack(*(coordinates(group, image) for image in images))

    return {"Ad": conjugation, "ad": ad, "coad": lambda x: ad(x).T}


def stored(group: Group, random: np.random.Generator) -> list[float]:
    x = 0.4 * random.normal(size=group.dim)
    algebra = sum(a * np.array(e, float) for a, e in zip(x, group.basis, strict=True))
    return [float(a) for a in group.store(Matrix(expm(algebra)))]


def evaluated(vehicle: Vehicle, d: Derivation, seed: int) -> Scope:
    """Every quantity of a routine at a random state, as matrices; configurations as elements."""
    group, random = group_of(vehicle), np.random.default_rng(seed)
    known: dict[Symbol, Any] = dict.fromkeys(CONSTANTS, sympy.Float(1e-60))
    upper = [a for i, row in enumerate(vehicle.inertia) for a in row[i:]]
    row: Any
    for q in d.inputs:
        row = upper if q.name == "inertia" else random.uniform(0.5, 2, q.size)
        row = stored(group, random) if q.place.endswith(".g") else row
        known |= zip(q.symbols(), (sympy.Float(float(a)) for a in row), strict=True)
    for step in d.steps:
        known |= {symbol: term.xreplace(known).evalf() for symbol, term in step.terms}
        for symbol, formula in zip(step.symbols, step.formula, strict=True):
            if symbol.is_Symbol and symbol not in known:  # shown, though nothing needs it
                known[symbol] = formula.xreplace(known).evalf()
    n, inertia = group.dim, Matrix([[float(a) for a in row] for row in vehicle.inertia])
    described: list[tuple[Quantity, Any]] = [(q, q.symbols()) for q in d.inputs]
    described += [(s.quantity, s.symbols) for s in d.steps] + list(d.outputs)
    scope: Scope = {"I": inertia, **actions(group)}
    for q, symbols in described:
        values = Matrix([symbol.xreplace(known) for symbol in symbols])
        scope[q.name] = values[0] if q.is_scalar else values
    for name in scope.keys() & {"g", "g_r", "g_e"}:
        scope[name] = Matrix(np.array(group.embed(scope[name]), float))
    if "to_body" in scope:
        scope["to_body"] = scope["to_body"].reshape(n, n)
    for name, source in (("eta", "nu_r"), ("eta_dot", "nu_r_dot")):  # where elements commute
        scope.setdefault(name, scope.get(source))
    return scope


def sides(source: str, scope: Scope) -> tuple[Any, Any]:
    left, right = source.split("==")
    return eval(left, {}, scope), eval(right.strip(), {}, scope)


@every_vehicle
def test_every_formula_holds(vehicle: Vehicle) -> None:
    parts = pipeline.derivations(vehicle)
    for seed, d in enumerate((parts.main, *parts.public)):
        scope = evaluated(vehicle, d, seed)
        sources = [said for step in d.steps if (said := paper.step(d, step.quantity.name))]
        assert len(sources) >= (2 if any(map(any, group_of(vehicle).structure)) else 0)
        for source in (*sources, paper.routine(d)):
            left, right = sides(source, scope)
            assert left.shape == right.shape, source
            assert (left - right).norm() <= 1e-11 * (1 + left.norm()), source


def test_every_formula_is_of_a_step_that_exists() -> None:
    found = {
        (of, step.quantity.name)
        for vehicle in SUBJECTS
        for parts in [pipeline.derivations(vehicle)]
        for d in (parts.main, *parts.public)
        for step in d.steps
        for of in (d.name, d.source)
    }
    assert sorted(set(paper.STEPS) - found) == []


@pytest.mark.parametrize("name", paper.KERNELS)
@pytest.mark.parametrize("w", [0.1, 0.5, 0.9])
def test_definitions_and_identities_of_the_kernel_hold(name: str, w: float) -> None:
    def k(w: Any) -> Any:
        return mpmath.acos(w) / mpmath.sqrt(1 - w**2)

    scope = {
        "k": k,
        "h": lambda w: -mpmath.diff(k, w),
        "m": lambda w: mpmath.diff(k, w, 2),
        "w": mpmath.mpf(w),
        "arccos": mpmath.acos,
        "sqrt": mpmath.sqrt,
        "prime": lambda f: lambda w: mpmath.diff(f, w),
    }
    with mpmath.workdps(40):
        for source in paper.KERNELS[name]:
            left, right = sides(source, scope)
            assert abs(left - right) < 1e-12, source


@pytest.mark.parametrize(
    ("source", "text", "latex", "mathml"),
    [
        ("a - (b + c)", "a - (b + c)", r"a - \left(b + c\right)", "<mo>)</mo>"),
        ("(a + b)*c", "(a + b) c", r"\left(a + b\right)\,c", "<mo>(</mo>"),
        ("-a*b", "-a b", r"-a\,b", "<mo>−</mo><mi>a</mi>"),
        ("a/(1 + b)", "a/(1 + b)", r"\frac{a}{1 + b}", "<mfrac>"),
        ("a/(b*c)", "a/(b c)", r"\frac{a}{b\,c}", "</mrow></mfrac>"),
        ("(a + b)/c", "(a + b)/c", r"\frac{a + b}{c}", "</mrow></mfrac>"),
        ("g**-1", "g^-1", "g^{-1}", "<msup>"),
        ("coad(nu_u)*x", "ad*(nu_u) x", r"\mathrm{ad}^{*}_{\nu_{u}}\,x", "<msubsup>"),
        ("prime(k)(w)", "k'(w)", r"k'\left(w\right)", "<mo>′</mo>"),
    ],
)
def test_a_formula_is_spelled_as_meant(source: str, text: str, latex: str, mathml: str) -> None:
    assert paper.said(source, TEXT) == text
    assert latex in paper.said(source, LATEX)
    assert mathml in paper.said(source, MATHML)


def test_what_cannot_be_read_is_refused() -> None:
    with pytest.raises(TypeError, match="no rule reads"):
        paper.said("a if b else c", TEXT)


@pytest.mark.parametrize("name", ["heisenberg", "product"])
def test_wheels_and_known_forces_are_in_the_formulas(name: str) -> None:
    (vehicle,) = (one for one in SUBJECTS if one.name == name)
    parts = pipeline.derivations(vehicle)
    for d in (parts.main, *parts.public):
        assert "(I*nu + momentum)" in paper.routine(d)
        assert re.search(r"[-+] external$", paper.routine(d))
    assert paper.step(parts.main, "whole_momentum") == "whole_momentum == I*nu + momentum"
