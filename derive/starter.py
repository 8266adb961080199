"""What `derive init` writes: a commented vehicle file that loads as it stands."""

from pathlib import Path

from derive.control.table import CONTROLLERS
from derive.vehicle import (
    DEFAULT_CONTROLLER,
    DEFAULT_LAW,
    SCALARS,
    SCHEMA,
    TARGETS,
    InputError,
    check_law,
    laws_on,
    look_up,
)
from derive.vehicle_check import check_name

COMMAND = "derive init"  # stands for the file in messages: there is none yet

ROTATIONS = ("SO3", "S3")  # known here, so that the common groups need no import of sympy
CUBESAT: tuple[str, ...] = ("0.0421", "0.0417", "0.0067")  # kg m^2: 4 kg in 10 x 10 x 34 cm
GAINS = {"lambda": "0.05", "k_s": "0.2"}  # 1/s: a few mN m on that CubeSat

TEMPLATE = """\
# A vehicle for derive. Replace the inertia and the gains with yours, then:
#   derive emit {name}.toml
schema = {schema}
name = "{name}"  # prefix of the emitted C: a C identifier
group = "{group}"  # where the vehicle moves: SO3 (rotation matrix), S3 (unit quaternion), ...
law = "{law}"  # kinematic law nu_u; a name that does not exist on the group is told
controller = "{controller}"  # one of: {controllers}

# Symmetric, positive definite; kg m^2 about the centre of mass, in body axes.
# {about}
inertia = [
{inertia}
]

[gains]  # 1/s
{gains}

[emit]
scalars = {scalars}  # float, double
targets = {targets}
"""


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
    usual, moments, about = _place_holders(group)
    if law is not None:
        check_law(COMMAND, group, law)
    return TEMPLATE.format(
        name=name,
        schema=SCHEMA,
        group=group,
        law=law or usual,
        controller=DEFAULT_CONTROLLER,
        controllers=", ".join(CONTROLLERS),
        about=about,
        inertia=_diagonal(moments),
        gains="\n".join(f"{gain} = {GAINS[gain]}" for gain in CONTROLLERS[DEFAULT_CONTROLLER]),
        scalars=_array(SCALARS),
        targets=_array(TARGETS),
    )


def _place_holders(group: str) -> tuple[str, tuple[str, ...], str]:
    """The usual law on a group, moments to start from, and what they are."""
    law, moments, about = DEFAULT_LAW, CUBESAT, "These are a 3U CubeSat's: 4 kg, 10 x 10 x 34 cm."
    if group not in ROTATIONS:
        facts, laws = look_up(COMMAND, group), laws_on(group)
        law = law if law in laws else laws[0]
        if not (facts.is_rotation and facts.dim == len(CUBESAT)):
            moments = tuple(f"{1 + place / 10:.1f}" for place in range(facts.dim))
            about = "Rotation before translation (kg m^2, then kg m and kg). These hold a place."
    return law, moments, about


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
