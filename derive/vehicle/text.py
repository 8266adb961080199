"""How a TOML file becomes exact typed values, and how a bad one is told.

Decimals become ``Fraction`` as they are read; a number that cannot become one is kept as an
``Unusable`` until its key is known, so that the message can name it.
"""

import re
import stat
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from decimal import Context, Decimal
from fractions import Fraction
from pathlib import Path

LARGEST_FILE = 1 << 20  # bytes; a vehicle needs about one thousand
LONGEST_NUMBER = 200  # characters
WIDEST_EXPONENT = 400  # decimal; a double ends at 308
LONGEST_FOUND = 60  # characters of a value repeated in a message


class InputError(Exception):
    """Something a person gave cannot be used; says where, what was expected and what to do."""

    def __init__(self, file: str, key: str, expected: str, found: str, remedy: str) -> None:
        super().__init__(file, key, expected, found, remedy)  # all five, so that it pickles
        self.file = file
        self.key = key
        self.expected = expected
        self.found = found
        self.remedy = remedy

    def __str__(self) -> str:
        where = f"{self.file}: {self.key}" if self.key else self.file
        return (
            f"{where}\n  expected: {self.expected}\n  found:    {self.found}"
            f"\n  to do:    {self.remedy}"
        )


@dataclass(frozen=True)
class Unusable:
    """A number as written that has no exact value worth holding (nan, inf, 1e999999999)."""

    text: str


def exact(text: str) -> Fraction | Unusable:
    """The value of a TOML float, exactly; never builds an integer of absurd size."""
    if len(text) > LONGEST_NUMBER or text.lstrip("+-") in {"inf", "nan"}:
        return Unusable(text)
    exponent = text.lower().partition("e")[2]
    if exponent and abs(int(exponent)) > WIDEST_EXPONENT:
        return Unusable(text)
    return Fraction(text)


def shown(value: Fraction, digits: int = 40) -> str:
    """A fraction as a decimal of at most so many significant digits."""
    if value.denominator == 1 and abs(value) < 10**15:
        return str(value)
    rounded = Context(prec=digits).divide(Decimal(value.numerator), Decimal(value.denominator))
    return f"{rounded.normalize(Context(prec=digits)):g}"


def quoted(text: str) -> str:
    """A string as it can be printed anywhere: escaped, and cut when long."""
    return repr(text if len(text) <= LONGEST_FOUND else text[: LONGEST_FOUND - 3] + "...")


def _plain(key: str) -> str:
    """A key as TOML spells it: bare where it can be, otherwise quoted."""
    return key if re.fullmatch("[A-Za-z0-9_-]{1,60}", key) else quoted(key)


def described(value: object) -> str:
    """What was found, in one short phrase; never looks inside arrays and tables."""
    match value:
        case bool():
            return f"the boolean {str(value).lower()}"
        case int() | Fraction():
            large = abs(value) >= 10**LONGEST_FOUND
            return "a number of more than 60 digits" if large else shown(Fraction(value))
        case Unusable():
            return quoted(value.text).strip("'")
        case str():
            return f"the string {quoted(value)}"
        case list():
            return f"an array of {len(value)}"
        case dict():
            return "a table"
        case _:
            return f"a date or time, {value}"


def nearest(word: str, known: Iterable[str]) -> str:
    """The known word most like the given one, whatever its case."""
    return _most_like(word, known, 0.0)[0]


def close(word: str, known: Iterable[str]) -> str | None:
    """The nearest known word if it could have been meant, otherwise None."""
    return next(iter(_most_like(word, known, 0.6)), None)


def _most_like(word: str, known: Iterable[str], cutoff: float) -> list[str]:
    """At most one known word, with a ratio of difflib of at least cutoff."""
    import difflib

    by_lower = {name.lower(): name for name in reversed(tuple(known))}
    found = difflib.get_close_matches(word.lower()[:100], by_lower, n=1, cutoff=cutoff)
    return [by_lower[lower] for lower in found]


