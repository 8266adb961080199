"""Inputs of `control` by name, and the status that the header promises for each."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from derive.vehicle import Vehicle
from tests.emit.subjects import ELEMENT, Array

OK, NEAR, OFF, RANGE, NONFINITE = 0, 2, 16, 17, 18
PI = np.pi

CUT: dict[tuple[str, str], tuple[float, bool] | None] = {
    ("SO3", "log"): (PI, False),
    ("SO3", "lee"): (PI, False),
    ("SO3", "skew"): None,
    ("SO3", "gibbs"): (PI, True),
    ("SO3", "mrp"): (PI, False),
    ("S3", "log"): (2 * PI, True),
    ("S3", "half_log"): (2 * PI, True),
    ("S3", "mrp"): (2 * PI, True),
    ("S3", "vec"): None,
    ("S3", "sign_vec"): (PI, False),
}
"""Where a law jumps, as an angle, and whether it or its rate grows without bound there."""

EXACT: dict[tuple[str, float], tuple[list[float], ...]] = {
    ("SO3", PI): (
        [1, 0, 0, 0, -1, 0, 0, 0, -1],
        [-1, 0, 0, 0, -1, 0, 0, 0, 1],
        [0, 1, 0, 1, 0, 0, 0, 0, -1],
    ),
    ("S3", PI): ([0, 1, 0, 0], [0, 0, 0, -1]),
    ("S3", 2 * PI): ([-1, 0, 0, 0],),
}
"""Elements exactly at the cut, free of rounding."""

GROWTH = {"SO3": 3.0, "S3": 2.0}
"""Largest residual of (1 + d) g over d: of the determinant, and of the squared norm."""

AXES = tuple(np.array(axis, float) for axis in ([1, 0, 0], [0, 1, 0], [0, 0, 1], [1, -2, 3]))

Row = dict[str, Array]


@dataclass(frozen=True)
class Case:
    """One input of `control` and the status it must get."""

    name: str
    row: Row
    status: int


def is_tracking(vehicle: Vehicle) -> bool:
    return vehicle.controller != "reaching"


def good(vehicle: Vehicle, seed: int = 1, angle: float = 1.0) -> Row:
    """A state and a reference an angle apart, velocities of order one."""
    random = np.random.default_rng(seed)
    element = ELEMENT[vehicle.group]
    row = {"g": element(AXES[3], angle).ravel(), "nu": random.normal(size=3)}
    if is_tracking(vehicle):
        row |= {"g_r": element(AXES[0], 0.0).ravel()}
        row |= {"nu_r": random.normal(size=3), "nu_r_dot": random.normal(size=3)}
    return row


def put(row: Row, field: str, index: int, value: float) -> Row:
    changed = row[field].copy()
    changed[index] = value
    return {**row, field: changed}


def cases(vehicle: Vehicle, limits: dict[str, float]) -> Iterator[Case]:
    """Every case of a vehicle; limits are the constants of its header."""
    row = good(vehicle)
    yield Case("good", row, OK)
    yield from _single(row, limits["MAX_INPUT"])
    yield from _drifted(vehicle, row, limits["MAX_DRIFT"])
    yield from _ranked(row, limits["MAX_INPUT"])
    if cut := CUT[vehicle.group, vehicle.law]:
        yield from _cut(vehicle, *cut, limits)
    else:
        for angle in (PI, 2 * PI):
            yield Case(f"no cut at {angle:.2f}", good(vehicle, angle=angle), OK)


def _single(row: Row, limit: float) -> Iterator[Case]:
    """Every number of the input in turn."""
    values = [(np.nan, NONFINITE), (np.inf, NONFINITE), (-np.inf, NONFINITE)]
    values += [(2 * limit, RANGE), (-2 * limit, RANGE)]
    for field, numbers in row.items():
        for index in range(len(numbers)):
            for value, status in values:
                yield Case(f"{field}[{index}] = {value}", put(row, field, index, value), status)
            if field.startswith("nu"):
                yield Case(f"{field}[{index}] at the limit", put(row, field, index, limit), OK)


def _drifted(vehicle: Vehicle, row: Row, limit: float) -> Iterator[Case]:
    drift = limit / GROWTH[vehicle.group]
    for field in (name for name in row if name.startswith("g")):
        for factor, status in ((1 + 1.05 * drift, OFF), (1 + 0.95 * drift, OK), (0.0, OFF)):
            yield Case(f"{field} times {factor}", {**row, field: row[field] * factor}, status)
        for factor, status in ((1 - 1.05 * drift, OFF), (1 - 0.95 * drift, OK), (2.0, OFF)):
            yield Case(f"{field} times {factor}", {**row, field: row[field] * factor}, status)
        yield Case(f"{field}[0] = 1.5", put(row, field, 0, 1.5), OFF)
        if vehicle.group == "SO3":
            mirror = row[field].reshape(3, 3) @ np.diag([1.0, 1.0, -1.0])
            yield Case(f"{field} mirrored", {**row, field: mirror.ravel()}, OFF)
            yield Case(f"{field} inverted", {**row, field: -row[field]}, OFF)


def _ranked(row: Row, limit: float) -> Iterator[Case]:
    """Two faults at once: the larger status wins, wherever each of them stands."""
    off = put(row, "g", 0, 1.5)
    for field in row:
        if field == "g":
            continue
        yield Case(f"off, {field} out of range", put(off, field, 0, 2 * limit), RANGE)
        yield Case(f"off, {field} not finite", put(off, field, 0, np.nan), NONFINITE)
        far = put(row, "g", 1, 2 * limit)
        yield Case(f"far, {field} not finite", put(far, field, 0, np.inf), NONFINITE)
        late = put(row, "g", 1, np.nan)
        yield Case(f"not finite, {field} far", put(late, field, 0, 2 * limit), NONFINITE)


def _cut(vehicle: Vehicle, angle: float, is_pole: bool, limits: dict[str, float]) -> Iterator[Case]:
    """Clearances are the sine or cosine of half the distance to the cut."""
    row, element = good(vehicle), ELEMENT[vehicle.group]
    near, refused = 2 * limits["NEAR_CUT"], 2 * limits["REFUSED_CUT"]
    steps = [(1.5 * near, OK), (0.5 * near, NEAR)]
    if limits["REFUSED_CUT"] < 1e-7:  # finer than the entries of a float matrix resolve
        steps += [(10 * refused, NEAR), (0.5 * refused, RANGE if is_pole else NEAR)]
    for axis in AXES:
        for away, status in steps:
            g = element(axis, angle - away).ravel()
            yield Case(f"{away:.0e} from the cut", {**row, "g": g}, status)
    for stored in EXACT[vehicle.group, angle]:
        at = {**row, "g": np.array(stored, float)}
        yield Case(f"at the cut, {stored}", at, RANGE if is_pole else NEAR)
        beyond = put(at, "nu", 0, 2 * limits["MAX_INPUT"])
        yield Case(f"out of range at the cut, {stored}", beyond, RANGE)
        drifted = at["g"] * (1 + 2 * limits["MAX_DRIFT"])
        yield Case(f"off the group at the cut, {stored}", {**at, "g": drifted}, OFF)
