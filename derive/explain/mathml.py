"""Formulas in presentation MathML, of the core that browsers draw themselves."""

from __future__ import annotations

import html
from collections.abc import Sequence

from derive.explain.notation import GREEK, Notation, conditions, parts


def _symbol(name: str) -> str:
    base, subscripts, is_dotted = parts(name)
    bare = _letter(base)
    if is_dotted:
        bare = f'<mover accent="true">{bare}<mo stretchy="false">˙</mo></mover>'
    below = "<mo>,</mo>".join(_letter(part) for part in subscripts)
    return f"<msub>{bare}<mrow>{below}</mrow></msub>" if below else bare


def _letter(part: str) -> str:
    return f"<mn>{part}</mn>" if part.isdigit() else f"<mi>{GREEK.get(part, part)}</mi>"


def _table(kind: str, rows: Sequence[Sequence[str]]) -> str:
    cells = ("".join(f"<mtd>{cell}</mtd>" for cell in row) for row in rows)
    return f'<mtable class="{kind}">{"".join(f"<mtr>{row}</mtr>" for row in cells)}</mtable>'


def _rows(rows: Sequence[tuple[str, str]]) -> str:
    equals = '<mo form="infix">=</mo>'
    table = _table("rows", [(left, equals * bool(left) + right) for left, right in rows])
    return f'<math display="block">{table}</math>'


MATHML = Notation(
    symbol=_symbol,
    is_flat=False,
    width=80,
    product='<mspace width="0.17em"/>',
    plus="<mo>+</mo>",
    minus="<mo>−</mo>",
    less="<mo>−</mo>",
    fraction="<mfrac><mrow>%s</mrow><mrow>%s</mrow></mfrac>",
    power="<msup><mrow>%s</mrow><mrow>%s</mrow></msup>",
    root="<msqrt>%s</msqrt>",
    absolute="<mrow><mo>|</mo>%s<mo>|</mo></mrow>",
    group="<mrow><mo>(</mo>%s<mo>)</mo></mrow>",
    opening='<mo stretchy="false">(</mo>',
    closing='<mo stretchy="false">)</mo>',
    call="%s<mrow><mo>(</mo>%s<mo>)</mo></mrow>",
    prime="<msup>%s<mo>′</mo></msup>",
    actions={
        "Ad": "<msub><mi>Ad</mi><mrow>%s</mrow></msub>",
        "ad": "<msub><mi>ad</mi><mrow>%s</mrow></msub>",
        "coad": "<msubsup><mi>ad</mi><mrow>%s</mrow><mo>∗</mo></msubsup>",
    },
    relation="<mo>%s</mo>",
    relations={">=": "≥", "<=": "≤", "<": "&lt;", ">": "&gt;"},
    both="<mtext>&#160;and&#160;</mtext>",
    column=lambda entries: (
        "<mrow><mo>(</mo>" + _table("column", [[one] for one in entries]) + "<mo>)</mo></mrow>"
    ),
    matrix=lambda rows: "<mrow><mo>(</mo>" + _table("matrix", rows) + "<mo>)</mo></mrow>",
    cases=lambda cases: (
        "<mrow><mo>{</mo>"
        + _table(
            "cases", conditions(cases, "<mtext>if&#160;</mtext>%s", "<mtext>otherwise</mtext>")
        )
        + "</mrow>"
    ),
    single='<math display="block">%s</math>',
    rows=_rows,
    plain=html.escape,
    code=html.escape,
)
