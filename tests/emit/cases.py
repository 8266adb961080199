"""Inputs of `control` by name, and the status that the header promises for each."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
import sympy

from derive.vehicle import Vehicle
from tests.emit import elements
from tests.emit.elements import AXES, PI, Array, element
from tests.emit.subjects import group

OK, SATURATED, NEAR, OFF, RANGE, NONFINITE = 0, 1, 2, 16, 17, 18

Row = dict[str, Array]


@dataclass(frozen=True)
class Case:
    """One input of `control` and the status it must get."""

    name: str
    row: Row
    status: int


def is_tracking(vehicle: Vehicle) -> bool:
    return vehicle.controller != "reaching"


def is_baseline(vehicle: Vehicle) -> bool:
    return vehicle.controller in ("lsf_printed", "lsf", "pd_plus")


def command(vehicle: Vehicle) -> tuple[str, ...]:
    """What a command of the vehicle holds besides its status."""
    return ("force", "s", "nu_u", "nu_u_dot")[: 3 if is_baseline(vehicle) else 4]


def good(vehicle: Vehicle, seed: int = 1, angle: float = 1.0) -> Row:
    """A state and a reference an angle apart, velocities of order one."""
    random, known = np.random.default_rng(seed), group(vehicle)
    row = {"g": element(known, AXES[3], angle, seed)}
    names = ["nu", *(name for name in ("momentum", "external") if name in vehicle.options)]
    if is_tracking(vehicle):
        row |= {"g_r": np.array(known.identity, float)}
        names += ["nu_r", "nu_r_dot"]
    return row | {name: random.normal(size=known.dim) for name in names}


def distance(vehicle: Vehicle) -> Callable[[Array], float]:
    """The distance of stored numbers from the group, by the equations that define it."""
    known = group(vehicle)
    stored = sympy.Matrix(sympy.symbols(f"g:{known.size}"))
    value = known.residual(stored)
    if not value:
        return lambda g: 0.0
    run = sympy.lambdify(list(stored), list(value), "math")
    return lambda g: float(np.linalg.norm(run(*g)))


def inverse(vehicle: Vehicle) -> Callable[[Array], Array]:
    """The inverse as the group defines it; of what is off by t, it is off by several t on SL3."""
    known = group(vehicle)
    stored = sympy.Matrix(sympy.symbols(f"g:{known.size}"))
    run = sympy.lambdify(
        list(stored), list(known.store(known.inverse(known.embed(stored)))), "math"
    )
    return lambda g: np.array(run(*g), float)


def divides(vehicle: Vehicle) -> bool:
    """Whether an inverse of stored numbers divides by some of them."""
    known = group(vehicle)
    stored = sympy.Matrix(sympy.symbols(f"g:{known.size}"))
    return any(
        sympy.denom(sympy.together(x)).free_symbols for x in known.inverse(known.embed(stored))
    )


def put(row: Row, field: str, index: int, value: float) -> Row:
    changed = row[field].copy()
    changed[index] = value
    return {**row, field: changed}


def cases(vehicle: Vehicle, limits: dict[str, float], drift: float) -> Iterator[Case]:
    """Every case of a vehicle; limits are the constants of its header, drift its default.

    OK stands for SATURATED too, where the law asks for more than the vehicle has.
    """
    row = good(vehicle)
    yield Case("good", row, OK)
    yield from _single(row, limits["MAX_INPUT"])
    yield from _drifted(vehicle, row, drift)
    yield from _ranked(row, limits["MAX_INPUT"])
    yield from _scaled(vehicle, row, drift)
    yield from _far(vehicle, row, limits)
    if vehicle.hysteresis is not None:
        yield from _turned(vehicle, float(vehicle.hysteresis))
    elif cut := elements.cut(group(vehicle), vehicle.law):
        yield from _cut(vehicle, *cut, limits, drift)
    else:
        for angle in (PI, 2 * PI) if elements.turner(group(vehicle)) is not None else ():
            yield Case(f"no cut at {angle:.2f}", good(vehicle, angle=angle), OK)


def _single(row: Row, limit: float) -> Iterator[Case]:
    """Every number of the input in turn."""
    values = [(np.nan, NONFINITE), (np.inf, NONFINITE), (-np.inf, NONFINITE)]
    values += [(2 * limit, RANGE), (-2 * limit, RANGE)]
    for field, numbers in row.items():
        for index in range(len(numbers)):
            for value, status in values:
                yield Case(f"{field}[{index}] = {value}", put(row, field, index, value), status)
            if not field.startswith("g"):
                yield Case(f"{field}[{index}] at the limit", put(row, field, index, limit), OK)


def _drifted(vehicle: Vehicle, row: Row, limit: float) -> Iterator[Case]:
    """Scaled until the group's own measure is at the limit; and what is far off."""
    size, turned = distance(vehicle), inverse(vehicle)
    for field in (name for name in row if name.startswith("g")):
        g = row[field]
        for sign in (1, -1):
            off = g * (1 + sign * 1e-9)
            slope = max(size(x) for x in (off, *([turned(off)] if field == "g_r" else []))) / 1e-9
            if slope < 0.1:
                continue
            for part, status in ((1.05, OFF), (0.95, OK)):
                factor = 1 + sign * part * limit / slope
                yield Case(f"{field} times {factor}", {**row, field: g * factor}, status)
        for name, far in (("zero", 0 * g), ("doubled", 2 * g), ("inverted", -g)):
            is_same = name == "inverted" and field == "g_r" and size(turned(far)) < 1e-9
            if size(far) > 0.01 and not is_same:  # (-1)^-1 is 1 by the formula of SL3
                # what has no inverse is infinitely far from anything
                status = RANGE if (field, name) == ("g_r", "zero") and divides(vehicle) else OFF
                yield Case(f"{field} {name}", {**row, field: far}, status)
        for k in range(len(g)):
            if size(put(row, field, k, 1.5)[field]) > 0.01:
                yield Case(f"{field}[{k}] = 1.5", put(row, field, k, 1.5), OFF)
        for mirrored in elements.mirrors(group(vehicle), g):
            yield Case(f"{field} mirrored", {**row, field: mirrored}, OFF)


