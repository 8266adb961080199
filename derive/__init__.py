"""Geometric sliding-mode controllers, from a vehicle file to verified C and numpy.

Decides the public names. They are imported when first used, so that `import derive` is
instant: sympy alone takes longer to load than most commands take to run.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from derive import bundle as bundle
    from derive.bundle import Bundle as Bundle
    from derive.bundle import State as State
    from derive.control.sliding import reaching as reaching
    from derive.control.sliding import tracking as tracking
    from derive.lie.catalogue import GROUPS as GROUPS
    from derive.lie.group import Group as Group
    from derive.routine.derivation import Derivation as Derivation
    from derive.vehicle import InputError as InputError
    from derive.vehicle import Vehicle as Vehicle
    from derive.vehicle import load as load

__version__ = "0.1.0"

_HOME = {
    "Bundle": "derive.bundle",
    "Derivation": "derive.routine.derivation",
    "GROUPS": "derive.lie.catalogue",
    "Group": "derive.lie.group",
    "InputError": "derive.vehicle",
    "State": "derive.bundle",
    "Vehicle": "derive.vehicle",
    "bundle": "derive.bundle",
    "load": "derive.vehicle",
    "reaching": "derive.control.sliding",
    "tracking": "derive.control.sliding",
}

__all__ = [
    "GROUPS",
    "Bundle",
    "Derivation",
    "Group",
    "InputError",
    "State",
    "Vehicle",
    "__version__",
    "bundle",
    "load",
    "reaching",
    "tracking",
]


def __getattr__(name: str) -> object:
    """Import a public name from its home on first use."""
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    home = import_module(_HOME[name])
    value: object = home if home.__name__ == f"{__name__}.{name}" else getattr(home, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOME})
