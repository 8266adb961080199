"""Where drivers and controllers meet: a quaternion as most drivers give it, as a configuration."""

from __future__ import annotations

from sympy import Matrix, sqrt

from derive.lie.group import Group
from derive.routine.derivation import Derivation, Quantity


def border(group: Group) -> Derivation | None:
    """From a quaternion (x, y, z, w) of about unit length to g; None where no attitude is g."""
    if group.attitude is None:
        return None
    d = Derivation(
        "from_xyzw",
        "A quaternion (x, y, z, w) that turns body into world axes, to the configuration",
        "",
    )
    q = d.take(Quantity("q", 4, "1", "quaternion, Hamilton, scalar last", place="q"))
    length = d.let("length", sqrt(q.dot(q)), "1", "its length, which drivers round")
    w = d.let("w", q[3] / length, "1", "scalar part")
    v = d.let("v", q[:3, :] / length, "1", "vector part")
    g = Quantity("g", group.size, "1", group.storage, place="g")
    d.give(g, group.attitude(Matrix([w, *v])))
    return d
