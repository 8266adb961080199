"""The lines of an image are read whole, or not at all."""

from pathlib import Path

import pytest

from derive.evidence.board import Row, parsed
from derive.evidence.emitted import Emitted
from derive.evidence.firmware import Image
from tests.evidence.emulated import M4F

IMAGE = Image(Emitted(Path("nowhere"), "body", "f32"), M4F, "-O2")
SAID = """test 0
golden 0 1 4000000000
known 65 65
row control 0 1 4000000000 4
cost control 0 700 701
stack control 0 132
end 6
"""


def test_every_line_is_read() -> None:
    reading = parsed(IMAGE, SAID)
    assert reading.failures == 0
    assert reading.golden == {0: Row(1, 4000000000)}
    assert reading.rows == {("control", 0): Row(1, 4000000000, 4)}
    assert reading.known == (65, 65)
    assert reading.cost == {("control", 0): (700, 701)}
    assert reading.stack == {("control", 0): 132}


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("end 6\n", "", "does not end"),
        ("known 65 65\n", "", "6 lines were written, 5 arrived"),
        ("known 65", "knows 65", "'knows 65 65'"),
        ("test 0", "fault", "'fault'"),
        ("end 6\n", "end 6\nstack control 1 8\n", "'end 6'"),
        ("row control 0 1 4000000000 4", "row control 0 1 x 4", "invalid literal"),
        ("cost control 0 700 701", "cost control 0 700", "not enough values"),
    ],
)
def test_a_line_that_is_lost_or_broken_is_refused(old: str, new: str, told: str) -> None:
    assert SAID.count(old) == 1
    with pytest.raises(ValueError, match=told):
        parsed(IMAGE, SAID.replace(old, new))
