"""Which controllers and options a vehicle file may ask for, and the gains each controller takes.

Kept free of third-party imports, so that a vehicle file is judged without deriving anything.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Gain:
    """A gain by its key in the vehicle file, which is its name on the target too.

    symbol: what the derivation calls it
    """

    name: str
    unit: str
    doc: str
    symbol: str


@dataclass(frozen=True)
class Controller:
    """What a controller takes, and where it exists.

    gains:  in the order in which they are passed on
    routines: its laws as they are called on the target; the first is what `control` guards
    law:    the kinematic law that its attitude error is made of; None where the file names one
    groups: names of the groups it exists on; none where it exists on every group
    why:    why on no other
    """

    gains: tuple[Gain, ...]
    routines: tuple[str, ...] = ("tracking",)
    law: str | None = None
    groups: tuple[str, ...] = ()
    why: str = ""

    @property
    def names(self) -> tuple[str, ...]:
        """Keys of its gains, in order."""
        return tuple(gain.name for gain in self.gains)

    @property
    def is_baseline(self) -> bool:
        """Whether it is one of those the paper compares with: its error is its own, no rate."""
        return self.law is not None

    @property
    def has_reference(self) -> bool:
        """Whether what `control` guards follows a reference; if not, it goes to rest at e."""
        return self.routines[0] == "tracking"

    def exists_on(self, group: str) -> bool:
        """Whether it exists on the group of that name."""
        return not self.groups or group in self.groups


_SLIDING = (
    Gain("lambda", "1/s", "sliding rate", "rate_gain"),
    Gain("k_s", "1/s", "reaching rate", "reach_gain"),
)
_LSF = (
    Gain("k", "1/s", "gain of s", "k"),
    Gain("kappa", "1/s^2", "gain of the attitude error", "kappa"),
)
_PD = (
    Gain("k_R", "N m", "gain of the attitude error", "k_R"),
    Gain("k_Omega", "N m s", "gain of s", "k_Omega"),
)
_MATRICES = "its attitude error is made of R_e - R_e^T of rotation matrices"

CONTROLLERS: dict[str, Controller] = {
    # Geometric sliding-mode tracking, eq. (TckCtrl), and the law without a reference, eq. (Ctrl2).
    "gsmc": Controller(_SLIDING, ("tracking", "reaching")),
    "reaching": Controller(_SLIDING, ("reaching",)),
    # What the paper compares with: eq. (Ctrls2) to the letter and mended, eq. (Ctrls3).
    "lsf_printed": Controller(_LSF, law="skew", groups=("SO3",), why=_MATRICES),
    "lsf": Controller(_LSF, law="skew", groups=("SO3",), why=_MATRICES),
    "pd_plus": Controller(_PD, law="lee", groups=("SO3",), why=_MATRICES),
}
"""Controller name -> what it takes."""

OPTIONS = ("external", "momentum")
"""What a state may hold besides g and nu: a known force, the internal momentum of wheels."""
