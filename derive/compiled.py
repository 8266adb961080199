"""Templates as jinja2 compiles them, kept as derivations are: whole, or not at all.

An entry is of one template, one jinja2 and one environment; jinja2 itself compares the text.
"""

from __future__ import annotations

from base64 import b64decode, b64encode
from hashlib import sha256
from pathlib import Path

import jinja2
from jinja2.bccache import Bucket

from derive import cache
from derive.emit import render


class Compiled(jinja2.BytecodeCache):
    """In a folder; one that cannot be written to keeps nothing."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._with = cache.release("jinja2"), Path(render.__file__).read_text(encoding="utf-8")

    def load_bytecode(self, bucket: Bucket) -> None:
        """What is kept of a template, where it is whole."""
        if isinstance(kept := cache.read(self._folder, self._name(bucket)), str):
            bucket.bytecode_from_string(b64decode(kept))

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Keep a template."""
        code = b64encode(bucket.bytecode_to_string()).decode("ascii")
        cache.write(self._folder, self._name(bucket), code)

    def _name(self, bucket: Bucket) -> str:
        return "template-" + sha256("\n".join((*self._with, bucket.key)).encode()).hexdigest()
