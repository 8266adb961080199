"""Printed text, evaluated as the language it is in, gives what sympy says it is."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy
from sympy import Abs, Add, And, Expr, Mul, Pow, Rational, sqrt

from derive.control.controller import routines
from derive.emit import printer
from derive.lie.kernel import NAMES, TINY, Arc, H, K, M
from derive.native.compile import SHARED, WARNINGS_C, Compiler
from tests.control.drawn import LAWS, full
from tests.groups import ALL

a, b, c, x = sympy.symbols("a b c x", real=True)
NUMPY, F64, F32 = printer.numpy(), printer.c99("f64", "p"), printer.c99("f32", "p")
PREFIXED = printer.c99("f64", "prefix")
POINTS = ((0.75, -1.25, 2.5, 0.5), (-3.0, 0.375, -0.5, 0.25), (1.5, 2.0, 0.125, 0.96875))
"""Values of a, b, c and x; x, which stands under a root or in a kernel, is in (0, 1]."""

EXPRESSIONS: tuple[Expr, ...] = (
    a, -a, Rational(-7, 3), sympy.pi, -sympy.pi * a, TINY + a,
    a + b, a - b, -a - b, b - a - 1, 1 - a, -a * b - 1, -(a + b) * c, a * (b - c),
    (a - b) * (c - 1),
    2 * a + 2 * b, -2 * a - 4 * b, a / 2 + b / 2, Rational(2, 3) * a, Rational(-3, 4) * a * b / c,
    a - (b - c) * 2, a - 2 * (b + c) + 3 * (a - b), Add(a, Mul(-1, b + c, evaluate=False)),
    a**2, a**3, (a + b) ** 2, (2 * a + 2 * b) ** 2, a**4 * b**2, -(a**2), (-a) ** 3, 1 - a**2,
    1 / a, -1 / a, a / b, a / b / c, a / (b * c), a / (b / c), a / (b + c), a / (-b),
    (a + b) / (2 * a - 2 * b), a * (1 + 1 / b),
    1 / a**2, a / b**2, a / (b * c**2), 1 / (1 + a) ** 2, 2 / (1 + a) ** 3,
    sqrt(x), 1 / sqrt(x), a / sqrt(x), a / (b * sqrt(x)), sqrt(a**2 + b**2 + TINY), sqrt(x) * a - b,
    Abs(a), Abs(a - b), -Abs(a * b), Abs(a) / Abs(b), Abs(a) ** 2, 1 / Abs(a - b) ** 2,
    K(x), H(x), M(x), K(Abs(x)), K(1 - x / 2) * a, -H(x) * b,
    (1 - x * K(x)) / ((1 - x) * (1 + x) + TINY),
)  # fmt: skip

CONDITIONS = (
    a >= b, a < 0, b - a >= c, a + b < 1 - c, And(a >= b, b - c < a), And(a < 1, b < 1, c < 1),
)  # fmt: skip


def truth(value: Expr, point: Sequence[float]) -> float:
    """sympy's own value, to 40 digits, at exactly that point."""
    exact = [Rational(*number.as_integer_ratio()) for number in point]
    known = dict(zip((a, b, c, x), exact, strict=True))
    return float(value.subs({**known, TINY: Rational(1, 10**290)}).evalf(40))


def scope(point: Iterable[Any]) -> dict[str, Any]:
    """Names an expression in numpy may use, the kernel functions by sympy."""
    kernels = {
        f"_{name}": lambda w, order=order: np.float64(
            Arc(order, sympy.Float(float(w), 40)).evalf(40)
        )
        for order, name in enumerate(NAMES)
    }
    return {**dict(zip("abcx", point, strict=True)), **kernels, "np": np}


@pytest.mark.parametrize("value", EXPRESSIONS, ids=str)
def test_numpy_text_has_the_value_of_the_expression(value: Expr) -> None:
    line = printer.text(value, NUMPY)
    for point in POINTS:
        found = eval(line, scope([np.float64(number) for number in point]))
        np.testing.assert_allclose(found, truth(value, point), rtol=1e-14, err_msg=line)


@pytest.mark.parametrize("condition", CONDITIONS, ids=str)
def test_numpy_conditions_have_their_value_on_arrays(condition: sympy.Basic) -> None:
    points = (*POINTS, (1.0, 1.0, 1.0, 1.0), (0.0, 1.0, 1.0, 1.0))  # the last two are ties
    columns = np.array(points).T
    line = printer.condition(condition, NUMPY)
    wanted = [bool(condition.subs(dict(zip((a, b, c, x), p, strict=True)))) for p in points]
    assert eval(line, scope(columns)).tolist() == wanted
    # A complex step changes no decision, not even at a tie.
    for step in (1e-200j, -1e-200j):
        stepped = columns + step * np.array([[1], [-1], [2], [1]])
        assert eval(line, scope(stepped)).tolist() == wanted


@pytest.mark.parametrize("value", [v for v in EXPRESSIONS if not v.atoms(Arc)], ids=str)
def test_numpy_text_takes_a_complex_step(value: Expr) -> None:
    for point in POINTS:
        stepped = [complex(point[0], 1e-100), *point[1:]]
        found = eval(printer.text(value, NUMPY), scope(np.array(stepped)))
        slope = truth(sympy.diff(value, a).doit(), point)
        np.testing.assert_allclose(np.imag(found) / 1e-100, slope, rtol=1e-13, atol=1e-14)


