"""How long the terms are that s and the force of a controller are sums of: its own table.

Lengths are taken block by block, (N, blocks); an error is judged on them where the sum cancels.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from derive.verify.natural import Natural

Array = NDArray[Any]
Lengths = tuple[Array, Array]
"""Of s, and of the force."""


def sliding(at: Natural) -> Lengths:
    """nu_e + lambda nu_u; coad(lambda nu_u - eta) I nu + I (eta' - lambda nu_u' - k_s s)."""
    rate_gain, reach_gain = at.gains
    law, rate = np.maximum(at.of("nu_u"), at.value), np.maximum(at.of("nu_u_dot"), at.rate)
    drive = rate_gain * (law + _product(at))
    s = at.speed + drive
    wanted = at.growth + rate_gain * rate + reach_gain * s
    return s, at.flat(wanted) + at.carried(drive + at.reference)


def lsf(at: Natural) -> Lengths:
    """nu - nu_r + (kappa/k) a; I (nu_r' - k s + nu x nu_r) - nu x I nu. a is twice the law."""
    k, kappa = at.gains
    own = at.length("nu")
    s = own + at.reference + kappa / k * (np.maximum(at.of("nu_u"), 2 * at.value) + _product(at))
    wanted = at.length("nu_r_dot") + k * s + own * at.reference
    return s, at.flat(wanted) + at.carried(own)


def pd_plus(at: Natural) -> Lengths:
    """nu_e + (k_R/k_Omega) nu_u; -k_Omega s + I R_e^T nu_r' + eta x I eta."""
    k_r, k_omega = at.gains
    eta = at.reference
    law = np.maximum(at.of("nu_u"), at.value) + _product(at)
    s = at.length("nu") + eta + k_r / k_omega * law
    turning = at.carried(eta, eta)
    return s, k_omega * s + at.flat(at.length("nu_r_dot")) + turning


def _product(at: Natural) -> Array | float:
    """Of the product g_r^-1 g, which rounds as a whole where the reference is not the identity."""
    return at.arm if at.is_moving else 0.0


TERMS: dict[str, Callable[[Natural], Lengths]] = {
    "gsmc": sliding,
    "reaching": sliding,
    "lsf_printed": lsf,
    "lsf": lsf,
    "pd_plus": pd_plus,
}
"""Controller -> lengths of the terms of s and of the force, without a known force."""
