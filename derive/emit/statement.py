"""The statements of a routine that take more than a name and a value: loads and choices."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

Data = Mapping[str, Any]
"""A printed input or step."""


def loads(one: Data) -> list[str]:
    """Of C: each entry of an input that is used, with where it lies in memory."""
    place = f"{one['holder']}->{one['member']}" if one["holder"] else one["member"]
    return [
        f"{name} = {place}" if one["is_scalar"] else f"{name} = {place}[{index}]"
        for name, index in one["entries"]
    ]


def names(one: Data) -> str:
    """Of numpy: the entries of an input that are used."""
    return ", ".join(name for name, _ in one["entries"])


def columns(one: Data) -> str:
    """Of numpy: where these entries lie in the argument."""
    return ", ".join(f"{one['argument']}[{index}]" for _, index in one["entries"])


def choice(step: Data) -> Iterator[tuple[str, str]]:
    """Of numpy: (name, value) of each condition of a step with cases, then of each entry."""
    if not step["cases"]:
        return
    *cases, last = step["cases"]
    whens = [f"{step['name']}_if_{place}" for place in range(len(cases))]
    yield from ((when, case["condition"]) for when, case in zip(whens, cases, strict=True))
    for row, (name, otherwise) in enumerate(last["lines"]):
        chosen = (
            f"np.where({when}, {case['lines'][row][1]}, "
            for when, case in zip(whens, cases, strict=True)
        )
        yield name, f"{''.join(chosen)}{otherwise}{')' * len(cases)}"


FILTERS = {one.__name__: one for one in (loads, names, columns, choice)}
"""Name in a template -> what it calls."""
