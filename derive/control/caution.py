"""What a user of a law is warned of when a vehicle is emitted, by group of the catalogue.

Frozen here, so that nothing has to be judged at emission: a test holds every sentence to what
derive.verify.law.definition computes. A sentence follows `law … on …`.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from derive.lie.group import Group


@dataclass(frozen=True)
class Caution:
    """A consequence, and the law that is free of it; told only where that law exists."""

    sentence: str
    instead: str = ""

    @property
    def text(self) -> str:
        """Both."""
        return f"{self.sentence}; not so with {self.instead}" if self.instead else self.sentence


_REFUSED = "{} towards {}: control refuses it there, and the force is zero"
_STAYS = "vanishes at {}: a vehicle at rest there stays"
_NO_BOUND, _STEEP = "has no bound", "has a rate without bound"
_PI, _ANTIPODE = "rotations by pi", "-i, the attitude of the identity"

_AT_PI = Caution(_REFUSED.format(_NO_BOUND, _PI), "log")
_NO_VALUE = Caution(_REFUSED.format(_NO_BOUND, _ANTIPODE), "vec")
_NO_RATE = Caution(_REFUSED.format(_STEEP, _ANTIPODE), "vec")
_EVERY = Caution(_STAYS.format("every rotation by pi"))


def _some(dimension: int) -> Caution:
    return Caution(_STAYS.format(f"{_PI}, on a set of dimension {dimension}"))


CAUTIONS: dict[tuple[str, str], Caution] = {
    ("SO2", "cayley"): _AT_PI,
    ("SO3", "skew"): _EVERY,
    ("SO3", "gibbs"): _AT_PI,
    ("SO3", "cayley"): _AT_PI,
    ("S3", "log"): _NO_RATE,
    ("S3", "half_log"): _NO_RATE,
    ("S3", "mrp"): _NO_VALUE,
    ("S3", "cayley"): _NO_VALUE,
    ("S3", "sign_vec"): Caution("lets V = V_2 rise for q0 < 0, where it drives to -i"),
    ("SE2", "skew"): _EVERY,
    ("SE2", "cayley"): _AT_PI,
    ("SE3", "skew"): _some(4),
    ("SE3", "cayley"): _AT_PI,
    ("SE23", "skew"): _some(6),
    ("SE23", "cayley"): _AT_PI,
}
"""(group, law) -> what is to be said; nothing of any other."""


def cautions(group: Group, law: str, available: Collection[str]) -> tuple[str, ...]:
    """What is to be said of a law on a group of the catalogue, or on a product of such groups.

    available: the names of all laws on that group
    """
    found = []
    for order, factor in enumerate(group.factors or (group,)):
        one = CAUTIONS.get((factor.name, law))
        if one and (not one.instead or one.instead in available):
            found.append(f"{one.text} (factor {order + 1}, {factor.name})" if group.factors
                         else one.text)  # fmt: skip
    return tuple(found)
