"""Formulas in LaTeX, as the paper writes them; amsmath is all they need."""

from __future__ import annotations

import re

from derive.explain.notation import GREEK, Notation, conditions, parts


def _symbol(name: str) -> str:
    base, subscripts, is_dotted = parts(name)
    bare = _letter(base)
    if is_dotted:
        bare = rf"\dot{{{bare}}}"
    below = ",".join(_letter(part) for part in subscripts)
    return f"{bare}_{{{below}}}" if below else bare


def _letter(part: str) -> str:
    if part in GREEK:
        return f"\\{part}"
    is_word = len(part) > 1 and not part.isdigit()
    return rf"\mathrm{{{part.replace(' ', '~')}}}" if is_word else part


_SPECIAL = {
    **{character: f"\\{character}" for character in "{}$&#_%"},
    **{character: f"${character}$" for character in "<>|"},
    "\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}",
}  # fmt: skip


def _plain(text: str) -> str:
    return re.sub(r"[{}$&#_%<>|\\^~]", lambda found: _SPECIAL[found[0]], text)


LATEX = Notation(
    symbol=_symbol,
    is_flat=False,
    width=72,
    product=r"\,",
    plus=" + ",
    minus="-",
    less=" - ",
    fraction=r"\frac{%s}{%s}",
    power="%s^{%s}",
    root=r"\sqrt{%s}",
    absolute=r"\left|%s\right|",
    group=r"\left(%s\right)",
    opening=r"\bigl(",
    closing=r"\bigr)",
    call=r"%s\left(%s\right)",
    prime="%s'",
    actions={
        "Ad": r"\mathrm{Ad}_{%s}", "ad": r"\mathrm{ad}_{%s}", "coad": r"\mathrm{ad}^{*}_{%s}",
    },
    relation=" %s ",
    relations={">=": r"\ge", "<=": r"\le"},
    both=r"\text{ and }",
    column=lambda entries: (
        r"\begin{pmatrix} " + r" \\ ".join(entries) + r" \end{pmatrix}"
    ),
    matrix=lambda rows: (
        r"\begin{pmatrix} " + r" \\ ".join(" & ".join(row) for row in rows) + r" \end{pmatrix}"
    ),
    cases=lambda cases: (
        r"\begin{cases} "
        + r" \\ ".join(
            f"{value} & {when}"
            for value, when in conditions(cases, r"\text{if } %s", r"\text{otherwise}")
        )
        + r" \end{cases}"
    ),
    single="\\[\n%s\n\\]",
    rows=lambda rows: (
        "\\begin{align*}\n"
        + " \\\\\n".join(f"{left} &= {right}" if left else f"&\\quad {right}"
                         for left, right in rows)
        + "\n\\end{align*}"
    ),
    plain=_plain,
    code=str,
)  # fmt: skip
