"""The truth about a command, out of what the truth said of the motion: exact for any inertia.

Force and s are sums of products of the inertia, the gains and what `golden` keeps; each number
carries the size of the terms it is made of, on which its error is judged. No third party is
imported: a new inertia of a known pattern waits for none.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Context, Decimal, localcontext
from fractions import Fraction
from typing import Any

from derive.emit.literal import nearest
from derive.verify.limits import EPS, LIMITS
from derive.verify.sized import ZERO, Sized, Vector, minus, plus, times, total

PRECISION = Context(prec=60)
"""Of what is put together, ten digits beyond what is kept."""

UNSURE = Decimal("0.01")
"""Relative distance from a force limit within which rounding may decide; what is cut has no error,
and is farther from its limit than any."""

SHRINKING = 5
"""eps that shrinking adds by itself: two on purpose, a quotient, two products, a rounded truth."""


Known = Mapping[str, Vector]


@dataclass(frozen=True)
class Body:
    """The numbers of a vehicle as one scalar stores them, and its bracket [i, j, k, c]."""

    inertia: tuple[tuple[Sized, ...], ...]
    gains: Mapping[str, Sized]
    bracket: tuple[tuple[int, int, int, Sized], ...]

    def flat(self, x: Vector) -> Vector:
        """I x."""
        return [total(a * b for a, b in zip(row, x, strict=True)) for row in self.inertia]

    def coad(self, x: Vector, a: Vector) -> Vector:
        """ad*_x a, where <ad*_x a; y> = <a; [x, y]>."""
        found = [ZERO] * len(x)
        for i, j, k, c in self.bracket:
            found[j] = found[j] + x[i] * a[k] * c
        return found


def _sliding(body: Body, at: Known) -> dict[str, Vector]:
    """Eqs. (TckCtrl), and (Ctrl2) where eta is zero."""
    slope, reach = body.gains["lambda"], body.gains["k_s"]
    drive = times(slope, at["nu_u"])
    s = plus(at["nu_e"], drive)
    wanted = minus(minus(at["eta_dot"], times(slope, at["nu_u_dot"])), times(reach, s))
    momentum = plus(body.flat(at["nu"]), at["momentum"])
    turning = body.coad(minus(drive, at["eta"]), momentum)
    return {"force": plus(body.flat(wanted), turning), "s": s}


def _lsf(body: Body, at: Known) -> dict[str, Vector]:
    """Eqs. (Ctrls2), (s2), without the last term of F_2."""
    s = minus(at["nu"], at["nu_r"])
    s = plus(s, times(body.gains["kappa"] / body.gains["k"], at["nu_u"]))
    driven = body.flat(minus(at["nu_r_dot"], times(body.gains["k"], s)))
    momentum = plus(body.flat(at["nu"]), at["momentum"])
    return {"force": minus(driven, body.coad(at["nu"], momentum)), "s": s}


def _cross(body: Body, at: Known) -> Vector:
    """nu x nu_r."""
    found = [ZERO] * len(at["nu"])
    for i, j, k, c in body.bracket:
        found[k] = found[k] + at["nu"][i] * at["nu_r"][j] * c
    return found


def _lsf_printed(body: Body, at: Known) -> dict[str, Vector]:
    found = _lsf(body, at)
    return found | {"force": minus(found["force"], _cross(body, at))}


def _lsf_mended(body: Body, at: Known) -> dict[str, Vector]:
    found = _lsf(body, at)
    return found | {"force": plus(found["force"], body.flat(_cross(body, at)))}


def _pd_plus(body: Body, at: Known) -> dict[str, Vector]:
    """Eqs. (Ctrls3), (s3)."""
    eta = minus(at["nu"], at["nu_e"])
    s = plus(at["nu_e"], times(body.gains["k_R"] / body.gains["k_Omega"], at["nu_u"]))
    momentum = plus(body.flat(eta), at["momentum"])
    carried = minus(body.flat(at["pulled"]), body.coad(eta, momentum))
    return {"force": minus(carried, times(body.gains["k_Omega"], s)), "s": s}


COMBINED: dict[str, Callable[[Body, Known], dict[str, Vector]]] = {
    "gsmc": _sliding,
    "reaching": _sliding,
    "lsf_printed": _lsf_printed,
    "lsf": _lsf_mended,
    "pd_plus": _pd_plus,
}
"""Controller -> force, but for the external one, and s."""


@dataclass(frozen=True)
class Answer:
    """What is true of a command: its status, and each output with the largest error of a number.

    No output of a refused row.
    """

    status: str
    outputs: dict[str, tuple[list[Decimal], float]]


@dataclass(frozen=True)
class Limits:
    """What the emitted code holds a force to: one number for each coordinate, or none.

    keeps_direction: whether the force shrinks as a whole
    """

    force: Sequence[Fraction] = ()
    keeps_direction: bool = False


def answers(
    golden: Mapping[str, Any], scalar: str, controller: str, inertia: Sequence[Sequence[Fraction]],
    gains: Sequence[tuple[str, Fraction]], limits: Limits, *, is_own: bool,
) -> list[Answer | None]:  # fmt: skip
    """The truth of each row; None of a row whose status rounding would decide."""
    bound = LIMITS["own_force" if is_own and scalar == "f64" else f"force_{scalar}"].figure
    with localcontext(PRECISION):
        body = Body(
            tuple(tuple(_stored(x, scalar) for x in row) for row in inertia),
            {name: _stored(x, scalar) for name, x in gains},
            tuple((i, j, k, _exact(Decimal(c))) for i, j, k, c in golden["bracket"]),
        )
        most = [_stored(x, scalar).value for x in limits.force]
        rows = golden["rows"][scalar]
        found = [_outputs(controller, body, row, bound) if row["known"] else {} for row in rows]
        pairs = zip(rows, found, strict=True)
        direct = limits.keeps_direction
        return [_limited(row["status"], one, most, direct, scalar) for row, one in pairs]


def _outputs(
    controller: str, body: Body, row: Mapping[str, Any], bound: float
) -> dict[str, tuple[list[Decimal], float]]:
    at = _sized(row)
    found = COMBINED[controller](body, at)
    found["force"] = minus(found["force"], at["external"])
    found |= {name: at[name] for name in ("nu_u", "nu_u_dot") if name in row["known"]}
    return {
        name: ([x.value for x in vector], bound * max(x.size for x in vector))
        for name, vector in found.items()
    }


def _limited(
    status: str, outputs: dict[str, tuple[list[Decimal], float]], most: Sequence[Decimal],
    keeps_direction: bool, scalar: str,
) -> Answer | None:  # fmt: skip
    """The same with the force held to its limits."""
    if not outputs or not most:
        return Answer(status, outputs)
    force, error = outputs["force"]
    parts = [abs(x) / y for x, y in zip(force, most, strict=True)]
    unsure = [UNSURE if keeps_direction else max(UNSURE, Decimal(error) / y) for y in most]
    if any(abs(part - 1) < one for part, one in zip(parts, unsure, strict=True)):
        return None
    if max(parts) < 1:
        return Answer(status, outputs)
    share = 1 / max(parts) if keeps_direction else Decimal(1)
    held = [max(-y, min(y, x * share)) for x, y in zip(force, most, strict=True)]
    if keeps_direction:
        error = _shrunk(error, force, parts) + SHRINKING * EPS[scalar] * float(max(map(abs, held)))
    worse = "SATURATED" if status == "OK" else status
    return Answer(worse, outputs | {"force": (held, error)})


def _shrunk(error: float, force: Sequence[Decimal], parts: Sequence[Decimal]) -> float:
    """An error of the force after it is shrunk: it scales by the share, whose own error it adds.

    parts: of the limits that the force asks for; the largest decides the share, or what is next
    to it
    """
    most = max(parts)
    deciding = [abs(x) for x, y in zip(force, parts, strict=True) if y > (1 - UNSURE) * most]
    least, widest = float(min(deciding)) - error, float(max(map(abs, force)))
    return error / float(most) * (1 + (widest + error) / least) if least > 0 else error


def _sized(row: Mapping[str, Any]) -> dict[str, Vector]:
    """What a row is given, exact, and what is known of it, on the scale of what it comes from.

    Towards a pole a relative error of the error grows as what the law gives does.
    """
    given = {name: [_exact(Decimal(x)) for x in numbers] for name, numbers in row["given"].items()}
    n = len(given["nu"])
    scales, pole = _scales(row), 1 / row["clearance"]
    known = {
        name: [Sized(Decimal(x), (abs(float(x)) + scales[name]) * growth) for x in numbers]
        for name, numbers in row["known"].items()
        for growth in [pole if name in ("nu_u", "nu_u_dot") else 1.0]
    }
    still = {name: [ZERO] * n for name in ("momentum", "external", "eta", "eta_dot")}
    return {"nu_e": given["nu"], **still, **given, **known}


def _scales(row: Mapping[str, Any]) -> dict[str, float]:
    """What an error of eps in g_r^-1 g, on the scale of its factors, moves each quantity by."""
    length = {name: max(map(abs, numbers)) for name, numbers in row["given"].items()}
    reach = max(1.0, length["g"]) * max(1.0, length.get("g_r", 0.0))
    speed = length["nu"] + reach * length.get("nu_r", 0.0)
    pole = 1 / row["clearance"]
    return {
        "nu_u": reach,
        "nu_u_dot": reach * speed * pole,
        "nu_e": speed,
        "eta": speed,
        "eta_dot": reach * (length.get("nu_r_dot", 0.0) + speed**2),
        "pulled": reach * length.get("nu_r_dot", 0.0),
    }


def _exact(value: Decimal) -> Sized:
    return Sized(value, abs(float(value)))


def _stored(value: Fraction, scalar: str) -> Sized:
    kept = nearest(value, scalar)
    return _exact(Decimal(kept.numerator) / kept.denominator)
