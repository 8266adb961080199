"""The motion of a vehicle file, as the simulator takes it: on the group, and of one piece."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import cache, partial
from pathlib import Path

import numpy as np
import pytest

from bench import made
from bench.algebra import Array, algebra, exp
from derive import flight
from derive.course import course
from derive.simulate.craft import Craft
from derive.simulate.flight import recorded
from derive.simulate.loop import Loop
from derive.simulate.reference import Reference
from derive.simulate.runs import Setting
from derive.vehicle import InputError, Vehicle
from derive.vehicle.experiment import Course, Experiment
from tests.simulate.plain import runs

RATE = (0.3, -0.2, 0.4)
FOLLOWED = ("SO3", "S3", "SE2", "SE3", "SL2")


@cache
def craft(name: str) -> Craft:
    return flight.craft(vehicle(name), None)


def vehicle(name: str, followed: Course | None = None, controller: str = "gsmc") -> Vehicle:
    law = "skew" if name == "SL2" else "log"
    one = replace(made.vehicle(name, law), controller=controller, source="body.toml")
    return replace(one, experiment=Experiment(followed or Course(), duration=Fraction(2)))


def followed(name: str, said: Course) -> Reference:
    return course(vehicle(name, said), craft(name)).reference()


def exact(values: tuple[float, ...] | Array) -> tuple[Fraction, ...]:
    return tuple(map(Fraction, map(float, values)))


def rate(name: str) -> Array:
    return np.resize(RATE, algebra(name).dim)


def start(name: str) -> Array:
    space = algebra(name)
    return space.store(exp(space.hat(0.5 * rate(name)[::-1])))


def csv(name: str, seconds: float = 2.0, step: float = 0.1, known: bool = True) -> list[str]:
    """A steady motion, line by line, by matrices alone."""
    space, nu = algebra(name), rate(name)
    names = ["t", *(f"g_{i}" for i in range(len(space.kept))),
             *(f"nu_r_{i}" for i in range(space.dim)),
             *(f"nu_r_dot_{i}" for i in range(space.dim) if known)]  # fmt: skip
    lines = [",".join(names)]
    for place in range(round(seconds / step) + 1):
        t = place * step
        g = space.store(space.embed(start(name)) @ exp(space.hat(t * nu)))
        row = [t, *g, *nu, *([0.0] * space.dim if known else [])]
        lines.append(",".join(repr(float(one)) for one in row))
    return lines


def of_file(folder: Path, name: str, lines: list[str]) -> Reference:
    path = folder / "m.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return followed(name, Course("file", file=path))


@pytest.mark.parametrize("known", [True, False], ids=["rates given", "rates by differences"])
@pytest.mark.parametrize("name", FOLLOWED)
def test_a_steady_motion_in_a_file_flies_like_the_rate(
    name: str, known: bool, tmp_path: Path
) -> None:
    steady = Course("rate", g_r=exact(start(name)), nu_r=exact(rate(name)))
    pair = (followed(name, steady), of_file(tmp_path, name, csv(name, known=known)))
    met = runs(craft(name), met=False)
    ends = []
    for reference in pair:
        (found,) = recorded(Loop(craft(name), "numpy", reference, Setting(1.0), met).moments())
        ends.append(np.concatenate([found.g[-1], found.nu[-1], found.g_r[-1]]))
    assert np.abs(ends[0] - ends[1]).max() < 1e-9


@pytest.mark.parametrize("name", FOLLOWED)
def test_left_out_it_starts_at_the_identity(name: str) -> None:
    space = algebra(name)
    for said in (Course(), Course("rate", nu_r=exact(rate(name)))):
        e = space.store(np.eye(space.basis.shape[-1]))
        np.testing.assert_array_equal(followed(name, said).start[:, 0], e)


def test_a_slew_is_as_long_as_written() -> None:
    said = Course("slew", along=exact(RATE), duration=Fraction(3))
    motion = followed("SO3", said)
    assert motion.at(2.9)[0].any()
    assert not motion.at(3.0)[0].any()
    np.testing.assert_allclose(
        motion.at(1.5)[0][:, 0], np.array(RATE) * 2772 / 1024 / 3, rtol=1e-15
    )


def refusal(act: Callable[[], object]) -> InputError:
    with pytest.raises(InputError) as caught:
        act()
    return caught.value


# group, numbers, fragments of expected and found
OFF = [
    ("SO3", (1, 0, 0), "9 numbers: rotation matrix", "3"),
    ("SO3", (1, 0, 0, 0, 1, 0, 0, 0, -1), "configuration of SO3, to 1e-06", "off the group"),
    ("SO3", (0,) * 9, "configuration of SO3", "off the group"),
    ("S3", (1, 0, 0, 0.1), "configuration of S3", "0.01 off the group"),
    ("S3", (1, 0, 0), "4 numbers: unit quaternion", "3"),
    ("SE2", (1, 0, 0, 0, 1, 0, 0, 0, 2), "configuration of SE2", "1 off the group"),
    ("SL2", (1, 0, 0, 1.5), "configuration of SL2", "off the group"),
]


@pytest.mark.parametrize(("name", "given", "expected", "found"), OFF)
def test_a_start_off_the_group_is_refused(
    name: str, given: tuple[float, ...], expected: str, found: str
) -> None:
    fault = refusal(lambda: followed(name, Course("rest", g_r=exact(given))))
    assert (fault.file, fault.key) == ("body.toml", "reference.g_r")
    assert expected in fault.expected
    assert found in fault.found


def test_a_start_as_decimals_leave_it_is_taken() -> None:
    given = (0.8, 0.6, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0, 1.0)
    motion = followed("SO3", Course("rest", g_r=exact(given)))
    np.testing.assert_array_equal(motion.start[:, 0], given)
    rough = tuple(round(x, 7) for x in (math.cos(1), -math.sin(1), 0, math.sin(1), math.cos(1), 0))
    followed("SO3", Course("rest", g_r=exact((*rough, 0, 0, 1))))


def test_reaching_takes_no_other_reference_than_the_identity() -> None:
    reaching = replace(craft("SO3"), controller="reaching")
    for said, key in (
        (Course("rate", nu_r=exact(RATE)), "reference"),
        (Course("rest", g_r=exact((0, -1, 0, 1, 0, 0, 0, 0, 1))), "reference.g_r"),
    ):
        fault = refusal(partial(course, vehicle("SO3", said, "reaching"), reaching))
        assert fault.key == key
        assert 'controller = "gsmc"' in fault.remedy
    e = Course("rest", g_r=exact(np.eye(3).ravel()))
    one = vehicle("SO3", e, "reaching")
    assert course(one, reaching).reference().is_at_rest


def changed(line: str, place: int, by: Callable[[float], float]) -> str:
    cells = line.split(",")
    cells[place] = repr(by(float(cells[place])))
    return ",".join(cells)


@pytest.mark.parametrize(("name", "line"), [("S3", 4), ("SO3", 2), ("SE2", 22)])
def test_a_row_off_the_group_is_told_by_its_line(name: str, line: int, tmp_path: Path) -> None:
    lines = csv(name)
    lines[line - 1] = changed(lines[line - 1], 1, lambda x: x + 1e-4)
    fault = refusal(lambda: of_file(tmp_path, name, lines))
    assert (fault.file, fault.key) == (str(tmp_path / "m.csv"), f"line {line}")
    assert f"a configuration of {name}" in fault.expected
    assert "off the group by" in fault.found
    assert "a quaternion has length 1" in fault.remedy


@pytest.mark.parametrize("name", FOLLOWED)
def test_a_row_that_does_not_follow_is_told_by_its_line(name: str, tmp_path: Path) -> None:
    """Each is on the group, but the eighth row is where the motion would be a second later."""
    lines = csv(name)
    far = csv(name, seconds=4.0)[18].split(",")
    own, k = lines[8].split(","), len(algebra(name).kept)
    lines[8] = ",".join([own[0], *far[1 : 1 + k], *own[1 + k :]])
    fault = refusal(lambda: of_file(tmp_path, name, lines))
    assert fault.key == "line 9"
    assert "nu_r leads to from the row above" in fault.expected
    assert "apart from it by" in fault.found


def test_velocities_in_the_wrong_frame_are_seen(tmp_path: Path) -> None:
    """Of a body that turns about another axis than the one it is turned by."""
    lines = csv("SO3")
    wrong = [lines[0], *(changed(line, 10, lambda x: -x) for line in lines[1:])]
    fault = refusal(lambda: of_file(tmp_path, "SO3", wrong))
    assert fault.key == "line 3"
    assert "velocities are in the body frame" in fault.remedy


def test_the_other_quaternion_of_a_row_is_a_jump(tmp_path: Path) -> None:
    lines = csv("S3")
    for place in range(1, 5):
        lines[6] = changed(lines[6], place, lambda x: -x)
    assert refusal(lambda: of_file(tmp_path, "S3", lines)).key == "line 7"


def test_a_motion_begins_with_the_flight(tmp_path: Path) -> None:
    lines = csv("SO3", seconds=4.0)
    late = [lines[0], *lines[3:]]
    said = refusal(lambda: of_file(tmp_path, "SO3", late))
    assert (said.key, said.expected, said.found) == ("line 2", "t = 0 in the first row", "t = 0.2")


def test_a_motion_lasts_as_long_as_the_flight(tmp_path: Path) -> None:
    said = refusal(lambda: of_file(tmp_path, "SO3", csv("SO3", seconds=1.5)))
    assert said.key == "line 17"
    assert "end of the flight, 2 s" in said.expected
    assert "--duration 1.5" in said.remedy


def test_rates_that_are_not_those_of_the_velocities_are_refused(tmp_path: Path) -> None:
    lines = csv("SO3")
    names = lines[0].split(",")
    place = names.index("nu_r_dot_0")
    wrong = [lines[0]]
    for line in lines[1:]:
        cells = line.split(",")
        cells[place] = repr(float(cells[place]) + 1.0)
        wrong.append(",".join(cells))
    said = refusal(lambda: of_file(tmp_path, "SO3", wrong))
    assert said.key == "line 3"
    assert "change of nu_r" in said.expected
