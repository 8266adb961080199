"""Which figures are promised of a package on a target; all others are measured and published."""

from __future__ import annotations

import tomllib

from derive.evidence.emitted import Emitted
from derive.evidence.machine import Machine
from derive.verify.limits import LIMITS, Limit, published

_PROMISED = {
    "tracking": {"SO3": "M4F SO3 tracking", "S3": "M4F S3 tracking"},
    **{name: dict.fromkeys(("SO3", "S3"), f"M4F {name}")
       for name in ("spread", "guard", "stack", "stack, guarded", "text", "text, guarded")},
}  # fmt: skip
"""What is measured -> group -> limit: of gsmc, in float, on a Cortex-M4F."""


def promise(what: str, unit: str, emitted: Emitted, machine: Machine) -> Limit:
    """The limit of what is measured, in the unit in which it is published otherwise."""
    limit = _PROMISED.get(what, {}).get(_group(emitted))
    is_meant = (machine.name, emitted.scalar) == ("Cortex-M4F", "f32")
    return LIMITS[limit] if limit and is_meant else published(unit)


def _group(emitted: Emitted) -> str:
    """The group that the sliding-mode controller of a package is on; no other is promised of."""
    manifest = tomllib.loads((emitted.folder / "MANIFEST.toml").read_text(encoding="utf-8"))
    return str(manifest["group"]) if manifest["controller"] == "gsmc" else ""
