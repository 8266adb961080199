"""Groups and laws are looked up in the catalogue, and the unknown ones told with what is near.

Computer algebra is imported here only, and only when something is looked up.
"""

import re
from dataclasses import dataclass

from derive.vehicle.group import VECTORS, OwnGroup, made
from derive.vehicle.number import LARGEST_DIMENSION
from derive.vehicle.text import InputError, close, described, quoted

OR_YOURS = "describe the whole group in a [group] table with name, basis and law"


@dataclass(frozen=True)
class Facts:
    """What must be known of a group to judge an inertia: its dimension n, and if it rotates."""

    dim: int
    is_rotation: bool


def look_up(file: str, group: str, own: OwnGroup | None = None) -> Facts:
    """The facts of a group; raises InputError for an unknown factor, or a name that is taken."""
    if own is not None:
        _check_free(file, own.name)
        _check_inverse(file, own)
        return Facts(dim=len(own.basis), is_rotation=False)
    factors = group.split(" x ")
    for factor in factors:
        if not _is_known(factor):
            raise _stranger(file, group, factor)
    _check_size(file, group, factors)
    found = made(group, None)
    return Facts(dim=found.dim, is_rotation=found.is_rotation)


def _check_inverse(file: str, own: OwnGroup) -> None:
    """Raise InputError for a group whose elements have no inverse of bearable size."""
    try:
        made(own.name, own)
    except ValueError as fault:
        expected = "matrices of at most 4 rows, or a regular bilinear form that the group keeps"
        remedy = "write it with smaller matrices, or as a product of groups that are known"
        raise InputError(file, "group.basis", expected, str(fault), remedy) from None


def laws_on(group: str, own: OwnGroup | None = None) -> tuple[str, ...]:
    """Names of the kinematic laws that exist on a group, which is known."""
    from derive.control.kinematic import laws_of

    return tuple(laws_of(made(group, own)))


def check_law(file: str, group: str, law: str, own: OwnGroup | None = None) -> None:
    """Raise InputError unless the law exists on that group, which is known."""
    there = laws_on(group, own)
    if law in there:
        return
    from derive.control.kinematic import LAWS, why_not

    expected = f"one of {', '.join(there)} (the laws that exist on {group})"
    found, remedy = _told("law", law, there)
    elsewhere = [other for other, name in LAWS if name == law]
    if elsewhere:
        places = ", ".join(elsewhere[:3]) + ", ..." * (len(elsewhere) > 3)
        why = why_not(made(group, own), law)
        found = f"{quoted(law)}, which exists only on {places}" + (f": {why}" if why else "")
    raise InputError(file, "law", expected, found, remedy)


def _is_known(factor: str) -> bool:
    from derive.lie.catalogue import GROUPS

    return factor in GROUPS or VECTORS.fullmatch(factor) is not None


def _stranger(file: str, group: str, factor: str) -> InputError:
    """The error for a factor that nobody knows, with what could have been meant."""
    from derive.lie.catalogue import GROUPS

    names = tuple(name for name in GROUPS if not VECTORS.fullmatch(name))
    found, remedy = _told("group", factor, (*names, "R3"))
    product = " x ".join(re.split(r"\s*[xX×*]\s*", group))
    if group != factor:
        remedy = remedy.replace("write group =", "write the factor as")
        found = f"{found} in {quoted(group)}"
    remedy = f"{remedy}, or {OR_YOURS}"
    if product != group and all(map(_is_known, product.split(" x "))):
        remedy = f'write group = "{product}", with a space on both sides of each x'
    several = f"R1 to R{LARGEST_DIMENSION}, a product such as SO3 x R3, or a [group] table"
    return InputError(file, "group", f"one of {', '.join(names)}, {several}", found, remedy)


def _check_size(file: str, group: str, factors: list[str]) -> None:
    """Raise InputError for a product of more dimensions than an inertia may have rows."""
    from derive.lie.catalogue import GROUPS

    sizes = [GROUPS[name].dim if name in GROUPS else int(name[1:]) for name in factors]
    if sum(sizes) > LARGEST_DIMENSION:
        expected = f"at most {LARGEST_DIMENSION} dimensions in all"
        found = f"{sum(sizes)}, in {quoted(group)}"
        raise InputError(file, "group", expected, found, "describe one vehicle to a file")


def _check_free(file: str, name: str) -> None:
    """Raise InputError for a group of one's own that is named like another."""
    if _is_known(name):
        expected = "a name that no group of the catalogue has"
        remedy = f'write name = "my_{name}", or group = "{name}" in place of the [group] table'
        raise InputError(file, "group.name", expected, quoted(name), remedy)


def _told(key: str, word: str, known: tuple[str, ...]) -> tuple[str, str]:
    """What was found and what to do for a word that is not known."""
    meant = close(word, known)
    remedy = f'write {key} = "{meant}", the nearest' if meant else f"choose a {key} of that list"
    return described(word), remedy
