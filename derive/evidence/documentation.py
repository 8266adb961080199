"""The header as documentation: doxygen must find everything described, and nothing amiss."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator

from derive.evidence.emitted import Emitted
from derive.evidence.tool import Tool, run
from derive.verify.check import Check
from derive.verify.limits import LIMITS

DOXYGEN = Tool("doxygen", "apt install doxygen")
SECONDS = 60

OPTIONS = {
    "OPTIMIZE_OUTPUT_FOR_C": "YES",
    "EXTRACT_ALL": "NO",  # or else what is not described is passed over
    "WARN_IF_UNDOCUMENTED": "YES",
    "WARN_IF_DOC_ERROR": "YES",
    "WARN_IF_INCOMPLETE_DOC": "YES",
    "WARN_NO_PARAMDOC": "YES",  # is right only where pages are written
    "GENERATE_HTML": "YES",
    "GENERATE_LATEX": "NO",
    "HAVE_DOT": "NO",
    "QUIET": "YES",
    "WARN_FORMAT": '"$file:$line: warning: $text"',
}
"""What it is asked for, beyond its defaults."""


def documented(one: Emitted) -> Iterator[Check]:
    """Warnings about the header of one scalar; raises ToolMissing, ToolFailed."""
    with tempfile.TemporaryDirectory() as scratch:
        places = {"INPUT": f'"{one.header}"', "OUTPUT_DIRECTORY": f'"{scratch}"'}
        asked = "".join(f"{key} = {value}\n" for key, value in (OPTIONS | places).items())
        said = run([DOXYGEN.path, "-"], SECONDS, fed=asked)
    lines = [re.sub(r"^\S*/", "", line) for line in said.splitlines() if line.strip()]
    first = lines[0] if lines else ""
    limit = LIMITS["findings"]
    yield Check("doxygen: warnings", one.scalar, len(lines), limit, 1, first, tuple(lines[1:10]))
