"""What the commands that close the loop share: their options, and numbers within bounds."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

import click
from click.core import ParameterSource

if TYPE_CHECKING:
    Kind = click.ParamType[Any]
else:
    Kind = click.ParamType  # takes no argument before click 8.2

Command = TypeVar("Command", bound=Callable[..., Any])

LARGEST_SEED = 2**63 - 1
PLACE = "command line"  # of an option that cannot be used


class Number(Kind):
    """A number from `least` to `most`; InputError for any other, for NaN and for words.

    is_open: `least` itself is refused
    """

    name = "number"

    def __init__(self, least: float, most: float, unit: str = "", is_open: bool = False) -> None:
        self.least, self.most, self.is_open = least, most, is_open
        self.unit = f" {unit}" if unit else ""

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float | tuple[float, ...]:
        """The value as a float."""
        return self._one(value, param)

    def _one(self, value: Any, param: Any) -> float:
        found = _number(value)
        above = found > self.least if self.is_open else found >= self.least
        if above and found <= self.most:
            return found
        bound = f"above {self.least:g}" if self.is_open else f"from {self.least:g}"
        raise refused(param, f"a number {bound} to {self.most:g}{self.unit}", str(value))


class Numbers(Number):
    """Such numbers with commas between them; one stands for every coordinate."""

    name = "numbers"

    def convert(self, value: Any, param: click.Parameter | None, ctx: Any) -> tuple[float, ...]:
        """The values as floats."""
        if isinstance(value, tuple):
            return value
        return tuple(self._one(word, param) for word in str(value).split(","))


class Count(Kind):
    """A whole number from `least` to `most`; InputError for any other."""

    name = "count"

    def __init__(self, least: int, most: int) -> None:
        self.least, self.most = least, most

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> int:
        """The value as an int."""
        word = str(value).strip()
        digits = word.removeprefix("-")
        if digits.isascii() and digits.isdigit() and len(digits) < 25:
            found = int(word)
            if self.least <= found <= self.most:
                return found
        raise refused(param, f"a whole number from {self.least} to {self.most}", word)


def said(*names: str) -> list[str]:
    """Those of these parameters that the command line gives, be it their default."""
    source = click.get_current_context().get_parameter_source
    return [name for name in names if source(name) is not ParameterSource.DEFAULT]


def refused(param: Any, expected: str, found: str) -> Exception:
    """The InputError of an option's value."""
    from derive.vehicle import InputError

    option = max(param.opts, key=len) if param else ""
    fallback = None if param is None else param.default
    plain = isinstance(fallback, int | float | str) and not isinstance(fallback, bool)
    remedy = f"give one, or leave {option} out" + (f" for {fallback}" if plain else "")
    return InputError(PLACE, option, expected, found or "nothing", remedy)


def _number(value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        return math.nan


backend_option = click.option(
    "--backend", default="f64", show_default=True, metavar="f64|f32|numpy",
    help="Which emitted controller flies: C in double or single precision, or numpy.",
)  # fmt: skip
settle_option = click.option(
    "--settle", default=1e-3, show_default=True, type=Number(0.0, 1e6, is_open=True),
    help="Bound on the height and on |nu_e| below which a run is settled.",
)  # fmt: skip


def start_options(command: Command) -> Command:
    """The box and the speed that a drawn start lies in."""
    box = click.option(
        "--box", default=1.0, show_default=True, type=Number(0.0, 1e6, "rad or m"),
        help="Drawn initial error, +- per coordinate, where the group is not compact.",
    )  # fmt: skip
    speed = click.option(
        "--speed", default=0.5, show_default=True, type=Number(0.0, 1e6, "rad/s or m/s"),
        help="Drawn velocity error, +- per coordinate.",
    )  # fmt: skip
    return box(speed(command))


rate_option = click.option(
    "--rate", type=Number(1e-3, 1e6, "Hz"),
    help="Of the controller, its force held between; continuous when left out.",
)  # fmt: skip

_OF_THE_FILE = (
    click.option("--duration", type=Number(1e-3, 1e6, "s"), help="Seconds to fly."),
    click.option("--step", type=Number(1e-6, 1.0, "s"), help="Longest step of the integration."),
    click.option(
        "--inertia-error", type=Number(-0.9, 10.0),
        help="Of the plant against the controller, relative; with --seed +-.",
    ),
    click.option(
        "--disturbance", type=Numbers(-1e9, 1e9, "N m or N"), metavar="F[,F...]",
        help="Constant force that the controller is not told; with --seed +-.",
    ),
    click.option(
        "--wave", type=Numbers(-1e9, 1e9, "N m or N"), metavar="F[,F...]",
        help="Amplitude of a periodic one; with --seed +-.",
    ),
    click.option("--hertz", type=Number(0.0, 1e6, "Hz"), help="Its frequency."),
    click.option(
        "--noise-g", type=Number(0.0, 0.1, "rad or m"),
        help="Standard deviation of a measured configuration.",
    ),
    click.option(
        "--noise-nu", type=Number(0.0, 1e9, "rad/s or m/s"),
        help="Standard deviation of a measured velocity.",
    ),
    click.option(
        "--force-limit", type=Numbers(0.0, 1e9, "N m or N", is_open=True), metavar="F[,F...]",
        help="What the actuators can give; one for all coordinates, or one for each.",
    ),
)  # fmt: skip


def experiment_options(command: Command) -> Command:
    """What the [simulate] table of a vehicle file says as well, but for the rate."""
    for option in reversed(_OF_THE_FILE):
        command = option(command)
    return command
