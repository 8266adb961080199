"""The table of targets: scalars, their constants, and the files each target consists of."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

CONSTANTS = {
    "TINY": {"f64": Fraction("1e-290"), "f32": Fraction("1e-30")},
    "SMALL": {"f64": Fraction("1e-60"), "f32": Fraction("1e-10")},
    "FLOOR": {"f64": Fraction("1e-17"), "f32": Fraction("1e-8")},
    "LEAST": {"f64": Fraction("1e-8"), "f32": Fraction("0.75")},
    "NOISE": {"f64": Fraction("4e-15"), "f32": Fraction("2e-6")},
    "CUT": {"f64": Fraction("1e-60"), "f32": Fraction("5e-8")},
}
"""Values of the kernel's named constants; an ulp over TINY does not overflow, nor SMALL^-3.

NOISE is more than the 13 eps that 24 products of four rounded factors and their sum are off by;
CUT is below the clearance that is refused; FLOOR moves a rate by less than a tenth of an ulp.
"""


@dataclass(frozen=True)
class Scalar:
    """A floating-point type: C spelling and the bounds of what `control` accepts.

    max_input: largest magnitude of any number in state and reference
    max_entry: largest magnitude of an entry of the error that the group keeps at most 1
    max_reach: largest magnitude of any other entry of the error; max_own: on a user's group
    max_drift: distance of the error from the group that is accepted by default
    least_drift, most_drift: least and largest such distance that may be asked for: rounding
        alone, of two good rotations and of the steps, leads up to 33.4 units of roundoff off
    near_cut:  clearance below which a command is flagged NEAR_CUT_LOCUS
    refused:   clearance below which a law with a pole is refused
    max_param: largest inertia entry, force limit, and gain that is no rate
    min_gain, max_rate: least gain, and largest in 1/s
    shrunk: of 1, what is below it by two ulps: a quotient and two products later still below 1
    """

    name: str
    type: str
    suffix: str
    max_input: Fraction
    max_entry: Fraction
    max_reach: Fraction
    max_own: Fraction
    max_drift: Fraction
    least_drift: Fraction
    most_drift: Fraction
    near_cut: Fraction
    refused: Fraction
    max_param: Fraction
    min_gain: Fraction
    max_rate: Fraction
    shrunk: Fraction

    def constants(
        self,
        is_own: bool = False,
        has_reference: bool = True,
        hysteresis: Fraction | None = None,
    ) -> tuple[tuple[str, Fraction, str], ...]:
        """(name, value, sentence) of each bound, as headers and modules state them.

        Without a reference the error is the state, which is bounded by max_input anyhow.
        hysteresis: of the choice between q and -q, where there is one
        """
        side = ("HYSTERESIS", hysteresis or Fraction(0), "scalar part that turns the error over")
        reach = self.max_own if is_own else self.max_reach
        reach = reach if has_reference else min(reach, self.max_input)
        return (
            (
                "MAX_INPUT",
                self.max_input,
                "largest velocity, rate of one, and number the group does not bound",
            ),
            ("MAX_ENTRY", self.max_entry, "of an entry of the error that the group keeps at 1"),
            ("MAX_REACH", reach, "of any other entry of the error"),
            ("LEAST_DRIFT", self.least_drift, "least max_drift that may be asked for"),
            ("MOST_DRIFT", self.most_drift, "largest max_drift that may be asked for"),
            ("NEAR_CUT", self.near_cut, "clearance below which NEAR_CUT_LOCUS is flagged"),
            side,
            ("REFUSED_CUT", self.refused, "clearance below which a law with a pole is refused"),
            ("MAX_PARAM", self.max_param, "largest inertia entry, force limit, or other gain"),
            ("MIN_GAIN", self.min_gain, "least gain"),
            ("MAX_RATE", self.max_rate, "largest gain in 1/s"),
        )


def _scalar(name: str, type_: str, suffix: str, *bounds: str) -> Scalar:
    return Scalar(name, type_, suffix, *(Fraction(bound) for bound in bounds))


SCALARS = {
    "f32": _scalar("f32", "float", "f", "1e6", "1.01", "4e6", "1e3", "1e-4", "2e-6", "0.1", "1e-3",
                   "1e-5", "1e9", "1e-9", "1e4", "4194303/4194304"),
    "f64": _scalar("f64", "double", "", "1e6", "1.01", "4e6", "1e6", "1e-6", "1e-14", "0.1", "1e-3",
                   "1e-8", "1e9", "1e-9", "1e4", "2251799813685247/2251799813685248"),
}  # fmt: skip


@dataclass(frozen=True)
class File:
    """One emitted file: its template and its path, {name} and {scalar} filled in.

    is_test: whether it belongs to the self-test, which only a group with a known truth has
    """

    template: str
    path: str
    is_test: bool = False


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
            File("test/test.h.jinja", "test/{name}_{scalar}_test.h", is_test=True),
            File("test/test.c.jinja", "test/{name}_{scalar}_test.c", is_test=True),
        ),
        (
            File("package/CMakeLists.txt.jinja", "CMakeLists.txt"),
            File("package/fragment.mk.jinja", "{name}.mk"),
            File("package/main.c.jinja", "example/main.c"),
            File("test/main.c.jinja", "test/main.c", is_test=True),
            File("package/DEVIATIONS.md.jinja", "DEVIATIONS.md"),
        ),
    ),
    "numpy": Target("numpy", ("f64",), (File("numpy/module.py.jinja", "numpy/{name}.py"),)),
}
