"""What a loop leaves behind: every instant of it, and the figures that are read from that."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, fields

import numpy as np

from derive.simulate.loop import Moment
from derive.simulate.space import Array


@dataclass(frozen=True)
class Flight:
    """One loop over T instants; arrays (T, size), or (T,) for t, height, energy and status.

    force:  what the actuators gave; asked: what the controller wanted
    height: how far g_e is off, by the Morse function of derive.control.motion.measure
    energy: square root of the integral of force^2, N m sqrt(s) where forces are torques
    """

    t: Array
    g: Array
    nu: Array
    g_r: Array
    nu_r: Array
    g_e: Array
    nu_e: Array
    height: Array
    force: Array
    asked: Array
    s: Array
    nu_u: Array
    energy: Array
    status: Array

    def rate_error(self) -> Array:
        """|nu_e|, (T,)."""
        return np.asarray(np.linalg.norm(self.nu_e, axis=-1))

    def effort(self) -> Array:
        """|force|, (T,)."""
        return np.asarray(np.linalg.norm(self.force, axis=-1))


def recorded(
    moments: Iterable[Moment], progress: Callable[[float], None] = lambda _: None
) -> list[Flight]:
    """Fly all loops to the end; one Flight each. progress is told the time flown, s."""
    rows: dict[str, list[Array]] = {one.name: [] for one in fields(Flight)}
    with np.errstate(over="ignore", invalid="ignore"):  # a loop that is lost says so by its rows
        for moment in moments:
            for name, value in _row(moment).items():
                rows[name].append(value)
            progress(moment.t)
    loops = rows["nu"][0].shape[-1]
    stacked = {name: np.stack([np.broadcast_to(one, (*one.shape[:-1], loops)) for one in values])
               for name, values in rows.items()}  # fmt: skip
    return [Flight(**{name: values[..., i] for name, values in stacked.items()})
            for i in range(loops)]  # fmt: skip


def _row(moment: Moment) -> dict[str, Array]:
    body, command = moment.body, moment.command
    return {
        "t": np.array([moment.t]),
        "g": body.g,
        "nu": body.nu,
        "g_r": body.g_r,
        "nu_r": moment.nu_r,
        "g_e": moment.g_e,
        "nu_e": moment.nu_e,
        "height": moment.height,
        "force": moment.force,
        "asked": command.force,
        "s": command.s,
        "nu_u": command.nu_u,
        "energy": np.sqrt(body.effort),
        "status": command.status,
    }
