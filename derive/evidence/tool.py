"""Tools of other makers: where they are, how to get them, and that none is waited for for ever."""

from __future__ import annotations

import os
import shlex
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

SAID = 2000  # characters of a tool's last words that are kept
GRACE = 5.0
"""Seconds for the last words of what was killed: a child that left its group may hold them open."""


@dataclass(frozen=True)
class Tool:
    """A command, and the packages that bring it.

    install: what a person types to get it
    where:   it has to be: on PATH, or what else its maker calls being there
    """

    command: str
    install: str
    where: str = "on PATH"

    @property
    def path(self) -> str:
        """Where it is, beside the interpreter or on PATH; raises ToolMissing."""
        beside = str(Path(sys.executable).parent)
        found = shutil.which(self.command, path=beside) or shutil.which(self.command)
        if not found:
            raise ToolMissing(self)
        return found


class ToolMissing(Exception):
    """Tools are not here; what to do is in the text."""

    def __init__(self, *tools: Tool) -> None:
        self.tools = tools
        super().__init__("; ".join(
            f"{one.command} is not {one.where}; get it with: {one.install}" for one in tools
        ))  # fmt: skip


class ToolFailed(Exception):
    """A tool ended with an error, or did not end in time; its command and last words are kept."""

    def __init__(self, command: Sequence[str], why: str, said: str) -> None:
        self.command, self.why, self.said = tuple(command), why, said[-SAID:]
        super().__init__(f"{command[0]} {why}\n  command: {shlex.join(command)}\n{self.said}")


def need(*tools: Tool) -> None:
    """Raise ToolMissing for those that are not here, all at once."""
    if lost := tuple(absent(tools)):
        raise ToolMissing(*lost)


def absent(tools: Sequence[Tool]) -> Iterator[Tool]:
    """Those that are not here."""
    for tool in tools:
        try:
            _ = tool.path
        except ToolMissing:
            yield tool


def run(
    command: Sequence[str], seconds: float, folder: Path | None = None, fed: str = "",
    codes: Sequence[int] = (0,),
) -> str:  # fmt: skip
    """What a command wrote on both streams, in order.

    seconds: after which it and all it started are killed
    fed: its standard input; codes: exit codes that are no failure
    Raises ToolFailed.
    """
    process = subprocess.Popen(
        command, cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True,
    )  # fmt: skip
    try:
        said, _ = process.communicate(fed, timeout=seconds)
    except subprocess.TimeoutExpired:
        said = _killed(process)
        raise ToolFailed(command, f"did not end within {seconds:g} s", said) from None
    except BaseException:
        _killed(process)
        raise
    if process.returncode not in codes:
        raise ToolFailed(command, f"ended with {process.returncode}", said)
    return said


def _killed(process: subprocess.Popen[str]) -> str:
    """End a process with all that it started; what it had said."""
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    try:
        return process.communicate(timeout=GRACE)[0]
    except subprocess.TimeoutExpired as late:
        said = late.output or b""  # bytes, whatever the process was asked for
        return said.decode(errors="replace") if isinstance(said, bytes) else str(said)
    finally:
        for stream in filter(None, (process.stdin, process.stdout)):
            stream.close()
        process.wait()
