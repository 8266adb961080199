"""The paper's comparison: a vehicle under every controller, through the paper's scenarios."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property, partial
from pathlib import Path

from derive import flight
from derive.demand import backend_of
from derive.simulate import claim_table, digest, scenario
from derive.simulate.claim import Judged, judged
from derive.simulate.craft import Craft
from derive.simulate.flight import Flight
from derive.simulate.invariant import Watched
from derive.simulate.picture import PAPER, performance, sliding
from derive.simulate.reading import until
from derive.simulate.scenario import ENTRANTS, SCENARIOS, SECONDS, Entrant
from derive.simulate.sphere import pointing
from derive.simulate.style import is_drawable, written
from derive.vehicle import CONTROLLERS, InputError, Vehicle

Progress = Callable[[str], None]

SCALARS = {"numpy": ("f64",), "f64": ("f64",), "f32": ("f32",)}
"""Backend -> what has to be emitted for it."""

AXIS = 3  # e_1 starts where the reference has it: R_e(0) turns about it
SHOWN = 15.0  # s, of sliding variables


@dataclass(frozen=True)
class Comparison:
    """All flights of a vehicle's comparison, and what was watched: number -> controller -> it."""

    vehicle: str
    backend: str
    crafts: tuple[Craft, ...]
    flights: Mapping[int, Mapping[str, Flight]]
    watched: Mapping[int, Mapping[str, Watched]]

    @property
    def broken(self) -> list[str]:
        """Every invariant that broke, in words."""
        return [
            f"scenario {number}, {ENTRANTS[name].title}: {one.name} {one.verdict}, "
            f"{one.measured:.2g}, at most {one.limit:g}"
            for number, each in self.watched.items()
            for name, all_of_it in each.items()
            for one in all_of_it
            if not one.ok
        ]

    @property
    def ok(self) -> bool:
        """Whether no invariant broke; the verdicts speak of the paper."""
        return not self.broken

    @cached_property
    def claims(self) -> list[Judged]:
        """The paper's statements on these scenarios."""
        return judged(self.flights)

    @cached_property
    def differences(self) -> list[str]:
        """What of body and controllers is not the paper's."""
        return scenario.differences(self.crafts)

    def table(self) -> str:
        """Figures per controller, and the claims, as text."""
        parts = [digest.table(number, each) for number, each in self.flights.items()]
        parts += [note for note in ["\n".join(self.broken), self._note()] if note]
        parts.append(claim_table.text(self.claims))
        return "\n\n".join(parts)

    def _note(self) -> str:
        """A warning where the verdicts are not on the paper's experiment."""
        if not self.differences:
            return ""
        return f"not the paper's body and controllers: {', '.join(self.differences)} differ"

    def as_json(self, number: int) -> str:
        """One scenario in numbers."""
        return digest.as_json(number, self.vehicle, self.backend, self.crafts,
                              self.flights[number], self.watched[number], self.claims,
                              self.differences)  # fmt: skip


@flight.roomy()
def scenarios(
    vehicle: Vehicle, cached: Path | None, numbers: Sequence[int], backend: str, show: Progress
) -> Comparison:
    """Every controller of the comparison through those scenarios, in one batch each.

    Raises InputError, and CompileError where the emitted C does not compile.
    """
    backend_of(backend)
    _refuse_other_groups(vehicle)
    flights: dict[int, dict[str, Flight]] = {number: {} for number in numbers}
    watched: dict[int, dict[str, Watched]] = {number: {} for number in numbers}
    crafts = []
    for entrant in ENTRANTS.values():
        show(f"{entrant.title}: deriving")
        made = flight.craft(entered(vehicle, entrant, backend), cached)
        crafts.append(made)
        told = partial(_flown, show, entrant.title)
        each = scenario.fly(made, numbers, backend, told)
        for number, (one, found) in zip(numbers, each, strict=True):
            flights[number][entrant.controller] = one
            watched[number][entrant.controller] = found
    return Comparison(vehicle.name, backend, tuple(crafts), flights, watched)


def _flown(show: Progress, title: str, t: float) -> None:
    show(f"{title}: {t:.0f} of {scenario.FLOWN:g} s")


def entered(vehicle: Vehicle, entrant: Entrant, backend: str) -> Vehicle:
    """The vehicle under a controller: with its own gains where it has those, or the paper's."""
    own = tuple(name for name, _ in vehicle.gains) == tuple(name for name, _ in entrant.gains)
    return replace(
        vehicle,
        name=entrant.controller,
        controller=entrant.controller,
        law=vehicle.law if own else entrant.law,
        gains=vehicle.gains if own else _gains(vehicle, entrant),
        scalars=SCALARS[backend],
        targets=("c99", "numpy"),
    )


def _gains(vehicle: Vehicle, entrant: Entrant) -> tuple[tuple[str, Fraction], ...]:
    """The paper's; those of a force grow with the body, so that they are as quick on any."""
    own = sum((row[i] for i, row in enumerate(vehicle.inertia)), Fraction())
    share = own / sum(map(Fraction, scenario.MOMENTS))  # of traces
    units = {gain.name: gain.unit for gain in CONTROLLERS[entrant.controller].gains}
    return tuple((name, Fraction(value) * (share if units[name].startswith("N m") else 1))
                 for name, value in entrant.gains)  # fmt: skip


def documents(found: Comparison, show: Progress) -> dict[str, bytes]:
    """Name -> content of every file: numbers, and each picture as PNG and SVG."""
    files: dict[str, bytes] = {}
    for number in found.flights:
        show(f"scenario {number}: pictures")
        stem = f"scenario{number}"
        files[f"{stem}.json"] = found.as_json(number).encode()
        drawn = pictures(number, found.flights[number]) if is_drawable() else {}
        files |= {f"{stem}{name}": content for name, content in drawn.items()}
    files["claims.md"] = claim_table.markdown(found.claims).encode()
    return files


def pictures(number: int, flights: Mapping[str, Flight]) -> dict[str, bytes]:
    """Ending of the file's name -> content: performance, sliding variables, pointing axis."""
    entries = [(ENTRANTS[name].title, until(one, SECONDS)) for name, one in flights.items()]
    title = f"Scenario {number}: {SCENARIOS[number].title}"
    axes = [f"axis {axis}" for axis in (1, 2, 3)]
    drawn = {
        "": performance(entries, PAPER, title),
        "_s": sliding(entries, axes, "rad/s", title, SHOWN),
        "_axis": pointing(entries, AXIS, f"Scenario {number}: path of the body axis $e_{AXIS}$"),
    }
    return {
        f"{name}{kind}": content
        for name, figure in drawn.items()
        for kind, content in written(figure).items()
    }


def _refuse_other_groups(vehicle: Vehicle) -> None:
    if vehicle.group != scenario.GROUP or vehicle.own is not None:
        raise InputError(
            vehicle.source,
            "group",
            f'"{scenario.GROUP}" for --scenario: the paper\'s scenarios turn a rigid body',
            f'"{vehicle.group}"',
            "name a vehicle whose attitude is a rotation matrix, or leave --scenario out",
        )
