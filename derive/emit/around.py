"""What surrounds the emitted code: the build files of a package and the example beside it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from derive.emit.render import environment, spelled
from derive.emit.target import SCALARS, Target

FLAGS = ("-std=c99", "-ffp-contract=off", "-fno-math-errno")
"""No fused multiply-add, so that every compiler rounds alike; sqrt an instruction, not a call."""

MEASURED = ("0.6", "0.0", "0.0", "0.8")
"""What the example's attitude sensor reads: x, y, z, w, a turn of 74 degrees about axis one."""


def around(
    target: Target, printed: Mapping[str, Any], values: Mapping[str, Any], *, has_test: bool = False
) -> dict[str, str]:
    """The files around all scalars of one target, {path: text}; the example uses the widest."""
    scalars = [scalar for scalar in target.scalars if scalar in printed]
    widest = scalars[-1]
    words = spelled(widest, target, values)
    built = _built(target, scalars, values["name"], has_test)
    context = {**printed[widest], **words, **built, **_initial(printed[widest], words["number"])}
    read = environment().get_template
    files = [file for file in target.around if has_test or not file.is_test]
    paths = {file.path.format(name=values["name"]): file.template for file in files}
    return {path: read(template).render(context) for path, template in paths.items()}


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
