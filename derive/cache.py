"""What was derived, kept on disk under a key of all that it depends on.

An entry carries a hash of its key and its payload: one that is damaged, cut short or moved is
ignored and written anew. It is written beside its place and renamed into it, so two processes
never see half an entry. Where nothing can be kept, nothing is: the cache is never needed.
"""

from __future__ import annotations

import json
from contextlib import suppress
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from derive import __version__
from derive.folder import save

DERIVING = (
    *("lie/*.py", "routine/*.py", "control/*.py", "emit/*.py", "verify/law/*.py"),
    *("verify/golden.py", "verify/rung.py", "verify/branch.py", "verify/plant.py"),
    *("verify/shape.py", "verify/oracle/*.py"),
    *("pipeline.py", "theory.py", "selftest.py"),
)
"""The source that decides what is derived, printed and warned of, and what an entry looks like."""

LIBRARIES = ("sympy", "mpmath")


def key(**parts: object) -> str:
    """Hash of the parts, the source that derives, and the versions of what it derives with."""
    digest = sha256(json.dumps([__version__, parts], sort_keys=True, default=str).encode())
    for library in LIBRARIES:
        digest.update(f"{library} {release(library)}\n".encode())
    root = Path(__file__).parent
    for source in sorted(path for pattern in DERIVING for path in root.glob(pattern)):
        text = source.read_bytes()
        digest.update(f"{source.relative_to(root)} {len(text)}\n".encode() + text)
    return digest.hexdigest()


def release(library: str) -> str:
    """Its dist-info folder, which names the version; cheaper than importlib.metadata."""
    spec = find_spec(library)
    if spec is None or spec.origin is None:
        return "missing"
    package = Path(spec.origin).parent
    return " ".join(sorted(info.name for info in package.parent.glob(f"{library}-*.dist-info")))


def read(folder: Path, name: str) -> Any:
    """The payload kept under that key, or None when there is none that is whole."""
    try:
        entry = json.loads((folder / f"{name}.json").read_text(encoding="utf-8"))
        text = entry["payload"]
        return json.loads(text) if entry["sha256"] == _seal(name, text) else None
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return None


def write(folder: Path, name: str, payload: Any) -> None:
    """Keep a payload of plain data; a folder that cannot be written to keeps nothing."""
    text = json.dumps(payload, sort_keys=True)
    entry = json.dumps({"sha256": _seal(name, text), "payload": text})
    with suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
        save(folder / f"{name}.json", entry)


def _seal(name: str, text: str) -> str:
    return sha256(f"{name}\n{text}".encode()).hexdigest()
