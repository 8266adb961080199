"""What `control` takes and gives, read from the header alone: structs, members, order."""

from __future__ import annotations

import re
from dataclasses import dataclass

from derive.evidence.emitted import Emitted
from derive.native.header import Routine, parse

REAL = {"f32": "float", "f64": "double"}
BYTES = {"float": 4, "double": 8, "int": 4, "int32_t": 4, "uint32_t": 4}
"""Sizes of the members' types, of an enum too."""

_STRUCT = r"typedef\s+struct\s*(?:\w+\s*)?\{{([^}}]*)\}}\s*{prefix}_(\w+)\s*;"
_MEMBER = re.compile(r"(\w+)\s+(\w+)\s*(?:\[\s*(\d+)\s*\])?\s*;")


@dataclass(frozen=True)
class Member:
    """`type name[count]` of a struct; one number where it is no array."""

    holder: str
    name: str
    type: str
    count: int
    is_array: bool

    @property
    def path(self) -> str:
        """As C reaches it: `state.g`."""
        return f"{self.holder}.{self.name}"

    @property
    def is_real(self) -> bool:
        """Whether it holds floating-point numbers."""
        return self.type in REAL.values()


@dataclass(frozen=True)
class Interface:
    """The structs of one scalar, by name, and the routines with their parameters in order."""

    emitted: Emitted
    structs: dict[str, tuple[Member, ...]]
    routines: dict[str, Routine]

    @property
    def real(self) -> str:
        """The C type of the scalar."""
        return REAL[self.emitted.scalar]

    @property
    def inputs(self) -> tuple[str, ...]:
        """The structs whose bits are not trusted: the state, the reference, what is kept."""
        names = [self._struct(one.type) for one in self.routines["control"].parameters]
        return tuple(name for name in names if name not in ("params", "command"))

    @property
    def judged(self) -> tuple[str, ...]:
        """Those of them that have to be finite: what a caller keeps may be anything."""
        given = [one for one in self.routines["control"].parameters if one.is_input]
        return tuple(name for one in given if (name := self._struct(one.type)) != "params")

    @property
    def law(self) -> str:
        """The bare law that `control` guards."""
        return "tracking" if "reference" in self.inputs else "reaching"

    @property
    def size(self) -> int:
        """Bytes of all inputs."""
        return sum(one.count * BYTES.get(one.type, 4) for one in self.members(*self.inputs))

    def members(self, *structs: str) -> tuple[Member, ...]:
        """The members of those structs, in order."""
        return tuple(member for struct in structs for member in self.structs[struct])

    def call(self, routine: str, spelled: dict[str, str]) -> str:
        """A call in C; spelled: struct -> the expression that points to one."""
        found = self.routines[routine]
        given = (spelled[self._struct(one.type)] for one in found.parameters)
        return f"{found.symbol}({', '.join(given)})"

    def _struct(self, ctype: str) -> str:
        return ctype.removeprefix(f"{self.emitted.prefix}_")


def interface(emitted: Emitted) -> Interface:
    """Read the header; raises OSError where there is none, ValueError where it is another's."""
    header = parse(emitted.header.read_text(encoding="utf-8"))
    pattern = re.compile(_STRUCT.format(prefix=re.escape(emitted.prefix)))
    structs = {
        name: tuple(_member(name, *found) for found in _MEMBER.findall(body))
        for body, name in pattern.findall(header.declarations)
    }
    routines = {
        symbol.removeprefix(f"{emitted.prefix}_"): one for symbol, one in header.routines.items()
    }
    if "control" not in routines or "command" not in structs:
        raise ValueError(
            f"{emitted.header.name}: expected {emitted.prefix}_control and its structs, "
            f"found {sorted(header.routines)}"
        )
    return Interface(emitted, structs, routines)


def _member(holder: str, ctype: str, name: str, count: str) -> Member:
    return Member(holder, name, ctype, int(count or 1), bool(count))
