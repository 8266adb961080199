"""Where the emitted C departs from MISRA C:2012 or is long, and why: the table in every package.

It is held to what a checker finds: a finding without a row is a fault, and so is a row without a
finding.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

LONGEST = 60
"""Lines from a function's opening brace to its closing one beyond which it needs a reason."""


CATEGORIES = {"8.7": "advisory", "12.1": "advisory", "12.3": "advisory", "15.5": "advisory"}
"""MISRA C:2012's category of each rule below. No deviation from a mandatory rule is permitted."""


@dataclass(frozen=True)
class Deviation:
    """A rule that is departed from.

    where:     the constructs that do, for people
    statement: the same as a regular expression, which matches from the start of a statement;
               `NAME` stands for the prefix of every name
    why:       the reason
    """

    rule: str
    where: str
    statement: str
    why: str

    @property
    def category(self) -> str:
        """Advisory, required or mandatory; KeyError for a rule whose category nobody has said."""
        return CATEGORIES[self.rule]


DEVIATIONS = (
    Deviation(
        "8.7",
        "the functions that the header declares",
        r"(void|NAME_status) NAME_[a-z_]+\(",
        "They are the interface: whoever calls them is outside of this package.",
    ),
    Deviation(
        "12.1",
        "sums of products",
        r"(const )?((float|double) )?\w+ = ",
        "Formulas are written as in the paper: * and / before + and -, as everybody reads them.",
    ),
    Deviation(
        "12.1",
        "comparisons in the guard",
        r"return |if |for ",
        "A comparison before && and ?, as everybody reads them.",
    ),
    Deviation(
        "12.3",
        "declarations of several numbers of one kind",
        r"(const )?(float|double) \w+( = |, )",
        "The commas separate declarators. There is no comma operator.",
    ),
    Deviation(
        "15.5",
        "functions that judge",
        r"return ",
        "The first finding decides, and is returned where it is found: nothing that follows can "
        "depend on what was found bad.",
    ),
)
"""Every rule that the emitted C departs from, in the order of the rules."""

LONG = (
    "They run straight on, one quantity or one condition after the other; the laws in the order of "
    "the paper, to be read beside it."
)
"""Why the longer functions are not cut up."""

_BODY = re.compile(r"^[\w ]*?\b(\w+)\([^;{}]*?\)\n\{\n.*?^\}", re.MULTILINE | re.DOTALL)


def long_functions(texts: Mapping[str, str]) -> Iterator[tuple[str, int]]:
    """(function, lines) of every function of the emitted sources that is longer than LONGEST."""
    for path, text in sorted(texts.items()):
        if path.startswith("c/src/"):
            for found in _BODY.finditer(text):
                lines = found[0].partition("\n{\n")[2].count("\n") + 1
                if lines > LONGEST:
                    yield found[1], lines
