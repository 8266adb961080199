"""The documents: every step of every vehicle, its own lines of C, and nothing that breaks."""

import csv
import os
import re
import shutil
import subprocess
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from derive.explanation import explain
from derive.vehicle import InputError, Vehicle
from derive.vehicle.group import group_of
from tests.emit.subjects import FILES, texts
from tests.explain.subjects import DOCUMENTED, OPTIONAL

VOID = {"meta", "br", "hr", "link", "img"}
REQUIRED = ("nu_e", "eta", "eta_dot", "nu_u_dot", "s", "force")

every_vehicle = pytest.mark.parametrize("vehicle", DOCUMENTED, ids=lambda v: v.name)
KEPT = TemporaryDirectory(prefix="derive-")
"""A cache of derivations for this file's tests."""


@cache
def document(vehicle: Vehicle, form: str) -> str:
    return explain(vehicle, Path(KEPT.name), form)


class Balance(HTMLParser):
    """Open tags, anchors, links, and everything that would be fetched."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.anchors: list[str] = []
        self.links: list[str] = []
        self.fetched: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        if tag not in VOID and not (self.get_starttag_text() or "").endswith("/>"):
            self.open.append(tag)
        self.anchors += [given["id"]] if "id" in given else []
        self.links += [given["href"]] if "href" in given else []
        self.fetched += [given["src"]] if "src" in given else []

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert tag == "mspace"


def rows(vehicle: Vehicle) -> list[dict[str, str]]:
    """trace.csv of the steps that are told."""
    told = ("tracking", "reaching", "plant")
    path = f"c/src/{vehicle.name}_f64.c"
    given = csv.DictReader(texts(vehicle)["trace.csv"].splitlines())
    return [row for row in given if row["file"] == path and row["routine"] in told]


@every_vehicle
def test_text_has_every_step_and_its_lines(vehicle: Vehicle) -> None:
    text = document(vehicle, "text")
    source = texts(vehicle)[f"c/src/{vehicle.name}_f64.c"].splitlines()
    assert all(len(line) <= 100 and line == line.rstrip() for line in text.splitlines())
    assert "\n\n\n\n" not in text
    headings = re.findall(r"^\d+\. (\w+)$", text, re.M)
    assert headings == [row["step"] for row in rows(vehicle)]
    if vehicle.controller == "gsmc":
        assert {"nu_e", "s", "force"} <= set(headings)
        if any(map(any, group_of(vehicle).structure)):
            assert set(REQUIRED) <= set(headings)
        assert re.search(r"^ +nu_u(_0)? = ", text, re.M)
    shown = {int(n): line for n, line in re.findall(r"^ {0,4}(\d+) (?=\S| )(.*)$", text, re.M)}
    for row in rows(vehicle):
        first = int(row["first_line"])
        assert source[first - 1].startswith(f"    /* {row['step']}: ")
        own = next(k for k in range(first, len(source)) if not source[k].strip())
        for number in range(first, own + 1):
            line = source[number - 1][4:]
            assert line.startswith(shown[number].rstrip()), number


@every_vehicle
def test_html_is_whole_and_needs_nothing_else(vehicle: Vehicle) -> None:
    page = document(vehicle, "html")
    reader = Balance()
    reader.feed(page)
    assert reader.open == []
    assert reader.fetched == []
    assert not re.search(r"https?:|url\(|@import|<script", page)
    assert len(reader.anchors) == len(set(reader.anchors))
    assert {link[1:] for link in reader.links} <= set(reader.anchors)
    steps = {f"{row['routine']}.{row['step']}" for row in rows(vehicle)}
    assert steps <= set(reader.anchors)
    assert {f"#{step}" for step in steps} <= set(reader.links)
    assert page.count("<math") > 3 * len(steps)
    assert "<=" not in re.sub(r"<pre>.*?</pre>", "", page, flags=re.S)


@every_vehicle
def test_latex_is_balanced(vehicle: Vehicle) -> None:
    article = document(vehicle, "latex")
    verbatim = re.compile(r"\\begin\{verbatim\}.*?\\end\{verbatim\}", re.S)
    assert len(verbatim.findall(article)) == len(rows(vehicle))
    rest = verbatim.sub("", article)
    assert rest.isascii()
    bare = rest.replace(r"\{", "").replace(r"\}", "")
    depth = 0
    for brace in re.findall(r"[{}]", bare):
        depth += 1 if brace == "{" else -1
        assert depth >= 0
    assert depth == 0
    assert rest.count(r"\left") == rest.count(r"\right")
    assert rest.count(r"\[") == rest.count(r"\]")
    open_: list[str] = []
    for kind, name in re.findall(r"\\(begin|end)\{([a-z*]+)\}", rest):
        assert kind == "begin" or open_.pop() == name
        open_ += [name] if kind == "begin" else []
    assert open_ == []
    if vehicle.controller == "gsmc":
        for symbol in (r"\nu_{e}", r"\dot{\eta}", "g_{r}", r"\mathrm{ad}^{*}_", r"\lambda"):
            assert symbol in rest


@pytest.mark.parametrize("vehicle", [*FILES, *OPTIONAL], ids=lambda v: v.name)
def test_latex_compiles(vehicle: Vehicle, tmp_path: Path) -> None:
    if shutil.which("pdflatex") is None:
        assert os.environ.get("CI") != "true", "CI must have pdflatex"
        pytest.skip("pdflatex is not installed: apt install texlive-latex-base")
    (tmp_path / "derivation.tex").write_text(document(vehicle, "latex"), encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "derivation.tex"]
    result = subprocess.run(
        command, check=False, cwd=tmp_path, capture_output=True, env={**os.environ, "TZ": "UTC"}
    )
    log = result.stdout.decode("utf-8", "replace")
    assert result.returncode == 0, log[-2000:]
    wide = [float(points) for points in re.findall(r"Overfull \\hbox \(([\d.]+)pt", log)]
    assert max(wide, default=0) < 20  # a third of the margin
    assert "Overfull \\vbox" not in log
    assert "Missing character" not in log


@pytest.mark.parametrize("form", ["text", "latex", "html"])
def test_one_equation_is_its_steps_alone(form: str) -> None:
    vehicle = next(v for v in FILES if v.name == "paper_so3")
    part = explain(vehicle, Path(KEPT.name), form, equation="velErr")
    assert len(part) < len(document(vehicle, form)) / 3
    for step, is_there in (("g_e", True), ("eta", True), ("nu_e", True), ("wanted", False)):
        assert (f"/* {step}: " in part) == is_there
    assert "arccos" not in part


def test_one_routine_is_told_alone_and_with_an_equation() -> None:
    vehicle = next(v for v in FILES if v.name == "paper_so3")
    plant = explain(vehicle, Path(KEPT.name), "text", routine="plant")
    assert re.findall(r"^(\w+): .*\(\w+\)$", plant, re.M) == ["plant"]
    both = explain(vehicle, Path(KEPT.name), "text", routine="tracking", equation="SurfaceErr")
    assert re.findall(r"^(\d+)\. (\w+)$", both, re.M) == [("25", "s")]


@pytest.mark.parametrize(
    ("chosen", "told"),
    [
        ({"equation": "velEr"}, "write --equation velErr, the nearest"),
        ({"equation": "eq"}, "one of velErr, TckCtrl, "),
        ({"routine": "plan"}, "write --routine plant, the nearest"),
        ({"routine": "plan"}, "one of tracking, reaching, plant"),
        ({"routine": "plant", "equation": "velErr"}, "one of EulerP\n"),
    ],
)
def test_what_is_not_there_is_told(chosen: dict[str, str], told: str) -> None:
    vehicle = next(v for v in FILES if v.name == "paper_so3")
    with pytest.raises(InputError) as caught:
        explain(vehicle, Path(KEPT.name), "text", **chosen)
    assert told in str(caught.value)


def test_constants_and_kernels_are_explained() -> None:
    vehicle = next(v for v in FILES if v.name == "paper_s3")
    text = document(vehicle, "text")
    assert "k(w) = arccos(w)/sqrt(1 - w^2)" in text
    assert "(1 - w^2) h(w) = 1 - w k(w)" in text
    assert "polynomial of degree 21" in text
    assert "CUT = 1.0e-60: least sine" in text


def test_a_group_of_ones_own_is_shown_by_its_basis() -> None:
    vehicle = next(v for v in DOCUMENTED if v.name == "sl2")
    assert "group      SL2, dimension 3\n" in document(vehicle, "text")
    assert "    E_1 = [[0, 0], [1, 0]]  [1/s]\n" in document(vehicle, "text")
    assert r"E_{2} = \begin{pmatrix} 1 & 0 \\ 0 & -1 \end{pmatrix}" in document(vehicle, "latex")
    assert document(vehicle, "html").count("<figure>") == 3
    known = next(v for v in DOCUMENTED if v.name == "underwater")
    assert "<figure>" not in document(known, "html")


@every_vehicle
def test_no_line_of_latex_is_too_wide(vehicle: Vehicle) -> None:
    """By the symbols that are set: a page takes some 100 of them at this size."""
    rest = re.sub(
        r"\\begin\{verbatim\}.*?\\end\{verbatim\}", "", document(vehicle, "latex"), flags=re.S
    )
    displays = r"\\\[\n(.*?)\n\\\]|\\begin\{align\*\}\n(.*?)\n\\end\{align\*\}"
    shown = re.findall(displays, rest, re.S)
    lines = [line for pair in shown for line in "".join(pair).split("\\\\\n")]
    assert lines
    assert max(map(width, lines)) < 100


def width(line: str) -> float:
    """Of a displayed line, in letters: indices are small, a column is as wide as its widest row."""
    line = re.sub(r"\\begin\{(pmatrix|cases)\}(.*?)\\end\{\1\}", lambda m: widest(m[2]), line)
    line = re.sub(r"\\frac\{([^{}]*)\}\{([^{}]*)\}", r"\1", line)
    line = re.sub(r"\\(mathrm|text|dot|sqrt|left|right|quad|bigl|bigr)", "", line)
    line = re.sub(r"\\[a-z]+", "x", line).replace(r"\,", "")
    indices = "".join(re.findall(r"_\{([^{}]*)\}", line))
    bare = re.sub(r"_\{[^{}]*\}", "", line)
    return len(re.sub(r"[{}&\\]", "", bare)) + 0.6 * len(indices)


def widest(body: str) -> str:
    return max(body.split(r"\\"), key=len)
