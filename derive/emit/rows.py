"""What the numpy guard compares and passes on, as text over rows: a batch of each input.

Each comparison holds for good numbers, and fails for NaN.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from derive.emit.condition import Data, gain_bounds

Places = Mapping[str, str]
"""Name of an input -> the expression that has its rows."""


def rows(data: Data) -> dict[str, Any]:
    """Texts and routines, by the name that templates know them by.

    reads:  what a law is run on: error, drift, what is divided by (apart), law past the error, and
        that on the chosen side
    inputs: the rows of state and reference; at_identity: the error where there is no reference
    most:   name of the largest magnitude of each entry of the error
    free:   whether the group leaves it free
    judged: conditions on all that is read; sound: on inertia and gains
    laws:   (symbol, routine) of what is run on columns, in the order in which it stands
    """
    place, is_bounded = _places(data), data["is_bounded"]
    sided = {**place, "g_e": "sign * g_e"}
    return {
        "reads": {
            **{name: _reads(place, data[name]) for name in ("error", "drift") if data[name]},
            "apart": [place["g_r"]] if data["error"] else [],
            "law": _reads(place, data["core"]),
            "sided_law": _reads(sided, data["core"]),
        },
        "inputs": [place[one["name"]] for one in _measured(data)],
        "at_identity": place["g"],
        "most": ["MAX_ENTRY" if one else "MAX_REACH" for one in is_bounded],
        "free": [not one for one in is_bounded],
        "judged": list(_judged(data, place)),
        "sound": list(_sound(data)),
        "laws": list(_laws(data)),
    }


def _places(data: Data) -> Places:
    """Of all inputs of the main routine: parameters first."""
    inputs = data["main"]["inputs"]
    params = [one for one in inputs if one["holder"] == "params"]
    whole = [*params, *_measured(data)]
    return {one["name"]: f"given[{i}]" for i, one in enumerate(whole)}


def _measured(data: Data) -> list[Data]:
    return [one for one in data["main"]["inputs"] if one["holder"] != "params"]


def _reads(place: Places, routine: Data) -> list[str]:
    """Rows of what a routine reads; the error has its own name."""
    return [place.get(one["name"], one["name"]) for one in routine["inputs"]]


def _judged(data: Data, place: Places) -> Iterator[str]:
    """Of the error, then of state and reference: an error bounds what its group bounds."""
    yield "(np.abs(g_e) <= BOUNDS).all(-1)"
    for one in _measured(data):
        small = f"np.abs({place[one['name']]}) <= MAX_INPUT"
        if one["member"] != "g":
            yield f"({small}).all(-1)"
        elif data["error"]:
            yield f"(({small}) | ~FREE).all(-1)"


def _sound(data: Data) -> Iterator[str]:
    """Of the inertia, its pivots and the zeros that were taken for granted; of each gain."""
    yield "(np.abs(inertia) <= MAX_PARAM).all(-1) & (pivots > 0.0).all(-1)"
    if data["zeros"]:
        yield f"(inertia[..., [{', '.join(map(str, data['zeros']))}]] == 0.0).all(-1)"
    bound_of = gain_bounds(data)
    for i, (name, _) in enumerate(data["gains"]):
        yield f"((gains[{i}] >= MIN_GAIN) & (gains[{i}] <= {bound_of[name]}))[..., 0]"


def _laws(data: Data) -> Iterator[tuple[str, Data]]:
    """With a side to choose, the main law starts from the error."""
    main, *others = data["routines"]
    yield main["symbol"], data["core"] if data["has_side"] else main
    yield from ((one["symbol"], one) for one in others)
    yield from ((name, data[name]) for name in ("error", "drift", "apart") if data[name])
