"""What a kinematic law is: a record that writes its steps; Definition 1 of the paper."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from sympy import Expr, Matrix

from derive.lie.cover import Let
from derive.lie.group import Group


@dataclass(frozen=True)
class Written:
    """A law at one element, over the steps that were written for it.

    value:     nu_u, (n, 1)
    rate:      (let, nu_e) -> its exact rate along g_e' = g_e hat(nu_e), (n, 1)
    clearance: zero where the law jumps or is not defined, else up to 1
    """

    value: Matrix
    rate: Callable[[Let, Matrix], Matrix]
    clearance: Expr


@dataclass(frozen=True)
class KinematicLaw:
    """nu_u : G -> algebra, def. (KctrLaw).

    write:   (let, group, g_e) -> the law at g_e, given by its stored numbers (k, 1)
    doc:     one sentence
    is_pole: the law or its rate has no bound near its cut: refused within a margin of it
    source:  the paper's label
    """

    name: str
    write: Callable[[Let, Group, Matrix], Written]
    doc: str
    is_pole: bool = False
    source: str = "def. (KctrLaw)"
