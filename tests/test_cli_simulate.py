"""`derive simulate` as a user calls it: what it prints, what it refuses, what it ends with."""

from __future__ import annotations

import json
import math
import re
from dataclasses import dataclass
from pathlib import Path

import pytest

from derive import simulation
from derive.cli import run
from tests.command import FILES, derive, refused

FIGURES = (
    *("first height", "last height", "last |nu_e|", "settled to 0.01", "settled to 1e-06"),
    *("energy", "peak |force|", "peak |nu_e|", "crossings of the cut", "refused instants"),
    *("W = W(0) exp(-2 k_s t)", "g and g_r stay on the group", "energy of the plant left alone"),
)
SHORT = ("--duration", "0.5", "--rate", "20")


@dataclass(frozen=True)
class Done:
    """What a command said, and its exit code."""

    code: int
    out: str
    err: str


class Command:
    """`derive simulate` on one vehicle, in this process and without pictures, for speed."""

    def __init__(self, body: Path, said: pytest.CaptureFixture[str]) -> None:
        self.body, self._said = body, said

    def __call__(self, *arguments: str) -> Done:
        code = run(["simulate", str(self.body), *arguments])
        out, err = self._said.readouterr()
        return Done(code, out, err)

    def add(self, text: str) -> None:
        self.body.write_text(f"{self.body.read_text(encoding='utf-8')}\n{text}", encoding="utf-8")


@pytest.fixture
def flown(
    home: Path, body: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Command:
    """In the folder of body.toml."""
    monkeypatch.setenv("HOME", str(home))
    monkeypatch.chdir(body.parent)
    monkeypatch.setattr(simulation, "is_drawable", lambda: False)
    return Command(body, capsys)


def figures(said: str) -> dict[str, str]:
    """What stands behind each name of the table."""
    rows = (re.fullmatch(r"  (.{24,28}?) +(\S.*)", line) for line in said.splitlines())
    return {row[1].strip(): row[2] for row in rows if row}


def test_the_table_names_everything(home: Path, body: Path) -> None:
    done = derive(body.parent, "simulate", str(body), *SHORT, home=home)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("body: gsmc on SO3, f64, 20 Hz, 0.5 s\n")
    assert "height: Psi = tr(1 - R)/2 [1]" in done.stdout
    for name in FIGURES:
        assert f"  {name} " in done.stdout, name
    assert "not applicable: the controller is sampled" in done.stdout
    assert "not settled" in done.stdout
    assert re.search(r"energy +\S+ N m sqrt\(s\)\n", done.stdout)


@pytest.mark.parametrize("file", FILES, ids=[Path(file).stem for file in FILES])
def test_every_vehicle_flies(file: str, flown: Command) -> None:
    flown.body = Path(file)
    done = flown(*SHORT)
    assert done.code == 0, done.err
    assert done.out.startswith(f"{Path(file).stem}: ")
    assert "BROKEN" not in done.out


def test_a_seed_is_a_run(flown: Command) -> None:
    first, again, other = (flown(*SHORT, "--seed", seed).out for seed in "334")
    assert first == again
    assert "0.5 s, seed 3\n" in first
    assert first.splitlines()[3] != other.splitlines()[3]


def test_options_of_a_draw_and_of_a_wave_are_taken_beside_it(flown: Command) -> None:
    drawn, slow = (flown(*SHORT, "--seed", "3", "--speed", one) for one in ("0.5", "0.1"))
    assert (drawn.code, slow.code) == (0, 0)
    assert figures(drawn.out)["peak |nu_e|"] != figures(slow.out)["peak |nu_e|"]
    assert flown(*SHORT, "--wave", "0", "--hertz", "2").code == 0


def test_every_backend_comes_to_the_same(flown: Command) -> None:
    tables = [flown(*SHORT, "--backend", one).out for one in ("f64", "numpy", "f32")]
    assert tables[0].split("\n", 1)[0] == tables[1].split("\n", 1)[0].replace("numpy", "f64")
    assert figures(tables[0]) == figures(tables[1])
    single, double = (figures(tables[i])["energy"].split()[0] for i in (2, 0))
    assert float(single) == pytest.approx(float(double), rel=1e-4)


def test_a_disturbance_by_coordinate_moves_it(flown: Command) -> None:
    still = flown(*SHORT)
    pushed = flown(*SHORT, "--disturbance", "0.01,0,0")
    assert pushed.code == 0
    assert figures(pushed.out)["last height"] != figures(still.out)["last height"]
    all_alike = flown(*SHORT, "--disturbance", "0.01")
    assert figures(all_alike.out)["last height"] != figures(pushed.out)["last height"]


def test_the_file_says_what_options_say(flown: Command) -> None:
    by_option = flown(*SHORT, "--disturbance", "0.01,0,0", "--force-limit", "0.002")
    flown.add(
        "[simulate]\nduration = 0.5\nrate = 20\ndisturbance = [0.01, 0, 0]\nforce_limit = 0.002\n"
    )
    assert flown().out == by_option.out
    # And an option goes before the file.
    assert "10 Hz, 0.5 s" in flown("--rate", "10").out


def test_a_run_that_breaks_says_so_and_ends_with_1(flown: Command) -> None:
    """A body that tumbles once in two steps: the integration is lost."""
    flown.add("[simulate]\nnu = [20, 30, 10]\n")
    lost = flown("--duration", "2", "--step", "0.1")
    assert lost.code == 1
    assert "BROKEN" in lost.out
    assert "Warning" not in lost.err
    # The step that is chosen for it keeps all.
    assert flown("--duration", "0.5").code == 0


# arguments, place, fragments of expected and found
BAD = [
    (("--backend", "f16"), "command line: --backend", "f32, f64, numpy", "f16"),
    (("--seed", "-1"), "--seed", "whole number from 0", "-1"),
    (("--seed", "1.5"), "--seed", "whole number", "1.5"),
    (("--seed", str(2**63)), "--seed", "to 9223372036854775807", str(2**63)),
    (("--duration", "0"), "--duration", "from 0.001 to 1e+06 s", "0"),
    (("--duration", "nan"), "--duration", "a number from", "nan"),
    (("--duration", "-3"), "--duration", "a number from", "-3"),
    (("--rate", "inf"), "--rate", "to 1e+06 Hz", "inf"),
    (("--rate", "0"), "--rate", "from 0.001", "0"),
    (("--step", "0"), "--step", "from 1e-06 to 1 s", "0"),
    (("--step", "2"), "--step", "from 1e-06 to 1 s", "2"),
    (("--noise-g", "0.2", "--rate", "9"), "--noise-g", "from 0 to 0.1", "0.2"),
    (("--noise-nu", "x"), "--noise-nu", "a number", "x"),
    (
        ("--noise-nu", "0.1"),
        "command line: --noise-nu",
        "a rate in Hz: noise is of samples",
        "continuous",
    ),
    (("--inertia-error", "-1"), "--inertia-error", "from -0.9 to 10", "-1"),
    (("--disturbance", "1,2"), "--disturbance", "one number, or 3", "2 numbers"),
    (("--disturbance", "1,,2"), "--disturbance", "a number", "nothing"),
    (("--force-limit", "0"), "--force-limit", "above 0", "0"),
    (("--wave", "1"), "command line: --wave", "above 0 where there is a wave", "no force at all"),
    (("--hertz", "2"), "command line: --hertz", "a wave of that frequency", "no --wave"),
    (("--box", "1"), "command line: --box", "a --seed", "--box without --seed"),
    (("--speed", "2"), "command line: --speed", "a --seed", "--speed without --seed"),
    (
        ("--scenario", "1", "--settle", "0.1", "--box", "1"),
        "command line: --scenario",
        "no option of a run of one's own",
        "--box, --settle",
    ),
    (("--hertz", "-1"), "--hertz", "from 0", "-1"),
    (
        ("--rate", "1", "--duration", "0.5"),
        "command line: --rate",
        "at least one period",
        "1 Hz over",
    ),
    (
        ("--rate", "1e6", "--duration", "1e6"),
        "command line: --duration",
        "1000000 steps",
        "1000000000000 of",
    ),
    (("--wave", "1", "--hertz", "1e6"), "command line", "1000000 steps", "of 1.59e-08 s"),
]


@pytest.mark.parametrize(("arguments", "place", "expected", "found"), BAD)
def test_what_cannot_be_is_refused(
    arguments: tuple[str, ...], place: str, expected: str, found: str, flown: Command
) -> None:
    done = flown(*arguments)
    head, *rest = done.err.splitlines()
    assert (done.code, done.out, len(rest)) == (2, "", 3)
    assert place in head
    assert expected in rest[0]
    assert found in rest[1]
    assert list(flown.body.parent.iterdir()) == [flown.body]


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ('[reference]\nkind = "file"\nfile = "no.csv"\n', "No such file"),
        ('[reference]\nkind = "file"\nfile = "."\n', "a directory"),
        ("[simulate]\nturn = [100, 0, 0]\n", "at most 32 in a coordinate that turns"),
    ],
)
def test_a_bad_file_is_refused_before_anything_is_flown(
    more: str, told: str, home: Path, flown: Command
) -> None:
    flown.add(more)
    assert told in refused(flown.body.parent, "simulate", str(flown.body), home=home)


