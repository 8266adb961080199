"""Which controllers and options a vehicle file may ask for, and the gains each controller takes.

Kept free of third-party imports, so that a vehicle file is judged without deriving anything.
"""

CONTROLLERS: dict[str, tuple[str, ...]] = {
    "gsmc": ("lambda", "k_s"),  # geometric sliding-mode tracking, eq. (TckCtrl); both in 1/s
    "reaching": ("lambda", "k_s"),  # the law without a reference, eq. (Ctrl2); both in 1/s
}
"""Controller name -> names of its gains, in the order in which they are passed on."""

OPTIONS = ("external", "momentum")
"""What a state may hold besides g and nu: a known force, the internal momentum of wheels."""