def _ranked(row: Row, limit: float) -> Iterator[Case]:
    """Two faults at once: the larger status wins, wherever each of them stands."""
    off = {**row, "g": row["g"] + 0.5}
    for field in row:
        if field == "g":
            continue
        yield Case(f"off, {field} out of range", put(off, field, 0, 2 * limit), RANGE)
        yield Case(f"off, {field} not finite", put(off, field, 0, np.nan), NONFINITE)
        far = put(row, "g", -1, 2 * limit)
        yield Case(f"far, {field} not finite", put(far, field, 0, np.inf), NONFINITE)
        late = put(row, "g", -1, np.nan)
        yield Case(f"not finite, {field} far", put(late, field, 0, 2 * limit), NONFINITE)


def _scaled(vehicle: Vehicle, row: Row, drift: float) -> Iterator[Case]:
    """Both configurations scaled: the error alone decides, and it is the same where they cancel."""
    if "g_r" not in row or not elements.is_compact(group(vehicle)):
        return
    for factor in (0.5, 4.0):
        both = {**row, "g": row["g"] * factor}
        yield Case(f"scaled by {factor}, oppositely", {**both, "g_r": row["g_r"] / factor}, OK)
        yield Case(f"scaled by {factor}, alike", {**both, "g_r": row["g_r"] * factor}, OFF)
        yield Case(f"scaled by {factor}, one of them", both, OFF)


def _far(vehicle: Vehicle, row: Row, limits: dict[str, float]) -> Iterator[Case]:
    """Numbers that the group lets grow, in both configurations alike, so that the error stays."""
    for index in elements.grows(group(vehicle)):
        for part, status in ((0.9, OK), (1.1, RANGE)):
            far = put(row, "g", index, part * limits["MAX_INPUT"])
            if "g_r" in row:
                far = put(far, "g_r", index, part * limits["MAX_INPUT"])
            yield Case(f"[{index}] at {part} of the largest", far, status)


def _turned(vehicle: Vehicle, hysteresis: float) -> Iterator[Case]:
    """Either side of half a turn, where q and -q are as far, and on to where they are one."""
    for part, status in ((1.1, OK), (0.9, NEAR), (0.0, NEAR), (-0.9, NEAR), (-1.1, OK)):
        angle = 2 * float(np.arccos(part * hysteresis))
        yield Case(f"a scalar part of {part} h", good(vehicle, angle=angle), status)
    yield Case("a full turn", good(vehicle, angle=2 * PI), OK)


def _cut(
    vehicle: Vehicle, angle: float, is_pole: bool, limits: dict[str, float], drift: float
) -> Iterator[Case]:
    """A little before the cut, and at it."""
    row, known = good(vehicle), group(vehicle)
    near, fine = limits["NEAR_CUT"], drift / 100  # a law without a pole refuses nothing
    refused = limits.get("REFUSED_CUT", fine)
    steps = [(1.5 * near, OK), (0.5 * near, NEAR)]
    if refused < 1e-7:  # finer than the entries of a float matrix resolve
        steps += [(10 * refused, NEAR), (0.5 * refused, RANGE if is_pole else NEAR)]
    for seed, axis in enumerate(AXES):
        for clearance, status in steps:
            off = elements.away(known, vehicle.law, clearance)
            g = element(known, axis, angle - off, seed)
            yield Case(f"{clearance:.0e} from the cut", {**row, "g": g}, status)
    for stored in elements.at_cut(known, vehicle.law):
        at = {**row, "g": stored}
        yield Case(f"at the cut, {stored}", at, RANGE if is_pole else NEAR)
        beyond = put(at, "nu", 0, 2 * limits["MAX_INPUT"])
        yield Case(f"out of range at the cut, {stored}", beyond, RANGE)
        drifted = stored * (1 + 2 * drift)
        if distance(vehicle)(drifted) > 1.5 * drift:
            yield Case(f"off the group at the cut, {stored}", {**at, "g": drifted}, OFF)
