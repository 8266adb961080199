"""What `derive explain` shows: a vehicle's routines, chosen by name and by equation."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from derive import pipeline
from derive.explain.document import document, labels
from derive.explain.section import Algebra
from derive.vehicle import InputError, Vehicle
from derive.vehicle.group import group_of
from derive.vehicle.text import described, nearest


def explain(
    vehicle: Vehicle,
    cached: Path | None,
    form: str,
    *,
    routine: str | None = None,
    equation: str | None = None,
) -> str:
    """The derivation step by step in one of derive.explain's formats; raises InputError."""
    whole = replace(vehicle, scalars=("f64",), targets=("c99",))
    facts = pipeline.printed(whole, cached)["targets"]["c99"]["f64"]
    parts = pipeline.derivations(vehicle)
    told = {d.name: d for d in (parts.main, *parts.public)}
    if routine is not None:
        _check_known(vehicle, "--routine", routine, list(told))
        told = {routine: told[routine]}
    chosen = list(told.values())
    if equation is not None:
        _check_known(vehicle, "--equation", equation, labels(chosen))
    words = {name: str(facts[name]) for name in ("group", "dim", "law", "controller", "storage")}
    files = pipeline.texts(whole, cached)
    told_of = {"vehicle": vehicle.name, **words}
    return document(chosen, told_of, files, form, equation, _basis(vehicle))


def _basis(vehicle: Vehicle) -> Algebra:
    """That of a group of one's own; nothing for a group that everyone knows."""
    if vehicle.own is None:
        return ()
    group = group_of(vehicle)
    return tuple(zip(group.basis, group.units, strict=True))


def _check_known(vehicle: Vehicle, option: str, word: str, known: Sequence[str]) -> None:
    """Raise InputError for a word of the command line that names nothing of this vehicle's."""
    if word not in known:
        expected = f"one of {', '.join(known)}"
        remedy = f"write {option} {shlex.quote(nearest(word, known))}, the nearest"
        raise InputError(vehicle.source, option, expected, described(word), remedy)
