"""What surrounds the emitted code: the build files of a package and the example beside it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from derive import __version__
from derive.emit.deviation import DEVIATIONS, LONG, LONGEST, long_functions
from derive.emit.render import environment, spelled
from derive.emit.target import SCALARS, Target

FLAGS = ("-std=c99", "-ffp-contract=off", "-fno-math-errno")
"""No fused multiply-add, so that every compiler rounds alike; sqrt an instruction, not a call."""

MEASURED = ("0.6", "0.0", "0.0", "0.8")
"""What the example's attitude sensor reads: x, y, z, w, a turn of 74 degrees about axis one."""


def around(
    target: Target, printed: Mapping[str, Any], values: Mapping[str, Any],
    texts: Mapping[str, str], *, has_test: bool = False,
) -> dict[str, str]:  # fmt: skip
    """The files around all scalars of one target, {path: text}; the example uses the widest.

    texts: what was rendered of the target; has_test: whether the package tests itself
    """
    scalars = [scalar for scalar in target.scalars if scalar in printed]
    widest = scalars[-1]
    words = spelled(widest, target, values)
    built = _built(target, scalars, values["name"], has_test)
    initial = _initial(printed[widest], words["number"])
    context = {**printed[widest], **words, **built, **initial, **_departures(texts)}
    read = environment().get_template
    files = [file for file in target.around if has_test or not file.is_test]
    paths = {file.path.format(name=values["name"]): file.template for file in files}
    return {path: read(template).render(context) for path, template in paths.items()}


def _departures(texts: Mapping[str, str]) -> dict[str, Any]:
    """What DEVIATIONS.md lists."""
    long = list(long_functions(texts))
    return {"deviations": DEVIATIONS, "long": long, "longest": LONGEST, "why_long": LONG}


def _built(target: Target, scalars: list[str], name: str, has_test: bool) -> dict[str, Any]:
    """sources, those of the self-test, the roots called, by scalar, and the flags of them all."""
    files = [
        (file.path.format(name=name, scalar=scalar), file.is_test)
        for scalar in scalars
        for file in target.files
    ]
    files += [(file.path, True) for file in target.around if file.is_test]
    sources = [one for one in files if one[0].endswith(".c")]
    return {
        "sources": [path for path, is_test in sources if not is_test],
        "tests": [path for path, is_test in sources if is_test and has_test],
        "prefixes": [f"{name}_{scalar}" for scalar in scalars],
        "roots": [f"sqrt{SCALARS[scalar].suffix}" for scalar in scalars],
        "flags": FLAGS,
        "version": __version__,
    }


def _initial(data: Mapping[str, Any], number: Callable[[Fraction], str]) -> dict[str, Any]:
    """Initialisers of the example: what is measured, and every struct at rest at the identity."""
    identity = ", ".join(number(Fraction(entry)) for entry in data["identity"])
    zero = number(Fraction(0))
    rest = {
        struct["name"]: ", ".join(
            f"{{{identity if field['member'] == 'g' else zero}}}" for field in struct["fields"]
        )
        for struct in data["structs"]
    }
    return {"rest": rest, "measured": ", ".join(number(Fraction(x)) for x in MEASURED)}