@dataclass(frozen=True)
class Table:
    """One table of a TOML file: its file, its name (empty at the top) and its values."""

    file: str
    name: str
    values: Mapping[str, object]

    def fault(self, key: str, expected: str, found: str, remedy: str) -> InputError:
        """The error for a key of this table; to be raised by the caller."""
        where = f"{self.name}.{key}" if self.name else key
        return InputError(self.file, where, expected, found, remedy)

    def only(self, known: tuple[str, ...], homes: Mapping[str, str]) -> None:
        """Refuse a key that is not known; homes says which table a misplaced key belongs to."""
        for key in self.values:
            if key in known:
                continue
            expected = f"one of the keys {', '.join(known)}"
            remedy = f"write {nearest(key, known)}, the nearest known key, or remove this one"
            if key in homes:
                remedy = f"move {key} {homes[key]}"
            raise self.fault(_plain(key), expected, "an unknown key", remedy)

    def require(self, key: str, expected: str, remedy: str) -> object:
        """The value of a key that must be there."""
        if key not in self.values:
            raise self.fault(key, expected, "nothing, the key is missing", remedy)
        return self.values[key]

    def word(self, key: str, expected: str, default: str | None = None) -> str:
        """The string under a key; required when it has no default."""
        remedy = f'write {key} = "{default or "..."}"'
        is_left_out = key not in self.values and default is not None
        value = default if is_left_out else self.require(key, expected, remedy)
        if not isinstance(value, str):
            raise self.fault(key, expected, described(value), f"{remedy}, in quotes")
        return value

    def choice(self, key: str, known: Iterable[str], default: str) -> str:
        """The string under a key, one of the known ones."""
        expected = f"one of {', '.join(known)}"
        value = self.word(key, expected, default)
        if value not in known:
            close = nearest(value, known)
            raise self.fault(key, expected, described(value), f'the nearest is {key} = "{close}"')
        return value

    def choices(self, key: str, known: tuple[str, ...]) -> tuple[str, ...]:
        """The strings under a key, each of them known, in the order of the known; all if absent."""
        value = self.values.get(key, list(known))
        expected = f"an array with one or more of {', '.join(known)}, each once"
        remedy = f"write {key} = {list(known)}, or leave the key out"
        if not isinstance(value, list) or not value:
            raise self.fault(key, expected, described(value), remedy)
        for place, item in enumerate(value):
            if not isinstance(item, str) or item not in known:
                close = (
                    f"; the nearest is {nearest(item, known)!r}" if isinstance(item, str) else ""
                )
                raise self.fault(key, expected, described(item) + close, remedy)
            if item in value[:place]:
                raise self.fault(key, expected, f"{quoted(item)} twice", remedy)
        return tuple(item for item in known if item in value)

    def table(self, key: str) -> "Table":
        """The table under a key; an empty one if absent."""
        value = self.values.get(key, {})
        if not isinstance(value, dict):
            remedy = f"write [{key}] on a line of its own, and its keys below it"
            raise self.fault(key, "a table", described(value), remedy)
        return Table(self.file, key, value)


def read(path: Path) -> Table:
    """The whole file as its top table; raises InputError for every way a file can be bad."""
    text = _text(path)
    example = "mend that line; `derive init NAME --group SO3` writes a file to start from"
    try:
        return Table(str(path), "", tomllib.loads(text, parse_float=exact))
    except tomllib.TOMLDecodeError as fault:
        raise InputError(str(path), "", "TOML", str(fault), example) from None
    except RecursionError:
        raise InputError(str(path), "", "TOML", "arrays nested too deeply", example) from None
    except ValueError:  # the only other one: Python's limit on the digits of an integer
        found = "an integer of more than 4300 digits"
        raise InputError(str(path), "", "TOML with sensible numbers", found, example) from None


def _text(path: Path) -> str:
    """The characters of a regular file of moderate size; a byte order mark is dropped."""
    expected = "a vehicle file: TOML, UTF-8, at most 1 MiB"
    data = _bytes(path, expected)
    if len(data) > LARGEST_FILE:
        raise InputError(str(path), "", expected, "more than 1 MiB", "give the vehicle's own file")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as fault:
        found = f"bytes that are not UTF-8, from byte {fault.start} on"
        raise InputError(str(path), "", expected, found, "save the file as UTF-8") from None
    if not text.strip():
        remedy = "start from `derive init NAME --group SO3`"
        raise InputError(str(path), "", expected, "an empty file", remedy)
    return text


def _bytes(path: Path, expected: str) -> bytes:
    """At most one byte more than the largest file; a pipe is refused, since it could block."""
    remedy = "check the path; `derive init NAME --group SO3` writes a vehicle file"
    try:
        mode = path.stat().st_mode
        if stat.S_ISREG(mode):
            with path.open("rb") as file:
                return file.read(LARGEST_FILE + 1)
    except FileNotFoundError:
        raise InputError(str(path), "", expected, "no such file", remedy) from None
    except (OSError, ValueError) as fault:
        reason = fault.strerror if isinstance(fault, OSError) else fault
        found = f"a file that cannot be read: {reason}"
        remedy = "check the path and its permissions"
        raise InputError(str(path), "", expected, found, remedy) from None
    found = "a directory" if stat.S_ISDIR(mode) else "something that is not a regular file"
    raise InputError(str(path), "", expected, found, "name one vehicle file")
