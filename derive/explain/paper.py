"""What the paper says of a step or a routine without coordinates, for any group.

Written once, as Python spells it, so that a test evaluates what a reader sees. `Ad`, `ad` and
`coad` act on what follows, `prime` is a derivative.
"""

from __future__ import annotations

import ast

from derive.explain.notation import Notation
from derive.routine.derivation import Derivation

ROUTINES = {
    "eq. (TckCtrl)": (
        "force == coad(rate_gain*nu_u - eta)*{carried}"
        " + I*(eta_dot - rate_gain*nu_u_dot - reach_gain*s){less}"
    ),
    "eq. (Ctrl2)": (
        "force == coad(rate_gain*nu_u)*{carried} - I*(rate_gain*nu_u_dot + reach_gain*s){less}"
    ),
    "eq. (EulerP)": "I*nu_dot == coad(nu)*{carried} + force{plus}",
    "eq. (Ctrls2)": "force == -k*I*s + I*nu_r_dot - coad(nu)*{carried} - ad(nu)*nu_r{less}",
    "eq. (Ctrls2) corrected": (
        "force == -k*I*s + I*nu_r_dot - coad(nu)*{carried} + I*ad(nu)*nu_r{less}"
    ),
    "eq. (Ctrls3)": (
        "force == -k_Omega*s + I*Ad(g_e**-1)*nu_r_dot - coad(eta)*{carried_by_eta}{less}"
    ),
}
"""Equation of a routine -> what it computes as a whole; see EXTRAS for what stands in braces."""

_ALL = ("tracking", "reaching", "plant")

STEPS = {
    ("tracking", "g_e"): "g_e == g_r**-1 * g",
    ("tracking", "to_body"): "to_body == Ad(g_e**-1)",
    ("tracking", "eta"): "eta == Ad(g_e**-1)*nu_r",
    ("tracking", "eta_dot"): "eta_dot == Ad(g_e**-1)*nu_r_dot - ad(nu_e)*eta",
    **{(routine, "momentum"): "momentum == I*nu" for routine in _ALL},
    **{(routine, "whole_momentum"): "whole_momentum == I*nu + momentum" for routine in _ALL},
    ("tracking", "force"): "force == coad(turning)*{whole} + I*wanted{less}",
    ("reaching", "force"): "force == coad(drive)*{whole} + I*wanted{less}",
    ("tracking", "crossing"): "crossing == ad(nu)*nu_r",
    ("tracking", "given"): "given == Ad(g_e**-1)*nu_r_dot",
    ("eq. (Ctrls2)", "force"): "force == I*wanted - coad(nu)*{whole} - crossing{less}",
    ("eq. (Ctrls2) corrected", "force"): "force == I*wanted - coad(nu)*{whole}{less}",
    ("eq. (Ctrls3)", "momentum"): "momentum == I*eta",
    ("eq. (Ctrls3)", "whole_momentum"): "whole_momentum == I*eta + momentum",
    ("eq. (Ctrls3)", "force"): "force == I*given - coad(eta)*{whole} - k_Omega*s{less}",
    ("plant", "total"): "total == coad(nu)*{whole} + force{plus}",
}
"""(routine or its equation, step) -> the step without coordinates, where entries do not say it."""

EXTRAS = {
    "carried": ("momentum", "(I*nu + momentum)", "I*nu"),
    "carried_by_eta": ("momentum", "(I*eta + momentum)", "I*eta"),
    "whole": ("momentum", "whole_momentum", "momentum"),
    "less": ("external", " - external", ""),
    "plus": ("external", " + external", ""),
}
"""What stands in braces: an input, what is said where the routine takes it, and where not."""

KERNELS = {
    "k": (
        "k(w) == arccos(w)/sqrt(1 - w**2)",
        "(1 - w**2)*h(w) == 1 - w*k(w)",
        "h(w) == -prime(k)(w)",
    ),
    "h": ("h(w) == -prime(k)(w)", "(1 - w**2)*h(w) == 1 - w*k(w)"),
    "m": ("m(w) == -prime(h)(w)", "(1 - w**2)*m(w) == k(w) - 3*w*h(w)"),
}
"""Special function -> its definition, and the identities that are used."""

