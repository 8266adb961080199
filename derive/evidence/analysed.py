"""The emitted source as Eva reads it: every statement marked, comparisons of |x| by cases.

The marks say which statements are reached. Of `fabs(x) <= limit` Eva 25 knows neither that it
holds x on both sides of zero, nor that it fails for NaN; the driver's EVA_ABS says both. Of
`size > limit`, both unknown, it keeps nothing; the driver's quotient is at most 1.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

MARK = "Frama_C_show_each_reached();"
_COMPARED = re.compile(r"\bfabsf?(\((?:[^()]|\([^()]*\))*\))(\s*<=)")
_SHARED = re.compile(r"(\(size > limit\) \? )limit/size\b")
_ENDS = (";", "{", "}")
_OPENS_NONE = re.compile(r"[}{]|else\b|case\b|default\b")
_NAMED = re.compile(r"(?!\s*[#/*]|typedef\b|extern\b)[\w\s*]*?\b(\w+)\(")


def analysed(source: str, is_marked: bool = True) -> str:
    """The same lines, a mark before each that begins a statement; EVA_ABS and eva_quotient."""
    marked = set(statements(source)) if is_marked else set()
    lines = source.splitlines()
    text = "\n".join(
        f"{MARK} {line.lstrip()}" if number in marked else line
        for number, line in enumerate(lines, start=1)
    )
    text = _SHARED.sub(r"\1eva_quotient(limit, size)", text)
    return _COMPARED.sub(r"EVA_ABS\1\2", text) + "\n"


def statements(source: str) -> Iterator[int]:
    """Numbers of the lines on which a statement of a function begins, the first line is 1.

    What a build has to ask for, in #ifdef, is left out.
    """
    is_comment, is_off, last = False, False, ""
    for number, name, line in _bodies(source):
        is_off = (is_off or line.startswith("#if")) and not line.startswith("#endif")
        code = re.sub(r"/\*.*?\*/", "", line).strip()
        was_comment, is_comment = is_comment, "*/" not in code and (is_comment or "/*" in code)
        if was_comment or is_comment or is_off or not code or code.startswith("#"):
            continue
        if name and last.endswith(_ENDS) and not _OPENS_NONE.match(code):
            yield number
        last = code


def places(source: str) -> dict[int, str]:
    """Line -> the function that it is in, for the lines of bodies."""
    return {number: name for number, name, _ in _bodies(source) if name}


def _bodies(source: str) -> Iterator[tuple[int, str, str]]:
    """(number, function, line) of every line; no function outside of the braces of a body."""
    name, is_inside = "", False
    for number, line in enumerate(source.splitlines(), start=1):
        found = _NAMED.match(line)
        name = found[1] if found and not is_inside else name
        is_inside = (is_inside or line == "{") and line != "}"
        yield number, name if is_inside and line != "{" else "", line
