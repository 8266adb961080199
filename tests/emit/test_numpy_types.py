"""`control` of the emitted numpy module judges real numbers of any type as the doubles they are."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.native.load import load_module
from derive.vehicle import Vehicle
from tests.emit import subjects
from tests.emit.cases import good
from tests.emit.subjects import ALIKE, group

KINDS = (np.int8, np.int16, np.int32, np.int64, np.uint64, np.float16, np.float32, np.longdouble)

every_vehicle = pytest.mark.parametrize("vehicle", ALIKE, ids=lambda v: v.name)


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("typed")


def module(vehicle: Vehicle, folder: Path) -> Any:
    return load_module(subjects.place(vehicle, folder) / f"numpy/{vehicle.name}.py")


def inputs(vehicle: Vehicle) -> dict[str, Any]:
    """One good row, its configurations in the shape the module takes."""
    shape = group(vehicle).shape
    row = good(vehicle)
    return {name: one.reshape(shape) if name[0] == "g" else one for name, one in row.items()}


@every_vehicle
def test_what_is_not_real_numbers_is_refused(folder: Path, vehicle: Vehicle) -> None:
    made, given = module(vehicle, folder), inputs(vehicle)
    for name, value in given.items():
        for odd, found in (
            (np.ma.masked_array(value, value > 0), "a masked array"),
            (value.astype(object), "an array of object"),
            (value.astype(str), "an array of <U32"),
            (value.astype(complex), "an array of complex128"),
            (np.full(value.shape, np.datetime64("1970-01-01")), r"an array of datetime64\[D\]"),
        ):
            with pytest.raises(TypeError, match=f"^{name}: expected real numbers, found {found}$"):
                made.control(**{**given, name: odd})


@every_vehicle
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_the_extremes_of_a_type_are_judged_in_double(
    folder: Path, vehicle: Vehicle, kind: Any
) -> None:
    """The least integer has no absolute value among integers; it must not pass for a small one."""
    made, given = module(vehicle, folder), inputs(vehicle)
    info: Any = np.iinfo(kind) if np.issubdtype(kind, np.integer) else np.finfo(kind)
    for value in (info.min, info.max):
        nu = np.array([value] + [0] * (group(vehicle).dim - 1), kind)
        with np.errstate(over="ignore"):
            wide = nu.astype(float)
        size = abs(wide[0])
        command, same = (made.control(**{**given, "nu": one}) for one in (nu, wide))
        good = {made.OK, made.SATURATED} if vehicle.limits.force else {made.OK}
        expected = {made.OUT_OF_RANGE} if size > made.MAX_INPUT else good
        assert int(command.status) in ({made.NONFINITE_INPUT} if np.isinf(size) else expected)
        assert command.status == same.status
        assert command.force.tolist() == same.force.tolist()


@every_vehicle
def test_truth_values_and_lists_are_numbers(folder: Path, vehicle: Vehicle) -> None:
    made, given = module(vehicle, folder), inputs(vehicle)
    n = group(vehicle).dim
    whole = [k % 2 == 0 for k in range(n)]
    force = made.control(**{**given, "nu": [float(x) for x in whole]}).force.tolist()
    for nu in (np.array(whole), [int(x) for x in whole], tuple(whole)):
        assert made.control(**{**given, "nu": nu}).force.tolist() == force
