"""The paper's comparison, flown once for all tests that look at it."""

from pathlib import Path

import pytest

from derive import comparison
from derive.comparison import Comparison
from derive.simulate.executor import Alone
from derive.vehicle import load
from tests.command import ROOT
from tests.simulate.sweeps import RUNS, flown


@pytest.fixture(scope="session")
def compared(tmp_path_factory: pytest.TempPathFactory) -> Comparison:
    cached = tmp_path_factory.mktemp("cache")
    vehicle = load(Path(ROOT) / "vehicles" / "paper_so3.toml")
    return comparison.scenarios(vehicle, cached, (1, 2, 3), "f64", lambda _: None)


@pytest.fixture(scope="session")
def truth(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """The rows of the short sweep, flown in one piece."""
    return flown(tmp_path_factory.mktemp("truth") / "out", Alone(), chunk=RUNS)
