"""What became of the statements: a table for people, JSON for machines, one verdict."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass

ENOUGH = 2
"""Mutants that every statement has to have."""


@dataclass(frozen=True)
class Row:
    """One statement on one subject.

    of:        the subject: any group, n = 3, a group's name, or the paper
    broken:    facts that do not hold; empty when the statement is proved
    mutants:   how many false versions were tried
    survivors: those that hold on this subject too, such as the sign of ad* where ad = 0
    shown:     what a counterexample found, in words
    """

    statement: str
    label: str
    of: str
    method: str
    seconds: float
    broken: tuple[str, ...]
    mutants: int
    survivors: tuple[str, ...]
    shown: tuple[str, ...] = ()

    @property
    def verdict(self) -> str:
        """Shown for a counterexample, proved for the rest, or what failed."""
        if self.broken:
            return "FAILED: " + "; ".join(self.broken)
        return "shown" if self.shown else "proved"

    @property
    def rejected(self) -> str:
        """Mutants rejected, of how many."""
        return f"{self.mutants - len(self.survivors)} of {self.mutants}"


@dataclass(frozen=True)
class ProofReport:
    """All rows; skipped: what could not be decided for a group, with the reason."""

    name: str
    rows: tuple[Row, ...]
    skipped: tuple[str, ...] = ()

    @property
    def missed(self) -> tuple[str, ...]:
        """Mutants that no subject rejects, and statements with too few of them."""
        found = []
        for statement in dict.fromkeys(row.statement for row in self.rows):
            rows = [row for row in self.rows if row.statement == statement]
            everywhere = set.intersection(*(set(row.survivors) for row in rows))
            found += [f"{statement}: {what}" for what in sorted(everywhere)]
            if rows[0].mutants < ENOUGH:
                found.append(f"{statement}: fewer than {ENOUGH} mutants")
        return tuple(found)

    @property
    def ok(self) -> bool:
        """Whether every statement is proved and every mutant rejected somewhere."""
        return bool(self.rows) and not self.missed and not any(row.broken for row in self.rows)

    def table(self) -> str:
        """Columns statement, paper, of, method, seconds, mutants rejected, verdict."""
        head = ("statement", "paper", "of", "method", "s", "rejected", "verdict")
        lines = [head, *(_cells(row) for row in self.rows)]
        widths = [max(len(line[i]) for line in lines) for i in range(len(head))]
        text = ["  ".join(f"{cell:{w}}" for cell, w in zip(line, widths, strict=True)).rstrip()
                for line in lines]  # fmt: skip
        text += [f"  {row.label}: {found}" for row in self.rows for found in row.shown]
        text += [f"mutant not rejected: {what}" for what in self.missed]
        text += [f"not decided: {reason}" for reason in self.skipped]
        failed = sum(bool(row.broken) for row in self.rows) + len(self.missed)
        seconds = sum(row.seconds for row in self.rows)
        end = f"{len(self.rows)} proofs, {failed} failed, {seconds:.1f} s"
        return "\n".join([f"{self.name}: statements of the paper", *text, end])

    def as_json(self) -> str:
        """The same for machines."""
        rows = [{**asdict(row), "verdict": row.verdict} for row in self.rows]
        body = {
            "name": self.name,
            "ok": self.ok,
            "rows": rows,
            "missed": list(self.missed),
            "skipped": list(self.skipped),
        }
        return json.dumps(body, indent=2) + "\n"


def _cells(row: Row) -> tuple[str, ...]:
    return (
        row.statement,
        row.label,
        row.of,
        row.method,
        f"{row.seconds:.2f}",
        row.rejected,
        row.verdict,
    )
