"""The package tests itself: on this machine, under every warning, and sees whatever is changed."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from derive import pipeline
from derive.native.compile import FLAGS, WARNINGS_C, Compiler
from derive.vehicle import Vehicle
from derive.vehicle.limits import LEAST_DRIFT, MOST_DRIFT, Limits
from tests.emit import subjects
from tests.emit.package import configure, make, need, project, run
from tests.emit.subjects import COMPILERS, FILES, GUARDED, RANDOM, STEERED

BY_NAME = {vehicle.name: vehicle for vehicle in FILES}
PAPER = BY_NAME["paper_so3"]
SHARED, LIMITED = BY_NAME["cubesat_3u"], BY_NAME["freeflyer"]
"""Vehicles whose force is limited: as a whole, and each coordinate by itself."""

FREE = next(v for v in STEERED if v.controller == "reaching" and v.group == "S3")
"""A controller without a reference."""

OTHERS = tuple(v for v in GUARDED if v.name in (
    *("so3_gibbs_gsmc_full", "s3_sign_vec_gsmc_full", "s3_vec_gsmc_full", "r3_log_gsmc_full"),
))  # fmt: skip
"""Laws with another pole, another cut or none than those of the vehicle files."""

BOTH = ("paper_so3", "underwater")
"""Vehicles that every compiler is asked about."""

M4F = ("-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard")
BARE = '#include "{0}_test.h"\nint main(void);\nint main(void) {{ return {0}_test(); }}\n'
"""A main that needs no library, as on a bare target."""


def words(root: Path, vehicle: Vehicle) -> list[str]:
    """What a compiler is told besides its flags."""
    return [
        f"-I{root / 'c/include'}",
        f"-I{root / 'test'}",
        f"-D{vehicle.name.upper()}_CHECK_POINTERS",
    ]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("selftests")


@pytest.mark.parametrize("vehicle", [*FILES, FREE, *OTHERS], ids=lambda v: v.name)
def test_the_code_gives_the_truth_and_these_very_bits(folder: Path, vehicle: Vehicle) -> None:
    root = subjects.place(vehicle, folder)
    texts = [str(path) for place in ("c/src", "test") for path in (root / place).glob("*.c")]
    for name in COMPILERS[: 2 if vehicle.name in BOTH else 1]:
        flags = [*FLAGS, *WARNINGS_C[name], *words(root, vehicle), *texts, "-lm"]
        said = run(Compiler.find([name]).run(flags, root / f"test_{name}"))
        found = re.findall(r"^(\w+): 0 failures, (\d+) cases$", said, re.M)
        names = [prefix for prefix, cases in found if int(cases) > 15]
        assert names == [f"{vehicle.name}_{scalar}" for scalar in vehicle.scalars]


TABLE = "test/paper_so3_f32_test.c"
Change = Callable[[str], str]


def first(old: str, new: str, skipped: int = 0) -> Change:
    """A place in a text, the first or a later one, written anew."""

    def changed(text: str) -> str:
        places = list(re.finditer(old, text))
        place = places[skipped]
        return text[: place.start()] + place.expand(new) + text[place.end() :]

    return changed


ROW = r"(?m)^        \{\{"
BROKEN: dict[str, tuple[str, Change, int]] = {
    "nothing": (TABLE, str, 0),
    "a true number": (TABLE, first(ROW + r"[^,]*,", "        {{99.0F,", 2), 1),
    "a true number of refused inputs": (TABLE, first(ROW + r"[^,]*,", "        {{99.0F,", -1), 1),
    "a hash": (TABLE, first(r"_F32_OK, 0x........U", "_F32_OK, 0x12345678U"), 1),
    "a hash of a bare routine": (TABLE, first(r"F\}, \{0x........U", "F}, {0x12345678U"), 1),
    "a status": (TABLE, first(r"SO3_F32_OK,", "SO3_F32_NEAR_CUT_LOCUS,"), 1),
    "a status of good inputs": (TABLE, first(r"SO3_F32_OK,", "SO3_F32_BAD_PARAMS,"), 1),
    "a status of refused inputs": (TABLE, first(r"SO3_F32_NOT_ON_GROUP,", "SO3_F32_OK,"), 1),
    "a bound": (TABLE, first(r"(?m)^        \{[^{}]*\}, \{0x", "        {-1.0F}, {0x"), 1),
}  # fmt: skip
"""What of the table is changed, and how many failures there must be."""

DRIFT = r"params->max_drift\*params->max_drift"
OFF = {
    PAPER: [f"off_{i}" for i in range(6)],
    BY_NAME["paper_s3"]: ["off_0"],
    BY_NAME["hovercraft"]: ["g_6", "g_r_7", "off_1", "off_5", "off_8"],
    LIMITED: ["g_13", "g_r_12", "off_5", "off_9", "off_13"],
    BY_NAME["two_bodies"]: ["g_14", "off_11", "off_19"],
}
"""Of which vehicle what of the squares that sum up to the drift, each by itself."""


def unjudged(name: str) -> Change:
    """The drift, without one of its squares."""
    return first(rf"(float drift = [^;]*?\b){name}(?=\*{name}\b)", rf"\g<1>0.0F*{name}")


HARMED: dict[str, tuple[Vehicle, Change]] = {
    "an ulp": (PAPER, first(r"nu_u_0 = power_0", "nu_u_0 = 1.0000001F*power_0")),
    "an ulp in reaching": (PAPER, first(r"nu_u_0 = power_0", "nu_u_0 = 1.0000001F*power_0", -1)),
    "a bound that no element meets": (PAPER, first(r"bounded = 49\.0F", "bounded = 48.0F")),
    "a sign of the plant": (PAPER, first(r"force_0 \+", "force_0 -", -1)),
    "a velocity that is not judged": (PAPER, first(r"fabsf\(state->nu\[2\]\) <= \w+", "1")),
    "a rate that is not judged": (PAPER, first(r"fabsf\(reference->nu_dot\[1\]\) <= \w+", "1")),
    "a place that is not judged": (LIMITED, first(r"fabsf\(state->g\[7\]\) <= \w+", "1")),
    "a force that is not judged": (PAPER, first(r"isfinite\(command->force\[1\]\)", "1")),
    "a gain that is not judged": (PAPER, first(r"if \(!\(params->lambda [^{]*\{", "if (0) {")),
    "a gain that may be too small": (PAPER, first(r"lambda >= \w+", "lambda > 0.0F")),
    "a gain that may be too large": (PAPER, first(r"k_s <= \w+_MAX_RATE", "k_s <= 2.0e4F")),
    "a gain that may be its least no more": (PAPER, first(r"lambda >= ", "lambda > ")),
    "a drift too small": (PAPER, first(r"max_drift >= \w+", "max_drift > 0.0F")),
    "a drift that may be its least no more": (PAPER, first(r"max_drift >= ", "max_drift > ")),
    "an inertia that is not judged": (PAPER, first(r"if \(!\(pivot\[i\] > 0\.0F\)\)", "if (0)")),
    "a pivot that may be zero": (PAPER, first(r"pivot\[i\] > 0\.0F", "pivot[i] >= 0.0F")),
    **{
        f"{name} of {vehicle.name}, off the group and not judged": (vehicle, unjudged(name))
        for vehicle, names in OFF.items()
        for name in names
    },
    "a drift beyond its largest": (PAPER, first(DRIFT, r"1.5F*\g<0>")),
    "a drift not up to its largest": (PAPER, first(DRIFT, r"0.75F*\g<0>")),
    "a largest drift that is not squared": (PAPER, first(DRIFT, "params->max_drift*1.0e-3F")),
    "a largest drift that does not grow": (PAPER, first(DRIFT, "params->max_drift*1.0e-4F")),
    "pointers that are not judged": (PAPER, first(r"\|\| reference == NULL", "|| 0")),
    "a limit that is not judged": (SHARED, first(r"fabsf\(command->force\[2\]\) <= [^)]*", "1")),
    "a share that rounding takes beyond its limit": (
        SHARED,
        first(r"share = share\*[\d.]+F", "share = share*1.0F"),
    ),
    "a share that is not the least": (
        SHARED,
        first(r"return \(a < b\) \? a", "return (a > b) ? a"),
    ),
    "a limit that is no number": (
        SHARED,
        first(r"fabsf\(command->force\[2\]\) <= params->force_limit\[2\]", "1", -1),
    ),
    "a force cut at a limit that is no number": (
        LIMITED,
        first(r"params->force_limit\[2\] >= 0\.0F", "1"),
    ),
    "a force that is not cut": (
        LIMITED,
        first(r"return \(fabsf\(force\) <= limit\) \?", "return (force <= limit) ?"),
    ),
    "an infinite force that is cut": (LIMITED, first(r"isfinite\(command->force\[2\]\)", "1")),
}
"""Of which vehicle what code is harmed: there must be a failure, or a crash."""


def changed(path: Path, change: Change) -> bool:
    """Whether a file is another one now."""
    text = path.read_text(encoding="utf-8")
    path.write_text(change(text), encoding="utf-8")
    return change(text) != text


def failures(root: Path, vehicle: Vehicle = PAPER) -> int:
    """What the test of one scalar returns, from a main without any library."""
    main, prefix = root / "bare.c", f"{vehicle.name}_f32"
    main.write_text(BARE.format(prefix), encoding="utf-8")
    texts = [root / f"test/{prefix}_test.c", root / f"c/src/{prefix}.c", main]
    flags = ["-std=c99", "-O1", *FLAGS[2:], *words(root, vehicle), *map(str, texts), "-lm"]
    program = Compiler.find(COMPILERS).run(flags, root / "bare")
    return subprocess.run([program], check=False, timeout=60).returncode


@pytest.mark.parametrize("name", BROKEN)
def test_what_is_changed_in_the_table_is_counted(tmp_path: Path, name: str) -> None:
    path, change, wanted = BROKEN[name]
    root = subjects.place(PAPER, tmp_path)
    assert changed(root / path, change) == (name != "nothing")
    assert failures(root) == wanted


HELD = re.compile(
    r"\{\{(-?[\d.e-]+)F((?:,\s+-?[\d.e-]+F)+\},(?:\s+\{[^{}]*\},?){3}\},\s+\w+_SATURATED)"
)
"""The first number of the true force of a row that is limited."""


@pytest.mark.parametrize(
    ("vehicle", "factor"), [(SHARED, 1 + 2e-4), (LIMITED, 1 - 2e-7)], ids=lambda v: str(v)[:7]
)
def test_a_truth_within_limits_is_judged_on_their_scale(
    tmp_path: Path, vehicle: Vehicle, factor: float
) -> None:
    """Of what is shrunk little may differ, of what is cut nothing: an ulp is counted."""
    root = subjects.place(vehicle, tmp_path)

    def moved(text: str) -> str:
        return HELD.sub(lambda row: f"{{{{{factor * float(row[1]):.9g}F{row[2]}", text, count=1)

    assert failures(root, vehicle) == 0
    assert changed(root / f"test/{vehicle.name}_f32_test.c", moved)
    assert failures(root, vehicle) == 1


@pytest.mark.parametrize("drift", [LEAST_DRIFT["f32"], MOST_DRIFT])
@pytest.mark.parametrize("name", ["paper_so3", "paper_s3", "hovercraft"])
def test_it_holds_whatever_drift_is_allowed(tmp_path: Path, name: str, drift: Fraction) -> None:
    vehicle = replace(BY_NAME[name], limits=Limits(drift=drift), targets=("c99",), scalars=("f32",))
    assert failures(subjects.place(vehicle, tmp_path), vehicle) == 0


@pytest.mark.parametrize("name", HARMED)
def test_what_is_harmed_in_the_code_is_found(tmp_path: Path, name: str) -> None:
    vehicle, change = HARMED[name]
    root = subjects.place(vehicle, tmp_path)
    assert changed(root / f"c/src/{vehicle.name}_f32.c", change)
    assert failures(root, vehicle) != 0


def test_ctest_runs_it(tmp_path: Path) -> None:
    need("cmake")
    root, build = subjects.place(PAPER, tmp_path), tmp_path / "build"
    configure(root, build)
    make(build)
    said = run("ctest", "--test-dir", build, "--output-on-failure")
    assert "100% tests passed, 0 tests failed out of 1" in said


def test_a_project_that_holds_the_package_is_spared_its_test(tmp_path: Path) -> None:
    need("cmake")
    subjects.place(PAPER, tmp_path)
    body = project(tmp_path, "int main(void) { return 0; }\n", "add_subdirectory(paper_so3)")
    configure(body, tmp_path / "build")
    asked = tmp_path / "asked"
    configure(body, asked, "-Dpaper_so3_BUILD_TESTS=ON")
    targets = [
        run("cmake", "--build", one, "--target", "help") for one in (tmp_path / "build", asked)
    ]
    assert ["paper_so3_test" in said for said in targets] == [False, True]


def test_make_has_its_sources(tmp_path: Path) -> None:
    need("make")
    subjects.place(PAPER, tmp_path)
    (tmp_path / "Makefile").write_text(
        "include paper_so3/paper_so3.mk\n"
        "tested: $(paper_so3_SOURCES) $(paper_so3_TEST_SOURCES)\n"
        "\t$(CC) $(paper_so3_CPPFLAGS) $(paper_so3_TEST_CPPFLAGS) $(paper_so3_CFLAGS) -o $@ $^ "
        "$(paper_so3_LDLIBS)\n",
        encoding="utf-8",
    )
    run("make", "--warn-undefined-variables", cwd=tmp_path)
    assert "paper_so3_f64: 0 failures" in run(tmp_path / "tested")


def test_a_bare_target_needs_no_library(tmp_path: Path) -> None:
    need("arm-none-eabi-gcc")
    root = subjects.place(PAPER, tmp_path)
    strict = [*WARNINGS_C["gcc"], "-ffreestanding", *words(root, PAPER)]
    run("arm-none-eabi-gcc", *M4F, *FLAGS, *strict, "-c", root / TABLE, "-o", root / "bare.o")
    missing = set(re.findall(r"U (\w+)", run("arm-none-eabi-nm", "-u", root / "bare.o")))
    own = {name for name in missing if name.startswith("paper_so3_f32_")}
    assert {"paper_so3_f32_control", "paper_so3_f32_check_params"} <= own
    assert missing - own <= {"memcpy", "memset"}


def test_a_group_without_a_truth_has_no_test_and_a_package_all_the_same(tmp_path: Path) -> None:
    for vehicle in (RANDOM[0], replace(PAPER, targets=("numpy",))):
        found = subjects.texts(vehicle)
        assert not [path for path in found if path.startswith("test/")]
        assert "BUILD_TESTS" not in found.get("CMakeLists.txt", "")
    assert "CMakeLists.txt" in subjects.texts(RANDOM[0])


def test_a_new_inertia_moves_the_table_and_not_its_inputs() -> None:
    other = replace(PAPER, inertia=tuple(tuple(2 * x for x in row) for row in PAPER.inertia))
    texts = [pipeline.texts(one)[TABLE] for one in (PAPER, other)]
    blocks = [re.findall(ROW + r"[^}]*\}", text) for text in texts]
    same = [a == b for a, b in zip(*blocks, strict=True)]
    assert all(same[0::3])
    assert all(same[1::3])
    assert not any(same[2 : 3 * texts[0].count("_F32_OK, 0x") : 3])
