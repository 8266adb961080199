"""Plain data for JSON, which has no infinity and no NaN."""

from __future__ import annotations

import math
from typing import Any


def plain(value: Any) -> Any:
    """The same with lists for tuples, and None for a number that is not finite."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [plain(one) for one in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