CONSTANTS = {
    "TINY": "rounds away beside any normal number, and keeps divisors from being zero",
    "SMALL": "added to a divisor that vanishes at a pole",
    "FLOOR": "added to a squared sine, beside which it rounds away where it counts",
    "SHORT": "squared length below which numbers are no quaternion",
    "CUT": "least sine that an error beyond pi is divided by",
    "NOISE": "of the terms of a determinant, what rounding may leave of one that is zero",
    "LEAST": "below the squared length of any unit quaternion",
}
"""Named constant -> what it is for."""


def routine(d: Derivation) -> str:
    """The formula of a routine as a whole; empty for one that the paper does not have."""
    return _filled(ROUTINES.get(d.source, ""), d)


def step(d: Derivation, name: str) -> str:
    """The formula of one of its steps; empty where the entries say it, or a step is not there.

    Where elements commute, whatever ad* acts on is not computed.
    """
    said_of = (STEPS.get((of, name)) for of in (d.source, d.name))
    source = _filled(next(filter(None, said_of), ""), d)
    there = {one.name for one in d.inputs} | {one.quantity.name for one in d.steps}
    said = {one.id for one in ast.walk(ast.parse(source)) if isinstance(one, ast.Name)}
    return source if said <= there | {"I", "Ad", "ad", "coad"} else ""


def _filled(source: str, d: Derivation) -> str:
    taken = {quantity.name for quantity in d.inputs}
    rows = EXTRAS.items()
    return source.format(**{name: there if of in taken else not_there
                            for name, (of, there, not_there) in rows})  # fmt: skip


def said(source: str, n: Notation) -> str:
    """A formula of this module in a notation, displayed."""
    return n.single % _node(ast.parse(source, mode="eval").body, n)


def _node(node: ast.expr, n: Notation) -> str:
    match node:
        case ast.Name(name):
            return n.symbol(name)
        case ast.Constant(value):
            return n.symbol(str(value))
        case ast.Compare(left, _, [right]):
            return _node(left, n) + n.relation % "=" + _node(right, n)
        case ast.UnaryOp(_, operand):
            return n.minus + _operand(operand, n)
        case ast.BinOp(left, operator, right):
            return _binary(left, operator, right, n)
        case ast.Call(function, arguments):
            return _call(function, tuple(_node(one, n) for one in arguments), n)
    raise TypeError(f"no rule reads {ast.dump(node)}")


def _binary(left: ast.expr, operator: ast.operator, right: ast.expr, n: Notation) -> str:
    match operator:
        case ast.Add():
            return _node(left, n) + n.plus + _node(right, n)
        case ast.Sub():
            return _node(left, n) + n.less + _operand(right, n)
        case ast.Mult():
            return _operand(left, n) + n.product + _operand(right, n)
        case ast.Pow():
            return n.power % (_node(left, n), _node(right, n))
    above, below = _node(left, n), _node(right, n)
    if n.is_flat:
        is_many = isinstance(right, ast.BinOp) and not isinstance(right.op, ast.Pow)
        above, below = _operand(left, n), n.group % below if is_many else below
    return n.fraction % (above, below)


def _operand(node: ast.expr, n: Notation) -> str:
    """In parentheses when it is a sum."""
    is_sum = isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub)
    return n.group % _node(node, n) if is_sum else _node(node, n)


def _call(function: ast.expr, given: tuple[str, ...], n: Notation) -> str:
    name = function.id if isinstance(function, ast.Name) else ""
    if name in n.actions:
        return n.actions[name] % given[0]
    if name in (patterns := {"sqrt": n.root, "prime": n.prime}):
        return patterns[name] % given[0]
    return n.call % (_node(function, n), given[0])
