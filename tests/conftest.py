"""Property tests are the same at every run, in CI without luck; and what commands start from."""

import os
import signal
from pathlib import Path

import pytest
from hypothesis import settings

from derive.vehicle.starter import starter
from tests.command import FILES, derive

settings.register_profile("laptop", deadline=None)
settings.register_profile("ci", deadline=None, derandomize=True, database=None, print_blob=True)
settings.load_profile("ci" if os.environ.get("CI") else "laptop")

# A run in the background inherits an ignored SIGINT, and so would every command that a test
# starts and interrupts; a handler here is the default there.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The home of a user whose cache holds every vehicle."""
    place = tmp_path_factory.mktemp("home")
    derive(place, "emit", *FILES, "--out", "unused", home=place)
    return place


@pytest.fixture
def body(tmp_path: Path) -> Path:
    """body.toml, as `derive init` writes it, alone in its folder."""
    place = tmp_path / "here"
    place.mkdir()
    (place / "body.toml").write_text(starter("body", "SO3"))
    return place / "body.toml"
