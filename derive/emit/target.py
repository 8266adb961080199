"""The table of targets: scalars, their constants, and the files each target consists of."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

CONSTANTS = {
    "TINY": {"f64": Fraction("1e-290"), "f32": Fraction("1e-30")},
    "SMALL": {"f64": Fraction("1e-60"), "f32": Fraction("1e-10")},
    "FLOOR": {"f64": Fraction("1e-17"), "f32": Fraction("1e-8")},
    "CUT": {"f64": Fraction("1e-60"), "f32": Fraction("5e-8")},
    "SHORT": {"f64": Fraction("1e-7"), "f32": Fraction("0.75")},
}
"""Values of the kernel's named constants; an ulp over TINY does not overflow, nor SMALL^-3.

CUT is below the clearance that is refused; FLOOR moves a rate by less than a tenth of an ulp.
"""


@dataclass(frozen=True)
class Scalar:
    """A floating-point type: C spelling and the bounds of what `control` accepts.

    max_input: largest magnitude of any number in state and reference
    max_drift: largest residual of a configuration, see `residual` of its group
    near_cut:  clearance below which a command is flagged NEAR_CUT_LOCUS
    refused:   clearance below which a law with a pole is refused
    max_param: largest inertia entry and gain
    """

    name: str
    type: str
    suffix: str
    max_input: Fraction
    max_drift: Fraction
    near_cut: Fraction
    refused: Fraction
    max_param: Fraction

    def constants(self) -> tuple[tuple[str, Fraction, str], ...]:
        """(name, value, sentence) of each bound, as headers and modules state them."""
        return (
            ("MAX_INPUT", self.max_input, "largest magnitude of a number in state or reference"),
            ("MAX_DRIFT", self.max_drift, "largest residual of a configuration on the group"),
            ("NEAR_CUT", self.near_cut, "clearance below which NEAR_CUT_LOCUS is flagged"),
            ("REFUSED_CUT", self.refused, "clearance below which a law with a pole is refused"),
            ("MAX_PARAM", self.max_param, "largest magnitude of an inertia entry or a gain"),
        )


def _scalar(name: str, type_: str, suffix: str, *bounds: str) -> Scalar:
    return Scalar(name, type_, suffix, *(Fraction(bound) for bound in bounds))


SCALARS = {
    "f32": _scalar("f32", "float", "f", "1e6", "1e-4", "1e-3", "1e-7", "1e9"),
    "f64": _scalar("f64", "double", "", "1e6", "1e-6", "1e-3", "1e-8", "1e9"),
}


@dataclass(frozen=True)
class File:
    """One emitted file: its template and its path, {name} and {scalar} filled in."""

    template: str
    path: str


@dataclass(frozen=True)
class Target:
    """A kind of package: scalars it can carry, files per scalar, and files around all of them."""

    name: str
    scalars: tuple[str, ...]
    files: tuple[File, ...]
    around: tuple[File, ...] = ()


TARGETS = {
    "c99": Target(
        "c99",
        ("f32", "f64"),
        (
            File("c99/header.h.jinja", "c/include/{name}_{scalar}.h"),
            File("c99/source.c.jinja", "c/src/{name}_{scalar}.c"),
        ),
        (
            File("package/CMakeLists.txt.jinja", "CMakeLists.txt"),
            File("package/fragment.mk.jinja", "{name}.mk"),
            File("package/main.c.jinja", "example/main.c"),
        ),
    ),
    "numpy": Target("numpy", ("f64",), (File("numpy/module.py.jinja", "numpy/{name}.py"),)),
}
