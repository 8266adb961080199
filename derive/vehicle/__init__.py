"""The vehicle file: from TOML to a Vehicle, exactly, or one readable error."""

from derive.vehicle.file import (
    CONTROLLERS,
    Facts,
    InputError,
    OwnGroup,
    Vehicle,
    check_facts,
    load,
    resolve,
)

__all__ = [
    "CONTROLLERS", "Facts", "InputError", "OwnGroup", "Vehicle", "check_facts", "load", "resolve",
]  # fmt: skip
