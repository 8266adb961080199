"""A vehicle file becomes a Vehicle, exactly, or one readable error.

Decides which keys a vehicle file has and which values they take. Nothing heavy is imported
before a group or a law has to be looked up.
"""

from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

from derive.control.table import CONTROLLERS, OPTIONS
from derive.vehicle.body import assembled, has_added_mass
from derive.vehicle.check import (
    Matrix,
    check_name,
    check_positive_definite,
    check_symmetric,
    check_triangle,
)
from derive.vehicle.controller import check_controller, gains_of, law_by_default
from derive.vehicle.experiment import Experiment, experiment
from derive.vehicle.group import OwnGroup, law_of, spelled
from derive.vehicle.key import EMIT_KEYS, HOMES, OPTION_KEYS, TOP_KEYS
from derive.vehicle.limits import Limits, limits
from derive.vehicle.lookup import Facts, check_law, look_up
from derive.vehicle.number import matrix, square
from derive.vehicle.rigid import check_rigid
from derive.vehicle.side import hysteresis
from derive.vehicle.text import InputError, Table, described, read

__all__ = [
    "CONTROLLERS", "Facts", "InputError", "OwnGroup", "Vehicle", "check_facts", "load", "resolve",
]  # fmt: skip

SCHEMA = 1
SCALARS = ("f32", "f64")
TARGETS = ("c99", "numpy")
DEFAULT_LAW = "log"
DEFAULT_CONTROLLER = "gsmc"

DIAGONAL = (
    "write [[J1, 0, 0], [0, J2, 0], [0, 0, J3]] for a diagonal inertia, or a [body] table with "
    "mass, center and moments in its place"
)


@dataclass(frozen=True)
class Vehicle:
    """All that a vehicle file says; inertia (n, n) and gains are exact.

    Inertia in kg m^2, and in kg m and kg where the group translates. Gains are in the order of
    their controller in CONTROLLERS, each in the unit that stands there.

    own:         the group, where the file describes it; `group` is then its name
    options:     those of OPTIONS that are asked for, sorted
    is_in_fluid: a fluid has a part in the inertia, which then need not be a rigid body's
    limits:      what `control` keeps the force to, and how far off the group is fine
    hysteresis:  by how much the other way round has to be shorter, cos of half an angle, until
                 `control` takes it; None where it takes the error as it is
    experiment:  what a closed loop of it is flown with; nothing emitted depends on it
    """

    name: str
    group: str
    law: str
    controller: str
    inertia: tuple[tuple[Fraction, ...], ...]
    gains: tuple[tuple[str, Fraction], ...]
    scalars: tuple[str, ...]
    targets: tuple[str, ...]
    source: str = field(compare=False)
    own: OwnGroup | None = None
    options: tuple[str, ...] = ()
    is_in_fluid: bool = False
    limits: Limits = field(default_factory=Limits)
    hysteresis: Fraction | None = None
    experiment: Experiment = field(default_factory=Experiment)

    @property
    def pattern(self) -> tuple[bool, ...]:
        """Where the upper triangle of the inertia, row by row, is not zero; n(n+1)/2 entries."""
        n = len(self.inertia)
        return tuple(self.inertia[i][j] != 0 for i in range(n) for j in range(i, n))


def load(path: Path) -> Vehicle:
    """The vehicle a file describes; raises InputError. Says nothing on group and law: resolve."""
    top = read(path)
    top.only(TOP_KEYS, HOMES)
    _check_schema(top)
    controller = top.choice("controller", tuple(CONTROLLERS), DEFAULT_CONTROLLER)
    gains, emit = gains_of(top, controller), top.table("emit")
    emit.only(EMIT_KEYS, HOMES)
    scalars = emit.choices("scalars", SCALARS)
    name = top.word("name", 'a name for the vehicle, such as "cubesat"')
    check_name(top.file, name)
    group, own = spelled(top)
    law = law_of(top, law_by_default(controller, DEFAULT_LAW))
    check_controller(top, controller, group, law)
    options = _options(top)
    inertia, is_in_fluid = _inertia(top, group, own, "added_mass" in options)
    return Vehicle(
        name=name,
        group=group,
        law=law,
        controller=controller,
        inertia=inertia,
        gains=gains,
        scalars=scalars,
        targets=emit.choices("targets", TARGETS),
        source=str(path),
        own=own,
        options=tuple(option for option in OPTIONS if option in options),
        is_in_fluid=is_in_fluid,
        limits=limits(top, len(inertia), scalars),
        hysteresis=hysteresis(top, group, controller, law),
        experiment=experiment(top, len(inertia)),
    )


def check_facts(vehicle: Vehicle, facts: Facts) -> None:
    """Raise InputError unless the inertia has the group's dimension and can be a body's."""
    n = len(vehicle.inertia)
    if n != facts.dim:
        raise InputError(
            vehicle.source,
            "inertia",
            f"{square(facts.dim)}: {vehicle.group} has dimension {facts.dim}",
            square(n),
            "give an inertia of that size, or change the group",
        )
    if facts.is_rotation and facts.dim == 3 and not vehicle.is_in_fluid:
        check_triangle(vehicle.source, vehicle.inertia)  # the moments of a body in space


def resolve(vehicle: Vehicle) -> Facts:
    """Look up group and law, whose modules are imported only here; raises InputError."""
    facts = look_up(vehicle.source, vehicle.group, vehicle.own)
    check_law(vehicle.source, vehicle.group, vehicle.law, vehicle.own)
    return facts


def _check_schema(top: Table) -> None:
    """Raise InputError for a schema that this version does not read; left out, it is the newest."""
    schema = top.values.get("schema", SCHEMA)
    if isinstance(schema, bool) or schema != SCHEMA:
        remedy = f"write schema = {SCHEMA}, or install the version of derive the file is for"
        raise top.fault("schema", f"the number {SCHEMA}", described(schema), remedy)


def _options(top: Table) -> set[str]:
    """The options that are asked for."""
    options = top.table("options")
    options.only(OPTION_KEYS, HOMES)
    for key, value in options.values.items():
        if not isinstance(value, bool):
            remedy = f"write {key} = true, or leave it out for false"
            raise options.fault(key, "true or false, without quotes", described(value), remedy)
    return {key for key, value in options.values.items() if value}


def _inertia(
    top: Table, group: str, own: OwnGroup | None, is_in_fluid: bool
) -> tuple[Matrix, bool]:
    """The inertia, (n, n), exact and positive definite, and whether a fluid has a part in it."""
    if "body" not in top.values:
        inertia = matrix(top, "inertia", DIAGONAL)
        check_symmetric(top.file, inertia)
        check_positive_definite(top.file, inertia)
        if own is None and not is_in_fluid:
            check_rigid(top.file, group, inertia)
        return inertia, is_in_fluid
    if "inertia" in top.values:
        remedy = "keep [body], or the inertia that stands at the top of the file"
        raise top.fault("body", "either a [body] or an inertia", "both", remedy)
    return assembled(top, group, own), is_in_fluid or has_added_mass(top)
