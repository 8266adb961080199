"""A controller for any group, derived and emitted as the pipeline does, without a vehicle file."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

from bench.algebra import OWN, algebra
from derive.control.controller import Routines, routines
from derive.control.kinematic import laws_of
from derive.emit.package import package
from derive.emit.render import render, targets
from derive.lie.catalogue import named
from derive.lie.group import Group
from derive.lie.own import of_basis

GAINS = (("lambda", Fraction(1, 2)), ("k_s", Fraction(1)))
"""As in the paper, 1/s."""


@cache
def group_of(name: str) -> Group:
    """A group of the catalogue, a product, or one that is made of its basis."""
    if name not in OWN:
        return named(name)
    basis = algebra(name).basis
    rows = [[[Fraction(float(x)) for x in row] for row in e] for e in basis]
    return of_basis(name, rows, ("1/s",) * len(basis))


@cache
def derived(name: str, law: str, options: tuple[str, ...], is_full: bool = True) -> Routines:
    """All routines, with a full or a diagonal inertia."""
    group = group_of(name)
    pattern = [is_full or i == j for i in range(group.dim) for j in range(i, group.dim)]
    return routines(group, laws_of(group)[law], "gsmc", tuple(pattern), options)


def texts(
    name: str, law: str, options: tuple[str, ...] = (), wanted: Sequence[str] = ("numpy", "c99")
) -> dict[str, str]:
    """The emitted files by path, prefix `made`, the identity as default inertia."""
    group, parts = group_of(name), derived(name, law, options)
    chosen = laws_of(group)[law]
    facts: dict[str, Any] = {
        "group": name,
        "law": f"{law} ({chosen.doc})",
        "controller": "gsmc",
        "storage": group.storage,
        "dim": group.dim,
        "stored": group.size,
        "element_shape": list(group.shape),
        "is_pole": chosen.is_pole,
        "zeros": [],
    }
    n = group.dim
    unit = [Fraction(i == j) for i in range(n) for j in range(i, n)]
    values = {"name": "made", **facts, "inertia": unit, "gains": GAINS}
    data = package("made", parts.main, parts.public, parts.inner, facts)
    files: dict[str, str] = {}
    for target in targets(tuple(wanted)):
        files |= render(target, data[target.name], values)
    return files


def place(files: dict[str, str], root: Path) -> Path:
    """Write emitted files below root."""
    for path, text in files.items():
        file = root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return root
