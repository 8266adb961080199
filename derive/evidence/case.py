"""Good states, from which an attack starts: all angles, moderate lengths and velocities."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.emit.target import SCALARS
from derive.evidence.interface import Interface, Member
from derive.verify import sample
from derive.verify.derived import has_pole
from derive.verify.plant import Plant

Array = NDArray[Any]

COUNT = 60
LENGTHS = (0.1, 1.0, 10.0)
"""Lengths of a translation, m: what vehicles have; a control would take a hundred thousand more."""

_NAMES = {"reference.g": "g_r", "reference.nu": "nu_r", "reference.nu_dot": "nu_r_dot"}


def good(plant: Plant, interface: Interface, count: int = COUNT) -> list[str]:
    """So many states with their references, each as a C initialiser of all inputs.

    Every rung of the ladder of angles, angles at random between; the same at every run.
    """
    scalar = interface.emitted.scalar
    rungs = _angles(plant, scalar)[-count // 2 :]
    random = np.random.default_rng(5)
    angle = np.concatenate([rungs, random.uniform(0, rungs[-1], count - len(rungs))])
    made = sample.states(plant, angle, scalar, random, is_moving=True, lengths=LENGTHS)
    return [_initialiser(interface, made, row) for row in range(count)]


def _angles(plant: Plant, scalar: str) -> Array:
    """The ladder, rad, without what is too near a pole of the law: control refuses that."""
    angles = np.array(sample.angles(plant))
    if not has_pole(plant):
        return angles
    pole = np.pi * np.ceil(angles[-1] / np.pi)
    return np.asarray(angles[(pole - angles) / 2 > 2 * float(SCALARS[scalar].refused)])


def _initialiser(interface: Interface, made: sample.States, row: int) -> str:
    structs = (
        ", ".join(_numbers(member, made, row) for member in interface.structs[name])
        for name in interface.inputs
    )
    return "{ " + ", ".join(f"{{ {one} }}" for one in structs) + " }"


def _numbers(member: Member, made: sample.States, row: int) -> str:
    """Exact, in hexadecimal; what no state speaks of is zero, as a caller starts it."""
    found: Array | None = getattr(made, _NAMES.get(member.path, member.name), None)
    if found is None:
        return "{ 0 }" if member.is_array else "0"
    numbers = ", ".join(float(x).hex() for x in np.atleast_1d(found[row]))
    return f"{{ {numbers} }}" if member.is_array else numbers
