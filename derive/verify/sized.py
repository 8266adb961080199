"""Exact numbers that carry the size of the terms they are made of, and vectors of them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from decimal import Decimal


@dataclass(frozen=True, slots=True)
class Sized:
    """A number and the size of the terms it is a sum of."""

    value: Decimal
    size: float

    def __add__(self, other: Sized) -> Sized:
        return Sized(self.value + other.value, self.size + other.size)

    def __sub__(self, other: Sized) -> Sized:
        return Sized(self.value - other.value, self.size + other.size)

    def __mul__(self, other: Sized) -> Sized:
        return Sized(self.value * other.value, self.size * other.size)

    def __truediv__(self, other: Sized) -> Sized:
        return Sized(self.value / other.value, self.size / other.size)


Vector = list[Sized]
ZERO = Sized(Decimal(0), 0.0)


def total(terms: Iterable[Sized]) -> Sized:
    """The sum."""
    return sum(terms, ZERO)


def plus(a: Vector, b: Vector) -> Vector:
    """a + b."""
    return [x + y for x, y in zip(a, b, strict=True)]


def minus(a: Vector, b: Vector) -> Vector:
    """a - b."""
    return [x - y for x, y in zip(a, b, strict=True)]


def times(factor: Sized, x: Vector) -> Vector:
    """The factor with each."""
    return [factor * each for each in x]
