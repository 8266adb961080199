"""The vehicles that the tests of `verify` run over: every group, every law, every option."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

from derive.control.kinematic import LAWS, laws_of
from derive.control.table import CONTROLLERS
from derive.lie.catalogue import named
from derive.vehicle import Vehicle, load
from derive.vehicle.group import OwnGroup, made
from derive.verify.plant import Plant
from tests.verify.oracle.test_factor_law import HEISENBERG, SL2

ROOT = Path(__file__).parents[2]
FILES = sorted((ROOT / "vehicles").glob("*.toml"))
PAPER = load(ROOT / "vehicles" / "paper_so3.toml")


def _own(name: str, basis: tuple[tuple[tuple[int, ...], ...], ...]) -> OwnGroup:
    exact = tuple(tuple(tuple(map(Fraction, row)) for row in e) for e in basis)
    return OwnGroup(name, exact, ("1/s",) * len(basis))


DILATION = (((1, 0), (0, 0)), ((0, 1), (0, 0)))
"""x -> a x + b: its inverse needs a division, and no multiple of 1 is in it."""

OWN = {
    name: _own(name, basis)
    for name, basis in (("Heisenberg", HEISENBERG), ("SL2", SL2), ("Affine", DILATION))
}
PRODUCTS = ("SO3 x R3", "SE3 x SO3", "S3 x R3", "SO2 x SE2")


def vehicle(
    group: str, law: str, controller: str = "gsmc", options: tuple[str, ...] = ()
) -> Vehicle:
    """A vehicle with a full inertia, whose numbers all differ."""
    own = OWN.get(group)
    n = made(group, own).dim
    inertia = tuple(
        tuple(Fraction(5 + i) if i == j else Fraction(7 + i + j + 3 * i * j, 100) for j in range(n))
        for i in range(n)
    )
    gains = tuple(
        (name, Fraction(2 + k, 4)) for k, name in enumerate(CONTROLLERS[controller].names)
    )
    return Vehicle(
        name=f"{group.lower().replace(' ', '')}_{law}",
        group=group,
        law=law,
        controller=controller,
        inertia=inertia,
        gains=gains,
        scalars=("f32", "f64"),
        targets=("c99", "numpy"),
        source="made for a test",
        own=own,
        options=options,
    )


def plant(of: Vehicle) -> Plant:
    """What the truth is told of it."""
    gains = tuple(value for _, value in of.gains)
    own = of.own.basis if of.own else None
    return Plant(of.group, of.law, of.inertia, gains, of.controller, own, tuple(of.options))


PAIRS = [
    *LAWS,
    *((name, law) for name in PRODUCTS for law in laws_of(named(name))),
    *((name, law) for name, own in OWN.items() for law in laws_of(made(name, own))),
]
"""Every law on every group of the catalogue, on some products, and on groups of one's own."""

GROUPS = list(dict.fromkeys(group for group, _ in PAIRS))
FIRST = {group: next(law for name, law in PAIRS if name == group) for group in GROUPS}
"""A law of each group."""
