"""What `derive init` writes: a commented vehicle file that loads as it stands."""

from itertools import cycle, repeat
from pathlib import Path

from derive.control.table import CONTROLLERS
from derive.vehicle import side
from derive.vehicle.check import check_name
from derive.vehicle.file import (
    DEFAULT_CONTROLLER,
    DEFAULT_LAW,
    SCALARS,
    SCHEMA,
    TARGETS,
    InputError,
)
from derive.vehicle.group import made, normal
from derive.vehicle.lookup import check_law, laws_on, look_up
from derive.vehicle.rigid import Kind, kinds

COMMAND = "derive init"  # stands for the file in messages: there is none yet

ROTATIONS = ("SO3", "S3")  # known here, so that the common groups need no import of sympy
CUBESAT: tuple[str, ...] = ("0.0421", "0.0417", "0.0067")  # kg m^2: 4 kg in 10 x 10 x 34 cm
MASS = "4.0"  # kg
GAINS = {"lambda": "0.05", "k_s": "0.2"}  # 1/s: a few mN m on that CubeSat

TEMPLATE = """\
# A vehicle for derive. Replace the inertia and the gains with yours, then:
#   derive emit {name}.toml
schema = {schema}
name = "{name}"  # prefix of the emitted C: a C identifier
group = "{group}"  # where the vehicle moves: SO3 (matrix), S3 (quaternion), SE3 (pose), ...
law = "{law}"  # kinematic law nu_u; a name that does not exist on the group is told
{shortest}controller = "{controller}"  # one of: {controllers}

{inertia}

[gains]  # 1/s
{gains}

# What the actuators give, and how far from the group a measured error may be.
# [limits]
# force = 0.005  # N m and N, either way, one for all coordinates or an array; no limit without
# saturation = "direction"  # where the force points stays; "axis" cuts each coordinate by itself
# drift = 1e-4  # left out: 1e-4 in float, 1e-6 in double

[emit]
scalars = {scalars}  # float, double
targets = {targets}

# What `derive simulate {name}.toml` flies, where it is not from half a unit of error to rest.
# One number stands for all coordinates; an array has one for each.
# [reference]
# along = 0.5  # a slew to exp(hat(along)), from rest to rest; or nu_r, a constant velocity
# duration = 120.0
# [simulate]
# duration = 240.0
# rate = 50.0  # Hz, the force held between; continuous when left out
# turn = 0.3  # first error, g = g_r exp(hat(turn))
# disturbance = 1e-5  # constant force that the controller is not told
"""


SHORTEST = "# shortest = true  # control takes the error q or -q, whichever is the shorter way\n"

INERTIA = """\
# Symmetric, positive definite; {what}.
# {about}
inertia = [
{rows}
]"""
IN_SPACE = (
    "kg m^2 about the centre of mass, in body axes",
    "These are a 3U CubeSat's: 4 kg, 10 x 10 x 34 cm.",
)
OTHERWISE = (
    "rotation before translation (kg m^2, then kg m and kg)",
    "These are the moments and the mass of a 3U CubeSat, and hold a place.",
)


def write(name: str, group: str, law: str | None = None) -> Path:
    """Write ./NAME.toml and return its path; raises InputError, also when it is there already."""
    text = starter(name, group, law)
    path = Path(f"{name}.toml")
    expected = "a new file in a folder that can be written to"
    try:
        _create(path, text)
    except FileExistsError:
        remedy = "choose another name, or move that file away: it is never overwritten"
        raise InputError(str(path), "", expected, "a file of that name", remedy) from None
    except OSError as fault:
        remedy = "change to another folder, or mend its permissions"
        found = fault.strerror or str(fault)
        raise InputError(str(path), "", expected, found, remedy) from fault
    return path


def _create(path: Path, text: str) -> None:
    """A new file, whole; OSError, and then none."""
    with path.open("x", encoding="utf-8") as file:
        try:
            file.write(text)
            file.flush()
        except OSError:
            path.unlink()
            raise


def starter(name: str, group: str, law: str | None = None) -> str:
    """Text of a vehicle file; raises InputError for a bad name, an unknown group or its law."""
    check_name(COMMAND, name)
    group = normal(group)
    usual = _usual_law(group)
    if law is not None:
        check_law(COMMAND, group, law)
    there = (name for name, one in CONTROLLERS.items() if one.exists_on(group))
    return TEMPLATE.format(
        name=name,
        schema=SCHEMA,
        group=group,
        law=law or usual,
        shortest=SHORTEST if group == side.GROUP else "",
        controller=DEFAULT_CONTROLLER,
        controllers=", ".join(there),
        inertia=_inertia(group),
        gains="\n".join(f"{gain} = {value}" for gain, value in GAINS.items()),
        scalars=_array(SCALARS),
        targets=_array(TARGETS),
    )


def _usual_law(group: str) -> str:
    """The usual law on a group; raises InputError for a group nobody knows."""
    if group in ROTATIONS:
        return DEFAULT_LAW
    look_up(COMMAND, group)
    laws = laws_on(group)
    return DEFAULT_LAW if DEFAULT_LAW in laws else laws[0]


def _inertia(group: str) -> str:
    """A [body], or one for each factor; an inertia where the group is that of no body in motion."""
    moving, factors = kinds(group), group.split(" x ")
    is_told_by_bodies = len(moving) > 1 or any(kind.has_arm for kind in moving)
    if is_told_by_bodies and all(kind.is_body for kind in moving):
        return "\n\n".join(map(_body, factors, moving, repeat(len(moving) > 1)))
    if group in ROTATIONS:
        return INERTIA.format(rows=_diagonal(CUBESAT), what=IN_SPACE[0], about=IN_SPACE[1])
    moments = cycle(CUBESAT)
    units = made(group, None).units
    entries = tuple(next(moments) if unit == "rad/s" else MASS for unit in units)
    return INERTIA.format(rows=_diagonal(entries), what=OTHERWISE[0], about=OTHERWISE[1])


def _body(factor: str, kind: Kind, is_part: bool) -> str:
    """The table of one body; of a product, that of one factor."""
    rows = _diagonal(CUBESAT)
    values = {
        "mass": f"{MASS}  # kg",
        "center": f"{[0.0] * kind.moves}  # centre of mass in body axes, m",
        "moments": f"{CUBESAT[0]}  # about the centre of mass, kg m^2",
    }
    if kind.turns > 1:
        values["moments"] = f"[  # about the centre of mass, kg m^2\n{rows}\n]"
    head = f"[[body]]  # on {factor}" if is_part else "[body]"
    told = "# These are a 3U CubeSat's: 4 kg, 10 x 10 x 34 cm. A fluid adds: added_mass = [[...]]"
    lines = (f"{key} = {values[key]}" for key in kind.keys if key in values)
    return "\n".join((head, told, *lines))


def _diagonal(moments: tuple[str, ...]) -> str:
    """Rows of a diagonal matrix, aligned."""
    width = max(map(len, moments))
    rows = (
        ", ".join((moment if i == j else "0.0").rjust(width) for j in range(len(moments)))
        for i, moment in enumerate(moments)
    )
    return "\n".join(f"  [{row}]," for row in rows)


def _array(words: tuple[str, ...]) -> str:
    """A TOML array of strings."""
    quoted = (f'"{word}"' for word in words)
    return f"[{', '.join(quoted)}]"
