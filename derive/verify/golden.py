"""Golden vectors: which inputs the package's own test tries, and what the truth says of each.

Nothing here depends on an inertia or a gain: what does is put together in `combined`. Inputs are
made with 130 digits and without random numbers, so every machine writes the same bytes.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

from derive.emit.status import FIRST_BAD, STATUSES
from derive.emit.target import SCALARS, Scalar
from derive.verify.branch import Turn, clearance, turns
from derive.verify.oracle import baseline_truth, matrix_truth, truth
from derive.verify.oracle.factor_law import lifted
from derive.verify.oracle.matrix_group import bracket, dim, factors
from derive.verify.plant import Plant
from derive.verify.rung import Rung, draw, element, ladder

mp = truth.mp

Row = dict[str, Any]
"""doc, given (input -> numbers), status, clearance, known (name -> decimals; none if refused)."""

Numbers = dict[str, list[float]]
"""What each input is given."""

DIGITS = 50
UNSURE = 1e-2
"""Relative distance from a threshold of the clearance within which rounding may decide."""

VALUE = {name: value for name, value, _ in STATUSES}
OFF = mp.mpf("1.25")
"""What an element is multiplied with to be off its group, far beyond every margin."""


def is_known(vehicle: Plant) -> bool:
    """Whether the truth knows the vehicle's group, as it must before it says anything."""
    try:
        return bool(factors(vehicle.space))
    except ValueError:
        return False


def golden(vehicle: Plant, *, is_pole: bool, scalars: Sequence[str]) -> dict[str, Any]:
    """Rows by scalar, the identity, and the bracket as [i, j, k, c]: [E_i, E_j] has c E_k in it.

    vehicle: its inertia and gains are not looked at; is_pole: whether its law has a pole
    """
    return {
        "bracket": _bracket(vehicle),
        "identity": [float(x) for x in element(vehicle, Rung("0", False), 0, is_moving=False)[1]],
        "rows": {scalar: _rows(vehicle, is_pole, scalar) for scalar in scalars},
    }


def _bracket(vehicle: Plant) -> list[list[Any]]:
    """Factor by factor: those of others commute, and so does all of R^n."""
    found: list[list[Any]] = []
    start, n = 0, dim(vehicle.space)
    for one in factors(vehicle.space):
        mine = range(start, start + one.dim) if one.turns or vehicle.own else ()
        found += [entry for i, j in combinations(mine, 2) for entry in _brackets(vehicle, n, i, j)]
        start += one.dim
    return sorted(found)


def _brackets(vehicle: Plant, n: int, i: int, j: int) -> Iterator[list[Any]]:
    """The entries of [E_i, E_j] and of [E_j, E_i]."""
    first, second = ([int(at == k) for k in range(n)] for at in (i, j))
    for k, c in enumerate(bracket(vehicle.space, first, second)):
        if c:
            yield from ([i, j, k, _decimal(c)], [j, i, k, _decimal(-c)])


def _rows(vehicle: Plant, is_pole: bool, scalar: str) -> list[Row]:
    kind, places = SCALARS[scalar], enumerate(ladder(vehicle, scalar, is_pole=is_pole))
    good = [row for i, rung in places if (row := _good(vehicle, rung, i, is_pole, kind))]
    whole = next(row for row in reversed(good) if row["status"] == "OK" and row["is_moving"])
    return good + list(_bad(vehicle, whole["given"], kind))


def _good(vehicle: Plant, rung: Rung, place: int, is_pole: bool, kind: Scalar) -> Row | None:
    """What `control` makes of a rung; None where rounding decides between two statuses.

    None too at -i itself, where the truth knows of no rate, not even a smooth law's.
    """
    given = _given(vehicle, rung, place, kind.name)
    seen = given if vehicle.hysteresis is None else _nearer(vehicle, given)
    try:
        found = {} if is_pole else _truth(vehicle, seen)
    except ZeroDivisionError:
        return None
    error = turns(vehicle, found) if found else _turns(vehicle, given)
    off = clearance(vehicle, error) if vehicle.hysteresis is None else error[0].q[0]
    margins = [vehicle.hysteresis or kind.near_cut, *([kind.refused] if is_pole else [])]
    if any(abs(off / float(margin) - 1) < UNSURE for margin in margins):
        return None
    refused = is_pole and off < float(kind.refused)
    near = "NEAR_CUT_LOCUS" if off < float(margins[0]) else "OK"
    return {
        "doc": f"{rung.doc}{_moves(rung)}" if vehicle.has_reference else rung.doc,
        "is_moving": rung.is_moving,
        "given": given,
        "status": "OUT_OF_RANGE" if refused else near,
        "clearance": float(off) if is_pole else 1.0,
        "known": {} if refused else _known(vehicle, given, found or _truth(vehicle, given)),
    }


def _nearer(vehicle: Plant, given: Numbers) -> Numbers:
    """The same, the reference's quaternion negated where that makes the error the nearer one."""
    q = truth.error(vehicle.group, given["g_r"], given["g"])
    return {**given, "g_r": [-x for x in given["g_r"]]} if q[0] < 0 else given


def _moves(rung: Rung) -> str:
    return ", moving reference" if rung.is_moving else ", at rest"


