"""The table of departures from rules, as every package has it."""

import re

import pytest

from derive.emit.deviation import CATEGORIES, DEVIATIONS, LONGEST, Deviation, long_functions
from tests.emit import subjects
from tests.emit.subjects import FILES

SHORT = "static int {name}(int x)\n{{\n{body}}}\n"


def sources(lines: int) -> dict[str, str]:
    return {"c/src/it.c": SHORT.format(name="one", body="    x++;\n" * (lines - 1))}


def test_a_function_is_long_from_brace_to_brace() -> None:
    assert list(long_functions(sources(LONGEST))) == []
    assert list(long_functions(sources(LONGEST + 1))) == [("one", LONGEST + 1)]


def test_only_sources_count_and_each_function_on_its_own() -> None:
    (text,) = sources(LONGEST + 1).values()
    assert list(long_functions({"example/main.c": text, "c/include/it.h": text})) == []
    two = text.replace("one", "two").replace("(int x)", "(int x,\n        int y)")
    assert [name for name, _ in long_functions({"c/src/it.c": text + two})] == ["one", "two"]


def test_the_rules_are_in_order_and_each_place_is_said_once() -> None:
    rules = [[int(n) for n in row.rule.split(".")] for row in DEVIATIONS]
    assert rules == sorted(rules)
    assert len({(row.rule, row.where) for row in DEVIATIONS}) == len(DEVIATIONS)
    for row in DEVIATIONS:
        assert "|" not in row.where + row.why
        assert row.why.endswith(".")


def test_every_rule_that_is_departed_from_has_its_category_and_no_other_has() -> None:
    assert set(CATEGORIES) == {row.rule for row in DEVIATIONS}
    assert {row.category for row in DEVIATIONS} <= {"advisory", "required"}  # never mandatory
    with pytest.raises(KeyError, match=r"99\.9"):
        _ = Deviation("99.9", "nowhere", "", "None.").category


def test_every_package_has_the_table() -> None:
    for vehicle in FILES:
        texts = subjects.texts(vehicle)
        table = texts["DEVIATIONS.md"]
        assert table.startswith(f"# {vehicle.name}: ")
        rows = re.findall(r"^\| (\d\S+) \| (\S+) \| (.+?) \| (.+) \|$", table, re.MULTILINE)
        assert rows == [(row.rule, "advisory", row.where, row.why) for row in DEVIATIONS]
        told = {name: int(n) for name, n in re.findall(r"^\| `(\w+)` \| (\d+) \|$", table, re.M)}
        assert told == dict(long_functions(texts))
        assert "complian" not in table
        for scalar in vehicle.scalars:
            assert f"{vehicle.name}_{scalar}_law" in told
