"""Printed C as a Python program: float arithmetic held to numpy's, hashes to published ones."""

from __future__ import annotations

import struct
from typing import Any

import numpy as np
import pytest

from derive.emit.literal import exact
from derive.emit.program import Limit, bits, limited, pack, program, rounded, run

TOY = {
    "has_side": False,
    "kernels": [{"name": "k", "terms": [["-", "0.1F"], ["+", "0.3F"], ["-", "0.7F"]]}],
    "routines": [
        {
            "symbol": "law",
            "inputs": [{"name": "x", "entries": [["x_0", 0], ["x_1", 2]]}],
            "steps": [
                {"lines": [["a", "sqrtf(x_0*x_0 + 1.0e-30F) - toy_f32_k(x_1)/x_0"]], "cases": []},
                {
                    "lines": [],
                    "cases": [
                        {"condition": "(x_0 >= 0.0F) && (x_1 < x_0)", "lines": [["b", "a*0.1F"]]},
                        {"condition": "fabsf(x_1) > 0.5F", "lines": [["b", "-a/3.0F"]]},
                        {"condition": "", "lines": [["b", "a*a + 0.2F*x_1"]]},
                    ],
                },
            ],
            "outputs": [{"member": "y", "entries": ["a", "b"]}],
        }
    ],
}


def in_numpy(x_0: np.float32, x_1: np.float32) -> list[np.float32]:
    """The toy, written by hand with numbers that numpy rounds itself."""
    f = np.float32
    z = f(1) - x_1
    k = (-f(0.1) * z + f(0.3)) * z - f(0.7)
    a = np.sqrt(x_0 * x_0 + f(1e-30)) - k / x_0
    if x_0 >= 0 and x_1 < x_0:
        return [a, a * f(0.1)]
    return [a, -a / f(3) if abs(x_1) > 0.5 else a * a + f(0.2) * x_1]


def test_a_program_in_float_rounds_where_c_does() -> None:
    law = run(program(TOY, "f32"))["law"]
    random = np.random.default_rng(3)
    rows = (random.normal(size=(400, 2)) * 10.0 ** random.integers(-3, 4, (400, 1))).astype("f4")
    seen = set()
    for x_0, x_1 in rows:
        given = {"x": [float(x_0), 0.0, float(x_1)]}
        assert law(given)["y"] == [float(y) for y in in_numpy(x_0, x_1)]
        seen.add((x_0 >= 0 and x_1 < x_0, abs(x_1) > 0.5))
    assert len(seen) == 4


def test_one_more_rounding_is_what_rounding_once_gives() -> None:
    """On sums, products, quotients and roots of random floats, ties and subnormals among them."""
    random = np.random.default_rng(4)
    a, b = random.integers(1, 0x7F000000, (2, 20000), dtype="u4").view("f4")
    a[::4], b[::4] = np.float32(1) + a[::4] % 1, np.float32(2.0**-24) * (1 + b[::4] % 1)
    with np.errstate(all="ignore"):
        for name in ("add", "subtract", "multiply", "divide"):
            wanted = getattr(np, name)(a, b)
            wide = getattr(np, name)(a.astype("f8"), b.astype("f8"))
            for x, y in zip(wide[np.isfinite(wanted)], wanted[np.isfinite(wanted)], strict=True):
                assert rounded(float(x)) == float(y)
        for x, y in zip(np.sqrt(a.astype("f8")), np.sqrt(a), strict=True):
            assert rounded(float(x)) == float(y)


@pytest.mark.parametrize(
    ("text", "found"), [("", 0x811C9DC5), ("foob", 0x3F5076EF), ("\0" * 4, 0x4B95F515)]
)
def test_the_hash_is_fnv(text: str, found: int) -> None:
    """As its authors' own test vectors have it."""
    numbers = [struct.unpack("<f", text.encode())[0]] if text else []
    assert pack(numbers, "f32") == text.encode()
    assert bits(numbers, "f32") == found


@pytest.mark.parametrize("scalar", ["f32", "f64"])
def test_a_number_is_written_so_that_it_reads_back(scalar: str) -> None:
    kind: Any = {"f32": np.float32, "f64": np.float64}[scalar]
    random = np.random.default_rng(5)
    spread = random.normal(size=2000) * 10.0 ** random.integers(-40, 38, 2000)
    for value in (0.0, -0.0, 0.1, 1e-45, 3.0, *spread):
        stored = float(kind(value))
        text = exact(stored, scalar)
        assert "." in text
        assert text.endswith("F") == (scalar == "f32")
        back = kind(text.rstrip("F"))
        assert back.tobytes() == kind(stored).tobytes()
    told = {value: exact(float(kind(value)), scalar).rstrip("F") for value in (0.1, 1e-12, -3.0)}
    assert told == {0.1: "0.1", 1e-12: "1.0e-12", -3.0: "-3.0"}


def test_a_force_is_held_to_its_limits() -> None:
    assert limited([3.0, -8.0], Limit((), True), "f64") == [3.0, -8.0]
    assert limited([1.0, -2.0], Limit((1.0, 2.0), True), "f64") == [1.0, -2.0]
    ulps = 1 - 2.0**-51
    assert limited([3.0, -8.0], Limit((4.0, 2.0), True), "f64") == [0.75 * ulps, -2.0 * ulps]
    assert limited([3.0, -8.0], Limit((4.0, 2.0), False), "f64") == [3.0, -2.0]
    third = np.float32(1) / np.float32(3) * np.float32(1 - 2.0**-22)
    share = limited([1.0, 3.0], Limit((1.0, 1.0), True), "f32")
    assert share == [float(third), float(np.float32(3) * third)]
