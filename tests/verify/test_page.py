"""The report as a page: every check, its verdict in words, and nothing fetched."""

import json
import re
from html.parser import HTMLParser

import pytest

from derive.verify.check import Check, Report
from derive.verify.limits import LIMITS, published

GOOD = Check("law", "C f64", 2.1, LIMITS["log"], 120, "phi=1")
CLEAN = Check("bits", "both", 0, LIMITS["rows"], 240)
BAD = Check("rate", "numpy f64", 8.0, LIMITS["rate"], 120, "phi=2")
LOST = Check("force", "C f32", float("nan"), LIMITS["force_f32"], 120)
ODD = Check("<script>alert(1)</script>", "a & b", 1.0, LIMITS["log"], 7, '"<b>"')


class Page(HTMLParser):
    """The rows of the tables of checks, as text; and whether every tag is closed."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.rows: list[list[str]] = []
        self.tags: list[str] = []
        self.open: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        if tag != "meta":
            self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        elif tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if {"td", "th"} & set(self.open):
            self.rows[-1][-1] += data


def told(*checks: Check, skipped: tuple[str, ...] = ()) -> str:
    return Report("body", checks, skipped).as_html()


def test_every_check_stands_with_its_figures_and_verdict() -> None:
    page = Page(told(GOOD, BAD, CLEAN))
    assert page.open == []
    assert ["✓ ok", "law", "C f64", "2.1 eps", "", "3 eps", "120", "phi=1"] in page.rows
    assert ["✗ FAILED", "rate", "numpy f64", "8 eps", "", "4 eps", "120", "phi=2"] in page.rows
    assert ["✓ ok", "bits", "both", "0 rows", "", "0 rows", "240", ""] in page.rows
    assert [row[0] for row in page.rows].count("✗ FAILED") == 2  # among the failed, and among all


def test_what_is_published_without_a_promise_has_no_limit() -> None:
    free = Check("cost", "M7", 1028, published("instructions"), 65)
    report = Report("body", (GOOD, free))
    assert report.ok
    page = Page(report.as_html())
    assert ["✓ ok", "cost", "M7", "1028 instructions", "", "none", "65", ""] in page.rows
    assert not any(row[0].startswith("published") for row in page.rows)
    assert "1028 instructions  none" in report.table()
    figures = [check["limit"]["figure"] for check in json.loads(report.as_json())["checks"]]
    assert figures == [3, None]


@pytest.mark.parametrize(
    ("checks", "skipped", "said"),
    [
        ((GOOD, CLEAN), (), ("all checks passed", "2 checks", "0 failed", "0 not checked")),
        ((GOOD, BAD, LOST), (), ("✗ 2 failed", "3 checks", "0 not checked")),
        ((GOOD,), ("no compiler",), ("all checks passed", "1 not checked", "<li>no compiler")),
    ],
)
def test_the_summary_counts(
    checks: tuple[Check, ...], skipped: tuple[str, ...], said: tuple[str, ...]
) -> None:
    text = told(*checks, skipped=skipped)
    assert all(part in text for part in said)
    assert ("failed</h2>" in text) == any(not check.is_ok for check in checks)
    assert ("not checked</h2>" in text) == bool(skipped)


@pytest.mark.parametrize(
    ("check", "share"), [(GOOD, 70), (CLEAN, 0), (BAD, 100), (LOST, 100)], ids=lambda v: str(v)[:20]
)
def test_the_bar_is_the_share_of_the_limit(check: Check, share: int) -> None:
    assert set(re.findall(r'"width: (\d+)%"', told(check))) == {str(share)}


def test_what_a_check_says_is_text() -> None:
    page = Page(told(ODD, skipped=("<i>",)))
    assert page.open == []
    assert not {"script", "b", "i"} & set(page.tags) - {"b"}
    assert [row[1:3] + row[7:] for row in page.rows if "7" in row] == [
        ["<script>alert(1)</script>", "a & b", '"<b>"']
    ]


def test_the_page_needs_nothing_else() -> None:
    assert not re.search(r"https?:|src=|href=|url\(|@import|<script", told(GOOD, BAD, LOST))


def test_verdicts_differ_in_more_than_red_and_green() -> None:
    text = told(GOOD, BAD)
    good, bad = re.findall(r"--(?:good|bad): #(\w{6})", text)
    blue = [int(colour[4:], 16) for colour in (good, bad)]
    assert blue[0] - blue[1] >= 100  # blue and orange, which no common colour blindness confuses
    assert "repeating-linear-gradient" in text
