"""Truth over a batch: each number as a pair of doubles, so that an error of 0.01 eps shows.

Within 8 eps of the cut locus of SO3 either branch is right: there a row has two truths.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from derive.verify import truth
from derive.verify.limits import EPS, LIMITS
from derive.verify.sample import DTYPES, States

Array = NDArray[np.float64]
Pair = tuple[Array, Array]


POLES = (("S3", "log"), ("S3", "half_log"), ("S3", "mrp"))
"""Laws without a bound near -i."""

HALVES = ("half_log", "lee", "sign_vec")
"""Laws that grow with half the angle: their natural scale is half that of the others."""


@dataclass(frozen=True)
class Plant:
    """The numbers of a vehicle that the truth needs, exact: inertia (3, 3) and gains."""

    group: str
    law: str
    inertia: tuple[tuple[Fraction, ...], ...]
    rate_gain: Fraction
    reach_gain: Fraction

    def stored(self, scalar: str) -> tuple[list[list[float]], float, float]:
        """Inertia and gains as that scalar keeps them."""

        def kept(value: Fraction) -> float:
            return float(np.asarray(float(value), DTYPES[scalar]))

        inertia = [[kept(value) for value in row] for row in self.inertia]
        return inertia, kept(self.rate_gain), kept(self.reach_gain)


@dataclass(frozen=True)
class Truth:
    """Outputs by name, (N, n) as high and low part, for each branch; the distance from the cut.

    scales: natural scale of an output where it is larger than its length, (N,)
    error:  unit quaternion of each row's error, to 130 digits
    conditioning: what a relative error on the move counts: s towards a pole at -i, where the
            product q_r^-1 q itself rounds at eps/s; with the identity as reference it is exact
    """

    branches: tuple[dict[str, Pair], ...]
    scales: dict[str, Array]
    error: tuple[Any, ...] = ()
    conditioning: Array | float = 1.0

    def errors(self, found: dict[str, NDArray[Any]]) -> dict[str, Array]:
        """|found - truth| / scale per row and output, on the branch whose law is nearer, (N,)."""
        each = [
            {name: self._one(name, np.asarray(value), branch) for name, value in found.items()
             if name in branch}
            for branch in self.branches
        ]  # fmt: skip
        first, second = each[0], each[-1]
        key = "nu_u" if "nu_u" in first else next(iter(first))
        nearer = second[key] < first[key]
        return {name: np.where(nearer, second[name], first[name]) for name in first}

    def first(self) -> Truth:
        """The same, with the deterministic branch alone counting as true."""
        return replace(self, branches=self.branches[:1])

    def _one(self, name: str, value: NDArray[Any], branch: dict[str, Pair]) -> Array:
        high, low = branch[name]
        with np.errstate(invalid="ignore", over="ignore"):
            off = np.linalg.norm((value.astype(np.float64) - high) - low, axis=-1)
        scale = np.maximum(np.linalg.norm(high, axis=-1), self.scales.get(name, 0.0))
        relative = off / np.where(scale > 0, scale, 1.0)
        return np.where(np.isnan(relative), np.inf, relative)


def tracking(vehicle: Plant, states: States, scalar: str) -> Truth:
    """Truth of the tracking law, eq. (TckCtrl), on the stored numbers of that scalar."""

    def one(row: int, flip: bool) -> dict[str, Any]:
        at = _row(states, row, "g_r", "g", "nu", "nu_r", "nu_r_dot")
        return truth.tracking(vehicle.group, vehicle.law, *vehicle.stored(scalar), *at, flip=flip)

    return _table(one, vehicle, states, scalar)


def reaching(vehicle: Plant, states: States, scalar: str) -> Truth:
    """Truth of the reaching law, eq. (Ctrl2)."""

    def one(row: int, flip: bool) -> dict[str, Any]:
        at = _row(states, row, "g", "nu")
        found = truth.reaching(vehicle.group, vehicle.law, *vehicle.stored(scalar), *at, flip=flip)
        return {**found, "nu_e": at[1]}

    return _table(one, vehicle, states, scalar)


def plant(vehicle: Plant, states: States, force: NDArray[Any], scalar: str) -> Truth:
    """Truth of the acceleration under a force (N, 3), eq. (EulerP)."""
    inertia = vehicle.stored(scalar)[0]
    pairs = zip(states.nu.tolist(), force.tolist(), strict=True)
    rows = [truth.plant(inertia, nu, applied) for nu, applied in pairs]
    size, speed, pushed = np.linalg.norm(inertia, 2), *_lengths(states.nu, force)
    terms = np.linalg.norm(np.linalg.inv(inertia), 2) * (size * speed**2 + pushed)
    return Truth(({"nu_dot": _pair(rows)},), {"nu_dot": terms / LIMITS["cancellation"].figure})


def _table(
    one: Callable[[int, bool], dict[str, Any]], vehicle: Plant, states: States, scalar: str
) -> Truth:
    names = ("force", "s", "nu_u", "nu_u_dot", "clearance")
    plain = [_with_clearance(one(row, False), vehicle) for row in range(len(states.angle))]
    near = np.array(
        [abs(found["q"][0]) < LIMITS["either side"].figure * EPS[scalar] for found in plain]
    )
    other = list(plain)
    if vehicle.group == "SO3":
        for row in np.flatnonzero(near):
            other[row] = _with_clearance(one(int(row), True), vehicle)
    branches = [{name: _pair([r[name] for r in rows]) for name in names} for rows in (plain, other)]
    scales = _scales(vehicle, states, branches[0], plain)
    has_pole = (vehicle.group, vehicle.law) in POLES
    conditioning = branches[0]["clearance"][0][:, 0] if has_pole else 1.0
    return Truth(tuple(branches), scales, tuple(found["q"] for found in plain), conditioning)


def _scales(
    vehicle: Plant, states: States, outputs: dict[str, Pair], rows: list[dict[str, Any]]
) -> dict[str, Array]:
    """Natural scales: of the law its own, of s its terms, of the force its terms where they cancel.

    On the move the product g_r^-1 g rounds at eps, which the law sees as an angle of eps: that
    counts as 1 rad beside the law.
    """
    eta, nu_e, eta_dot = (
        np.array([[float(x) for x in row.get(name, (0, 0, 0))] for row in rows])
        for name in ("eta", "nu_e", "eta_dot")
    )
    sine = np.array([float(truth.mp.norm(row["q"][1:])) for row in rows])
    unit = 0.5 if vehicle.law in HALVES else 1.0
    nu, turning, speed, growth = _lengths(states.nu, eta, nu_e, eta_dot)
    law, rate = _lengths(outputs["nu_u"][0], outputs["nu_u_dot"][0])
    inertia, rate_gain, reach_gain = vehicle.stored("f64")
    drive = rate_gain * (law + (1.0 if states.nu_r.any() else 0.0))
    s = speed + drive
    wanted = growth + rate_gain * rate + reach_gain * s
    force = np.linalg.norm(inertia, 2) * (wanted + nu * (drive + turning))
    return {
        "nu_u": 2 * unit * sine,
        "nu_u_dot": unit * speed,
        "s": s,
        "force": force / LIMITS["cancellation"].figure,
        "clearance": np.ones(len(rows)),
    }


def _lengths(*vectors: NDArray[Any]) -> list[Array]:
    return [np.linalg.norm(np.asarray(vector, np.float64), axis=-1) for vector in vectors]


def _with_clearance(found: dict[str, Any], vehicle: Plant) -> dict[str, Any]:
    """Add the distance from where the law jumps, by its definition in the table of laws."""
    w, s = found["q"][0], truth.mp.norm(found["q"][1:])
    distance = {
        ("SO3", "skew"): truth.mp.one,
        ("S3", "vec"): truth.mp.one,
        ("S3", "sign_vec"): abs(w),
    }
    default = abs(w) if vehicle.group == "SO3" else (s if w < 0 else truth.mp.one)
    return {**found, "clearance": (distance.get((vehicle.group, vehicle.law), default),)}


def _row(states: States, row: int, *names: str) -> list[list[float]]:
    return [[float(x) for x in getattr(states, name)[row]] for name in names]


def _pair(rows: list[Any]) -> Pair:
    high = np.array([[float(x) for x in row] for row in rows])
    low = np.array([[float(x - float(x)) for x in row] for row in rows])
    return high, low
