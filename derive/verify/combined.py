"""The truth about a command, out of what the truth said of the motion: exact for any inertia.

Force and s are sums of products of the inertia, the gains and what `golden` keeps; each number
carries the size of the terms it is made of, on which its error is judged. No third party is
imported: a new inertia of a known pattern waits for none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Context, Decimal, localcontext
from fractions import Fraction
from typing import Any

from derive.emit.literal import nearest
from derive.verify.limits import LIMITS

PRECISION = Context(prec=60)
"""Of what is put together, ten digits beyond what is kept."""


@dataclass(frozen=True, slots=True)
class Sized:
    """A number and the size of the terms it is a sum of."""

    value: Decimal
    size: float

    def __add__(self, other: Sized) -> Sized:
        return Sized(self.value + other.value, self.size + other.size)

    def __sub__(self, other: Sized) -> Sized:
        return Sized(self.value - other.value, self.size + other.size)

    def __mul__(self, other: Sized) -> Sized:
        return Sized(self.value * other.value, self.size * other.size)

    def __truediv__(self, other: Sized) -> Sized:
        return Sized(self.value / other.value, self.size / other.size)


Vector = list[Sized]
Known = Mapping[str, Vector]
ZERO = Sized(Decimal(0), 0.0)


@dataclass(frozen=True)
class Body:
    """The numbers of a vehicle as one scalar stores them, and its bracket [i, j, k, c]."""

    inertia: tuple[tuple[Sized, ...], ...]
    gains: Mapping[str, Sized]
    bracket: tuple[tuple[int, int, int, Sized], ...]

    def flat(self, x: Vector) -> Vector:
        """I x."""
        return [_total(a * b for a, b in zip(row, x, strict=True)) for row in self.inertia]

    def coad(self, x: Vector, a: Vector) -> Vector:
        """ad*_x a, where <ad*_x a; y> = <a; [x, y]>."""
        found = [ZERO] * len(x)
        for i, j, k, c in self.bracket:
            found[j] = found[j] + x[i] * a[k] * c
        return found


def _total(terms: Iterable[Sized]) -> Sized:
    return sum(terms, ZERO)


def _plus(a: Vector, b: Vector) -> Vector:
    return [x + y for x, y in zip(a, b, strict=True)]


def _minus(a: Vector, b: Vector) -> Vector:
    return [x - y for x, y in zip(a, b, strict=True)]


def _times(factor: Sized, x: Vector) -> Vector:
    return [factor * each for each in x]


def _sliding(body: Body, at: Known) -> dict[str, Vector]:
    """Eqs. (TckCtrl), and (Ctrl2) where eta is zero."""
    slope, reach = body.gains["lambda"], body.gains["k_s"]
    drive = _times(slope, at["nu_u"])
    s = _plus(at["nu_e"], drive)
    wanted = _minus(_minus(at["eta_dot"], _times(slope, at["nu_u_dot"])), _times(reach, s))
    momentum = _plus(body.flat(at["nu"]), at["momentum"])
    turning = body.coad(_minus(drive, at["eta"]), momentum)
    return {"force": _plus(body.flat(wanted), turning), "s": s}


def _lsf(body: Body, at: Known) -> dict[str, Vector]:
    """Eqs. (Ctrls2), (s2), without the last term of F_2."""
    s = _minus(at["nu"], at["nu_r"])
    s = _plus(s, _times(body.gains["kappa"] / body.gains["k"], at["nu_u"]))
    driven = body.flat(_minus(at["nu_r_dot"], _times(body.gains["k"], s)))
    momentum = _plus(body.flat(at["nu"]), at["momentum"])
    return {"force": _minus(driven, body.coad(at["nu"], momentum)), "s": s}


def _cross(body: Body, at: Known) -> Vector:
    """nu x nu_r."""
    found = [ZERO] * len(at["nu"])
    for i, j, k, c in body.bracket:
        found[k] = found[k] + at["nu"][i] * at["nu_r"][j] * c
    return found


def _lsf_printed(body: Body, at: Known) -> dict[str, Vector]:
    found = _lsf(body, at)
    return found | {"force": _minus(found["force"], _cross(body, at))}


def _lsf_mended(body: Body, at: Known) -> dict[str, Vector]:
    found = _lsf(body, at)
    return found | {"force": _plus(found["force"], body.flat(_cross(body, at)))}


def _pd_plus(body: Body, at: Known) -> dict[str, Vector]:
    """Eqs. (Ctrls3), (s3)."""
    eta = _minus(at["nu"], at["nu_e"])
    s = _plus(at["nu_e"], _times(body.gains["k_R"] / body.gains["k_Omega"], at["nu_u"]))
    momentum = _plus(body.flat(eta), at["momentum"])
    carried = _minus(body.flat(at["pulled"]), body.coad(eta, momentum))
    return {"force": _minus(carried, _times(body.gains["k_Omega"], s)), "s": s}


COMBINED: dict[str, Callable[[Body, Known], dict[str, Vector]]] = {
    "gsmc": _sliding,
    "reaching": _sliding,
    "lsf_printed": _lsf_printed,
    "lsf": _lsf_mended,
    "pd_plus": _pd_plus,
}
"""Controller -> force, but for the external one, and s."""


def commands(
    golden: Mapping[str, Any], scalar: str, controller: str, inertia: Sequence[Sequence[Fraction]],
    gains: Sequence[tuple[str, Fraction]], *, is_own: bool,
) -> list[dict[str, tuple[list[Decimal], float]]]:  # fmt: skip
    """Of each row each output and the largest error of a number in it; a refused one has none."""
    limit = LIMITS["own_force" if is_own and scalar == "f64" else f"force_{scalar}"].figure
    with localcontext(PRECISION):
        body = Body(
            tuple(tuple(_stored(x, scalar) for x in row) for row in inertia),
            {name: _stored(x, scalar) for name, x in gains},
            tuple((i, j, k, _exact(Decimal(c))) for i, j, k, c in golden["bracket"]),
        )
        rows = golden["rows"][scalar]
        return [_command(controller, body, row, limit) if row["known"] else {} for row in rows]


def _command(
    controller: str, body: Body, row: Mapping[str, Any], limit: float
) -> dict[str, tuple[list[Decimal], float]]:
    at = _sized(row)
    found = COMBINED[controller](body, at)
    found["force"] = _minus(found["force"], at["external"])
    found |= {name: at[name] for name in ("nu_u", "nu_u_dot") if name in row["known"]}
    return {
        name: ([x.value for x in vector], limit * max(x.size for x in vector))
        for name, vector in found.items()
    }


def _sized(row: Mapping[str, Any]) -> dict[str, Vector]:
    """What a row is given, exact, and what is known of it, on the scale of what it comes from."""
    given = {name: [_exact(Decimal(x)) for x in numbers] for name, numbers in row["given"].items()}
    n = len(given["nu"])
    scales = _scales(row)
    known = {
        name: [Sized(Decimal(x), abs(float(x)) + scales[name]) for x in numbers]
        for name, numbers in row["known"].items()
    }
    still = {name: [ZERO] * n for name in ("momentum", "external", "eta", "eta_dot")}
    return {"nu_e": given["nu"], **still, **given, **known}


def _scales(row: Mapping[str, Any]) -> dict[str, float]:
    """What an error of eps in g_r^-1 g, on the scale of its factors, moves each quantity by."""
    length = {name: max(map(abs, numbers)) for name, numbers in row["given"].items()}
    reach = max(1.0, length["g"]) * max(1.0, length.get("g_r", 0.0))
    speed = length["nu"] + reach * length.get("nu_r", 0.0)
    pole = 1 / row["clearance"]  # towards a pole a law grows so, and its slope as the square
    return {
        "nu_u": reach * pole,
        "nu_u_dot": reach * speed * pole**2,
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
