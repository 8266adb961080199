"""One run of a vehicle: flown, told, watched for what must not break, drawn and written."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any

from derive import folder, place
from derive.course import course
from derive.demand import backend_of
from derive.flight import craft, overridden, roomy, setting_of, spread_of, stated
from derive.simulate import tell
from derive.simulate.craft import Craft, group_of
from derive.simulate.draw import drawn
from derive.simulate.flight import Flight, recorded
from derive.simulate.invariant import Invariant, crossings, invariants
from derive.simulate.loop import Loop
from derive.simulate.picture import captions_of, performance, sliding
from derive.simulate.reference import Reference
from derive.simulate.runs import Runs, Setting
from derive.simulate.space import space_of
from derive.simulate.sphere import in_space, pointing
from derive.simulate.style import is_drawable, written
from derive.vehicle import Vehicle


@dataclass(frozen=True)
class Asked:
    """What a command line says of a run.

    seed:   draw the run as a sweep does; None for the one that the vehicle file states
    settle: bound on the height and on |nu_e| below which the run is settled
    given:  keys of Experiment that replace those of the vehicle file
    """

    backend: str = "f64"
    seed: int | None = None
    box: float = 1.0
    speed: float = 0.5
    settle: float = 1e-3
    given: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Flown:
    """One run of a vehicle, its flight, and what was watched in it."""

    vehicle: Vehicle
    craft: Craft
    setting: Setting
    asked: Asked
    flight: Flight
    invariants: tuple[Invariant, ...]

    @property
    def ok(self) -> bool:
        """Whether no invariant broke."""
        return all(one.ok for one in self.invariants)

    @property
    def found(self) -> dict[str, float | None]:
        """Its figures by name."""
        turns = space_of(self.craft).turns
        crossed = crossings(self.flight, turns, self.setting.period)
        return tell.figures(self.flight, crossed, self.asked.settle)

    def table(self) -> str:
        """Figures and invariants as text."""
        rate = self.setting.rate
        pace = "continuous" if rate is None else f"{rate:g} Hz"
        drawn = "" if self.asked.seed is None else f", seed {self.asked.seed}"
        head = (
            f"{self.craft.name}: {self.craft.controller} on {self.craft.group}, "
            f"{self.asked.backend}, {pace}, {self._flown()}{drawn}"
        )
        return tell.table(head, group_of(self.craft), self.found, self.invariants)

    def _flown(self) -> str:
        """How long it is: where the force is held, a flight ends with its last whole period."""
        flown, asked = float(self.flight.t[-1]), self.setting.seconds
        is_whole = abs(flown - asked) <= 1e-9 * asked
        return f"{asked:g} s" if is_whole else f"{flown:g} of {asked:g} s, in whole periods"

    def as_json(self) -> str:
        """Everything, trajectory included."""
        made, asked = self.craft, self.asked
        head = {
            "vehicle": made.name, "group": made.group, "law": made.law,
            "controller": made.controller, "gains": dict(made.gains),
            "inertia": list(made.inertia), "backend": asked.backend, "seed": asked.seed,
            "spread": None if asked.seed is None else {"box": asked.box, "speed": asked.speed},
            "flown": float(self.flight.t[-1]), "settle": asked.settle,
            "experiment": decimal(asdict(self.vehicle.experiment)),
        }  # fmt: skip
        group = group_of(made)
        return tell.as_json(head, group, self.setting, self.flight, self.found, self.invariants)


def decimal(value: Any) -> Any:
    """Exact numbers as floats, paths as text: what JSON can hold."""
    if isinstance(value, dict):
        return {key: decimal(one) for key, one in value.items()}
    if isinstance(value, tuple):
        return [decimal(one) for one in value]
    if isinstance(value, Fraction):
        return float(value)
    return value.name if isinstance(value, Path) else value


@roomy()
def simulate(
    vehicle: Vehicle,
    cached: Path | None,
    asked: Asked,
    progress: Callable[[str], None] = lambda _: None,
) -> Flown:
    """One run as the vehicle file states it, or, by a seed, as a sweep draws it.

    Raises InputError.
    """
    backend_of(asked.backend)
    one = overridden(vehicle, asked.given)
    progress("deriving")
    made = craft(one, cached)
    reference = course(one, made).reference()
    setting = setting_of(one, asked.given, made, reference)
    runs = _runs(one, made, reference, asked)
    loop = Loop(made, asked.backend, reference, setting, runs)
    (flight,) = recorded(loop.moments(), lambda t: progress(f"{t:.1f} of {setting.seconds:g} s"))
    progress("invariants")
    return Flown(one, made, setting, asked, flight, invariants(loop, flight))


def _runs(vehicle: Vehicle, made: Craft, reference: Reference, asked: Asked) -> Runs:
    if asked.seed is None:
        runs: Runs = stated(vehicle, made, reference)
        return runs
    spread = spread_of(vehicle, asked.given, asked.box, asked.speed)
    return drawn(made, reference, spread, [asked.seed])


def documents(flown: Flown) -> dict[str, bytes]:
    """Name -> content: the run in numbers, and its pictures where they can be drawn."""
    files = {"flight.json": flown.as_json().encode()}
    if not is_drawable():
        return files
    group, made = group_of(flown.craft), flown.craft
    entries = [(made.controller, flown.flight)]
    title = f"{made.name}: {made.controller} on {made.group}"
    names = [f"$s_{{{i}}}$" for i in range(group.dim)]
    drawn = {
        "flight": performance(entries, captions_of(group), title),
        "flight_s": sliding(entries, names, group.unit, title),
    }
    if made.group in ("SO3", "S3"):
        turned = [(made.controller, in_space(flown.flight))]
        drawn["flight_axis"] = pointing(turned, 3, f"{made.name}: path of the body axis $e_3$")
    return files | {
        f"{name}{kind}": content
        for name, figure in drawn.items()
        for kind, content in written(figure).items()
    }


def write(files: Mapping[str, bytes], out: Path) -> tuple[Path, ...]:
    """Put them into a folder, all or none, beside what else is there. Raises InputError."""
    with place.told(out, "a folder that can be written to"):
        folder.save_all(out, files)
    return tuple(out / name for name in files)
