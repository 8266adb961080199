"""The factor y of property (iv), V' = -y V under nu = -nu_u, as stated: formula and function.

phi is the rotation angle; on S3, where it goes up to 2 pi, theta = phi/2 = arccos q0. These are
claims: derive.verify.law.definition holds them to what it measures.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]


@dataclass(frozen=True)
class Factor:
    """y in words, and as a function of phi in rad, (...) to (...)."""

    text: str
    of_angle: Callable[[Array], Array]


def _cot(x: Array) -> Array:
    return np.asarray(1 / np.tan(x))


def _constant(value: float) -> Factor:
    return Factor(f"{value:g}", lambda phi: np.full_like(phi, value))


def _doubled(text: str, factor: Factor) -> Factor:
    return Factor(text, lambda phi: 2 * factor.of_angle(phi))


_TURN = {
    "V_1": {
        "log": Factor("phi/2*cot(phi/4)", lambda phi: phi / 2 * _cot(phi / 4)),
        "lee": Factor("cos(phi/4)**2", lambda phi: np.cos(phi / 4) ** 2),
        "skew": Factor("sin(phi)/2*cot(phi/4)", lambda phi: np.sin(phi) / 2 * _cot(phi / 4)),
        "gibbs": Factor("tan(phi/2)*cot(phi/4)", lambda phi: np.tan(phi / 2) * _cot(phi / 4)),
        "cayley": Factor("tan(phi/2)*cot(phi/4)", lambda phi: np.tan(phi / 2) * _cot(phi / 4)),
        "mrp": _constant(2),
    },
    "Psi": {
        "log": Factor("phi*cot(phi/2)", lambda phi: phi * _cot(phi / 2)),
        "lee": Factor("cos(phi/2)", lambda phi: np.cos(phi / 2)),
        "skew": Factor("1 + cos(phi)", lambda phi: 1 + np.cos(phi)),
        "gibbs": _constant(2),
        "cayley": _constant(2),
        "mrp": Factor("4*tan(phi/4)*cot(phi/2)", lambda phi: 4 * np.tan(phi / 4) * _cot(phi / 2)),
    },
    "|log|^2/2": {
        "log": _constant(2),
        "lee": Factor("2*sin(phi/2)/phi", lambda phi: 2 * np.sin(phi / 2) / phi),
        "skew": Factor("2*sin(phi)/phi", lambda phi: 2 * np.sin(phi) / phi),
        "gibbs": Factor("4*tan(phi/2)/phi", lambda phi: 4 * np.tan(phi / 2) / phi),
        "cayley": Factor("4*tan(phi/2)/phi", lambda phi: 4 * np.tan(phi / 2) / phi),
        "mrp": Factor("8*tan(phi/4)/phi", lambda phi: 8 * np.tan(phi / 4) / phi),
    },
}
"""V -> law -> y on SO3, and on SO2 of those laws that it has."""

_ROOT = {
    "log": Factor("theta/2*cot(theta/2)", lambda phi: phi / 4 * _cot(phi / 4)),
    "half_log": Factor("theta/4*cot(theta/2)", lambda phi: phi / 8 * _cot(phi / 4)),
    "mrp": _constant(1),
    "cayley": _constant(1),
    "vec": Factor("(1 + cos(theta))/2", lambda phi: (1 + np.cos(phi / 2)) / 2),
    "sign_vec": Factor(
        "sign(cos(theta))*(1 + cos(theta))/4",
        lambda phi: np.where(phi <= np.pi, 1, -1) * (1 + np.cos(phi / 2)) / 4,
    ),
}

_SPHERE = {
    "V_2": _ROOT,
    "1 - q0": {
        "log": _doubled("theta*cot(theta/2)", _ROOT["log"]),
        "half_log": _doubled("theta/2*cot(theta/2)", _ROOT["half_log"]),
        "mrp": _constant(2),
        "cayley": _constant(2),
        "vec": _doubled("1 + cos(theta)", _ROOT["vec"]),
        "sign_vec": _doubled("sign(cos(theta))*(1 + cos(theta))/2", _ROOT["sign_vec"]),
    },
    "|log|^2/2": {
        "log": _constant(2),
        "half_log": _constant(1),
        "mrp": Factor("4*tan(theta/2)/theta", lambda phi: 8 * np.tan(phi / 4) / phi),
        "cayley": Factor("4*tan(theta/2)/theta", lambda phi: 8 * np.tan(phi / 4) / phi),
        "vec": Factor("2*sin(theta)/theta", lambda phi: 4 * np.sin(phi / 2) / phi),
        "sign_vec": Factor(
            "sign(cos(theta))*sin(theta)/theta",
            lambda phi: np.where(phi <= np.pi, 1, -1) * 2 * np.sin(phi / 2) / phi,
        ),
    },
}

_TABLES = {"SO2": _TURN, "SO3": _TURN, "S3": _SPHERE}
_LOG, _SQUARE = "log", "|log|^2/2"


def claimed(group: str, law: str, morse: str) -> Factor | None:
    """What is stated of y; None where nothing is. Where log is, V = |log|^2/2 falls with y = 2."""
    table = _TABLES.get(group, {_SQUARE: {_LOG: _constant(2)}})
    return table.get(morse, {}).get(law)