def _inputs(vehicle: Plant) -> tuple[str, ...]:
    reference = ("g_r", "nu_r", "nu_r_dot") if vehicle.has_reference else ()
    return ("g", "nu", *vehicle.options, *reference)


def _given(vehicle: Plant, rung: Rung, place: int, scalar: str) -> Numbers:
    """The numbers of a rung as that scalar stores them."""
    is_moving = rung.is_moving and vehicle.has_reference
    names, n, numbers = _inputs(vehicle), dim(vehicle.space), draw(place)
    found: dict[str, Any] = dict(zip(("g", "g_r"), element(vehicle, rung, place, is_moving),
                                     strict=True))  # fmt: skip
    for name in ("nu", "nu_r", "nu_r_dot", "momentum", "external"):
        moves = is_moving or not name.startswith("nu_r")
        found[name] = [next(numbers) * rung.pace if moves else 0.0 for _ in range(n)]
    return {name: [stored(x, scalar) for x in found[name]] for name in names}


def stored(value: Any, scalar: str) -> float:
    """The number of that scalar next to a value."""
    number = float(value)
    return float(struct.unpack("f", struct.pack("f", number))[0]) if scalar == "f32" else number


def _turns(vehicle: Plant, given: Numbers) -> tuple[Turn, ...]:
    """The error of each factor, to 130 digits, where the law itself may have no bound."""
    name, g = vehicle.space, given["g"]
    if vehicle.is_attitude:
        identity = truth.IDENTITY[vehicle.group]
        q = truth.error(vehicle.group, given.get("g_r", identity), g)
        return (Turn(vehicle.group, None, q),)
    error = matrix_truth.element(name, g)
    if "g_r" in given:
        error = matrix_truth.error(name, matrix_truth.element(name, given["g_r"]), error)
    parts = zip(vehicle.factors, factors(name), error, strict=True)
    return tuple(Turn(which, a, lifted(one, a).q) for which, one, a in parts)


def _known(vehicle: Plant, given: Numbers, found: dict[str, Any]) -> dict[str, list[str]]:
    """The law, its rate and the velocities it is made of, in decimals."""
    names = ("nu_u", "nu_u_dot", "nu_e", "eta", "eta_dot")
    known = {name: found[name] for name in names if name in found}
    if vehicle.controller == "pd_plus":  # R_e^T nu_r_dot is the velocity error of such a reference
        still = (0,) * len(given["nu"])
        turned = _truth(vehicle, given | {"nu": still, "nu_r": given["nu_r_dot"]})
        known["pulled"] = [-x for x in turned["nu_e"]]
    return {name: [_decimal(x) for x in row] for name, row in known.items()}


def _truth(vehicle: Plant, given: dict[str, Any]) -> dict[str, Any]:
    """The oracle's own answer for the unit inertia and unit gains."""
    n = dim(vehicle.space)
    unit = [[int(i == j) for j in range(n)] for i in range(n)]
    row = {name: x for name, x in given.items() if name not in vehicle.options}
    if vehicle.is_baseline:
        ones = dict.fromkeys(vehicle.named_gains("f64"), 1)
        return baseline_truth.tracking(vehicle.controller, unit, ones, **row)
    if vehicle.is_attitude:
        write = truth.tracking if vehicle.has_reference else truth.reaching
        return write(vehicle.group, vehicle.law, unit, 1, 1, **row)
    run = matrix_truth.tracking if vehicle.has_reference else matrix_truth.reaching
    return run(vehicle.space, vehicle.law, unit, 1, 1, **row)


def _decimal(value: Any) -> str:
    return str(mp.nstr(value, DIGITS))


def _bad(vehicle: Plant, good: Numbers, kind: Scalar) -> Iterator[Row]:
    """Every input not finite and out of range, both configurations off the group."""
    harms = (("not a number", float("nan"), 0, "NONFINITE_INPUT"),
             ("infinite", float("-inf"), 1, "NONFINITE_INPUT"),
             ("out of range", 2 * float(kind.max_input), 0, "OUT_OF_RANGE"))  # fmt: skip
    for name in _inputs(vehicle):
        for doc, value, place, status in harms:
            numbers = [*good[name]]
            numbers[place % len(numbers)] = value
            yield _refused(f"{name} {doc}", {**good, name: numbers}, status)
    for name in ("g", "g_r"):
        for doc, numbers in _off(vehicle, good.get(name, [])):
            given = {**good, name: [stored(x, kind.name) for x in numbers]}
            yield _refused(f"{name} {doc}", given, "NOT_ON_GROUP")


def _off(vehicle: Plant, g: list[float]) -> Iterator[tuple[str, list[Any]]]:
    """The element off its group; nothing where all multiples of one are elements."""
    if not g or not any(one.turns or vehicle.own for one in factors(vehicle.space)):
        return
    if vehicle.own:
        from derive.verify.shape import space

        if space(vehicle.space).shapes[0].holds_one():
            return
    yield "off the group", [(2 if vehicle.own else OFF) * x for x in g]
    if vehicle.group == "SO3":
        yield "mirrored", [-x for x in g]


def _refused(doc: str, given: Numbers, status: str) -> Row:
    assert VALUE[status] >= FIRST_BAD
    return {"doc": doc, "is_moving": True, "given": given, "status": status, "clearance": 1.0,
            "known": {}}  # fmt: skip
