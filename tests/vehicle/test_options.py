"""Options are booleans that are off unless asked for."""

from pathlib import Path

import pytest

from derive.vehicle import InputError, Vehicle, load
from derive.vehicle.key import OPTION_KEYS


def with_options(folder: Path, lines: str) -> Vehicle:
    path = folder / "body.toml"
    path.write_text(
        'name = "body"\ngroup = "R1"\ninertia = [[1]]\ngains = {lambda = 0.5, k_s = 1}\n' + lines
    )
    return load(path)


@pytest.mark.parametrize(
    ("lines", "options", "is_in_fluid"),
    [
        ("", (), False),
        ("[options]", (), False),
        ("[options]\nmomentum = false\nadded_mass = false", (), False),
        ("[options]\nmomentum = true", ("momentum",), False),
        ("[options]\nmomentum = true\nexternal = true", ("external", "momentum"), False),
        ("[options]\nadded_mass = true\nexternal = true", ("external",), True),
    ],
)
def test_options_are_off_unless_asked_for(
    tmp_path: Path, lines: str, options: tuple[str, ...], is_in_fluid: bool
) -> None:
    vehicle = with_options(tmp_path, lines)
    assert (vehicle.options, vehicle.is_in_fluid) == (options, is_in_fluid)


@pytest.mark.parametrize("key", OPTION_KEYS)
@pytest.mark.parametrize(
    ("value", "found"), [("1", "1"), ('"true"', "string 'true'"), ("[[1]]", "array of 1")]
)
def test_what_is_not_true_or_false_is_told(
    tmp_path: Path, key: str, value: str, found: str
) -> None:
    with pytest.raises(InputError) as caught:
        with_options(tmp_path, f"[options]\n{key} = {value}")
    assert caught.value.key == f"options.{key}"
    assert caught.value.expected == "true or false, without quotes"
    assert found in caught.value.found
    assert caught.value.remedy == f"write {key} = true, or leave it out for false"


@pytest.mark.parametrize(
    ("lines", "key", "remedy"),
    [
        ("[options]\nmomentun = true", "options.momentun", "write momentum, the nearest"),
        ("[options]\nk_s = 1", "options.k_s", "move k_s below [gains]"),
        ("momentum = true", "momentum", "move momentum below [options]"),
        ("added_mass = true", "added_mass", "below [options] as true"),
        ("mass = 1", "mass", "move mass below [body]"),
        ("basis = []", "basis", "move basis below [group]"),
        ("options = true", "options", "write [options]"),
        ("[[options]]\nmomentum = true", "options", "write [options]"),
    ],
)
def test_a_misplaced_key_is_told(tmp_path: Path, lines: str, key: str, remedy: str) -> None:
    with pytest.raises(InputError) as caught:
        with_options(tmp_path, lines)
    assert caught.value.key == key
    assert remedy in caught.value.remedy
