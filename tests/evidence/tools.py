"""Tools of other makers, as tests need them: skipped on a laptop, required in CI."""

import os
import shutil
from collections.abc import Callable
from typing import Any, TypeVar

import pytest

from derive.evidence.tool import ToolMissing

T = TypeVar("T")


def had(what: Callable[[], T]) -> T:
    """What a call gives; on a laptop that lacks the tool the test is skipped."""
    try:
        return what()
    except ToolMissing as missing:
        if os.environ.get("CI") == "true":
            pytest.fail(f"CI must have it: {missing}")
        pytest.skip(str(missing))


def hide(monkeypatch: pytest.MonkeyPatch, command: str) -> None:
    """Make a machine of this one that has no such command."""
    which = shutil.which

    def without(name: str, *others: Any, **named: Any) -> str | None:
        return None if name == command else which(name, *others, **named)

    monkeypatch.setattr(shutil, "which", without)
