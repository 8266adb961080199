"""What a controller consists of: the routines a vehicle of that kind is emitted with."""

from __future__ import annotations

from dataclasses import dataclass

from derive.control.baseline import lsf, lsf_printed, pd_plus
from derive.control.guard import Guarded, guarded
from derive.control.kinematic import KinematicLaw
from derive.control.mechanics import definiteness, plant
from derive.control.sliding import reaching, tracking
from derive.control.table import CONTROLLERS
from derive.lie.group import Group
from derive.routine.derivation import Derivation

WRITERS = {
    "gsmc": (tracking, reaching),
    "reaching": (reaching,),
    "lsf_printed": (lsf_printed,),
    "lsf": (lsf,),
    "pd_plus": (pd_plus,),
}
"""Controller -> its laws, as CONTROLLERS names them; the first is what `control` guards."""


@dataclass(frozen=True)
class Routines:
    """The derivations of one vehicle.

    main: the law that `control` guards, whole; guard: the same in parts, and what is judged
    public: the other routines that may be called; inner: those that only check_params calls
    """

    main: Derivation
    public: tuple[Derivation, ...]
    inner: tuple[Derivation, ...]
    guard: Guarded


def routines(
    group: Group,
    law: KinematicLaw,
    controller: str,
    pattern: tuple[bool, ...],
    options: tuple[str, ...] = (),
) -> Routines:
    """Derive everything a vehicle of this group, law, controller and zero pattern needs.

    Raises ValueError for a controller that does not exist on the group, or has another law.
    """
    known = CONTROLLERS[controller]
    if not known.exists_on(group.name) or known.law not in (None, law.name):
        places = " and ".join(known.groups) or "every group"
        what = f"{controller} exists on {places}, with law {known.law}"
        raise ValueError(f"{what}, not on {group.name} with {law.name}")
    main, *others = (write(group, law, pattern, options) for write in WRITERS[controller])
    bare = tuple(d.without("clearance") for d in others)
    guard, definite = guarded(group, main), definiteness(group, pattern)
    return Routines(main.pruned(), (*bare, plant(group, pattern, options)), (definite,), guard)
