"""EVIDENCE.md says what was measured, what failed and what was not run; the same at every run."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from tempfile import gettempdir

import pytest

from derive import dossier, folder, selftest
from derive.evidence import version
from derive.evidence.emitted import Emitted
from derive.evidence.gather import Evidence, gather
from derive.evidence.kind import KINDS, Kind, Step, Work, held
from derive.evidence.markdown import shown
from derive.evidence.page import LESS, WHOLE, page
from derive.evidence.rule import RULES
from derive.evidence.stamp import Fault, fault, hashes, outdated
from derive.evidence.summary import PROMISES, lines
from derive.evidence.tool import ToolFailed
from derive.vehicle import load
from derive.verify.check import Check
from derive.verify.limits import LIMITS
from tests.evidence import attacked, made
from tests.evidence.tools import hide

NAME = "paper_so3"
ROOT = Path(__file__).parents[2]


@pytest.fixture
def work(tmp_path: Path) -> Work:
    vehicle = load(ROOT / "vehicles" / f"{NAME}.toml")
    package = ROOT / "generated" / NAME
    packages = tuple(Emitted(package, NAME, scalar) for scalar in ("f32", "f64"))
    texts = folder.derived(package)
    return Work(NAME, texts, packages, selftest.plant_of(vehicle), tmp_path)


@pytest.fixture(autouse=True)
def versions(monkeypatch: pytest.MonkeyPatch) -> None:
    """Asking all tools takes a second."""
    monkeypatch.setattr(version, "COMMANDS", version.COMMANDS[:1])


def found(work: Work, *kinds: Kind) -> Evidence:
    return gather(work, kinds)


def test_a_page_names_what_it_measured_and_every_figure(work: Work) -> None:
    text = page(found(work, made.GOOD))
    source = (ROOT / "generated" / NAME / "c/src/paper_so3_f32.c").read_bytes()
    assert f"| `c/src/paper_so3_f32.c`     | `{sha256(source).hexdigest()}` |\n" in text
    assert f"**All 4 checks passed.** {WHOLE}\n" in text
    assert re.search(r"^\| any bits: alarms +\| C f64 +\| 0 findings +\| 0 findings +\| 10 +\| ok "
                     r"+\| worst \\\| one \|$", text, re.MULTILINE)  # fmt: skip
    assert re.search(r"^\| size +\| f32 +\| 1234 B +\| published ", text, re.MULTILINE)
    assert "`size`, f32: first; second.\n" in text
    assert re.search(r"^\| any input bits: no undefined behaviour, proved +\| 0 findings +\| "
                     r"0 findings +\| 20 +\| ok \|$", text, re.MULTILINE)  # fmt: skip
    assert "\nNothing: everything was run.\n\nSHA-256 of all" in text


def test_a_page_is_the_same_again_and_holds_no_place_and_no_date(work: Work) -> None:
    text = page(found(work, made.GOOD, made.BAD, made.LACKING, made.HUNG))
    assert text == page(found(work, made.GOOD, made.BAD, made.LACKING, made.HUNG))
    assert str(ROOT) not in text
    assert "/tmp" not in text
    assert "/usr" not in text
    assert not re.search(r"\b20\d\d-\d\d|\d\d:\d\d", text)


def test_what_failed_broke_down_or_is_missing_is_told(work: Work) -> None:
    evidence = found(work, made.GOOD, made.BAD, made.LACKING, made.HUNG)
    text = page(evidence)
    assert [check.name for check in evidence.failed] == ["same bits"] * 2 + ["hung: broke down"]
    assert "**3 of 11 checks failed.**\n" in text
    assert text.splitlines()[2] == (
        f"{LESS} Missing, whole or in part: 2 measurements for want of RV32's tools, no-such-tool. "
        "See the end of the page."
    )
    assert "- same bits, C f32: 3 rows, at most 0 rows; worst \\| one\n" in text
    assert "emulator did not end within 10 s" in text
    words = (  # once, though both scalars said so
        "no-such-tool is not on PATH; get it with: apt install it", "it is not here",
    )  # fmt: skip
    lines = (f"lacking, f32 and f64, in part: {words[0]}", f"RV32: {words[1]}")
    assert sorted(map(str, evidence.missing)) == sorted(lines)
    assert all(f"- {one}\n" in text for one in lines)
    for row in (
        rf"lacking +\| f32 and f64 +\|( +\|)+ \*\*in part\*\* +\| {words[0]} \|",
        rf"RV32 +\|( +\|)+ \*\*not run\*\* \| {words[1]} \|",
        r"lacking: no no-such-tool here +\|( +\|)+ \*\*in part\*\* \|",
        r"RV32: no RV32's tools here +\|( +\|)+ \*\*not run\*\* \|",
    ):
        assert len(re.findall(rf"^\| {row}$", text, re.MULTILINE)) == 1, row
    assert "/usr/bin/emulator" in evidence.broken[0]
    assert "its words" in evidence.broken[0]


def test_a_quick_run_says_what_it_left_out(work: Work) -> None:
    evidence = found(replace(work, is_quick=True), made.GOOD)
    assert not evidence.is_whole
    assert "- left out of a quick run: the other half" in page(evidence)
    line = f"{LESS} Missing, whole or in part: 1 for a quick run. See the end of the page."
    assert page(evidence).splitlines()[2] == line


def test_a_kind_that_gave_nothing_is_told(work: Work) -> None:
    """There are packages without kernel polynomials; and there are machines without the tools."""
    absent = Kind("kernel", (Step("absent", lambda *_: made.absent()),))
    assert "The package has nothing of this kind." in page(found(work, Kind("kernel", ())))
    assert re.search(r"\*\*not run\*\* +\| it is not here \|$", page(found(work, absent)), re.M)


def test_what_nobody_foresaw_ends_its_step_alone(work: Work) -> None:
    evidence = found(work, Kind("attack", (Step("odd", made.odd),)), made.GOOD)
    told = [(one.name, one.worst) for one in evidence.failed]
    assert told == [("odd: broke down", "what nobody foresaw")] * 2
    assert len(evidence.all_checks) == 6
    assert "in odd\n" in evidence.broken[0]  # where in our own code


def test_progress_counts_the_steps(work: Work) -> None:
    told: list[str] = []
    found(replace(work, progress=told.append), made.GOOD, made.BAD)
    assert [re.sub(r"f32|f64", "", one).split(" (")[1] for one in told] == [
        "1 of 3)", "2 of 3)", "3 of 3)",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("said", "stands"),
    [
        ("in /tmp/derive-x/paper.c:3: at", "in paper.c:3: at"),
        ("a/b and c/ d", "a/b and c/ d"),
        (
            f"-I{gettempdir()}/derive-x1y2z3_4/a/b, {gettempdir()}/tmpx1y2z3_4",
            "-Iscratch/a/b, scratch",
        ),
        ("x | y\nand *z* <= `w`", r"x \| y and \*z\* \<= \`w\`"),
    ],
)
def test_words_of_tools_are_fit_for_a_table(said: str, stands: str) -> None:
    assert shown(said) == stands


def test_the_summary_takes_the_worst_of_each_limit() -> None:
    checks = [
        Check("force: truth", "C f64", 1e-14, LIMITS["force_f64"], 5, "first"),
        Check("force: truth", "numpy f64", 3e-14, LIMITS["force_f64"], 7, "second"),
        Check("force: truth", "C f32", 1e-6, LIMITS["force_f32"], 9, "third"),
        Check("same bits", "f64", 8, LIMITS["rows"], 1, "a number"),
        Check("same bits", "f32", math.nan, LIMITS["rows"], 1, "no number"),
    ]
    told = {line.promise.text: (line.worst.worst, line.samples) for line in lines(checks)}
    assert told == {
        "force in float against truth": ("third", 9),
        "force in double against truth": ("second", 12),
        "rows whose bits are not the same on every machine, at every level": ("no number", 2),
    }


def test_every_promise_is_of_a_check_that_a_committed_page_has() -> None:
    """Names of checks are said twice: where they are made, and in the summary."""
    pages = sorted((ROOT / "generated").glob("*/EVIDENCE.md"))
    if not pages:
        pytest.skip("no evidence is committed")
    text = "".join(one.read_text(encoding="utf-8") for one in pages)
    assert [one.text for one in PROMISES if f"| {one.text} " not in text] == []


@pytest.mark.parametrize(
    ("path", "change", "reason"),
    [
        ("c/src/paper_so3_f32.c", "other", "it measured another paper_so3_f32.c"),
        ("c/include/paper_so3_f64.h", "other", "it measured another paper_so3_f64.h"),
        ("c/src/paper_so3_f64.c", None, "it measured paper_so3_f64.c, which is no more"),
        ("c/src/another.c", "new", "it did not measure another.c"),
        ("trace.csv", "other", ""),
    ],
)
def test_a_page_is_outdated_by_another_source(
    work: Work, path: str, change: str | None, reason: str
) -> None:
    text = page(found(work, made.GOOD))
    texts = {**work.texts, path: change or ""}
    if change is None:
        del texts[path]
    assert outdated(text, work.texts) == ""
    assert outdated(text, texts) == reason
    assert outdated("something else", work.texts) == "it does not say what it measured"
    assert fault(text, texts) == (Fault("stale", reason) if reason else None)
    assert len(hashes(work.texts)) == 5


def test_the_last_line_is_the_digest_of_the_lines_above(work: Work) -> None:
    *above, last = page(found(work, made.GOOD)).splitlines(keepends=True)
    assert last.split("`")[1] == sha256("".join(above).encode()).hexdigest()


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("| 1234 B ", "| 1233 B ", "another digest"),
        ("**All 4 checks", "**All 5 checks", "another digest"),
        ("SHA-256 of all that", "It: of all that", "does not give its digest"),
        ("`\n\\Z", "`\nand more\n", "another digest"),
        ("`\n\\Z", "`", "another digest"),
    ],
)
def test_a_page_whose_words_were_edited_is_told(
    work: Work, old: str, new: str, reason: str
) -> None:
    text = page(found(work, made.GOOD))
    assert fault(text, work.texts) is None
    other, count = re.subn(old if "Z" in old else re.escape(old), new, text, count=1)
    assert count == 1
    assert (told := fault(other, work.texts))
    assert told.word == "edited"
    assert reason in told.reason


def test_a_tool_that_is_missing_or_breaks_down_spares_the_others(
    work: Work, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuses(_: Emitted) -> Iterator[Check]:
        yield from ()
        raise ToolFailed(["/usr/bin/doxygen"], "ended with 3", "")

    rule = next(kind for kind in KINDS if kind.key == "rule")
    assert [step.name for step in rule.steps] == list(RULES)
    steps = tuple(held("doxygen", refuses) if s.name == "doxygen" else s for s in rule.steps)
    for tool in ("clang-tidy", "arm-none-eabi-gcc", "cppcheck"):
        hide(monkeypatch, tool)
    evidence = found(replace(work, packages=work.packages[:1]), replace(rule, steps=steps))
    assert [(one.what, one.tools, one.is_part) for one in evidence.missing] == [
        ("warnings of compilers", ("arm-none-eabi-gcc",), True),
        ("clang-tidy", ("clang-tidy",), False),
        ("MISRA C:2012", ("cppcheck",), False),
        ("symbols", ("arm-none-eabi-gcc",), True),
    ]
    assert "pip install gsmc-derive[evidence]" in evidence.missing[2].why
    assert [one.name for one in evidence.failed] == ["doxygen: broke down"]
    names = {check.name for check in evidence.all_checks}
    assert {"gcc: warnings", "clang: warnings", "calls through a pointer"} <= names


def test_a_package_is_measured_for_true(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The kind that takes a second: every bit flipped, and coverage, on a copy."""
    attack = next(kind for kind in KINDS if kind.key == "attack")
    steps = tuple(step for step in attack.steps if step.name != "fuzzing")
    made.gathered(monkeypatch, Kind("attack", steps))
    vehicle = load(ROOT / "vehicles" / f"{NAME}.toml")
    with attacked.needed():
        evidence = dossier.measured(vehicle, ROOT / "generated", lambda _: None)
    assert evidence.broken == ()
    assert {check.name for check in evidence.all_checks} == {
        "bit flips: promises broken", "bit flips: harmful, not found",
        "self-test: lines and branches missed",
    }  # fmt: skip
    assert re.search(r"^- state\.g: \d+ of \d+ harmful flips found", page(evidence), re.MULTILINE)


def test_versions_are_numbers_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(version, "run", lambda *_: "it (15:12.2.rel1-1) 12.2.1 20221205\nmore 9.9")
    monkeypatch.setattr(version, "COMMANDS", (version.Asked("python3", "nothing"),))
    monkeypatch.setattr(version, "PACKAGES", {"no-such-package": "nothing"})
    assert version.versions() == [
        ("python3", "12.2.1", "nothing"), ("no-such-package", "not here", "nothing"),
    ]  # fmt: skip