@pytest.mark.parametrize("slew", ["0.05", "0.2"])
def test_a_slew_is_resolved_however_short(slew: str, flown: Command, tmp_path: Path) -> None:
    """The reference ends where it should, and W falls as it must."""
    with flown.body.open("a") as file:
        file.write(f"\n[reference]\nalong = [0.0, 0.6, 0.8]\nduration = {slew}\n")
    done = flown("--duration", "1", "--out", str(tmp_path / "out"))
    assert done.code == 0, done.out + done.err
    assert re.search(r"W = W\(0\) exp\(-2 k_s t\) +holds", done.out)
    kept = json.loads((tmp_path / "out" / "flight.json").read_text())["trajectory"]["g_r"][-1]
    assert math.acos((kept[0] + kept[4] + kept[8] - 1) / 2) == pytest.approx(1.0, abs=1e-9)


def test_a_step_that_skips_a_slew_is_refused(flown: Command) -> None:
    with flown.body.open("a") as file:
        file.write("\n[reference]\nalong = 0.5\nduration = 0.01\n")
    done = flown("--duration", "1", "--step", "0.005")
    assert done.code == 2
    assert "command line: --step" in done.err
    assert "at most 0.001 s" in done.err


def test_a_flight_ends_with_a_whole_period_and_says_so(flown: Command) -> None:
    done = flown("--duration", "2.8", "--rate", "0.7")
    assert "1.42857 of 2.8 s, in whole periods" in done.out.splitlines()[0]
