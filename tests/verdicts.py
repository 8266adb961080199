"""The verdicts on every law of the catalogue, computed once for all tests."""

from functools import cache

from derive.lie.catalogue import GROUPS
from derive.verify.law.report import LawReport, report
from derive.verify.law.verdict import Verdict


@cache
def catalogue() -> LawReport:
    """What `derive laws` shows."""
    return report(list(GROUPS.values()))


def verdict(group: str, law: str) -> Verdict:
    """Of one law."""
    return next(one for one in catalogue().verdicts if (one.group, one.law) == (group, law))