@cache
def compiled(folder: Path) -> ctypes.CDLL:
    """Every expression in both precisions and every condition, as functions of one C file."""
    lines = ["#include <math.h>"]
    for scalar, kind, dialect in (("f32", "float", F32), ("f64", "double", F64)):
        names = ", ".join(f"{kind} {name}" for name in "abcx")
        ignore = " ".join(f"(void){name};" for name in "abcx")
        tables = f"{kind} p_kernel_{scalar}[3];"
        lines += [tables, *(f"#define p_{n} p_{n}_{scalar}" for n in NAMES)]
        for order, name in enumerate(NAMES):
            head = f"static inline {kind} p_{name}({kind} w)"
            lines.append(f"{head} {{ (void)w; return p_kernel_{scalar}[{order}]; }}")
        for i, value in enumerate(EXPRESSIONS):
            body = f"{ignore} return {printer.text(value, dialect)};"
            lines.append(f"{kind} value_{scalar}_{i}({names}) {{ {body} }}")
        for i, condition in enumerate(CONDITIONS):
            body = f"{ignore} return ({printer.condition(condition, dialect)}) ? 1 : 0;"
            lines.append(f"int holds_{scalar}_{i}({names}) {{ {body} }}")
        lines += [f"#undef p_{name}" for name in NAMES]
    source = folder / "printed.c"
    source.write_text("\n".join(lines) + "\n", encoding="utf-8")
    compiler = Compiler.find()
    wanted = ("-Wmissing-prototypes", "-Wstrict-prototypes")
    strict = [flag for flag in WARNINGS_C["gcc"] if flag not in wanted]
    flags = [*SHARED, *strict, "-Wno-unused-function", str(source), "-lm"]
    return ctypes.CDLL(str(compiler.run(flags, folder / "printed.so")))


@pytest.fixture(scope="session")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    return compiled(tmp_path_factory.mktemp("printed"))


@pytest.mark.parametrize(("scalar", "rtol"), [("f32", 1e-6), ("f64", 1e-14)])
@pytest.mark.parametrize("index", range(len(EXPRESSIONS)), ids=lambda i: str(EXPRESSIONS[i]))
def test_c_text_has_the_value_of_the_expression(
    library: ctypes.CDLL, scalar: str, rtol: float, index: int
) -> None:
    number = {"f32": ctypes.c_float, "f64": ctypes.c_double}[scalar]
    function = library[f"value_{scalar}_{index}"]
    function.restype, function.argtypes = number, [number] * 4
    kernels = (number * 3).in_dll(library, f"p_kernel_{scalar}")
    value = EXPRESSIONS[index]
    for point in POINTS:
        for call in value.atoms(Arc):
            kernels[int(call.args[0])] = truth(call, point)
        np.testing.assert_allclose(function(*point), truth(value, point), rtol=rtol)


@pytest.mark.parametrize("scalar", ["f32", "f64"])
@pytest.mark.parametrize("index", range(len(CONDITIONS)), ids=lambda i: str(CONDITIONS[i]))
def test_c_conditions_have_their_value(library: ctypes.CDLL, scalar: str, index: int) -> None:
    number = {"f32": ctypes.c_float, "f64": ctypes.c_double}[scalar]
    function = library[f"holds_{scalar}_{index}"]
    function.argtypes = [number] * 4
    for point in POINTS:
        wanted = bool(CONDITIONS[index].subs(dict(zip((a, b, c, x), point, strict=True))))
        assert function(*point) == wanted


@pytest.mark.parametrize("value", [a ** Rational(3, 2), Pow(a, b), sympy.exp(a), sympy.I], ids=str)
def test_what_has_no_rule_is_refused(value: Expr) -> None:
    for dialect in (NUMPY, F32, F64):
        with pytest.raises(TypeError, match="no rule prints"):
            printer.text(value, dialect)


PRINTED = [pair for pair in LAWS if "Random" not in pair[0] or pair[0] == "Random2"]


@pytest.mark.parametrize(("group", "law"), PRINTED)
def test_both_languages_print_one_arithmetic(group: str, law: str) -> None:
    """C in double and numpy agree term by term, up to how a root or a condition is spelled."""
    for step in routines(ALL[group], LAWS[group, law], "gsmc", full(ALL[group])).main.steps:
        for _, value in step.terms:
            for one in value.args if isinstance(value, sympy.Piecewise) else (value,):
                expression = one[0] if isinstance(value, sympy.Piecewise) else one
                if expression.atoms(Abs):
                    continue
                plain = printer.text(expression, PREFIXED).replace("prefix_", "_")
                assert printer.text(expression, NUMPY).replace("np.", "") == plain


def test_the_entries_of_a_choice_must_share_their_conditions() -> None:
    from derive.emit.printed import routine
    from derive.routine.derivation import Derivation, Quantity

    d = Derivation("torn", "entries that choose differently", "")
    y = d.take(Quantity("y", 2, "1", "input"))
    cases = [sympy.Piecewise((y[0], y[i] < 0), (y[1], True), evaluate=False) for i in (0, 1)]
    d.give(Quantity("z", 2, "1", "output"), d.let("z", sympy.Matrix(cases), "1", "two choices"))
    with pytest.raises(ValueError, match="different conditions"):
        routine(d, F64)
