"""The toy vehicle of toy.h and toy.c in either scalar, and what it should answer, in numpy."""

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

HERE = Path(__file__).parent
INERTIA, RATE_GAIN, REACH_GAIN = np.arange(1.0, 7.0), 0.5, 2.0


def write(folder: Path, scalar: str) -> tuple[Path, Path]:
    """Write header and source in `scalar` ("f32" or "f64") to `folder`; return both paths."""
    paths = folder / f"toy_{scalar}.h", folder / f"toy_{scalar}.c"
    for path, name in zip(paths, ("toy.h", "toy.c"), strict=True):
        text = (HERE / name).read_text(encoding="utf-8").replace('"toy.h"', f'"{paths[0].name}"')
        if scalar == "f32":
            text = text.replace("double", "float").replace("f64", "f32").replace("F64", "F32")
            text = re.sub(r"\b(\d+\.\d+(e\d+)?)\b", r"\1F", text)
        path.write_text(text, encoding="utf-8")
    return paths


def rows(count: int) -> tuple[NDArray[np.float64], ...]:
    """Random g (count, 4), nu (count, 2), g_r, nu_r, nu_r_dot, the same at every call."""
    random = np.random.default_rng(7)
    return tuple(random.normal(size=(count, k)) for k in (4, 2, 4, 2, 2))
